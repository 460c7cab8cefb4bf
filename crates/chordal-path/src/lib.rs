//! From commands to the path of the tool tip, its times, and the checks that need the path.
//!
//! [`PathBuilder`] turns each motion command into exact curves in one frame for the whole
//! run; [`Checks`] watches travel, rapids and tangency as the commands go by. Both keep a
//! bounded state: nothing is collected here.

#![forbid(unsafe_code)]

mod builder;
mod checks;
pub mod compensation;
mod contour_check;
mod contour_level;
mod frame;
pub mod gouge;
mod rapid;
mod segment;
mod side_check;

pub use builder::{PathBuilder, duration_s};
pub use checks::{Checks, ChecksMemory, Seen};
pub use compensation::{
    Compensator, CompensatorMemory, ContourPiece, PathCommand, PathSink, PlaneCurve, Role,
};
pub use contour_check::ContourCheck;
pub use contour_level::ContourLevel;
pub use frame::Frame;
pub use segment::{Segment, SegmentKind, curve_of};
pub use side_check::SideCheck;

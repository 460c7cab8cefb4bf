//! Turns commands into the path of the tool tip with its times, and makes the checks that need the path.
//!
//! [`PathBuilder`] turns each motion command into exact curves in one frame for the whole run. [`RunChecks`] checks
//! travel, rapids and tangency as it follows the commands. The memory of both is bounded.
//!
//! ```
//! use chordal_command::{
//!     AxisMask, Command, CommandKind, Feed, FeedAlong, FeedMode, Move, Origin,
//! };
//! use chordal_machine::Machine;
//! use chordal_path::PathBuilder;
//!
//! let (all, to) = (AxisMask::ALL, [3.0, 4.0, 0.0, 0.0, 0.0, 0.0]);
//! let motion = Move { from: [0.0; 6], to, from_known: all, to_known: all };
//! let feed = Feed {
//!     value: 10.0, // mm/s
//!     mode: FeedMode::PerTime,
//!     along: FeedAlong::Path,
//!     spindle_rev_per_s: 0.0,
//!     lead_change: 0.0,
//!     surface: None,
//! };
//! let command = Command { kind: CommandKind::Line { motion, feed }, origin: Origin::default() };
//!
//! let machine = Machine::from_builtin("haas-vf2").unwrap();
//! let mut path = PathBuilder::new(&machine, [0.0; 6], AxisMask::ALL);
//! let mut segments = Vec::new();
//! path.command(&command, |segment| segments.push(segment.clone()));
//! assert_eq!((segments[0].length_mm, segments[0].duration_s), (5.0, 0.5));
//! ```

#![forbid(unsafe_code)]

mod axis_moves;
mod axis_path;
mod builder;
mod checks;
pub mod compensation;
mod contour_check;
mod contour_level;
mod contour_rapid;
mod excess;
mod frame;
pub mod gouge;
mod rapid;
mod rapid_check;
mod rotary;
mod rotary_extremes;
mod segment;
mod side_check;
mod surface;
mod tip;
mod turret_log;

pub use axis_moves::{AxisMoves, AxisMovesError, TimedAxisPiece};
pub use axis_path::{AxisPiece, AxisPieces, axis_pieces, tip_pieces};
pub use builder::{PathBuilder, RunFrame, duration_s};
pub use checks::{CheckedRange, ChecksMemory, RunChecks, depth_mm};
pub use compensation::{
    BlockRole, CompensationCurve, Compensator, CompensatorMemory, ContourPiece, PathCommand,
    PathSink,
};
pub use contour_check::ContourCheck;
pub use contour_level::ContourLevel;
pub use frame::ProgramFrame;
pub use rapid::rapid_corners;
pub use rotary::{RotaryLimits, rotary_parts};
pub use rotary_extremes::places_on_axes;
pub use segment::{NotNamed, Segment, SegmentKind, UnrelatedZero, curve_of, curves_of};
pub use side_check::SideCheck;
pub use surface::{SurfacePart, surface_parts};
pub use tip::{TipDoubt, TipPlace, TipTracker};

//! What a program makes a machine do, as plain data, whatever language the program is written in.
//!
//! A [`Command`] is one thing the machine does: a move, a dwell, a tool change, a change of mode.
//! A run pushes commands and diagnostics into a [`Sink`]. Lengths are in mm, angles in rad, times in
//! s. Positions are those of the tool tip in program coordinates, of the active work coordinate system.
//!
//! ```
//! use chordal_command::{AxisMask, Move};
//! use chordal_machine::AXES;
//!
//! let motion = Move {
//!     from: [0.0; AXES],
//!     to: [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
//!     from_known: AxisMask::ALL,
//!     to_known: AxisMask::ALL,
//! };
//! assert!(motion.only_turns(None), "A turns, and the tool tip stays");
//! ```

#![forbid(unsafe_code)]

mod axes;
mod command;
mod effect;
mod mode;
mod motion;
mod origin;
mod part_frame;
mod sink;
mod surface;
mod units;
mod work_name;
mod work_zero;

pub use axes::{AxisMask, Position};
pub use command::{Command, CommandKind};
pub use effect::Effect;
pub use mode::{CompensationSide, Coolant, Overrides, PathMode, SpindleState};
pub use motion::{
    ArcShape, Feed, FeedAlong, FeedMode, Move, RapidPath, RotaryLength, SurfaceSpeed,
};
pub use origin::{CallPath, CallPaths, Origin};
pub use part_frame::{PartFrame, ProgramOffsets, TipCurve};
pub use sink::Sink;
pub use surface::{RotarySurface, SurfaceRun, SurfaceShape};
pub use units::{Units, number_text, telling_number};
pub use work_name::{WorkName, WorkNaming};
pub use work_zero::{UnknownPresets, WorkZero};

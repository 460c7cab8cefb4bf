//! From the exact path to timed setpoints.
//!
//! A [`Move`] is an exact curve with the speed asked for and a [`Corner`] that says how its end
//! is passed. Moves go into a planner, which emits [`Stretch`]es: smooth pieces of path and
//! the phases of constant jerk in which they are travelled. Whoever wants setpoints evaluates a
//! stretch at a time, or lets a [`Sampler`] do it at a period.
//!
//! Lengths are in mm, angles in rad, time in s. Arrays over axes are X Y Z A B C. The path of a
//! move is measured in mm along X, Y and Z, and in rad where rotary axes alone move; both are
//! called σ below.
//!
//! | pass | gives | file |
//! |---|---|---|
//! | input | [`Move`] | `segment.rs` |
//! | corners eased within their tolerance | [`Piece`] | `smooth/` |
//! | the velocity profile | [`Phase`], [`Stretch`] | `profile/` |
//! | the least time | [`bound()`] | `bound/` |
//! | the least time with jerk | [`reference()`] | `reference/` |
//! | setpoints | [`Sample`] | `sampler.rs` |
//! | setpoints for a servo loop | [`Feeder`], [`Servo`] | `stream/` |

#![forbid(unsafe_code)]

mod bound;
mod cell;
mod limits;
mod overlap;
mod piece;
mod planner;
mod profile;
mod reader;
mod reference;
mod root;
mod sampler;
mod segment;
mod smooth;
mod span;
mod stream;
mod trajectory;
mod verify;

pub use bound::{Bound, Run, RunError, bound};
pub use limits::{AxisLimit, LimitError, Limits, Quantity};
pub use piece::{Jet, Piece};
pub use planner::{Level, Planner, PlannerOptions};
pub use reference::{Best, Effort, Gauge, Law, Least, ReferenceError, RunTimes, best, reference};
pub use sampler::{Sample, Sampler};
pub use segment::{Corner, Move, MoveError, MoveKind};
pub use span::{PathPart, Span};
pub use stream::{FeedError, Feeder, Pushed, Servo, Setpoint, StreamOptions, stream};
pub use trajectory::{Along, Cursor, Phase, State, Step, Stretch};
pub use verify::{Use, largest_use};

/// A value for each axis X Y Z A B C, in mm and rad or their derivatives.
pub type Axes = [f64; 6];

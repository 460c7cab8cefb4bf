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
//! | their velocity profile | [`Phase`], [`Stretch`] | `profile/` |
//! | dense lines as one curve | [`Piece`] | `curve/` |
//! | the law of time on it | [`law()`] | `law/` |
//! | both together, from corner to corner | [`Stretch`] | `dense.rs` |
//! | trapezoids with junction deviation, for controls that have no jerk | [`JunctionLaw`] | `junction.rs` |
//! | the least time | [`bound()`] | `bound/` |
//! | the least time with jerk | [`reference()`] | `reference/` |
//! | setpoints | [`Sample`] | `cursor.rs`, `sampler.rs` |
//! | setpoints for a servo loop | [`Feeder`], [`Servo`] | `stream/` |
//!
//! ```
//! use chordal_geometry::{Curve, Line, Vec3};
//! use chordal_motion::{
//!     AxisLimit, Corner, Level, Limits, Move, MoveKind, Planner, PlannerOptions, Sampler,
//! };
//!
//! let axis = Some(AxisLimit { velocity: 400.0, acceleration: 3000.0, jerk: 100_000.0 });
//! let limits = Limits::new([axis, axis, axis, None, None, None]).unwrap();
//! let mut planner = Planner::new(limits, PlannerOptions::new(Level::Fast));
//! let mut sampler = Sampler::new(0.001);
//! let mut last = None;
//! let line = Move {
//!     curve: Curve::Line(Line { start: Vec3::new(0.0, 0.0, 0.0), end: Vec3::new(50.0, 0.0, 0.0) }),
//!     rotary_from: [0.0; 3],
//!     rotary_to: [0.0; 3],
//!     speed: 100.0,
//!     corner: Corner::Stop,
//!     kind: MoveKind::Cut,
//!     tag: 1,
//! };
//! planner.push(&line, |step| sampler.push(step, |sample| last = Some(*sample))).unwrap();
//! planner.finish(|step| sampler.push(step, |sample| last = Some(*sample)));
//! sampler.finish(|sample| last = Some(*sample));
//! let last = last.unwrap();
//! assert_eq!(last.position[0], 50.0);
//! assert!(last.time_s > 0.5 && last.time_s < 0.6);
//! ```

#![forbid(unsafe_code)]

mod bound;
mod cell;
mod cursor;
mod curve;
mod dense;
mod junction;
#[cfg(test)]
mod junction_times;
mod law;
mod limits;
mod piece;
mod planner;
mod profile;
mod reader;
mod reference;
mod root;
mod sample;
mod sampler;
mod segment;
mod smooth;
mod stream;
mod trajectory;
mod verify;

pub use bound::{Bound, Run, RunError, bound};
pub use cursor::Cursor;
pub use junction::{JunctionLaw, SegmentLengths};
pub use law::{Work, law};
pub use limits::{AxisLimit, LimitError, Limits, Quantity};
pub use piece::{Jet, Piece};
pub use planner::{Level, Planner, PlannerOptions};
pub use reference::{Effort, Gauge, Law, Least, ReferenceError, RunTimes, reference};
pub use sample::{Sample, State};
pub use sampler::Sampler;
pub use segment::{Corner, Move, MoveError, MoveKind};
pub use smooth::span::{PathPart, Span};
pub use stream::{FeedError, Feeder, Pushed, Servo, Setpoint, StreamOptions, stream};
pub use trajectory::{Along, Phase, Step, Stretch};
pub use verify::{Use, largest_use};

/// A value for each axis X Y Z A B C, in mm and rad or their derivatives.
pub type Axes = chordal_geometry::PerAxis<f64>;

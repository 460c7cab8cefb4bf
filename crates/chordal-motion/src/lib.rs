//! From the exact path to timed setpoints.
//!
//! A [`MoveRequest`] is an exact curve with its programmed speed and a [`CornerMode`] for the corner at its
//! end. Moves go into a planner, which emits [`PlannedTrajectory`]s: smooth pieces of path and
//! the phases of constant jerk in which they are travelled. Setpoints come from evaluating a trajectory
//! at a time, or from a [`SetpointSampler`] at a fixed period.
//!
//! Lengths are in mm, angles in rad, time in s. Arrays over axes are X Y Z A B C. The path of a
//! move is measured in mm along X, Y and Z, and in rad where rotary axes alone move; both are
//! called σ below.
//!
//! | stage | gives | where |
//! |---|---|---|
//! | input | [`MoveRequest`] | `move_request.rs` |
//! | look-ahead, and the choice between the strategies below | [`PlannerStep`] | `planner/` |
//! | **corners:** corner blending, within the tolerance of each | [`PathPiece`] | `corner_blend/` |
//! | axis limits turned into limits along the path | intervals | `path_limits.rs` |
//! | feedrate profile of seven-phase ramps | [`JerkPhase`] | `ramp_profile/` |
//! | **curves:** runs of dense moves between corners | [`PlannedTrajectory`] | `curve_planner/` |
//! | curve fitting, with proof of its tolerance | [`PathPiece`] | `curve_fit/` |
//! | feedrate profile by Newton steps on the time itself | [`solve_profile()`] | `profile_solver/` |
//! | **junctions:** trapezoids with junction deviation, for controls without jerk limits | [`JunctionRule`] | `junction_planner.rs` |
//! | the least time without jerk | [`time_bound()`] | `time_bound/` |
//! | the least time with jerk | [`reference()`] | `reference/` |
//! | setpoints | [`MotionSample`] | `cursor.rs`, `reader.rs`, `sampler.rs` |
//! | setpoints for a servo loop | [`StreamFeeder`], [`StreamServo`] | `stream/` |
//! | how much of the axis limits is used | [`LimitUse`] | `limit_use.rs` |
//!
//! ```
//! use chordal_geometry::{Curve, Line, Vec3};
//! use chordal_motion::{
//!     AxisLimit, CornerMode, PlannerLevel, KinematicLimits, MoveRequest, MoveKind, MotionPlanner, PlannerOptions, SetpointSampler,
//! };
//!
//! let axis = Some(AxisLimit { velocity: 400.0, acceleration: 3000.0, jerk: 100_000.0 });
//! let limits = KinematicLimits::new([axis, axis, axis, None, None, None]).unwrap();
//! let mut planner = MotionPlanner::new(limits, PlannerOptions::new(PlannerLevel::Fast));
//! let mut sampler = SetpointSampler::new(0.001);
//! let mut last = None;
//! let line = MoveRequest {
//!     curve: Curve::Line(Line { start: Vec3::new(0.0, 0.0, 0.0), end: Vec3::new(50.0, 0.0, 0.0) }),
//!     rotary_from: [0.0; 3],
//!     rotary_to: [0.0; 3], path_length: None,
//!     speed: 100.0,
//!     corner: CornerMode::Stop,
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

mod corner_blend;
mod cube_root;
mod cursor;
mod curve_fit;
mod curve_planner;
mod junction_planner;
mod limit_use;
mod limits;
mod move_request;
mod path_limits;
mod piece;
mod planner;
mod profile_solver;
mod ramp_profile;
mod reader;
mod reference;
mod sample;
mod sampler;
mod stream;
mod time_bound;
mod trajectory;
mod tuning;

pub use corner_blend::path_span::{PathPart, PathSpan};
pub use cursor::TrajectoryCursor;
pub use junction_planner::{ArcSegmentLengths, JunctionRule};
pub use limit_use::{LimitUse, largest_use};
pub use limits::{AxisLimit, KinematicLimits, LimitError, LimitedQuantity};
pub use move_request::{CornerMode, MoveError, MoveKind, MoveRequest};
pub use piece::{AxisJet, PathPiece};
pub use planner::{MotionPlanner, PlannerLevel, PlannerOptions};
pub use profile_solver::{SolverWork, solve_profile};
pub use reference::{
    LeastTimeGauge, LeastTimes, ReferenceError, ReferenceProfile, ReferenceQuality, RunTimes,
    reference,
};
pub use sample::{AxisState, MotionSample};
pub use sampler::SetpointSampler;
pub use stream::{
    FeederError, PushOutcome, ServoSetpoint, StreamFeeder, StreamOptions, StreamServo, stream,
};
pub use time_bound::{PathRun, PathRunError, TimeBound, time_bound};
pub use trajectory::{JerkPhase, PlannedTrajectory, PlannerStep, ProfilePoint};

/// A value for each axis X Y Z A B C, in mm and rad or their derivatives.
pub type AxisValues = chordal_geometry::PerAxis<f64>;

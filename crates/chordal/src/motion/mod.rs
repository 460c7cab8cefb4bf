//! Turns a run into the input of a motion planner: moves that join on to each other, and waits.
//!
//! ```text
//! tool-centre path ── MotionBuilder ──▶ MotionStep ── Planner ──▶ Step
//! ```
//!
//! [`Job::motion`](crate::Job::motion) emits the moves with their speeds and corners;
//! [`Job::plan`](crate::Job::plan) also plans them. Both stream: a step is emitted as soon as
//! the one after it is known.
//!
//! # The frame of the moves
//!
//! A planner needs moves of the machine: each begins where the one before ends. Program coordinates jump where a work
//! offset, a tool length or G92 changes. Every move is therefore shifted so that it joins on; the shift is zero until
//! the first jump and is reported with each step ([`StepSource::shift`]): position − shift gives the coordinates of
//! [`Job::path`](crate::Job::path). Where the machine file does not give an offset, the true position of the axis is
//! not known; such moves are planned as if the offset were zero and are counted ([`MotionReport::unknown_moves`]).
//!
//! # Corners
//!
//! What happens at the end of a move is decided by the active path mode at its block and by the
//! rules of the control ([`PathRules`](crate::control::PathRules)); see `corner.rs`.

mod builder;
mod corner;
mod limits;
mod operations;
mod options;
mod plan;
mod run;
mod setpoints;
mod steps;

pub use chordal_motion::{
    AxisJet, AxisLimit, AxisState, AxisValues, CornerMode, JerkPhase, KinematicLimits, LimitError,
    LimitedQuantity, MotionPlanner, MotionSample, MoveError, MoveKind, MoveRequest, PathPart,
    PathPiece, PathSpan, PlannedTrajectory, PlannerLevel, PlannerOptions, PlannerStep,
    ProfilePoint, SetpointSampler, TrajectoryCursor,
};

pub use limits::{AssumedLimit, MachineLimits};
pub use operations::{OperationMark, OperationStart};
pub use options::MotionOptions;
pub use plan::{PlanSink, StepSources};
pub use setpoints::{SamplingError, SamplingReport, SamplingRequest};
pub use steps::{
    MotionReport, MotionSink, MotionStep, MotionWait, PlacedPartFrame, RefusedMove, StepKind,
    StepSource, UnknownAxes, WaitKind,
};

pub(crate) use builder::MotionBuilder;
pub(crate) use plan::{PlanObserver, PlanningSink, SourcedSink};

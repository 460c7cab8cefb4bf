//! The time of a program: how long it takes, where the time goes and why.
//!
//! | what | file |
//! |---|---|
//! | which move a trajectory is in at which time | `trajectory_parts.rs` |
//! | moves and steps to a report | `builder.rs`, `report.rs` |
//! | why a move is not faster | `reason.rs` |
//! | the blocks that cost the most | `blocks.rs` |
//! | a job that is timed | `timed_run.rs` |
//! | the least time it could take | `least_time.rs` |
//! | the same with other overrides and path modes | `what_if.rs` |
//! | all questions about the time at once | `time_study.rs` |
//! | what short lines cost, and what would change that | `chords.rs` |
//! | limits from measured times | `calibration.rs` |

mod blocks;
mod builder;
mod calibration;
mod chords;
mod least_time;
mod reason;
mod report;
mod time_study;
mod timed_run;
mod trajectory_parts;
mod what_if;

pub use builder::TimeBuilder;
pub use calibration::{
    FitParameter, FittedProgram, LimitFactors, LimitFit, TimePrediction, UnfitReason, fit,
};
pub use chordal_motion::{LeastTimes, ReferenceQuality};
pub use chords::{ChordCost, ChordRemedy};
pub use least_time::LeastReport;
pub use report::{BlockTime, CutEnds, OperationTime, TimeReason, TimeReport, TimeShares, ToolTime};
pub use time_study::{RepeatPlanning, TimeQuestion, TimeStudy, max_summarized_moves};
pub use timed_run::TimedRun;
pub use what_if::{PlanningChange, TimeAlternative};

//! Time for people: how long a program takes, where the time goes and why.
//!
//! | what | file |
//! |---|---|
//! | which move is under way when | `walk.rs` |
//! | moves and steps to a report | `builder.rs`, `report.rs` |
//! | why a move is not faster | `reason.rs` |
//! | the blocks that cost the most | `blocks.rs` |
//! | a job that is timed | `run.rs` |
//! | the least time it could take | `least.rs` |
//! | the same with other overrides and path modes | `what_if.rs` |
//! | all that is asked about the time at once | `study.rs` |
//! | what short lines cost, and what would change that | `chords.rs` |
//! | limits from measured times | `calibrate.rs` |

mod blocks;
mod builder;
mod calibrate;
mod chords;
mod least;
mod reason;
mod report;
mod run;
mod study;
mod walk;
mod what_if;

pub use builder::TimeBuilder;
pub use calibrate::{Factors, Fit, Fitted, Parameter, Prediction, Untold, fit};
pub use chordal_motion::{Effort, Least};
pub use chords::{ChordCost, Remedy};
pub use least::LeastReport;
pub use report::{BlockTime, CutEnds, OperationTime, Reason, TimeReport, Times, ToolTime};
pub use run::Timed;
pub use study::{Again, TimeQuestion, TimeStudy, most_summarized};
pub use what_if::{Alternative, Change};

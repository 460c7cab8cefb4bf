//! Programs of lathes on stock: the exact half section after every pass.
//!
//! [`Job::turned_stock`](crate::Job::turned_stock) answers what [`Job::stock`](crate::Job::stock) answers for
//! mills. What a tool leaves is a region of lines and arcs, so volumes have no bounds but where threads are cut.

mod approach_check;
mod bodies;
mod contour;
mod cut;
mod gather;
mod grooves;
mod helix;
mod load;
mod nose;
mod problems;
mod recorder;
mod replay;
mod report;
mod run;
mod target;
mod threads;
mod tools;

pub use approach_check::{ApproachCheck, ApproachHit};
pub use replay::{TurnedPiece, TurnedReplay, TurnedShape};
pub use report::{
    CutOffPart, SegmentOrigin, TurnedMove, TurnedReport, TurnedTarget, TurnedThread,
    TurnedToolRemoved,
};
pub use run::TurnedOptions;

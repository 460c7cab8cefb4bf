//! Lathe programs on stock: the exact half section after every pass.
//!
//! [`Job::turned_stock`](crate::Job::turned_stock) is for lathes what [`Job::stock`](crate::Job::stock) is for mills.
//! What a tool leaves is a region of lines and arcs, so volumes are exact, except where threads are cut: there they
//! have bounds.

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

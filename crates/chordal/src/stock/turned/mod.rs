//! Programs of lathes on stock: the exact half section after every pass.
//!
//! [`Job::turned_stock`](crate::Job::turned_stock) answers what [`Job::stock`](crate::Job::stock) answers for
//! mills. What a tool leaves is a region of lines and arcs, so volumes have no bounds but where threads are cut.

mod bodies;
mod contour;
mod cut;
mod gather;
mod grooves;
mod helix;
mod load;
mod nose;
mod recorder;
mod replay;
mod report;
mod run;
mod said;
mod target;
mod threads;
mod tools;
mod way_in;

pub use replay::{TurnedPiece, TurnedReplay, TurnedShape};
pub use report::{
    CutOffPart, SegmentOrigin, TurnedMove, TurnedReport, TurnedTarget, TurnedThread,
    TurnedToolRemoved,
};
pub use run::TurnedOptions;
pub use way_in::{WayHit, WayIn};

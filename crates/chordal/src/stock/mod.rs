//! Programs on stock: what is left, what the tool touches, and how certain that is.
//!
//! [`Job::stock`](crate::Job::stock) runs a program on the stock of its machine's setup. Every result is an interval
//! between two bounds, and the verdict is "clean" only where the bounds prove it.

mod earlier_side;
mod engagement;
mod fixtures;
mod gather;
mod heights;
mod inside;
mod lathe;
mod left;
mod outline;
mod pass;
mod passed_heights;
mod premise;
mod problems;
mod removal;
mod replay;
mod report;
mod run;
mod setup;
mod sides;
mod solid;
mod solid_intervals;
mod target;
mod teeth;
mod tools;
mod turning_bodies;
mod turns;

pub use chordal_stock::columns::{JobResult, JobRunner, TileJob};
pub use chordal_stock::mesh;
pub use chordal_stock::{CellHeights, ColumnStock, StockError, VolumeInterval};
pub use engagement::{
    BoundedValue, ChipThickness, CuttingLoad, EngagementOptions, EngagementProblem,
    EngagementReport, EngagementSlice, LoadPeak, MATERIALS, MaterialData, MaterialGroup,
    MoveEngagement, NoMaterial, POWER_SHARE, ToolEngagement, engagement_angle,
};
pub use lathe::{
    ApproachCheck, ApproachHit, CutOffPart, SegmentOrigin, TurnedMove, TurnedOptions, TurnedPiece,
    TurnedReplay, TurnedReport, TurnedShape, TurnedTarget, TurnedThread, TurnedToolRemoved,
};
pub use left::{StockLeft, ToolRemoves};
pub(crate) use outline::{ToolFrustums, ToolPart, tool_outlines};
pub use pass::StockOptions;
pub use problems::StockProblem;
pub use replay::{
    ColumnDrop, FixtureMesh, GapChange, ReplayOmissions, ReplayOptions, ReplaySink, StockBefore,
};
pub use report::{StockReport, StockVerdict, ToolRemoved};
pub use run::StockRunError;
pub(crate) use setup::body_bounds;
pub use setup::{SetupError, SetupFileReader};
pub use target::TargetReport;
/// Half sections: the outlines of turned parts.
pub mod section {
    pub use chordal_stock::lathe::{OutlineSegment, PlaceSide, Region, SegmentArc};
}

//! How hard tools work: width and depth of cut, chip, removal rate, power and torque of every move.
//!
//! | what | file |
//! |---|---|
//! | materials and the force on a chip | `materials.rs` |
//! | one move after the other on the stock | `run.rs` |
//! | a move, a tool, a problem | `report.rs` |
//! | what a tool does for most of its time | `typical.rs` |
//! | chips too thick, too thin, too much power | `limits.rs` |

mod limits;
mod materials;
mod report;
mod run;
mod typical;

pub use chordal_stock::engagement::{BoundedValue, EngagementSlice, engagement_angle};
pub use materials::{MATERIALS, MaterialData, MaterialGroup, NoMaterial, POWER_SHARE};
pub use report::{
    ChipThickness, CuttingLoad, EngagementProblem, EngagementReport, LoadPeak, MoveEngagement,
    ToolEngagement,
};
pub use run::EngagementOptions;

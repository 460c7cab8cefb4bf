//! The load on tools: width and depth of cut, chip thickness, removal rate, power and torque of every move.
//!
//! | what | file |
//! |---|---|
//! | materials and their specific cutting force | `materials.rs` |
//! | the measurement of each move on the stock | `run.rs` |
//! | the results by move and by tool, and the problems | `report.rs` |
//! | medians by time | `typical.rs` |
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

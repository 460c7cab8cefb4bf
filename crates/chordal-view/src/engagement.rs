//! The cutting loads of a run as columns, for the timeline.

use chordal::diagnostics::Code;
use chordal::stock::{EngagementOptions, EngagementReport, MoveEngagement};
use serde_json::json;

use crate::frame::ColumnFrame;

/// With more path segments the loads are not computed, because it would take minutes.
pub const MAX_ROWS: u64 = 300_000;

/// The options of a page: the defaults, as for the command.
pub fn options() -> EngagementOptions {
    EngagementOptions::default()
}

/// The number of a problem in the columns: 0 none, 1 chip too thick, 2 tool rubs, 3 spindle overloaded.
fn problem(code: Option<Code>) -> u8 {
    match code {
        None => 0,
        Some(Code::ToolRubs) => 2,
        Some(Code::SpindleOverloaded) => 3,
        Some(_) => 1,
    }
}

/// The frame with the loads of the moves that cut; -1 is an unknown value.
pub fn frame(run: u64, found: &EngagementReport) -> Vec<u8> {
    let cuts: Vec<&MoveEngagement> =
        found.moves.iter().filter(|each| each.across_mm.most > 0.0).collect();
    let column = |of: &dyn Fn(&MoveEngagement) -> f64| -> Vec<f32> {
        cuts.iter().map(|each| of(each) as f32).collect()
    };
    let mut frame = ColumnFrame::default();
    let rows: Vec<u32> = cuts.iter().map(|each| each.row).collect();
    let problems: Vec<u8> = cuts.iter().map(|each| problem(each.problem)).collect();
    frame.column("row", &rows);
    frame.column("radial", &column(&|each| each.across_mm.most));
    frame.column("chip", &column(&|each| each.chip.map_or(-1.0, |chip| chip.peak_mm.most)));
    frame.column("power", &column(&|each| each.effort.map_or(-1.0, |effort| effort.power_kw)));
    frame.column("problem", &problems);
    frame.finish(json!({
        "type": "engagement",
        "run": run,
        "resolution_mm": found.resolution_mm,
        "whole": found.is_whole,
    }))
}

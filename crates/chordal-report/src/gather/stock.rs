//! What is left of the stock, as data.

use chordal::stock::{CutOffPart, StockLeft, VolumeInterval};
use chordal::time::TimeReport;
use chordal_export::{stock_verdict_text, turned_verdict_text};

use crate::data::{CappedRows, ReportedStock, StockPart, StockTool, VolumeBounds};

/// Tools that are listed.
const MAX_TOOLS: usize = 100;
/// Parts that were cut off that are listed.
const MAX_PARTS: usize = 50;

/// What a run on stock answers, with the times of the tools where the run was planned.
pub fn stock(found: &StockLeft, time: Option<&TimeReport>) -> ReportedStock {
    let volume = |amount: VolumeInterval| VolumeBounds { least: amount.least, most: amount.most };
    let time_of = |number: u32| {
        let own = time?.tools.iter().find(|tool| tool.number == number)?;
        Some(own.times.total_s())
    };
    let [removed, left] = found.volumes_mm3();
    let all = found.tools();
    let tools = all.iter().take(MAX_TOOLS).map(|tool| StockTool {
        number: tool.number,
        removed_mm3: volume(tool.removed_mm3),
        lowest_mm: tool.lowest_mm,
        time_s: time_of(tool.number),
    });
    ReportedStock {
        resolution_mm: found.resolution_mm(),
        removed_mm3: volume(removed),
        left_mm3: volume(left),
        verdict: found.verdict().as_str(),
        sentence: match found {
            StockLeft::Columns(found) => stock_verdict_text(found.verdict),
            StockLeft::Section(found) => turned_verdict_text(found.verdict),
        },
        parts: parts(found),
        tools: CappedRows {
            rows: tools.collect(),
            left_out: all.len().saturating_sub(MAX_TOOLS) as u64,
        },
    }
}

/// What was cut off on a lathe.
fn parts(found: &StockLeft) -> CappedRows<StockPart> {
    let loose = match found {
        StockLeft::Columns(_) => &[][..],
        StockLeft::Section(found) => &found.loose,
    };
    let parts = loose.iter().take(MAX_PARTS);
    let part = |part: &CutOffPart| StockPart { line: part.line, volume_mm3: part.section.volume() };
    CappedRows {
        rows: parts.map(part).collect(),
        left_out: loose.len().saturating_sub(MAX_PARTS) as u64,
    }
}

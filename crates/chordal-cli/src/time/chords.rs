//! What short lines cost, and what would make them quicker.

use chordal::Job;
use chordal::control::{ShortBlocks, Units as ProgramUnits};
use chordal::time::{ChordCost, ChordRemedy};
use comfy_table::Table;

use super::cells::fine;
use crate::numbers::short;
use crate::summary::{plain_table, tool_name};

/// Titles of the tables.
pub const LINES: &str = "short lines, one after the other";
pub const REMEDIES: &str = "what would make the short lines quicker";

/// The short lines of each tool.
pub fn lines(costs: &[ChordCost], job: &Job, units: ProgramUnits) -> Table {
    let header = ["tool", "lines", "each about", "time", "at the feed"];
    let mut table = plain_table(&header, 1);
    for cost in costs {
        table.add_row([
            tool_name(cost.tool, job),
            cost.lines.to_string(),
            units.length_text(rounded(cost.length_mm / cost.lines as f64)),
            fine(cost.time_s),
            fine(cost.feed_s),
        ]);
    }
    table
}

/// What would change them.
pub fn remedies(costs: &[ChordCost], job: &Job, units: ProgramUnits) -> Table {
    let mut table = plain_table(&["tool", "saves", "with"], 1);
    if let Some(column) = table.column_mut(2) {
        column.set_cell_alignment(comfy_table::CellAlignment::Left);
    }
    for cost in costs {
        for (remedy, saved) in &cost.savings {
            let what = remedy_text(remedy, cost, job, units);
            table.add_row([tool_name(cost.tool, job), fine(*saved), what]);
        }
    }
    table
}

fn remedy_text(remedy: &ChordRemedy, cost: &ChordCost, job: &Job, units: ProgramUnits) -> String {
    match *remedy {
        ChordRemedy::Joined => match job.rules().path.short_blocks {
            ShortBlocks::LookAhead => "look-ahead on: this control then joins short blocks".into(),
            _ => "a control that joins short blocks".into(),
        },
        ChordRemedy::Tolerance(mm) => format!(
            "a tolerance of {} (it is {})",
            units.length_text(mm),
            units.length_text(rounded(cost.tolerance_mm))
        ),
        ChordRemedy::Decimals(decimals) => format!(
            "{decimals} decimals: the corners that rounding to {} makes are gone",
            decimals - 1
        ),
        ChordRemedy::Finer(mm) => format!(
            "shorter lines: within {} of the curve through their ends",
            units.length_text(rounded(mm))
        ),
        ChordRemedy::Arcs { within_mm, pieces } => format!(
            "{pieces} arcs and lines within {} (chordal transform --fit)",
            units.length_text(rounded(within_mm))
        ),
    }
}

/// Three figures are enough.
fn rounded(mm: f64) -> f64 {
    let digits = 2 - mm.abs().max(1e-9).log10().floor() as i32;
    short(mm, digits.clamp(0, 9) as usize).parse().unwrap_or(mm)
}

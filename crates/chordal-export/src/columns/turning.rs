//! What every move of a lathe takes, as columns.

use chordal::control::Origin;
use chordal::stock::TurnedMove;

use super::moves::{CuttingMoveData, NumberSpec, number};

/// Name and version of the columns of turning.
pub const TURNING_COLUMNS: &str = "chordal.turning-columns/1";

/// Every number of a move.
const NUMBERS: [NumberSpec<TurnedMove>; 11] = [
    number("length_mm", "mm", "length of the move", |each| Some(each.length_mm)),
    number("engaged_mm", "mm", "how far the cut extends along the feed", |each| {
        Some(each.engaged_mm)
    }),
    number("feed_mm_per_min", "mm/min", "the programmed feed, if it is known", |each| {
        (each.feed_mm_per_s > 0.0).then_some(each.feed_mm_per_s * 60.0)
    }),
    number("spindle_rpm", "rpm", "mean speed of the spindle", |each| Some(each.rpm)),
    number("depth_mm", "mm", "depth of cut: how far the cut extends across the feed", |each| {
        Some(each.depth_mm)
    }),
    number("area_mm2", "mm²", "removed from the half section", |each| Some(each.area_mm2)),
    number("removed_mm3", "mm³", "removed; of a thread at most", |each| Some(each.removed_mm3)),
    number(
        "chip_mm2",
        "mm²",
        "mean area of the chip: mean depth by feed of a revolution",
        |each| each.chip_mm2,
    ),
    number("chip_mm", "mm", "thickness of the chip", |each| each.chip_mm),
    number("rate_mm3_per_min", "mm³/min", "removal rate in material", |each| {
        Some(each.rate_mm3_per_s * 60.0)
    }),
    number("power_kw", "kW", "power, an estimate to 30 %", |each| each.power_kw),
];

impl CuttingMoveData for TurnedMove {
    const COLUMNS: &'static str = TURNING_COLUMNS;
    const NUMBERS: &'static [NumberSpec<TurnedMove>] = &NUMBERS;

    fn origin(&self) -> Origin {
        self.origin
    }

    fn tool(&self) -> u32 {
        self.tool
    }
}

//! What every move of a lathe takes, as columns and as comma-separated text.

use std::fmt;
use std::io::{self, Write};

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};
use chordal::Job;
use chordal::stock::{TurnedMove, TurnedReport};

use super::field::Column;
use super::file::Rows;
use super::moves::{self, MoveColumns, Number, number};

/// Name and version of the columns of turning.
pub const TURNING_COLUMNS: &str = "chordal.turning-columns/1";

/// Every number of a move.
const NUMBERS: [Number<TurnedMove>; 11] = [
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

pub(super) fn columns() -> Vec<Column> {
    moves::columns(&NUMBERS)
}

/// Gathers moves, one row each.
pub struct TurningColumns<'a>(MoveColumns<'a, TurnedMove>);

impl fmt::Debug for TurningColumns<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TurningColumns").field("rows", &self.0.rows()).finish_non_exhaustive()
    }
}

impl<'a> TurningColumns<'a> {
    /// Columns for the cuts of a job.
    pub fn new(job: &'a Job<'a>) -> TurningColumns<'a> {
        TurningColumns(MoveColumns::new(job, TURNING_COLUMNS, &NUMBERS))
    }

    /// Takes a move.
    pub fn cut(&mut self, each: &TurnedMove) {
        self.0.put(each.origin, each.tool, each);
    }
}

impl Rows for TurningColumns<'_> {
    fn rows(&self) -> usize {
        self.0.rows()
    }

    fn schema(&self) -> &SchemaRef {
        self.0.schema()
    }

    fn take(&mut self) -> Result<RecordBatch, ArrowError> {
        self.0.take()
    }
}

/// Writes the same as comma-separated text, with the names of the columns first; a gap is empty.
///
/// # Errors
/// Those of the output.
pub fn turning_csv(out: impl Write, job: &Job<'_>, found: &TurnedReport) -> io::Result<()> {
    let moves = found.moves.iter().map(|each| (each.origin, each.tool, each));
    moves::csv(out, job, &NUMBERS, moves)
}

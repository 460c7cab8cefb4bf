//! Engagement of moves as columns, and as comma-separated text.

use std::fmt;
use std::io::{self, Write};

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};
use chordal::Job;
use chordal::stock::{EngagementReport, MoveEngagement};

use super::field::Column;
use super::file::Rows;
use super::moves::{self, MoveColumns, Number, number};

/// Name and version of the columns of engagement.
pub const ENGAGEMENT_COLUMNS: &str = "chordal.engagement-columns/1";

/// Every number of a move.
const NUMBERS: [Number<MoveEngagement>; 19] = [
    number("length_mm", "mm", "length of the move", |each| Some(each.length_mm)),
    number("engaged_mm", "mm", "how long the tool may be in material", |each| {
        Some(each.engaged_mm)
    }),
    number("feed_mm_per_min", "mm/min", "the programmed feed, if it is known", |each| {
        (each.feed_mm_per_s > 0.0).then_some(each.feed_mm_per_s * 60.0)
    }),
    number("spindle_rpm", "rpm", "speed of the spindle", |each| Some(each.rpm)),
    number("radial_depth_least_mm", "mm", "radial depth of cut, at least", |each| {
        Some(each.across_mm.least)
    }),
    number("radial_depth_most_mm", "mm", "radial depth of cut, at most", |each| {
        Some(each.across_mm.most)
    }),
    number("axial_depth_least_mm", "mm", "axial depth of cut, at least", |each| {
        Some(each.axial_mm.least)
    }),
    number("axial_depth_most_mm", "mm", "axial depth of cut, at most", |each| {
        Some(each.axial_mm.most)
    }),
    number("angle_least_deg", "deg", "angle of engagement, at least", |each| {
        Some(each.angle_rad.least.to_degrees())
    }),
    number("angle_most_deg", "deg", "angle of engagement, at most", |each| {
        Some(each.angle_rad.most.to_degrees())
    }),
    number("facing_most", "", "the thickest chip by the feed of a tooth, at most", |each| {
        Some(each.facing.most)
    }),
    number("chip_least_mm", "mm", "the thickest chip, at least", |each| {
        Some(each.chip?.peak_mm.least)
    }),
    number("chip_most_mm", "mm", "the thickest chip, at most", |each| {
        Some(each.chip?.peak_mm.most)
    }),
    number("chip_mean_mm", "mm", "the mean chip where most is removed", |each| {
        Some(each.chip?.mean_mm)
    }),
    number("removed_mm3", "mm³", "removed, by the middle of the bounds", |each| {
        Some(each.removed_mm3)
    }),
    number("rate_mm3_per_min", "mm³/min", "largest removal rate, by the middle", |each| {
        Some(each.rate_mm3_per_s * 60.0)
    }),
    number("rate_most_mm3_per_min", "mm³/min", "largest removal rate, at most", |each| {
        Some(each.most_rate_mm3_per_s * 60.0)
    }),
    number("power_kw", "kW", "power, an estimate to 30 %", |each| Some(each.effort?.power_kw)),
    number("torque_nm", "N·m", "torque, an estimate to 30 %", |each| Some(each.effort?.torque_nm)),
];

pub(super) fn columns() -> Vec<Column> {
    moves::columns(&NUMBERS)
}

/// Gathers moves, one row each.
pub struct EngagementColumns<'a>(MoveColumns<'a, MoveEngagement>);

impl fmt::Debug for EngagementColumns<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("EngagementColumns").field("rows", &self.0.rows()).finish_non_exhaustive()
    }
}

impl<'a> EngagementColumns<'a> {
    /// Columns for the cuts of a job.
    pub fn new(job: &'a Job<'a>) -> EngagementColumns<'a> {
        EngagementColumns(MoveColumns::new(job, ENGAGEMENT_COLUMNS, &NUMBERS))
    }

    /// Takes a move.
    pub fn cut(&mut self, each: &MoveEngagement) {
        self.0.put(each.origin, each.tool, each);
    }
}

impl Rows for EngagementColumns<'_> {
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
pub fn engagement_csv(out: impl Write, job: &Job<'_>, found: &EngagementReport) -> io::Result<()> {
    let moves = found.moves.iter().map(|each| (each.origin, each.tool, each));
    moves::csv(out, job, &NUMBERS, moves)
}

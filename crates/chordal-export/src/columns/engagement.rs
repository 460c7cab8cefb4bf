//! Engagement of moves as columns, and as comma-separated text.

use std::io::{self, Write};

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};
use chordal::Job;
use chordal::diagnostics::FileId;
use chordal::stock::{EngagementReport, MoveEngagement};

use super::cells::{Files, Integers, Numbers};
use super::field::{Cell, Column, schema};
use super::file::Rows;

/// Name and version of the columns of engagement.
pub const ENGAGEMENT_COLUMNS: &str = "chordal.engagement-columns/1";

/// A column of numbers: its name, its unit, what it means, its value.
struct Row {
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&MoveEngagement) -> Option<f64>,
}

const fn row(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&MoveEngagement) -> Option<f64>,
) -> Row {
    Row { name, unit, meaning, value }
}

/// Every number of a move.
const NUMBERS: [Row; 19] = [
    row("length_mm", "mm", "length of the move", |each| Some(each.length_mm)),
    row("engaged_mm", "mm", "how long the tool may be in material", |each| Some(each.engaged_mm)),
    row("feed_mm_per_min", "mm/min", "the programmed feed, if it is known", |each| {
        (each.feed_mm_per_s > 0.0).then_some(each.feed_mm_per_s * 60.0)
    }),
    row("spindle_rpm", "rpm", "speed of the spindle", |each| Some(each.rpm)),
    row("radial_depth_least_mm", "mm", "radial depth of cut, at least", |each| {
        Some(each.across_mm.least)
    }),
    row("radial_depth_most_mm", "mm", "radial depth of cut, at most", |each| {
        Some(each.across_mm.most)
    }),
    row("axial_depth_least_mm", "mm", "axial depth of cut, at least", |each| {
        Some(each.axial_mm.least)
    }),
    row("axial_depth_most_mm", "mm", "axial depth of cut, at most", |each| {
        Some(each.axial_mm.most)
    }),
    row("angle_least_deg", "deg", "angle of engagement, at least", |each| {
        Some(each.angle_rad.least.to_degrees())
    }),
    row("angle_most_deg", "deg", "angle of engagement, at most", |each| {
        Some(each.angle_rad.most.to_degrees())
    }),
    row("facing_most", "", "the thickest chip by the feed of a tooth, at most", |each| {
        Some(each.facing.most)
    }),
    row("chip_least_mm", "mm", "the thickest chip, at least", |each| {
        Some(each.chip?.peak_mm.least)
    }),
    row("chip_most_mm", "mm", "the thickest chip, at most", |each| Some(each.chip?.peak_mm.most)),
    row("chip_mean_mm", "mm", "the mean chip where most is removed", |each| {
        Some(each.chip?.mean_mm)
    }),
    row("removed_mm3", "mm³", "removed, by the middle of the bounds", |each| {
        Some(each.removed_mm3)
    }),
    row("rate_mm3_per_min", "mm³/min", "largest removal rate, by the middle", |each| {
        Some(each.rate_mm3_per_s * 60.0)
    }),
    row("rate_most_mm3_per_min", "mm³/min", "largest removal rate, at most", |each| {
        Some(each.most_rate_mm3_per_s * 60.0)
    }),
    row("power_kw", "kW", "power, an estimate to 30 %", |each| Some(each.effort?.power_kw)),
    row("torque_nm", "N·m", "torque, an estimate to 30 %", |each| Some(each.effort?.torque_nm)),
];

pub(super) fn columns() -> Vec<Column> {
    let mut columns = vec![
        Column::new("line", Cell::Integer, "", "line of the block, from 1"),
        Column::new("file", Cell::File, "", "the text that the block is in"),
        Column::new("tool", Cell::Integer, "", "the tool in the spindle"),
    ];
    columns.extend(
        NUMBERS.iter().map(|row| Column::new(row.name, Cell::NumberOrGap, row.unit, row.meaning)),
    );
    columns
}

/// Gathers moves, one row each.
#[derive(Debug)]
pub struct EngagementColumns<'a> {
    schema: SchemaRef,
    rows: usize,
    line: Integers,
    file: Files<'a>,
    tool: Integers,
    numbers: Vec<Numbers>,
}

impl<'a> EngagementColumns<'a> {
    /// Columns for the cuts of a job.
    pub fn new(job: &'a Job<'a>) -> EngagementColumns<'a> {
        EngagementColumns {
            schema: schema(job, ENGAGEMENT_COLUMNS, &columns(), &[]),
            rows: 0,
            line: Integers::new(),
            file: Files::of(job),
            tool: Integers::new(),
            numbers: NUMBERS.iter().map(|_| Numbers::new()).collect(),
        }
    }

    /// Takes a move.
    pub fn cut(&mut self, each: &MoveEngagement) {
        let row = self.rows;
        self.line.put(row, each.origin.line);
        self.file.push(each.origin.span.file);
        self.tool.put(row, each.tool);
        for (column, number) in self.numbers.iter_mut().zip(&NUMBERS) {
            if let Some(value) = (number.value)(each) {
                column.put(row, value);
            }
        }
        self.rows += 1;
    }
}

impl Rows for EngagementColumns<'_> {
    fn rows(&self) -> usize {
        self.rows
    }

    fn schema(&self) -> &SchemaRef {
        &self.schema
    }

    fn take(&mut self) -> Result<RecordBatch, ArrowError> {
        let rows = std::mem::take(&mut self.rows);
        let mut arrays = vec![self.line.take(rows), self.file.take()?, self.tool.take(rows)];
        arrays.extend(self.numbers.iter_mut().map(|column| column.take(rows)));
        RecordBatch::try_new(self.schema.clone(), arrays)
    }
}

/// Writes the same as comma-separated text, with the names of the columns first; a gap is empty.
///
/// # Errors
/// Those of the output.
pub fn engagement_csv(
    mut out: impl Write,
    job: &Job<'_>,
    found: &EngagementReport,
) -> io::Result<()> {
    let names: Vec<String> = columns().into_iter().map(|column| column.name).collect();
    writeln!(out, "{}", names.join(","))?;
    let file = |id: FileId| {
        let name = job.sources().get(id).map_or("", |source| source.name());
        let is_plain = !name.contains([',', '"', '\n', '\r']);
        if is_plain { name.to_string() } else { format!("\"{}\"", name.replace('"', "\"\"")) }
    };
    for each in &found.moves {
        write!(out, "{},{},{}", each.origin.line, file(each.origin.span.file), each.tool)?;
        for number in &NUMBERS {
            match (number.value)(each) {
                Some(value) => write!(out, ",{value}")?,
                None => write!(out, ",")?,
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

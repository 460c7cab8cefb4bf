//! The half section that a program of a lathe leaves, as columns: one row a line or an arc.

use arrow_array::RecordBatch;
use arrow_schema::ArrowError;
use chordal::Job;
use chordal::stock::TurnedReport;

use super::cells::{FlagColumn, IntegerColumn, NumberColumn, WordColumn};
use super::field::{CellType, Column, schema};

/// Name and version of the columns of half sections.
pub const SECTION_COLUMNS: &str = "chordal.section-columns/1";

const KINDS: &[&str] = &["line", "arc"];

/// Name, unit and meaning of the numbers: those of arcs alone are gaps in lines.
const NUMBERS: [(&str, CellType, &str, &str); 8] = [
    ("z_from_mm", CellType::Number, "mm", "start along the axis"),
    ("r_from_mm", CellType::Number, "mm", "start, distance from the axis: a radius"),
    ("z_to_mm", CellType::Number, "mm", "end along the axis"),
    ("r_to_mm", CellType::Number, "mm", "end, a radius"),
    ("z_center_mm", CellType::NumberOrGap, "mm", "centre of an arc along the axis"),
    ("r_center_mm", CellType::NumberOrGap, "mm", "centre of an arc, distance from the axis"),
    ("radius_mm", CellType::NumberOrGap, "mm", "radius of an arc"),
    (
        "sweep_deg",
        CellType::NumberOrGap,
        "deg",
        "angle of an arc, positive from z towards the radius",
    ),
];

pub(super) fn columns() -> Vec<Column> {
    let mut columns = vec![
        Column::new(
            "part",
            CellType::Integer,
            "",
            "0 is in the chuck, 1 is the first that was cut off",
        ),
        Column::new(
            "loop",
            CellType::Integer,
            "",
            "loop of the part, from 0; the material is to its left",
        ),
        Column::new("kind", CellType::Word, "", "line or arc"),
        Column::new("tool", CellType::Integer, "", "the tool that made it; 0 is the stock"),
        Column::new("line", CellType::IntegerOrGap, "", "line of the block that made it"),
        Column::new("is_axis", CellType::Flag, "", "it lies on the axis: no surface"),
    ];
    columns.extend(
        NUMBERS.iter().map(|(name, cell, unit, meaning)| Column::new(name, *cell, unit, meaning)),
    );
    columns
}

/// Everything that is left: in the chuck, and cut off.
///
/// # Errors
/// None that a half section could cause.
pub fn section_columns(job: &Job<'_>, found: &TurnedReport) -> Result<RecordBatch, ArrowError> {
    let mut rows = 0;
    let (mut part, mut number, mut kind) =
        (IntegerColumn::new(), IntegerColumn::new(), WordColumn::new(KINDS));
    let (mut tool, mut line, mut is_axis) =
        (IntegerColumn::new(), IntegerColumn::new(), FlagColumn::new());
    let mut numbers: [NumberColumn; 8] = std::array::from_fn(|_| NumberColumn::new());
    for (which, section) in (0..).zip(found.sections()) {
        for (at, outline) in (0..).zip(section.outline()) {
            for segment in outline {
                part.put(rows, which);
                number.put(rows, at);
                kind.put(rows, usize::from(segment.bend.is_some()));
                let made_by = found.made_by(&segment);
                tool.put(rows, made_by.map_or(0, |made_by| made_by.tool));
                if let Some(made_by) = made_by {
                    line.put(rows, made_by.line);
                }
                let (start, end) = (segment.start, segment.end);
                is_axis.put(rows, segment.bend.is_none() && start.b == 0.0 && end.b == 0.0);
                let ends = [start.a, start.b, end.a, end.b];
                let arc = segment.bend.map(|bend| {
                    [bend.center.a, bend.center.b, bend.radius, segment.sweep().to_degrees()]
                });
                let values = ends.into_iter().chain(arc.into_iter().flatten());
                for (column, value) in numbers.iter_mut().zip(values) {
                    column.put(rows, value);
                }
                rows += 1;
            }
        }
    }
    let mut arrays = vec![
        part.take(rows),
        number.take(rows),
        kind.take(rows)?,
        tool.take(rows),
        line.take(rows),
        is_axis.take(rows),
    ];
    arrays.extend(numbers.iter_mut().map(|column| column.take(rows)));
    RecordBatch::try_new(schema(job, SECTION_COLUMNS, &columns(), &[]), arrays)
}

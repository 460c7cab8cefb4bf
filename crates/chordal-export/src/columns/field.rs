//! What columns are called, what they mean and what a schema says about itself.

use std::collections::HashMap;
use std::sync::Arc;

use arrow_schema::{DataType, Field, Schema, SchemaRef};
use chordal::Job;
use chordal::control::AxisMask;
use chordal::diagnostics::FileId;

use crate::digest::sha256_hex;
use crate::motion::PositionScale;

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CellType {
    /// A double in every row.
    Number,
    /// A double, or a gap.
    NumberOrGap,
    /// A whole number in every row.
    Integer,
    /// A whole number, or a gap.
    IntegerOrGap,
    /// A word of a small set in every row.
    Word,
    /// A word, or a gap.
    WordOrGap,
    /// The name of a file in every row.
    File,
    /// Yes or no in every row.
    Flag,
    /// Yes, no, or a gap.
    FlagOrGap,
    /// Text, or a gap.
    TextOrGap,
}

impl CellType {
    pub fn data_type(self) -> DataType {
        let words = |key| DataType::Dictionary(Box::new(key), Box::new(DataType::Utf8));
        match self {
            CellType::Number | CellType::NumberOrGap => DataType::Float64,
            CellType::Integer | CellType::IntegerOrGap => DataType::UInt32,
            CellType::Word | CellType::WordOrGap => words(DataType::Int8),
            CellType::File => words(DataType::Int16),
            CellType::Flag | CellType::FlagOrGap => DataType::Boolean,
            CellType::TextOrGap => DataType::Utf8,
        }
    }

    pub fn has_gaps(self) -> bool {
        use CellType::{FlagOrGap, IntegerOrGap, NumberOrGap, TextOrGap, WordOrGap};
        matches!(self, NumberOrGap | IntegerOrGap | WordOrGap | FlagOrGap | TextOrGap)
    }
}

/// A column: its name, what it holds, its unit (empty where it has none) and what it means.
#[derive(Clone, Debug)]
pub(super) struct Column {
    pub name: String,
    pub cell: CellType,
    pub unit: &'static str,
    pub meaning: String,
}

impl Column {
    pub fn new(name: &str, cell: CellType, unit: &'static str, meaning: &str) -> Column {
        Column { name: name.into(), cell, unit, meaning: meaning.into() }
    }

    fn field(&self) -> Field {
        let field = Field::new(&self.name, self.cell.data_type(), self.cell.has_gaps());
        match self.unit {
            "" => field,
            unit => field.with_metadata(HashMap::from([("unit".to_string(), unit.to_string())])),
        }
    }
}

/// The place of each axis, as `x_from_mm` or `a_from_deg`.
pub(super) fn places(axes: AxisMask, end: &str, cell: CellType, meaning: &str) -> Vec<Column> {
    let name = |axis: chordal::machine::Axis| {
        let unit = if axis.is_rotary() { "deg" } else { "mm" };
        let letter = axis.letter();
        let name = format!("{}_{end}_{unit}", letter.to_ascii_lowercase());
        Column { name, cell, unit, meaning: format!("{letter} {meaning}") }
    };
    axes.iter().map(name).collect()
}

/// X, Y, Z and the rotary axes that a machine has.
pub(super) fn axes_of(job: &Job) -> AxisMask {
    job.axes().and(AxisMask::ROTARY).or(AxisMask::LINEAR)
}

/// A value of an axis in mm or rad as its column has it.
#[inline]
pub(super) fn of_axis(axis: usize, value: f64) -> f64 {
    if axis < 3 { value } else { value.to_degrees() }
}

/// Columns and what they come from.
pub(super) fn schema(
    job: &Job,
    name: &str,
    columns: &[Column],
    more: &[(&str, String)],
) -> SchemaRef {
    let program = job.sources().get(FileId(0));
    let about = [
        ("program", program.map_or_else(String::new, |source| source.name().to_string())),
        ("program_sha256", sha256_hex(program.map_or(&[][..], |source| source.text()))),
        ("machine", job.machine().name.clone()),
        ("control", job.machine().control.as_str().to_string()),
    ];
    // A key of its own, so that nothing changes for a machine without diameters.
    let diameters = PositionScale::of(job).diameters();
    let diameters = (!diameters.is_empty()).then_some(("diameter", diameters));
    let more: Vec<_> = more.iter().cloned().chain(diameters).collect();
    schema_of(name, about, columns, &more)
}

/// The same where the program, its digest, the machine and the control are known otherwise.
pub(super) fn schema_of(
    name: &str,
    about: [(&str, String); 4],
    columns: &[Column],
    more: &[(&str, String)],
) -> SchemaRef {
    let own = [("schema", name.to_string()), ("version", env!("CARGO_PKG_VERSION").to_string())];
    let about = own.into_iter().chain(about).chain(more.iter().cloned());
    let metadata = about.map(|(key, value)| (format!("chordal.{key}"), value)).collect();
    let fields: Vec<Field> = columns.iter().map(Column::field).collect();
    Arc::new(Schema::new_with_metadata(fields, metadata))
}

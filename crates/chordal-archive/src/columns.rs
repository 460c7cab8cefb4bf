//! The columns of an archive's table.

use std::collections::HashMap;
use std::fmt::Write;
use std::sync::Arc;

use arrow_array::builder::{
    BooleanBuilder, Float64Builder, ListBuilder, StringBuilder, StructBuilder, UInt32Builder,
    UInt64Builder,
};
use arrow_array::{ArrayRef, RecordBatch};
use arrow_schema::{ArrowError, DataType, Field, Fields, Schema, SchemaRef};
use chordal_export::columns::RowBatcher;

use crate::row::{ArchiveRow, FileRecord, RunTotals};

/// Name and version of the columns.
pub const ARCHIVE_COLUMNS: &str = "chordal.archive-columns/1";

/// The type of a column. All types except `…Always` allow nulls (gaps).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ColumnType {
    TextAlways,
    Text,
    CountAlways,
    Count,
    Number,
    Flag,
    Numbers,
    Words,
    Problems,
}

const COLUMNS: &[(&str, ColumnType, &str, &str)] = {
    use ColumnType::*;
    &[
        ("path", TextAlways, "", "the file, with the name of the folder that was given"),
        (
            "kind",
            TextAlways,
            "",
            "`program`; `subprogram` (another program of the file calls it); `empty`, `binary`, \
             `other` (no program by its name or content), `unreadable`",
        ),
        (
            "status",
            TextAlways,
            "",
            "`ok`, `warnings`, `errors`; `stopped` (its budget was used up: perhaps it is endless); \
             `called` (run where it is called); `skipped` (no program); `failed` (not run: see \
             `message`)",
        ),
        ("message", Text, "", "why it was not run, or why it has no time"),
        ("program", Count, "", "program number"),
        ("place", CountAlways, "", "position among the programs of the file, from 0"),
        ("line", CountAlways, "", "line of the file on which it begins, from 1"),
        ("lines", CountAlways, "", "lines of its text"),
        ("bytes", CountAlways, "byte", "size of its text"),
        ("sha256", Text, "", "SHA-256 of its text as the control reads it"),
        ("file_bytes", CountAlways, "byte", "size of the file"),
        ("file_sha256", Text, "", "SHA-256 of the file"),
        ("control", Text, "", "the control whose rules were used"),
        ("machine", Text, "", "the machine it was run on"),
        ("chosen", Text, "", "why this machine"),
        ("end", Text, "", "how the run ended"),
        ("inch", Flag, "", "the units of its last block are inches"),
        ("blocks", Count, "", "blocks carried out, repeats counted"),
        ("cuts", Count, "", "cutting moves"),
        ("rapids", Count, "", "rapid moves"),
        ("tools", Numbers, "", "tools in the order of their first use; 0 before any change"),
        ("x_min_mm", Number, "mm", "lowest X, frame of the run"),
        ("x_max_mm", Number, "mm", "highest X, frame of the run"),
        ("y_min_mm", Number, "mm", "lowest Y"),
        ("y_max_mm", Number, "mm", "highest Y"),
        ("z_min_mm", Number, "mm", "lowest Z"),
        ("z_max_mm", Number, "mm", "highest Z"),
        ("a_min_deg", Number, "deg", "lowest A"),
        ("a_max_deg", Number, "deg", "highest A"),
        ("b_min_deg", Number, "deg", "lowest B"),
        ("b_max_deg", Number, "deg", "highest B"),
        ("c_min_deg", Number, "deg", "lowest C"),
        ("c_max_deg", Number, "deg", "highest C"),
        ("cut_length_mm", Number, "mm", "length of the cuts"),
        ("rapid_length_mm", Number, "mm", "length of the rapids"),
        ("at_feed_s", Number, "s", "time at feed and in dwells, without acceleration"),
        (
            "time_s",
            Number,
            "s",
            "time with acceleration and jerk; a gap where it was not planned, or the program `stopped`",
        ),
        ("cutting_s", Number, "s", "part of it that cuts"),
        ("rapid_s", Number, "s", "part of it in rapids"),
        ("other_s", Number, "s", "part of it in dwells, tool changes, spindle"),
        (
            "stock_verdict",
            Text,
            "",
            "with `--stock`: `clean`, `problems` or `not-proved`; a gap where there is no stock",
        ),
        ("stock_problems", Count, "", "what rapids, shank, holder touch, or may touch"),
        ("removed_least_mm3", Number, "mm³", "the program removes at least so much"),
        ("removed_most_mm3", Number, "mm³", "and at most so much"),
        ("left_least_mm3", Number, "mm³", "of the stock at least so much is left"),
        ("left_most_mm3", Number, "mm³", "and at most so much"),
        ("columns_mm", Number, "mm", "the side of a column of the stock"),
        ("errors", Count, "", "errors, with those of the stock"),
        ("warnings", Count, "", "warnings"),
        ("notes", Count, "", "notes"),
        ("codes", Words, "", "the codes that occurred, most severe first"),
        ("problems", Problems, "", "the first 20 problems, most severe first"),
    ]
};

/// The fields of a problem; `line` is 0 when it is in another text.
fn problem_fields() -> Fields {
    Fields::from(vec![
        Field::new("severity", DataType::Utf8, true),
        Field::new("code", DataType::Utf8, true),
        Field::new("line", DataType::UInt32, true),
        Field::new("message", DataType::Utf8, true),
    ])
}

impl ColumnType {
    fn data_type(self) -> DataType {
        let list = |item| DataType::List(Arc::new(Field::new("item", item, true)));
        match self {
            ColumnType::TextAlways | ColumnType::Text => DataType::Utf8,
            ColumnType::CountAlways | ColumnType::Count => DataType::UInt64,
            ColumnType::Number => DataType::Float64,
            ColumnType::Flag => DataType::Boolean,
            ColumnType::Numbers => list(DataType::UInt32),
            ColumnType::Words => list(DataType::Utf8),
            ColumnType::Problems => list(DataType::Struct(problem_fields())),
        }
    }

    fn has_gaps(self) -> bool {
        !matches!(self, ColumnType::TextAlways | ColumnType::CountAlways)
    }

    fn word(self) -> &'static str {
        match self {
            ColumnType::TextAlways => "utf8",
            ColumnType::Text => "utf8, or a gap",
            ColumnType::CountAlways => "uint64",
            ColumnType::Count => "uint64, or a gap",
            ColumnType::Number => "float64, or a gap",
            ColumnType::Flag => "bool, or a gap",
            ColumnType::Numbers => "list of uint32, or a gap",
            ColumnType::Words => "list of utf8, or a gap",
            ColumnType::Problems => "list of {severity, code, line, message}, or a gap",
        }
    }
}

/// The Arrow schema, with units as metadata.
fn schema() -> SchemaRef {
    let field = |(name, holds, unit, _): &(&str, ColumnType, &str, &str)| {
        let field = Field::new(*name, holds.data_type(), holds.has_gaps());
        match *unit {
            "" => field,
            unit => field.with_metadata(HashMap::from([("unit".to_string(), unit.to_string())])),
        }
    };
    let fields: Vec<Field> = COLUMNS.iter().map(field).collect();
    Arc::new(Schema::new_with_metadata(fields, about(ARCHIVE_COLUMNS)))
}

/// The metadata of a table: its schema and the version of Chordal.
pub(crate) fn about(columns: &str) -> HashMap<String, String> {
    let about = [("schema", columns), ("version", env!("CARGO_PKG_VERSION"))];
    about.map(|(key, value)| (format!("chordal.{key}"), value.to_string())).into()
}

/// The columns as a Markdown table for `docs/archives.md`.
pub fn archive_reference() -> String {
    let mut page =
        format!("`{ARCHIVE_COLUMNS}`\n\n| column | type | unit | |\n|---|---|---|---|\n");
    for (name, holds, unit, meaning) in COLUMNS {
        let _ = writeln!(page, "| `{name}` | {} | {unit} | {meaning} |", holds.word());
    }
    page
}

/// The Arrow builder of a column.
enum ColumnBuffer {
    Text(StringBuilder),
    Count(UInt64Builder),
    Number(Float64Builder),
    Flag(BooleanBuilder),
    Numbers(ListBuilder<UInt32Builder>),
    Words(ListBuilder<StringBuilder>),
    Problems(Box<ListBuilder<StructBuilder>>),
}

impl ColumnBuffer {
    fn of(holds: ColumnType) -> ColumnBuffer {
        match holds {
            ColumnType::TextAlways | ColumnType::Text => ColumnBuffer::Text(StringBuilder::new()),
            ColumnType::CountAlways | ColumnType::Count => {
                ColumnBuffer::Count(UInt64Builder::new())
            }
            ColumnType::Number => ColumnBuffer::Number(Float64Builder::new()),
            ColumnType::Flag => ColumnBuffer::Flag(BooleanBuilder::new()),
            ColumnType::Numbers => ColumnBuffer::Numbers(ListBuilder::new(UInt32Builder::new())),
            ColumnType::Words => ColumnBuffer::Words(ListBuilder::new(StringBuilder::new())),
            ColumnType::Problems => {
                let item = StructBuilder::from_fields(problem_fields(), 0);
                ColumnBuffer::Problems(Box::new(ListBuilder::new(item)))
            }
        }
    }

    fn finish(&mut self) -> ArrayRef {
        match self {
            ColumnBuffer::Text(cells) => Arc::new(cells.finish()),
            ColumnBuffer::Count(cells) => Arc::new(cells.finish()),
            ColumnBuffer::Number(cells) => Arc::new(cells.finish()),
            ColumnBuffer::Flag(cells) => Arc::new(cells.finish()),
            ColumnBuffer::Numbers(cells) => Arc::new(cells.finish()),
            ColumnBuffer::Words(cells) => Arc::new(cells.finish()),
            ColumnBuffer::Problems(cells) => Arc::new(cells.finish()),
        }
    }
}

/// Collects rows for the table.
pub(crate) struct ArchiveColumns {
    schema: SchemaRef,
    cells: Vec<ColumnBuffer>,
    rows: usize,
}

/// The value of a row in a column.
enum RowValue<'a> {
    Text(Option<&'a str>),
    Count(Option<u64>),
    Number(Option<f64>),
    Flag(Option<bool>),
    Tools(Option<&'a [u32]>),
    Codes(Option<&'a [String]>),
    Problems(Option<&'a RunTotals>),
}

impl ArchiveColumns {
    pub fn new() -> ArchiveColumns {
        let cells = COLUMNS.iter().map(|(_, holds, ..)| ColumnBuffer::of(*holds)).collect();
        ArchiveColumns { schema: schema(), cells, rows: 0 }
    }

    pub fn push(&mut self, path: &str, file: &FileRecord, row: &ArchiveRow) {
        for ((name, ..), cells) in COLUMNS.iter().zip(&mut self.cells) {
            put(cells, value_in_row(name, path, file, row));
        }
        self.rows += 1;
    }
}

impl RowBatcher for ArchiveColumns {
    fn rows(&self) -> usize {
        self.rows
    }

    fn schema(&self) -> &SchemaRef {
        &self.schema
    }

    fn take(&mut self) -> Result<RecordBatch, ArrowError> {
        self.rows = 0;
        let cells = self.cells.iter_mut().map(ColumnBuffer::finish).collect();
        RecordBatch::try_new(self.schema.clone(), cells)
    }
}

fn value_in_row<'a>(
    column: &str,
    path: &'a str,
    file: &'a FileRecord,
    row: &'a ArchiveRow,
) -> RowValue<'a> {
    let ran = row.ran.as_ref();
    let stock = ran.and_then(|ran| ran.stock.as_ref());
    let count = |of: fn(&RunTotals) -> u64| RowValue::Count(ran.map(of));
    let number = |of: &dyn Fn(&RunTotals) -> Option<f64>| RowValue::Number(ran.and_then(of));
    let text = |text: &'a Option<String>| RowValue::Text(text.as_deref());
    match column {
        "path" => RowValue::Text(Some(path)),
        "kind" => RowValue::Text(Some(&row.kind)),
        "status" => RowValue::Text(Some(&row.status)),
        "message" => text(&row.message),
        "program" => RowValue::Count(row.program.map(u64::from)),
        "place" => RowValue::Count(Some(row.place.into())),
        "line" => RowValue::Count(Some(row.line.into())),
        "lines" => RowValue::Count(Some(row.lines)),
        "bytes" => RowValue::Count(Some(row.bytes)),
        "sha256" => text(&row.sha256),
        "file_bytes" => RowValue::Count(Some(file.file_bytes)),
        "file_sha256" => text(&file.file_sha256),
        "control" => text(&row.control),
        "machine" => text(&row.machine),
        "chosen" => text(&row.chosen),
        "end" => RowValue::Text(ran.map(|ran| ran.end.as_str())),
        "inch" => RowValue::Flag(ran.map(|ran| ran.inch)),
        "blocks" => count(|ran| ran.blocks),
        "cuts" => count(|ran| ran.cuts),
        "rapids" => count(|ran| ran.rapids),
        "tools" => RowValue::Tools(ran.map(|ran| ran.tools.as_slice())),
        "cut_length_mm" => number(&|ran| Some(ran.cut_length_mm)),
        "rapid_length_mm" => number(&|ran| Some(ran.rapid_length_mm)),
        "at_feed_s" => number(&|ran| Some(ran.at_feed_s)),
        "time_s" => number(&|ran| ran.planned.map(|times| times.iter().sum())),
        "cutting_s" => number(&|ran| ran.planned.map(|times| times[0])),
        "rapid_s" => number(&|ran| ran.planned.map(|times| times[1])),
        "other_s" => number(&|ran| ran.planned.map(|times| times[2])),
        "stock_verdict" => RowValue::Text(stock.map(|stock| stock.verdict.as_str())),
        "stock_problems" => RowValue::Count(stock.map(|stock| stock.problems)),
        "removed_least_mm3" => RowValue::Number(stock.map(|stock| stock.removed_mm3[0])),
        "removed_most_mm3" => RowValue::Number(stock.map(|stock| stock.removed_mm3[1])),
        "left_least_mm3" => RowValue::Number(stock.map(|stock| stock.left_mm3[0])),
        "left_most_mm3" => RowValue::Number(stock.map(|stock| stock.left_mm3[1])),
        "columns_mm" => RowValue::Number(stock.and_then(|stock| stock.resolution_mm)),
        "errors" => count(|ran| ran.counts[0]),
        "warnings" => count(|ran| ran.counts[1]),
        "notes" => count(|ran| ran.counts[2]),
        "codes" => RowValue::Codes(ran.map(|ran| ran.codes.as_slice())),
        "problems" => RowValue::Problems(ran),
        // `x_min_mm` and the other travel columns.
        travel => {
            let axis = travel.chars().next().and_then(|letter| "xyzabc".find(letter)).unwrap_or(0);
            let is_low = travel.contains("_min_");
            number(&|ran| ran.travel[axis].map(|(low, high)| if is_low { low } else { high }))
        }
    }
}

fn put(cells: &mut ColumnBuffer, stated: RowValue) {
    match (cells, stated) {
        (ColumnBuffer::Text(cells), RowValue::Text(text)) => cells.append_option(text),
        (ColumnBuffer::Count(cells), RowValue::Count(count)) => cells.append_option(count),
        (ColumnBuffer::Number(cells), RowValue::Number(number)) => {
            cells.append_option(number.filter(|number| number.is_finite()));
        }
        (ColumnBuffer::Flag(cells), RowValue::Flag(flag)) => cells.append_option(flag),
        (ColumnBuffer::Numbers(cells), RowValue::Tools(tools)) => {
            let tools = tools.map(|tools| tools.iter().copied().map(Some));
            cells.append_option(tools);
        }
        (ColumnBuffer::Words(cells), RowValue::Codes(codes)) => {
            cells.append_option(codes.map(|codes| codes.iter().map(Some)));
        }
        (ColumnBuffer::Problems(cells), RowValue::Problems(ran)) => put_problems(cells, ran),
        // The tests fill every column, so the types of columns and values are known to match.
        _ => unreachable!("a column holds what the table of columns says"),
    }
}

fn put_problems(cells: &mut ListBuilder<StructBuilder>, ran: Option<&RunTotals>) {
    for problem in ran.iter().flat_map(|ran| &ran.problems) {
        let row = cells.values();
        let texts = [(0, &problem.severity), (1, &problem.code), (3, &problem.message)];
        for (field, text) in texts {
            if let Some(cells) = row.field_builder::<StringBuilder>(field) {
                cells.append_value(text);
            }
        }
        if let Some(cells) = row.field_builder::<UInt32Builder>(2) {
            cells.append_value(problem.line);
        }
        row.append(true);
    }
    cells.append(ran.is_some());
}

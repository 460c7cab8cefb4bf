//! Writes a comparison as a table.

use std::io::{self, Write};
use std::sync::Arc;

use arrow_array::{
    ArrayRef, BooleanArray, Float64Array, RecordBatch, StringArray, UInt32Array, UInt64Array,
};
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};
use chordal_export::OutputFormat;
use chordal_export::columns::{ColumnFile, RowBatcher};

use super::DiffRow;
use crate::columns::about;

/// Name and version of the columns.
pub const DIFF_COLUMNS: &str = "chordal.diff-columns/2";

const COLUMNS: &[(&str, &str, &str, &str)] = &[
    ("path", "utf8", "", "the file, below the two folders"),
    (
        "status",
        "utf8",
        "",
        "`same`, `text`, `not-verified`, `functions`, `feeds`, `path`, `other`, `unreadable`, `missing`, `new`",
    ),
    (
        "message",
        "utf8, or a gap",
        "",
        "what else differs, or why it could not be compared, or only in part",
    ),
    ("released_sha256", "utf8, or a gap", "", "SHA-256 of the released file"),
    ("returned_sha256", "utf8, or a gap", "", "SHA-256 of the returned file"),
    ("released_line", "uint32, or a gap", "", "first line of the released file that differs"),
    ("returned_line", "uint32, or a gap", "", "first line of the returned file that differs"),
    ("feeds_differ", "bool, or a gap", "", "feeds, spindle speeds or times differ"),
    (
        "functions_differ",
        "bool, or a gap",
        "",
        "something else than motion, feeds, speeds and times differs",
    ),
    ("distance_min_mm", "float64, or a gap", "mm", "the paths are at least this far apart"),
    ("distance_max_mm", "float64, or a gap", "mm", "the paths are at most this far apart"),
    ("released_at_feed_s", "float64, or a gap", "s", "time of the released one at feed"),
    ("returned_at_feed_s", "float64, or a gap", "s", "time of the returned one at feed"),
    (
        "released_time_s",
        "float64, or a gap",
        "s",
        "time of the released one with acceleration and jerk",
    ),
    (
        "returned_time_s",
        "float64, or a gap",
        "s",
        "time of the returned one with acceleration and jerk",
    ),
    ("new_problems", "uint64", "", "problems that the returned one has more, counted by code"),
    ("gone_problems", "uint64", "", "problems that it has no longer, counted by code"),
];

/// The columns as a Markdown table for `docs/archives.md`.
pub fn diff_reference() -> String {
    let mut page = format!("`{DIFF_COLUMNS}`\n\n| column | type | unit | |\n|---|---|---|---|\n");
    for (name, kind, unit, meaning) in COLUMNS {
        page.push_str(&format!("| `{name}` | {kind} | {unit} | {meaning} |\n"));
    }
    page
}

fn schema() -> SchemaRef {
    let field = |(name, kind, unit, _): &(&str, &str, &str, &str)| {
        let data = match kind.split(',').next() {
            Some("uint32") => DataType::UInt32,
            Some("uint64") => DataType::UInt64,
            Some("bool") => DataType::Boolean,
            Some("float64") => DataType::Float64,
            _ => DataType::Utf8,
        };
        let unit = (!unit.is_empty()).then(|| ("unit".to_string(), (*unit).to_string()));
        Field::new(*name, data, kind.contains("gap")).with_metadata(unit.into_iter().collect())
    };
    let fields: Vec<Field> = COLUMNS.iter().map(field).collect();
    Arc::new(Schema::new_with_metadata(fields, about(DIFF_COLUMNS)))
}

/// The rows that are not written yet.
struct DiffColumns<'a> {
    schema: SchemaRef,
    rows: &'a [DiffRow],
}

impl RowBatcher for DiffColumns<'_> {
    fn rows(&self) -> usize {
        self.rows.len()
    }

    fn schema(&self) -> &SchemaRef {
        &self.schema
    }

    fn take(&mut self) -> Result<RecordBatch, ArrowError> {
        RecordBatch::try_new(self.schema.clone(), arrays(std::mem::take(&mut self.rows)))
    }
}

/// Writes a comparison as Parquet.
///
/// # Errors The output cannot be written.
pub fn write_table<W: Write + Send + 'static>(rows: &[DiffRow], out: W) -> io::Result<W> {
    let columns = DiffColumns { schema: schema(), rows: &[] };
    let mut table = ColumnFile::new(out, OutputFormat::Parquet, columns)?;
    table.put(|columns| columns.rows = rows)?;
    table.finish()
}

fn arrays(rows: &[DiffRow]) -> Vec<ArrayRef> {
    let texts = |of: &dyn Fn(&DiffRow) -> Option<String>| -> ArrayRef {
        Arc::new(rows.iter().map(of).collect::<StringArray>())
    };
    let lines = |of: &dyn Fn(&DiffRow) -> Option<u32>| -> ArrayRef {
        Arc::new(rows.iter().map(of).collect::<UInt32Array>())
    };
    let flags = |of: &dyn Fn(&DiffRow) -> Option<bool>| -> ArrayRef {
        Arc::new(rows.iter().map(of).collect::<BooleanArray>())
    };
    let numbers = |of: &dyn Fn(&DiffRow) -> Option<f64>| -> ArrayRef {
        Arc::new(rows.iter().map(of).collect::<Float64Array>())
    };
    let counts = |of: &dyn Fn(&DiffRow) -> u64| -> ArrayRef {
        Arc::new(rows.iter().map(|row| Some(of(row))).collect::<UInt64Array>())
    };
    vec![
        texts(&|row| Some(row.path.clone())),
        texts(&|row| Some(row.status.word().into())),
        texts(&|row| row.message.clone()),
        texts(&|row| row.released_sha256.clone()),
        texts(&|row| row.returned_sha256.clone()),
        lines(&|row| row.lines.map(|lines| lines.0)),
        lines(&|row| row.lines.map(|lines| lines.1)),
        flags(&|row| row.feeds_differ),
        flags(&|row| row.functions_differ),
        numbers(&|row| row.distance_mm.map(|mm| mm.0)),
        numbers(&|row| row.distance_mm.map(|mm| mm.1)),
        numbers(&|row| row.at_feed_s.map(|s| s.0)),
        numbers(&|row| row.at_feed_s.map(|s| s.1)),
        numbers(&|row| row.time_s.map(|s| s.0)),
        numbers(&|row| row.time_s.map(|s| s.1)),
        counts(&|row| row.new_problems),
        counts(&|row| row.gone_problems),
    ]
}

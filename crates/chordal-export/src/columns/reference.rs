//! The page that documents the columns, made of the columns themselves.

use std::fmt::Write;

use chordal::control::AxisMask;

use super::field::{Cell, Column};
use super::{
    CHORD_COLUMNS, COMMAND_COLUMNS, PATH_COLUMNS, TOOL_PATH_COLUMNS, chords, commands, path,
};
use crate::samples::{SAMPLE_SCHEMA, sample_columns};

const HEAD: &str = "\
# Columns

The Arrow columns that `chordal` writes, in the Python package and in files.
This page is made from the code (`chordal_export::column_reference`); a test checks that they agree.

Every field carries its unit in the metadata key `unit`. The schema carries, under `chordal.` keys,
`schema` (name and version, as below), `version` of Chordal, `program` and `program_sha256` (the name and the
SHA-256 of its text), `machine` and `control`; setpoints also `period_s`, chords `tolerance_mm` and `placement`. Rotary
axes A, B and C are columns only where the machine has them. A gap is null in Arrow; in a NumPy array of numbers it is NaN.

|| command | rows 
|---|---|
| `chordal commands part.nc -o part.parquet` | commands as programmed |
| `chordal path part.nc -o part.parquet` | commands of the tool centre |
| `chordal chords part.nc -o part.parquet` | chords |
| `chordal sample part.nc -o part.parquet` | setpoints |

The extension may also be `.arrow`. Rows are written as they come: a Parquet file in groups of 131,072 rows, an
Arrow file in batches of 8,192, so memory does not grow with the program. The exact path is available in Python.
";

/// The columns of all tables as Markdown.
pub fn column_reference() -> String {
    let mut page = HEAD.to_string();
    let tables = [
        ("Commands as programmed", COMMAND_COLUMNS, commands::columns(AxisMask::ALL, false)),
        ("Commands of the tool centre", TOOL_PATH_COLUMNS, commands::columns(AxisMask::ALL, true)),
        ("Exact path", PATH_COLUMNS, path::columns(AxisMask::ALL)),
        ("Chords", CHORD_COLUMNS, chords::columns()),
    ];
    for (title, name, columns) in tables {
        table(&mut page, title, name, &columns);
    }
    let setpoints: Vec<Column> = sample_columns(AxisMask::ALL)
        .map(|(name, unit, meaning)| Column { name, cell: Cell::Number, unit, meaning })
        .chain([Column::new("line", Cell::Integer, "", "line of the block, from 1")])
        .collect();
    table(&mut page, "Setpoints", SAMPLE_SCHEMA, &setpoints);
    page
}

fn table(page: &mut String, title: &str, name: &str, columns: &[Column]) {
    let _ =
        write!(page, "\n## {title}: `{name}`\n\n| column | type | unit | |\n|---|---|---|---|\n");
    for column in columns {
        let gap = if column.cell.has_gaps() { ", or a gap" } else { "" };
        let kind = match column.cell {
            Cell::Number | Cell::NumberOrGap => "float64",
            Cell::Integer | Cell::IntegerOrGap => "uint32",
            Cell::Word | Cell::WordOrGap => "dictionary of words",
            Cell::File => "dictionary of names",
            Cell::Flag | Cell::FlagOrGap => "bool",
            Cell::TextOrGap => "utf8",
        };
        let Column { name, unit, meaning, .. } = column;
        let _ = writeln!(page, "| `{name}` | {kind}{gap} | {unit} | {meaning} |");
    }
}

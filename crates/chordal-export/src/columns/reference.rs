//! The page that documents the columns, made of the columns themselves.

use std::fmt::Write;

use chordal::control::AxisMask;
use chordal::stock::{MoveEngagement, TurnedMove};

use super::field::{CellType, Column};
use super::{
    CHORD_COLUMNS, COMMAND_COLUMNS, ENGAGEMENT_COLUMNS, PATH_COLUMNS, SECTION_COLUMNS,
    TOOL_PATH_COLUMNS, TURNING_COLUMNS, chords, commands, moves, path, section,
};
use crate::setpoints::{SAMPLE_SCHEMA, sample_columns};

const HEAD: &str = "\
# Columns

The Arrow columns of `chordal`, in the Python package and in files.
This page is written from the code (`chordal_export::column_reference`); a test compares the two.

Every field has its unit in the metadata key `unit`. The schema has, under `chordal.` keys, `schema` (name and version,
as below), `version` of Chordal, `program` and `program_sha256` (the name and the SHA-256 of its text), `machine` and
`control`; setpoints also `period_s`, chords `tolerance_mm` and `placement`. `diameter` lists the axes that are programmed
as diameters, as X of a lathe: in the two tables of commands their places and centres are diameters, everywhere else radii.
Rotary axes A, B and C have columns only if the machine has them. A gap is null in Arrow; in a NumPy array of numbers it is NaN.

**Units: millimetres, degrees, mm/min and seconds, also for programs in inches.**

|| command | rows 
|---|---|
| `chordal commands part.nc -o part.parquet` | commands as programmed |
| `chordal path part.nc -o part.parquet` | commands of the tool centre |
| `chordal chords part.nc -o part.parquet` | chords |
| `chordal sample part.nc -o part.parquet` | setpoints |
| `chordal stock part.nc --setup op1.toml --engagement -o part.parquet` | how hard each cut is; on a lathe the table of cuts of a lathe |

The ending may also be `.arrow`. Rows are written as they come: a Parquet file in groups of 131,072 rows, an Arrow file in
batches of 8,192, so that memory does not grow with the program. The exact path and the half section are available in Python only.
";

/// The columns of all tables as Markdown.
pub fn column_reference() -> String {
    let mut page = HEAD.to_string();
    let tables = [
        ("Commands as programmed", COMMAND_COLUMNS, commands::columns(AxisMask::ALL, false)),
        ("Commands of the tool centre", TOOL_PATH_COLUMNS, commands::columns(AxisMask::ALL, true)),
        ("Exact path", PATH_COLUMNS, path::columns(AxisMask::ALL)),
        ("Chords", CHORD_COLUMNS, chords::columns()),
        ("Engagement of cuts", ENGAGEMENT_COLUMNS, moves::columns::<MoveEngagement>()),
        ("Cuts of a lathe", TURNING_COLUMNS, moves::columns::<TurnedMove>()),
        ("Half section of a lathe", SECTION_COLUMNS, section::columns()),
    ];
    for (title, name, columns) in tables {
        table(&mut page, title, name, &columns);
    }
    let setpoints: Vec<Column> = sample_columns(AxisMask::ALL)
        .map(|(name, unit, meaning)| Column { name, cell: CellType::Number, unit, meaning })
        .chain([Column::new("line", CellType::Integer, "", "line of the block, from 1")])
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
            CellType::Number | CellType::NumberOrGap => "float64",
            CellType::Integer | CellType::IntegerOrGap => "uint32",
            CellType::Word | CellType::WordOrGap => "dictionary of words",
            CellType::File => "dictionary of names",
            CellType::Flag | CellType::FlagOrGap => "bool",
            CellType::TextOrGap => "utf8",
        };
        let Column { name, unit, meaning, .. } = column;
        let _ = writeln!(page, "| `{name}` | {kind}{gap} | {unit} | {meaning} |");
    }
}

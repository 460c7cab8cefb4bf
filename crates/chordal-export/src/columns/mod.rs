//! Commands, path, chords and setpoints as columns: Arrow record batches.
//!
//! A builder ([`RowBatcher`]) takes what a run pushes and gives a batch whenever it is asked, so that a
//! caller holds as many rows as it wants: all of them, or a group of a file (`ColumnFile`). Lengths are mm, angles
//! degrees, feeds mm/min, times s; every field says its unit, and the schema says its version,
//! the program, the SHA-256 of its text, the machine and the control.

mod cells;
mod chords;
mod commands;
mod engagement;
mod field;
mod file;
mod moves;
#[cfg(feature = "files")]
mod parquet;
mod path;
mod reference;
mod rows;
mod samples;
mod section;
mod text_table;
mod turning;

pub(crate) use chords::chords_of;
pub use chords::{CHORD_COLUMNS, ChordColumns};
pub use commands::{COMMAND_COLUMNS, CommandColumns, TOOL_PATH_COLUMNS};
pub use engagement::ENGAGEMENT_COLUMNS;
pub use file::ColumnFile;
pub use moves::{CutColumns, CuttingMoveData, NumberSpec, cuts_csv};
pub(crate) use path::kind_word;
pub use path::{PATH_COLUMNS, PathColumns};
pub use reference::column_reference;
pub use rows::RowBatcher;
pub use samples::{SampleColumns, SampleWriter};
pub use section::{SECTION_COLUMNS, section_columns};
pub use turning::TURNING_COLUMNS;

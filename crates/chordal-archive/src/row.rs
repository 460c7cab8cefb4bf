//! The results for a file, as stored in the journal.

use chordal::machine::PerAxis;
use serde::{Deserialize, Serialize};

/// A problem of a program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ArchivedProblem {
    /// `error`, `warning` or `note`.
    pub severity: String,
    /// The diagnostic code, such as `CH401`.
    pub code: String,
    /// The line of the file, from 1; 0 when the problem is in another text.
    pub line: u32,
    /// One sentence with the measured numbers.
    pub message: String,
}

/// The results of the run of a program.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RunTotals {
    /// How the run ended, in words such as `program end` or `budget`.
    pub end: String,
    /// Whether the units are inches at the end.
    pub inch: bool,
    /// The number of executed blocks, including repeated ones.
    pub blocks: u64,
    /// The number of cutting moves.
    pub cuts: u64,
    /// The number of rapids.
    pub rapids: u64,
    /// Tools in the order of their first use.
    pub tools: Vec<u32>,
    /// The lowest and the highest position of X, Y, Z (mm) and A, B, C (degrees); `None` for an axis that does not
    /// move.
    pub travel: PerAxis<Option<(f64, f64)>>,
    /// The total length of the cuts, mm.
    pub cut_length_mm: f64,
    /// The total length of the rapids, mm.
    pub rapid_length_mm: f64,
    /// The time without acceleration: lengths divided by feeds, plus waits, s.
    pub at_feed_s: f64,
    /// The cutting, rapid and other time with acceleration and jerk, s; `None` when the motion was not planned.
    pub planned: Option<[f64; 3]>,
    /// What remains of the stock of its setup; `None` when this was not requested or there is no stock.
    #[serde(default)]
    pub stock: Option<RanStock>,
    /// The numbers of errors, warnings and notes.
    pub counts: [u64; 3],
    /// The codes that occurred, the most severe first.
    pub codes: Vec<String>,
    /// The first problems, the most severe first.
    pub problems: Vec<ArchivedProblem>,
}

/// What a program leaves of its stock; volumes are a lower and an upper bound, mm³.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RanStock {
    /// `clean`, `problems` or `not-proved`.
    pub verdict: String,
    /// The number of collisions that occur or cannot be excluded.
    pub problems: u64,
    /// The bounds of the removed volume, mm³.
    pub removed_mm3: [f64; 2],
    /// The bounds of the remaining volume, mm³.
    pub left_mm3: [f64; 2],
    /// The side of a column, mm; `None` when the stock is exact.
    pub resolution_mm: Option<f64>,
}

/// A row of the table: a program, or a file without one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ArchiveRow {
    /// The kind of the row: see the reference of the columns.
    pub kind: String,
    /// The result: see the reference of the columns.
    pub status: String,
    /// Why it was not run to its end or has no time; `None` otherwise.
    pub message: Option<String>,
    /// The program number; `None` without one.
    pub program: Option<u32>,
    /// Its position among the programs of the file, from 0.
    pub place: u32,
    /// The line of the file on which it begins, from 1.
    pub line: u32,
    /// The number of lines of its text.
    pub lines: u64,
    /// The size of its text, bytes.
    pub bytes: u64,
    /// SHA-256 of its text; `None` for a file without a program.
    pub sha256: Option<String>,
    /// The control whose rules were used; `None` for a file without a program.
    pub control: Option<String>,
    /// The machine on which it was run; `None` for a file without a program.
    pub machine: Option<String>,
    /// Why this machine was used; `None` for a file without a program.
    pub chosen: Option<String>,
    /// The results of the run; `None` when it was not run.
    pub ran: Option<RunTotals>,
}

/// The record of a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FileRecord {
    /// A digest of everything on which the rows depend: equal keys mean equal rows.
    pub key: String,
    /// The size of the file, bytes.
    pub file_bytes: u64,
    /// SHA-256 of the file, as `sha256sum` prints it; `None` when the file was not read.
    pub file_sha256: Option<String>,
    /// The rows of the file.
    pub rows: Vec<ArchiveRow>,
}

impl FileRecord {
    /// The record of a file that could not be read.
    pub fn unreadable(key: String, message: String) -> FileRecord {
        let row = ArchiveRow {
            kind: "unreadable".into(),
            status: "failed".into(),
            message: Some(message),
            ..ArchiveRow::default()
        };
        FileRecord { key, file_bytes: 0, file_sha256: None, rows: vec![row] }
    }
}

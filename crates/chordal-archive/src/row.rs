//! What is found about a file, as it goes through the journal.

use chordal::machine::PerAxis;
use serde::{Deserialize, Serialize};

/// A problem of a program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ArchivedProblem {
    /// `error`, `warning` or `note`.
    pub severity: String,
    /// The registered code, as `CH401`.
    pub code: String,
    /// Line of the file, from 1; 0 in another text.
    pub line: u32,
    /// One sentence with the measured numbers.
    pub message: String,
}

/// What a run of a program came to. Lengths are mm, times s.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RunTotals {
    /// How it ended.
    pub end: String,
    /// The units of its last block are inches.
    pub inch: bool,
    /// Blocks carried out, repeats counted.
    pub blocks: u64,
    /// Cuts.
    pub cuts: u64,
    /// Rapids.
    pub rapids: u64,
    /// Tools in the order of their first use.
    pub tools: Vec<u32>,
    /// Lowest and highest place of X, Y, Z (mm) and A, B, C (degrees), where it moves.
    pub travel: PerAxis<Option<(f64, f64)>>,
    /// Length of the cuts.
    pub cut_length_mm: f64,
    /// Length of the rapids.
    pub rapid_length_mm: f64,
    /// Length over feed and waits, without acceleration.
    pub at_feed_s: f64,
    /// Cutting, rapid and other time with acceleration and jerk, where it was planned.
    pub planned: Option<[f64; 3]>,
    /// What it leaves of the stock of its setup, where that was asked.
    #[serde(default)]
    pub stock: Option<RanStock>,
    /// Errors, warnings and notes.
    pub counts: [u64; 3],
    /// The codes that occurred, gravest first.
    pub codes: Vec<String>,
    /// The first problems, gravest first.
    pub problems: Vec<ArchivedProblem>,
}

/// What a program leaves of its stock: volumes are between two bounds, mm³.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RanStock {
    /// `clean`, `problems`, `not-proved`.
    pub verdict: String,
    /// What is touched, or cannot be excluded.
    pub problems: u64,
    /// At least and at most so much is removed.
    pub removed_mm3: [f64; 2],
    /// At least and at most so much is left.
    pub left_mm3: [f64; 2],
    /// The side of a column, mm; without one where the stock is exact.
    pub resolution_mm: Option<f64>,
}

/// A row of the table: a program, or a file that holds none.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ArchiveRow {
    /// What it is: see the reference of the columns.
    pub kind: String,
    /// How it fared.
    pub status: String,
    /// Why it was not run to its end, where it was not.
    pub message: Option<String>,
    /// Its number, where it has one.
    pub program: Option<u32>,
    /// Its place among the programs of the file, from 0.
    pub place: u32,
    /// The line of the file that it begins on.
    pub line: u32,
    /// Lines of its text.
    pub lines: u64,
    /// Bytes of its text.
    pub bytes: u64,
    /// SHA-256 of its text.
    pub sha256: Option<String>,
    /// The control whose rules it was read by.
    pub control: Option<String>,
    /// The machine it was run on.
    pub machine: Option<String>,
    /// Why this machine.
    pub chosen: Option<String>,
    /// What the run came to.
    pub ran: Option<RunTotals>,
}

/// Everything about a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FileRecord {
    /// What the rows depend on, as a digest: the same key means the same rows.
    pub key: String,
    /// Bytes of the file.
    pub file_bytes: u64,
    /// SHA-256 of the file, as `sha256sum` prints it.
    pub file_sha256: Option<String>,
    /// Its rows.
    pub rows: Vec<ArchiveRow>,
}

impl FileRecord {
    /// A file that could not be read.
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

//! What stands in the cells of the tables: times and lines.

use chordal::diagnostics::FileId;
use chordal::time::OperationTime;

use crate::numbers::{duration, fixed};

/// Most operations that are listed.
pub const MAX_OPERATIONS: usize = 30;

/// Times that differ by less than this, s, are the same: less than is shown.
pub const EQUAL_TIME_S: f64 = 0.0005;

/// Times of blocks are short: three decimals below ten seconds.
pub fn fine(seconds: f64) -> String {
    if seconds < EQUAL_TIME_S {
        "-".to_string()
    } else if seconds < 9.9995 {
        format!("{} s", fixed(seconds, 3))
    } else if seconds < 59.95 {
        format!("{} s", fixed(seconds, 1))
    } else {
        duration(seconds)
    }
}

/// The lines of the program between which an operation lies; those of other files say nothing.
pub fn lines(operation: &OperationTime) -> String {
    let line = |origin: &chordal::control::Origin| match origin.span.file {
        FileId(0) => origin.line.to_string(),
        _ => "-".to_string(),
    };
    format!("{} to {}", line(&operation.first), line(&operation.last))
}

//! What the tables of time have in common: how a time and an operation are told.

use chordal::diagnostics::FileId;
use chordal::time::OperationTime;

use crate::numbers::{duration, fixed};

/// Most operations that are listed.
pub(super) const MOST_OPERATIONS: usize = 30;

/// Times that differ by less than this, s, are the same: less than is shown.
pub(super) const SAME_S: f64 = 0.0005;

/// Times of blocks are short: three decimals below ten seconds.
pub(super) fn fine(seconds: f64) -> String {
    if seconds < SAME_S {
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
pub(super) fn lines(operation: &OperationTime) -> String {
    let line = |origin: &chordal::control::Origin| match origin.span.file {
        FileId(0) => origin.line.to_string(),
        _ => "-".to_string(),
    };
    format!("{} to {}", line(&operation.first), line(&operation.last))
}

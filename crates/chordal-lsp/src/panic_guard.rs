//! Catches panics, so that a defect in Chordal ends one answer and never the server.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// Returns the result of `work`, or a message with its panic. State that it left half changed must not be used again.
pub fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|payload| {
        let words = payload.downcast_ref::<String>().map(String::as_str);
        let words = words.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("a panic");
        format!("Chordal failed: {words}; please report it with the program")
    })
}

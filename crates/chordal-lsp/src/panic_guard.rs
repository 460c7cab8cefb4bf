//! A failure of ours ends one answer, and never the server.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// What `work` gives, or the words of its panic. What it has left half done must not be used again.
pub fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|reported| {
        let words = reported.downcast_ref::<String>().map(String::as_str);
        let words = words.or_else(|| reported.downcast_ref::<&str>().copied()).unwrap_or("a panic");
        format!("Chordal failed: {words}; please report it with the program")
    })
}

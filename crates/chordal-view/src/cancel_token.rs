//! Cancels work that is out of date.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use chordal::control::InterruptCheck;

/// Belongs to one run, comparison or stock, by its number. A newer one of the same kind, or the end of the page, cancels it.
#[derive(Clone, Debug)]
pub struct CancelToken {
    /// The number of the newest work of this kind.
    pub newest: Arc<AtomicU64>,
    pub closed: Arc<AtomicBool>,
    /// The number of this work.
    pub number: u64,
}

impl CancelToken {
    /// Whether the work is still the newest of its kind, and the page open.
    pub fn is_current(&self) -> bool {
        self.newest.load(Ordering::Relaxed) == self.number && !self.closed.load(Ordering::Relaxed)
    }

    /// For a job: ends its run once the token is canceled.
    pub fn interrupt(&self) -> InterruptCheck {
        let token = self.clone();
        Arc::new(move || !token.is_current())
    }
}

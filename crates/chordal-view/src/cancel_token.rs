//! Cancels outdated work.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use chordal::control::InterruptCheck;

/// The cancel token of one run, comparison or stock. Newer work of the same kind, or closing the page, cancels it.
#[derive(Clone, Debug)]
pub struct CancelToken {
    /// The number of the newest work of this kind.
    pub newest: Arc<AtomicU64>,
    pub closed: Arc<AtomicBool>,
    /// The number of this work.
    pub number: u64,
}

impl CancelToken {
    /// Whether the work is still the newest of its kind and the page is open.
    pub fn is_current(&self) -> bool {
        self.newest.load(Ordering::Relaxed) == self.number && !self.closed.load(Ordering::Relaxed)
    }

    /// A check for a job that ends its run once the token is canceled.
    pub fn interrupt(&self) -> InterruptCheck {
        let token = self.clone();
        Arc::new(move || !token.is_current())
    }
}

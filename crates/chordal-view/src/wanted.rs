//! Whether a run is still wanted.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use chordal::control::InterruptCheck;

/// A run by its number. A newer text, another machine or the end of the page make it needless.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The number of the newest run.
    pub newest: Arc<AtomicU64>,
    /// The page has gone.
    pub over: Arc<AtomicBool>,
    /// The number of this one.
    pub number: u64,
}

impl Wanted {
    /// Whether it is.
    pub fn is_wanted(&self) -> bool {
        self.newest.load(Ordering::Relaxed) == self.number && !self.over.load(Ordering::Relaxed)
    }

    /// Ends the run once it is not.
    pub fn interrupt(&self) -> InterruptCheck {
        let wanted = self.clone();
        Arc::new(move || !wanted.is_wanted())
    }
}

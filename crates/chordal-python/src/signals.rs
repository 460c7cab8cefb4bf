//! What ends work that has begun: Ctrl-C, and errors of what Python was asked.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use chordal::control::InterruptCheck;
use pyo3::prelude::*;

/// So often Python is asked for signals: soon enough for who waits, and rarely enough for other
/// threads that hold the interpreter lock.
const BETWEEN_ASKINGS: Duration = Duration::from_millis(50);

/// What was raised during one piece of work.
pub struct PythonSignals {
    checked_at: Mutex<Instant>,
    raised: Mutex<Option<PyErr>>,
}

impl PythonSignals {
    pub fn new() -> Arc<PythonSignals> {
        Arc::new(PythonSignals { checked_at: Mutex::new(Instant::now()), raised: Mutex::new(None) })
    }

    /// Asks for signals when it is time to. Only the main thread has any.
    pub fn interrupt(self: &Arc<PythonSignals>) -> InterruptCheck {
        let signals = self.clone();
        Arc::new(move || signals.is_due() && signals.ask())
    }

    /// Ends the work with an error; of several the first counts.
    pub fn raise(&self, error: PyErr) {
        locked(&self.raised).get_or_insert(error);
    }

    /// The error that ended the work.
    pub fn raised(&self) -> PyResult<()> {
        locked(&self.raised).take().map_or(Ok(()), Err)
    }

    pub fn has_raised(&self) -> bool {
        locked(&self.raised).is_some()
    }

    fn is_due(&self) -> bool {
        if self.has_raised() {
            return true;
        }
        let mut requested = locked(&self.checked_at);
        let due = requested.elapsed() >= BETWEEN_ASKINGS;
        if due {
            *requested = Instant::now();
        }
        due
    }

    fn ask(&self) -> bool {
        if let Err(error) = Python::attach(|py| py.check_signals()) {
            self.raise(error);
        }
        self.has_raised()
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

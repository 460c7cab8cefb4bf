//! Drafts that are being written: a signal that ends the process takes them away first.

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The drafts of this process.
static DRAFTS: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn drafts() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    DRAFTS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes a draft: no signal comes between its making and its being known.
pub fn made<T>(make: impl FnOnce() -> io::Result<(PathBuf, T)>) -> io::Result<T> {
    heed_signals();
    let mut drafts = drafts();
    let (path, made) = make()?;
    drafts.insert(path);
    Ok(made)
}

/// A draft is in its place, or gone.
pub fn forget(path: &Path) {
    drafts().remove(path);
}

/// The first draft has signals heeded, so that a process that writes no file leaves them as they are.
#[cfg(unix)]
fn heed_signals() {
    use std::sync::Once;

    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;

    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // Without the thread signals end the process at once, as they would anyway.
        let Ok(mut signals) = Signals::new([SIGINT, SIGTERM, SIGHUP]) else { return };
        std::thread::spawn(move || {
            for signal in signals.forever() {
                // Whoever makes a draft now waits, and ends with the process.
                for draft in drafts().iter() {
                    let _ = std::fs::remove_file(draft);
                }
                let _ = emulate_default_handler(signal);
            }
        });
    });
}

#[cfg(not(unix))]
fn heed_signals() {}

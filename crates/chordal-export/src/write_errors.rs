//! Errors of writers that are called from a run.

/// Calls `next` unless an earlier call has failed. The callbacks of a run return nothing, so the first error of a writer is
/// kept for its end.
pub fn write_unless_failed<E>(written: &mut Result<(), E>, next: impl FnOnce() -> Result<(), E>) {
    if written.is_ok() {
        *written = next();
    }
}

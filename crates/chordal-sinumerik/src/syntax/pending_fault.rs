//! A fault of the statement that is being read.

/// A fault of the statement that is being read.
pub(super) struct PendingFault {
    pub at: usize,
    pub message: String,
}

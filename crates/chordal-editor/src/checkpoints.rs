//! Where a run was left off as far as it was needed, so that the next question begins near its line.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use chordal::control::Checkpoint;
use chordal::diagnostics::TextRange;

/// The checkpoints of a run as far as it was needed.
#[derive(Debug, Default)]
pub(crate) struct RunCheckpoints(Mutex<CheckpointState>);

#[derive(Clone, Debug, Default)]
pub(crate) struct CheckpointState {
    /// Where the text was left off, each with what was read elsewhere in the stretch before it.
    pub checkpoints: Vec<(Arc<Checkpoint>, Option<TextRange>)>,
}

impl CheckpointState {
    /// The first stretch that may carry a byte out.
    pub fn segment_of(&self, byte: u32) -> Option<usize> {
        (0..self.checkpoints.len()).find(|&index| {
            let from = self.start(index).map_or(0, |checkpoint| checkpoint.offset());
            let (end, inspected) = &self.checkpoints[index];
            let inspected = inspected
                .is_some_and(|range_read| (range_read.start..range_read.end).contains(&byte));
            (from..end.offset()).contains(&byte) || inspected
        })
    }

    /// The checkpoint at which a stretch begins; none for the first.
    pub fn start(&self, index: usize) -> Option<&Checkpoint> {
        index.checked_sub(1).map(|before| &*self.checkpoints[before].0)
    }
}

impl RunCheckpoints {
    /// Those that are known so far.
    pub fn known(&self) -> MutexGuard<'_, CheckpointState> {
        // Nothing is left half done where a panic could strike.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

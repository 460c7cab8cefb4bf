//! What a run emits in addition to its commands: the state after each block, and checkpoints.

use std::ops::ControlFlow;

use chordal_command::{Origin, Sink};
use chordal_diagnostics::TextRange;

use crate::checkpoint::Checkpoint;
use crate::modal::Modal;
use crate::state_items::{StateItem, StateValue};

/// The state after a block, computed on request.
pub struct AfterBlock<'s> {
    /// The modal state, as the screen of a control shows it.
    pub modal: &'s dyn Fn() -> Modal,
    /// The whole state, item by item; several times as expensive as `modal`.
    pub items: &'s dyn Fn() -> Vec<(StateItem, StateValue)>,
}

/// A sink that can also request the state after each block, and checkpoints.
pub trait RunSink: Sink {
    /// True when [`block_done`](Self::block_done) is to be called; read once, at the start.
    fn wants_blocks(&self) -> bool {
        false
    }
    /// Called after each block; `after` computes the state after it.
    fn block_done(&mut self, _origin: &Origin, _after: &AfterBlock) {}
    /// The byte of the main program from which the next [`Checkpoint`] is requested; read at the start and after
    /// each checkpoint.
    fn next_checkpoint(&self) -> u32 {
        u32::MAX
    }
    /// True when the sink has no pending command, so that a checkpoint is possible here.
    fn is_settled(&self) -> bool {
        true
    }
    /// A checkpoint; `Break` ends the run here. `text_read` is the part of the first text that was read since the
    /// previous checkpoint in addition to the blocks between the two: called programs, and those searched for a
    /// label; `None` when there is none.
    fn checkpoint(
        &mut self,
        _checkpoint: Checkpoint,
        _text_read: Option<TextRange>,
    ) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// Sees nothing.
impl RunSink for () {}

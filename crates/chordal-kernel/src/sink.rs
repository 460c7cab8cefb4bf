//! What a run gives beside its commands: the state after each block, and places to go on from.

use std::ops::ControlFlow;

use chordal_command::{Origin, Sink};
use chordal_diagnostics::TextRange;

use crate::checkpoint::Checkpoint;
use crate::modal::Modal;
use crate::state_items::{StateItem, StateValue};

/// What is in force after a block: computed where it is called for.
pub struct AfterBlock<'s> {
    /// As the screen of a control shows it.
    pub modal: &'s dyn Fn() -> Modal,
    /// All that the control keeps, item by item. It takes several times as long.
    pub items: &'s dyn Fn() -> Vec<(StateItem, StateValue)>,
}

/// A sink that may also ask for the state after each block, and for checkpoints.
pub trait RunSink: Sink {
    /// Whether [`block_done`](Self::block_done) is to be called; asked once.
    fn wants_blocks(&self) -> bool {
        false
    }
    /// A block has been carried out.
    fn block_done(&mut self, _origin: &Origin, _after: &AfterBlock) {}
    /// From which byte of the main program on a [`Checkpoint`] is wanted; asked at the beginning
    /// and after each.
    fn next_checkpoint(&self) -> u32 {
        u32::MAX
    }
    /// Whether what has come so far can be left off here.
    fn is_settled(&self) -> bool {
        true
    }
    /// A place at which the run may be taken up again. `Break` ends it here. `looked` is what of
    /// the first text was read since the checkpoint before, except the blocks between the two:
    /// called programs, and those that were searched for a label.
    fn checkpoint(
        &mut self,
        _checkpoint: Checkpoint,
        _text_read: Option<TextRange>,
    ) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

//! Positions between two blocks at which a run can stop and be resumed, so that after a change of the text
//! only the part that it affects is run again.

use std::any::Any;
use std::fmt::Debug;

use chordal_diagnostics::TextShift;

/// What a language and the kernel remember at a checkpoint: everything that the rest of the run depends on.
pub trait CheckpointMemory: Any + Debug + Send + Sync {
    /// True when the rest of the run is the same from both, bit for bit.
    fn is_like(&self, other: &dyn CheckpointMemory) -> bool;
    /// Moves its spans to a text that was changed at another position; `None` when a word that it
    /// remembers was deleted.
    fn shift(&mut self, shift: &TextShift) -> Option<()>;
    /// A copy (`Clone` cannot be called on a trait object).
    fn copy(&self) -> Box<dyn CheckpointMemory>;
    /// For a downcast to the language's own type.
    fn as_any(&self) -> &dyn Any;
}

/// A position between two blocks of the main program, with everything that is remembered there.
#[derive(Debug)]
pub struct Checkpoint {
    offset: u32,
    line: u32,
    blocks: u64,
    memory: Box<dyn CheckpointMemory>,
}

impl Clone for Checkpoint {
    fn clone(&self) -> Checkpoint {
        Checkpoint { memory: self.memory.copy(), ..*self }
    }
}

impl Checkpoint {
    /// A checkpoint before the block that begins at byte `offset`, on `line` (from 1), after `blocks` blocks.
    pub fn new(
        offset: u32,
        line: u32,
        blocks: u64,
        memory: Box<dyn CheckpointMemory>,
    ) -> Checkpoint {
        Checkpoint { offset, line, blocks, memory }
    }

    /// The byte at which the next block begins.
    pub fn offset(&self) -> u32 {
        self.offset
    }

    /// Its line, from 1.
    pub fn line(&self) -> u32 {
        self.line
    }

    /// Blocks carried out since the run began.
    pub fn blocks(&self) -> u64 {
        self.blocks
    }

    /// What the language remembers; `None` when it is of another type.
    pub fn memory<M: CheckpointMemory>(&self) -> Option<&M> {
        self.memory.as_any().downcast_ref()
    }

    /// True when the rest of the run is the same from both, bit for bit.
    pub fn leads_on_like(&self, other: &Checkpoint) -> bool {
        (self.offset, self.line) == (other.offset, other.line)
            && self.memory.is_like(other.memory.as_ref())
    }

    /// Replaces the number of blocks carried out before it.
    pub fn count_blocks(&mut self, blocks: u64) {
        self.blocks = blocks;
    }

    /// Moves its spans to a text that was changed at another position; `None` when a word that it
    /// remembers was deleted.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        (self.offset, self.line) = shift.place(self.offset, self.line)?;
        self.memory.shift(shift)
    }
}

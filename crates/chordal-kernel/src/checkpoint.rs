//! Places between two blocks at which a run may be left off and taken up again, so that a text
//! that changed somewhere needs not be run whole.

use std::any::Any;
use std::fmt::Debug;

use chordal_diagnostics::TextShift;

/// What a language and the kernel remember at a checkpoint: all that decides about what follows.
pub trait CheckpointMemory: Any + Debug + Send + Sync {
    /// True when what follows is the same after both, to the bit.
    fn is_like(&self, other: &dyn CheckpointMemory) -> bool;
    /// Makes it one of a text that has changed elsewhere; `None` where it remembers words that went.
    fn shift(&mut self, shift: &TextShift) -> Option<()>;
    /// A copy.
    fn copy(&self) -> Box<dyn CheckpointMemory>;
    /// The language's own type again.
    fn as_any(&self) -> &dyn Any;
}

/// A place between two blocks of the main program, and all that is remembered there.
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
    /// Before the block that begins at a byte of a line, after so many blocks.
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

    /// What the language remembers, where it is of this type.
    pub fn memory<M: CheckpointMemory>(&self) -> Option<&M> {
        self.memory.as_any().downcast_ref()
    }

    /// True when what follows is the same after both, to the bit.
    pub fn leads_on_like(&self, other: &Checkpoint) -> bool {
        (self.offset, self.line) == (other.offset, other.line)
            && self.memory.is_like(other.memory.as_ref())
    }

    /// Counts other blocks before it.
    pub fn count_blocks(&mut self, blocks: u64) {
        self.blocks = blocks;
    }

    /// Makes it one of a text that has changed elsewhere; `None` where it remembers words that went.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        (self.offset, self.line) = shift.place(self.offset, self.line)?;
        self.memory.shift(shift)
    }
}

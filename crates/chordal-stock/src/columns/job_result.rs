//! What jobs report in addition to lowering columns.

use super::ContactDepth;

/// Counts of the work of a job.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ColumnCounts {
    /// Evaluations of a column's floor.
    pub columns: u64,
    /// Blocks that were compared with a piece of the path.
    pub blocks: u64,
    /// Blocks that were set to one height as a whole.
    pub even: u64,
}

impl ColumnCounts {
    pub(crate) fn plus(self, other: ColumnCounts) -> ColumnCounts {
        ColumnCounts {
            columns: self.columns + other.columns,
            blocks: self.blocks + other.blocks,
            even: self.even + other.even,
        }
    }
}

/// The result of a job.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JobResult {
    pub(crate) tile: usize,
    /// Counts of its work.
    pub counts: ColumnCounts,
    /// Body, move, and how deep the body touches on the move on this tile.
    pub(crate) contacts: Vec<(u32, u32, ContactDepth)>,
}

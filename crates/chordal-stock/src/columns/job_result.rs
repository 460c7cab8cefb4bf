//! What jobs find besides lower columns.

use super::ContactDepth;

/// What was looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ColumnCounts {
    /// Columns whose floor was found, each time it was.
    pub columns: u64,
    /// Blocks that were compared with a piece of the path.
    pub blocks: u64,
    /// Blocks that became even at once.
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

/// What a job found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JobResult {
    pub(crate) tile: usize,
    /// What was looked at.
    pub counts: ColumnCounts,
    /// Body, move, and how deep the one touches on the other on this tile.
    pub(crate) contacts: Vec<(u32, u32, ContactDepth)>,
}

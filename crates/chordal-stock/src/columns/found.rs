//! What jobs find besides lower columns.

use super::Contact;

/// What was looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Columns whose floor was found, each time it was.
    pub columns: u64,
    /// Blocks that were compared with a piece of the path.
    pub blocks: u64,
    /// Blocks that became even at once.
    pub even: u64,
}

impl Counts {
    pub(crate) fn plus(self, other: Counts) -> Counts {
        Counts {
            columns: self.columns + other.columns,
            blocks: self.blocks + other.blocks,
            even: self.even + other.even,
        }
    }
}

/// What a job found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    pub(crate) tile: usize,
    /// What was looked at.
    pub counts: Counts,
    /// Body, move, and how deep the one touches on the other on this tile.
    pub(crate) contacts: Vec<(u32, u32, Contact)>,
}

//! What a plan comes to: the lines of each block, and what is told of them.

use super::Refusal;
use super::layout::Lines;
use crate::Change;

/// What a plan comes to.
#[derive(Default)]
pub(crate) struct Rendered {
    pub lines: Lines,
    pub changes: Vec<Change>,
    pub refusals: Vec<Refusal>,
    /// Text that the program printed is a remark now.
    pub printed: bool,
    /// Blocks that keep their words because they could not be written out.
    pub unwritten: Vec<Refusal>,
}

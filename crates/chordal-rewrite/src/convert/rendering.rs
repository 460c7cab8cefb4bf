//! What a plan comes to: the lines of each block, and what is told of them.

use super::ConvertRefusal;
use super::layout::BlockLines;
use crate::Change;

/// What a plan comes to.
#[derive(Default)]
pub(crate) struct RenderedPlan {
    pub lines: BlockLines,
    pub changes: Vec<Change>,
    pub refusals: Vec<ConvertRefusal>,
    /// Text that the program printed is a remark now.
    pub printed: bool,
    /// Blocks that keep their words because they could not be written out.
    pub unwritten: Vec<ConvertRefusal>,
}

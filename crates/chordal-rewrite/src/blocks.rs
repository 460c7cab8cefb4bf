//! The blocks of a text, one at a time.

use chordal::Control;
use chordal::diagnostics::FileId;
use chordal::syntax::{Block, BlockReader};

/// All blocks of a first text in order.
pub(crate) fn blocks_of<'a>(
    text: &'a [u8],
    control: &Control,
) -> impl Iterator<Item = Block> + use<'a> {
    let mut reader = BlockReader::new(text, FileId(0), control.table.lexicon);
    std::iter::from_fn(move || {
        let mut block = Block::new();
        reader.read(&mut block).then_some(block)
    })
}

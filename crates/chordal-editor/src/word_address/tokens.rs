//! The words of a text by what they are, for colours.

use chordal::control::{Token, block_tokens};

use super::WordAddressText;

/// Bytes of a block whose words have colours, at most: nobody writes a longer one, and no editor shows its colours.
const MAX_COLOURED: u32 = 20_000;

impl WordAddressText<'_> {
    /// The tokens of the lines from `from` up to, not including, `to`, in the order of the text.
    pub(crate) fn tokens(&self, from: u32, to: u32) -> Vec<Token> {
        let mut tokens = Vec::new();
        self.blocks(from, to, |block| {
            if block.range.len() <= MAX_COLOURED {
                block_tokens(self.text(), self.lexicon(), block, &mut tokens);
            }
        });
        tokens
    }
}

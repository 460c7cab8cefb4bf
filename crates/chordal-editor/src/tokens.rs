//! The words of a text by what they are, for colours.

use chordal::control::block_tokens;
pub use chordal::control::{Class, Token};

use crate::Program;

impl Program {
    /// The tokens of the lines from `from` up to, not including, `to`, in the order of the text.
    pub fn tokens(&self, from: u32, to: u32) -> Vec<Token> {
        let mut tokens = Vec::new();
        self.blocks(from, to, |block| {
            block_tokens(self.text(), self.lexicon(), block, &mut tokens);
        });
        tokens
    }
}

//! What moved the zero and holds, in the words of the program: G52, and a G92 before the first move.

use chordal::syntax::Block;

use crate::source::SourceBlocks;

/// The blocks that made it, while it is not back at zero.
#[derive(Clone, Debug, Default)]
pub(super) struct ActiveShift {
    pub(super) lines: Vec<String>,
    /// The axes that are off zero.
    axes: Vec<u8>,
    /// The blocks that gave the place where the program starts its coordinates.
    pub(super) presets: Vec<String>,
}

impl ActiveShift {
    /// Takes a block with G52; false where a value is no plain number, so that it cannot be said again.
    pub(super) fn take(&mut self, source: &SourceBlocks, block: &Block) -> bool {
        for word in &block.words {
            if !b"XYZABCUVW".contains(&word.letter) {
                continue;
            }
            let Some(number) = word.number() else { return false };
            self.axes.retain(|axis| *axis != word.letter);
            if number.to_f64() != 0.0 {
                self.axes.push(word.letter);
            }
        }
        self.lines.push(source.words_of(block));
        if self.axes.is_empty() {
            self.lines.clear();
        }
        true
    }

    /// Takes a block with G92 that stands before the first move: at the place where the program starts it can
    /// be said again. False where a value is no plain number.
    pub(super) fn take_preset(&mut self, source: &SourceBlocks, block: &Block) -> bool {
        self.presets.push(source.words_of(block));
        block.words.iter().all(|word| word.number().is_some())
    }
}

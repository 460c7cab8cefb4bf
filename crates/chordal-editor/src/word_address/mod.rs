//! What an editor asks about a program of word-address blocks.

mod complete;
mod format;
mod hover;
mod names;
mod outline;
mod tokens;

use std::ops::Deref;

use chordal::control::{Control, WordAddressControl};
use chordal::diagnostics::FileId;
use chordal::syntax::{Block, BlockReader, Lexicon};

pub use complete::{Completion, CompletionKind};
pub use format::NumberingOptions;
pub use names::{NameOccurrence, NameRole, RenameError, RenamedVariable, SymbolName};

use crate::EditorProgram;
use crate::meaning::ControlView;

/// A program of word-address blocks with the tables of its control.
#[derive(Clone, Copy)]
pub(crate) struct WordAddressText<'p> {
    program: &'p EditorProgram,
    control: &'p Control,
}

impl Deref for WordAddressText<'_> {
    type Target = EditorProgram;

    fn deref(&self) -> &EditorProgram {
        self.program
    }
}

impl EditorProgram {
    /// The program as one of word-address blocks; `None` when its language is another one.
    pub(crate) fn word_address(&self) -> Option<WordAddressText<'_>> {
        let control = WordAddressControl::tables(self.configured_control())?;
        Some(WordAddressText { program: self, control })
    }
}

impl<'p> WordAddressText<'p> {
    /// The control with its tables.
    fn control(&self) -> &'p Control {
        self.control
    }

    /// The text.
    fn text(&self) -> &'p [u8] {
        self.program.text()
    }

    /// How the control writes its text.
    fn lexicon(&self) -> &'static Lexicon {
        &self.control.table.lexicon
    }

    /// What explains words on the control.
    fn view(&self) -> ControlView {
        ControlView::of(self.control)
    }

    /// Shows every block from the start of line `from` up to, not including, line `to`.
    fn blocks(&self, from: u32, to: u32, mut see: impl FnMut(&Block)) {
        let mut reader = BlockReader::new(self.text(), FileId(0), *self.lexicon());
        let offset = self.source().line_start(from);
        reader.seek(chordal::syntax::BlockPosition { offset, line: from });
        reader.limit(self.source().line_start(to));
        let mut block = Block::new();
        while reader.read(&mut block) {
            see(&block);
        }
    }

    /// The block at a byte of the text, if there is one.
    fn block_at(&self, offset: u32) -> Option<Block> {
        let line = self.source().line_of(offset);
        let mut found = None;
        self.blocks(line, line.saturating_add(1), |block| {
            if block.range.start <= offset && offset <= block.range.end {
                found = Some(block.clone());
            }
        });
        found
    }
}

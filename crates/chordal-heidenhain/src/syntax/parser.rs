//! Blocks with their number, their skip sign and their statement.

use super::ast::KlartextBlock;
use super::cursor::TokenCursor;
use super::reader::{BlockLines, LineReader};
use super::statements::statement;
use super::tokens::scan_tokens;

/// Reads the blocks of a text in their order, from any place on.
#[derive(Clone, Debug)]
pub struct KlartextReader<'t> {
    lines: LineReader<'t>,
}

impl<'t> KlartextReader<'t> {
    /// At the start of a text.
    pub fn new(text: &'t [u8]) -> KlartextReader<'t> {
        KlartextReader { lines: LineReader::new(text) }
    }

    /// The first byte of the next block.
    pub fn offset(&self) -> u32 {
        self.lines.offset()
    }

    /// The line of the next block, from 1.
    pub fn line(&self) -> u32 {
        self.lines.line()
    }

    /// Goes to the block that begins at a byte, on a line.
    pub fn seek(&mut self, offset: u32, line: u32) {
        self.lines.seek(offset, line);
    }
}

impl Iterator for KlartextReader<'_> {
    type Item = KlartextBlock;

    fn next(&mut self) -> Option<KlartextBlock> {
        let lines = self.lines.next()?;
        Some(block_of_lines(self.lines.text(), &lines))
    }
}

/// Reads a block.
pub fn block_of_lines(text: &[u8], lines: &BlockLines) -> KlartextBlock {
    let mut tokens = Vec::new();
    lines.parts.iter().for_each(|part| scan_tokens(text, *part, &mut tokens));
    let mut cursor = TokenCursor::new(text, &tokens);
    let mut is_skippable = cursor.take_sign(b'/');
    // The number of the block stands before a word; a sign before it may mark the block as one to skip.
    let number = cursor.take_whole();
    is_skippable |= cursor.take_sign(b'/');
    let statement = statement(&mut cursor);
    KlartextBlock {
        range: lines.range,
        line: lines.line,
        number,
        is_skippable,
        statement,
        faults: cursor.faults,
    }
}

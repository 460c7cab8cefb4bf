//! Blocks with their number, their skip sign and their statement.

use chordal_diagnostics::TextRange;

use super::ast::{KlartextBlock, KlartextFaultKind};
use super::cursor::TokenCursor;
use super::iso::iso_statement;
use super::reader::{KlartextLines, LineReader};
use super::statements::statement;
use super::tokens::{KlartextTokenKind, scan_tokens};
use super::word_search::contains_ignoring_case;

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

    /// The next block that is more than a comment, if it contains one of these words and is no straight move; it is not
    /// taken.
    pub fn peek_with(&self, words: &[&[u8]]) -> Option<KlartextBlock> {
        if self.lines.next_is_straight() {
            return None;
        }
        let text = self.lines.text();
        let lines = self.lines.clone().find(|lines| is_more_than_comment(text, lines))?;
        let has_word = |part: &TextRange| {
            let part = part.slice(text);
            words.iter().any(|word| contains_ignoring_case(part, word))
        };
        lines.parts.iter().any(has_word).then(|| block_of_lines(text, &lines))
    }

    /// Goes to the block that begins at a byte, on a line.
    pub fn seek(&mut self, offset: u32, line: u32) {
        self.lines.seek(offset, line);
    }
}

impl Iterator for KlartextReader<'_> {
    type Item = KlartextBlock;

    fn next(&mut self) -> Option<KlartextBlock> {
        if let Some(block) = self.lines.take_plain_line() {
            return Some(block);
        }
        let lines = self.lines.next()?;
        Some(block_of_lines(self.lines.text(), &lines))
    }
}

/// Whether a block is no comment, heading or empty line.
fn is_more_than_comment(text: &[u8], lines: &KlartextLines) -> bool {
    let first = lines.parts.first().map(|part| part.slice(text));
    first.is_some_and(|first| {
        let digits = first.iter().take_while(|byte| byte.is_ascii_digit()).count();
        !matches!(first[digits..].trim_ascii_start().first(), None | Some(b'*'))
    })
}

/// Reads a block.
pub fn block_of_lines(text: &[u8], lines: &KlartextLines) -> KlartextBlock {
    let mut tokens = Vec::new();
    lines.parts.iter().for_each(|part| scan_tokens(text, *part, &mut tokens));
    let mut cursor = TokenCursor::new(text, &tokens);
    let mut is_skippable = cursor.take_sign(b'/');
    if lines.is_iso {
        let number = cursor.take_word("N").then(|| cursor.take_whole()).flatten();
        let statement = iso_statement(&mut cursor, number.is_some());
        let (range, line, faults) = (lines.range, lines.line, cursor.faults);
        return KlartextBlock { range, line, number, is_skippable, statement, faults };
    }
    // The number of the block stands before a word; a sign before it may mark the block as one to skip.
    let number = lettered_number(&mut cursor).or_else(|| cursor.take_whole());
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

/// `N12`: the number of a block as other languages write it, which is reported.
fn lettered_number(cursor: &mut TokenCursor<'_>) -> Option<u32> {
    let letter = cursor.peek()?.range;
    let is_number = cursor.peek_word() == Some("N")
        && matches!(cursor.peek_after(1)?.kind, KlartextTokenKind::Number(_));
    if !is_number {
        return None;
    }
    cursor.take();
    let number = cursor.take_whole()?;
    let range = cursor.range_from(letter);
    let message = format!("block numbers of this language have no N: write {number}");
    cursor.fault(KlartextFaultKind::Unreadable, range, message);
    Some(number)
}

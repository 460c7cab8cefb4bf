//! Reads the blocks of a program one after another.

use chordal_diagnostics::{TextRange, line_end_length};

use super::ast::ProgramBlock;
use super::parser::BlockParser;
use super::precedence::ComparisonPrecedence;
use super::scanner::is_blank;

/// Reads the blocks of a text from a place on. Lines without content and lines with `%` at their start are no blocks; a
/// line with only a comment is one.
#[derive(Clone)]
pub struct BlockReader<'t> {
    text: &'t [u8],
    at: usize,
    end: usize,
    line: u32,
    precedence: ComparisonPrecedence,
}

impl<'t> BlockReader<'t> {
    /// A reader of the whole text.
    pub fn new(text: &'t [u8]) -> BlockReader<'t> {
        let precedence = ComparisonPrecedence::default();
        BlockReader { text, at: byte_order_mark(text), end: text.len(), line: 1, precedence }
    }

    /// Reads comparisons with this precedence from now on.
    pub fn set_precedence(&mut self, precedence: ComparisonPrecedence) {
        self.precedence = precedence;
    }

    /// Goes on at the beginning of a line: its offset in bytes and its number from 1.
    pub fn seek(&mut self, offset: u32, line: u32) {
        let mark = if offset == 0 { byte_order_mark(self.text) } else { 0 };
        self.at = (offset as usize).max(mark);
        self.line = line;
    }

    /// Ends the text at an offset in bytes.
    pub fn limit(&mut self, end: u32) {
        self.end = self.text.len().min(end as usize);
    }

    /// The offset in bytes of the next line.
    pub fn offset(&self) -> u32 {
        self.at as u32
    }

    /// The number of the next line, from 1.
    pub fn line(&self) -> u32 {
        self.line
    }

    /// What is not read yet.
    pub(super) fn rest(&self) -> &'t [u8] {
        self.text.get(self.at..self.end).unwrap_or(&[])
    }

    /// Goes on after some bytes, in which so many lines end.
    pub(super) fn advance_lines(&mut self, bytes: usize, lines: u32) {
        self.at += bytes;
        self.line += lines;
    }

    /// Leaves out lines up to one that `ends`; without one the rest of the text.
    pub fn skip_lines_until(&mut self, ends: impl Fn(&[u8]) -> bool) {
        loop {
            let (at, line) = (self.at, self.line);
            let Some((range, _)) = self.next_line() else { return };
            if ends(range.slice(self.text)) {
                (self.at, self.line) = (at, line);
                return;
            }
        }
    }

    /// The next line with its number, whatever is in it; `None` at the end.
    pub(super) fn next_line(&mut self) -> Option<(TextRange, u32)> {
        let rest = self.text.get(self.at..self.end).filter(|rest| !rest.is_empty())?;
        let length = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
        let range = TextRange::new(self.at as u32, (self.at + length) as u32);
        let line = self.line;
        self.at += length;
        if length < rest.len() {
            self.at += line_end_length(&rest[length..]);
            self.line += 1;
        }
        Some((range, line))
    }
}

impl Iterator for BlockReader<'_> {
    type Item = ProgramBlock;

    fn next(&mut self) -> Option<ProgramBlock> {
        loop {
            let (range, line) = self.next_line()?;
            let content = range.slice(self.text).iter().find(|byte| !is_blank(**byte));
            if content.is_some_and(|first| *first != b'%') {
                return Some(BlockParser::new(self.text, range, line, self.precedence).read());
            }
        }
    }
}

/// The length of the byte order mark at the start of a text.
pub(super) fn byte_order_mark(text: &[u8]) -> usize {
    if text.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 }
}

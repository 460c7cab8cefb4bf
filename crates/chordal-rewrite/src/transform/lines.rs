//! Whole lines: line ends, what stands between blocks, words put together.

use chordal::diagnostics::TextRange;
use chordal::syntax::Block;

use super::edit::line_end;

/// The end of lines of a text.
pub(super) fn newline(text: &[u8]) -> &'static str {
    match text.iter().position(|byte| *byte == b'\n') {
        Some(at) if text[at..].starts_with(b"\n\r\r") => "\n\r\r",
        Some(at) if at > 0 && text[at - 1] == b'\r' => "\r\n",
        None if text.contains(&b'\r') => "\r",
        _ => "\n",
    }
}

/// What stands between the end of a block's words and the end of its line, when that is nothing but
/// blanks and an end of block: what a line put in after it ends with, too.
pub(super) fn tail<'a>(text: &'a [u8], block: &Block) -> Option<&'a str> {
    let rest = TextRange::new(block.range.end, line_end(text, block.range.end)).slice(text);
    let rest = std::str::from_utf8(rest).ok()?;
    rest.chars().all(|letter| letter.is_whitespace() || letter == ';').then_some(rest.trim_end())
}

/// Words of one block put together.
#[derive(Debug, Default)]
pub(super) struct BlockWords(Vec<String>);

impl BlockWords {
    pub(super) fn push(&mut self, word: impl Into<String>) {
        self.0.push(word.into());
    }

    pub(super) fn join(&self, gap: &str) -> String {
        self.0.join(gap)
    }
}

//! The part of a text that is run to compare its readings: all of a short text; of a long one its beginning, its end,
//! and the context of every line between that contains a kind of word which no earlier line had.

use std::borrow::Cow;

use super::word_kinds::WordKinds;

/// The length of the beginning of a long text that is run, bytes: some thousand blocks.
const BEGINNING_BYTES: usize = 64 << 10;

/// The length of the end of a long text that is run, bytes.
const END_BYTES: usize = 4 << 10;

/// The number of lines that are run before and after a line with a new kind of word, so that the block has nearly the
/// modes and the position of the whole program.
const CONTEXT_LINES: usize = 24;

/// A text with more lines of new kinds is run whole.
const EXCERPT_PIECES_LIMIT: usize = 64;

/// The parts of a text that are run, joined.
pub struct TrialExcerpt<'a> {
    /// The text to run.
    pub text: Cow<'a, [u8]>,
    /// Where each piece begins, as byte offsets in the excerpt and in the whole text.
    pieces: Vec<(usize, usize)>,
}

impl<'a> TrialExcerpt<'a> {
    /// The whole text.
    pub fn whole(text: &'a [u8]) -> TrialExcerpt<'a> {
        TrialExcerpt { text: Cow::Borrowed(text), pieces: vec![(0, 0)] }
    }

    /// The excerpt of a text; the whole text when it is short, or when calls or jumps could run a part of it more
    /// than once or not at all.
    pub fn of(text: &'a [u8]) -> TrialExcerpt<'a> {
        if text.len() <= BEGINNING_BYTES + END_BYTES {
            return TrialExcerpt::whole(text);
        }
        let beginning = line_end(text, BEGINNING_BYTES);
        let mut kinds = WordKinds::default();
        kinds.read(&text[..beginning]);
        let Some(mut ranges) = lines_of_new_kinds(text, beginning, &mut kinds) else {
            return TrialExcerpt::whole(text);
        };
        if kinds.jumps() {
            return TrialExcerpt::whole(text);
        }
        let end = line_end(text, text.len() - END_BYTES);
        ranges.push((end, text.len()));
        let mut excerpt = text[..beginning].to_vec();
        let mut pieces = vec![(0, 0)];
        let mut copied = beginning;
        for (start, end) in ranges {
            let start = start.max(copied);
            if start >= end {
                continue;
            }
            if start > copied {
                pieces.push((excerpt.len(), start));
            }
            excerpt.extend_from_slice(&text[start..end]);
            copied = end;
        }
        TrialExcerpt { text: Cow::Owned(excerpt), pieces }
    }

    /// Whether nothing of the text is left out.
    pub fn is_whole(&self) -> bool {
        self.pieces.len() == 1
    }

    /// The length of the first piece, bytes: up to there positions are exactly those of the whole program.
    pub fn beginning_bytes(&self) -> usize {
        self.pieces.get(1).map_or(self.text.len(), |(start, _)| *start)
    }

    /// The offset in the whole text of a byte of the excerpt.
    pub fn offset_in_text(&self, offset: u32) -> u32 {
        let piece = self.pieces.partition_point(|(start, _)| *start <= offset as usize);
        let (start, in_text) = self.pieces[piece.saturating_sub(1)];
        offset - start as u32 + in_text as u32
    }
}

/// The byte ranges around the lines from `from` on that have a kind of word which no earlier line had; `None` when
/// there are more than [`EXCERPT_PIECES_LIMIT`].
fn lines_of_new_kinds(
    text: &[u8],
    from: usize,
    kinds: &mut WordKinds,
) -> Option<Vec<(usize, usize)>> {
    let mut ranges = Vec::new();
    let mut start = from;
    while start < text.len() {
        let end = line_end(text, start);
        if kinds.read(&text[start..end]) {
            if ranges.len() == EXCERPT_PIECES_LIMIT {
                return None;
            }
            ranges.push((lines_back(text, start), lines_on(text, end)));
        }
        start = end;
    }
    Some(ranges)
}

/// The end of the line at an offset, after its line break.
fn line_end(text: &[u8], at: usize) -> usize {
    memchr::memchr2(b'\n', b'\r', &text[at..]).map_or(text.len(), |end| at + end + 1)
}

fn lines_back(text: &[u8], from: usize) -> usize {
    let ends = memchr::memrchr2_iter(b'\n', b'\r', &text[..from]);
    ends.take(CONTEXT_LINES + 1).last().map_or(0, |end| end + 1)
}

fn lines_on(text: &[u8], from: usize) -> usize {
    (0..CONTEXT_LINES).fold(from, |at, _| line_end(text, at.min(text.len())))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn long_text() -> Vec<u8> {
        let mut text = b"G21 G90\n".to_vec();
        for line in 0..40_000 {
            let special = if line == 20_000 { "G81 Z-5. R2.\n" } else { "" };
            text.extend(format!("X{}.5 Y1.25\n{special}", line % 97).bytes());
        }
        text.extend(b"M30\n");
        text
    }

    #[test]
    fn a_long_text_is_its_beginning_its_end_and_what_is_new_between() {
        let text = long_text();
        let excerpt = TrialExcerpt::of(&text);
        assert!(!excerpt.is_whole());
        assert!(excerpt.text.len() < BEGINNING_BYTES + 3 * END_BYTES);
        assert!(excerpt.text.ends_with(b"M30\n"));
        let found = memchr::memmem::find(&excerpt.text, b"G81").map(|at| at as u32);
        let there = memchr::memmem::find(&text, b"G81").map(|at| at as u32);
        assert_eq!(found.map(|at| excerpt.offset_in_text(at)), there);
    }

    #[test]
    fn a_text_with_calls_or_statements_is_run_whole() {
        for special in ["M98 P100\n", "G65 P9000\n", "#1=2\n", "O1\nO2\n", "L102\n"] {
            let mut text = long_text();
            text.extend(special.bytes());
            assert!(TrialExcerpt::of(&text).is_whole(), "{special}");
        }
    }
}

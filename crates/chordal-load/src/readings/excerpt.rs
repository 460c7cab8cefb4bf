//! What is run of a text to compare its readings: all of a short one; of a long one its beginning, its end, and the
//! surroundings of every line between that has a kind of word which no line before it had.

use std::borrow::Cow;

use super::word_kinds::WordKinds;

/// The beginning that is run of a long text, bytes: some thousand blocks.
const BEGINNING_BYTES: usize = 128 << 10;

/// The end that is run of a long text, bytes.
const END_BYTES: usize = 4 << 10;

/// Lines that are run before and after a line with a new kind of word, so that the modes and the position of
/// its block are those of its surroundings.
const CONTEXT_LINES: usize = 24;

/// A text with more such lines is run whole.
const EXCERPT_PIECES_LIMIT: usize = 64;

/// The parts of a text that are run, one after the other.
pub struct TrialExcerpt<'a> {
    /// What is run.
    pub text: Cow<'a, [u8]>,
    /// Where each piece begins: in the excerpt, and in the text.
    pieces: Vec<(usize, usize)>,
}

impl<'a> TrialExcerpt<'a> {
    /// The whole text.
    pub fn whole(text: &'a [u8]) -> TrialExcerpt<'a> {
        TrialExcerpt { text: Cow::Borrowed(text), pieces: vec![(0, 0)] }
    }

    /// Of a text; all of it where it is short, or where a part of it may run more than once or not at all.
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

    /// Nothing of the text is left out.
    pub fn is_whole(&self) -> bool {
        self.pieces.len() == 1
    }

    /// Where the beginning ends in the excerpt: the position is that of the program up to there.
    pub fn beginning_bytes(&self) -> usize {
        self.pieces.get(1).map_or(self.text.len(), |(start, _)| *start)
    }

    /// Where a byte of the excerpt stands in the text.
    pub fn offset_in_text(&self, offset: u32) -> u32 {
        let piece = self.pieces.partition_point(|(start, _)| *start <= offset as usize);
        let (start, in_text) = self.pieces[piece.saturating_sub(1)];
        offset - start as u32 + in_text as u32
    }
}

/// The surroundings of the lines from there on that have a kind of word which no line before them had; nothing
/// where there are too many.
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

/// The end of the line at a place, after its line feed.
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

//! Maps locations in a text to their locations after a change.

use crate::source::line_ends;
use crate::{Diagnostic, FileId, Span, TextRange};

/// The difference between two texts as one changed range, and how far the text after it has moved.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TextShift {
    /// The replaced bytes in the old text.
    changed: TextRange,
    /// The replaced bytes with the lines around them, whose interpretation the change may affect.
    touched: TextRange,
    bytes: i64,
    lines: i64,
}

impl TextShift {
    /// Compares two texts.
    pub fn between(old: &[u8], new: &[u8]) -> TextShift {
        let before = common(old, new);
        let rest = old.len().min(new.len()) - before;
        let following = old.len() - common_end(&old[old.len() - rest..], &new[new.len() - rest..]);
        let from = line_start_above(old, before);
        let to = line_ends(&old[following..]).nth(1).map_or(old.len(), |end| following + end);
        let bytes = new.len() as i64 - old.len() as i64;
        let count = |text: &[u8]| line_ends(text).count() as i64;
        let to_new = (to as i64 + bytes) as usize;
        TextShift {
            changed: TextRange::new(before as u32, following as u32),
            touched: TextRange::new(from as u32, to as u32),
            bytes,
            lines: count(&new[from..to_new]) - count(&old[from..to]),
        }
    }

    /// By how many lines the text after the change has moved.
    pub fn lines(&self) -> i64 {
        self.lines
    }

    /// Whether a range of the old text is outside of the change and of the lines next to it.
    pub fn leaves(&self, range: TextRange) -> bool {
        range.end <= self.touched.start || range.start >= self.touched.end
    }

    /// The new offset of an offset in the old text; `None` inside the replaced bytes.
    pub fn offset(&self, offset: u32) -> Option<u32> {
        if offset < self.changed.end {
            return (offset <= self.changed.start).then_some(offset);
        }
        Some(self.moved(offset))
    }

    /// The new offset and line of an offset and its line in the old text; `None` inside the replaced bytes.
    pub fn place(&self, offset: u32, line: u32) -> Option<(u32, u32)> {
        let lines = if offset < self.changed.end { 0 } else { self.lines };
        Some((self.offset(offset)?, u32::try_from(i64::from(line) + lines).ok()?))
    }

    fn moved(&self, offset: u32) -> u32 {
        (i64::from(offset) + self.bytes) as u32
    }

    /// The new range of a range in the old text; `None` when it overlaps the replaced bytes.
    pub fn range(&self, range: TextRange) -> Option<TextRange> {
        if range.end <= self.changed.start {
            return Some(range);
        }
        let following = range.start >= self.changed.end;
        following.then(|| TextRange::new(self.moved(range.start), self.moved(range.end)))
    }

    /// The new span of a span; only the first text of a job has changed.
    pub fn span(&self, span: Span) -> Option<Span> {
        if span.file != FileId(0) {
            return Some(span);
        }
        self.range(span.range).map(|range| range.in_file(span.file))
    }

    /// Moves a diagnostic of the old text to the new text; `None` when one of its spans overlaps the replaced bytes.
    pub fn diagnostic(&self, diagnostic: &mut Diagnostic) -> Option<()> {
        let Diagnostic { primary, secondary, fix, other_fixes, calls, .. } = diagnostic;
        let labels = std::iter::once(primary).chain(secondary).map(|label| &mut label.span);
        let fix = fix.iter_mut().chain(other_fixes).map(|fix| &mut fix.span);
        for span in labels.chain(fix).chain(calls) {
            *span = self.span(*span)?;
        }
        Some(())
    }
}

/// The length of the common beginning of two texts, bytes.
fn common(one: &[u8], other: &[u8]) -> usize {
    const STEP: usize = 4096;
    let mut at = 0;
    let most = one.len().min(other.len());
    while at + STEP <= most && one[at..at + STEP] == other[at..at + STEP] {
        at += STEP;
    }
    at + one[at..most].iter().zip(&other[at..most]).take_while(|(a, b)| a == b).count()
}

/// The length of the common end of two texts of equal length, bytes.
fn common_end(one: &[u8], other: &[u8]) -> usize {
    const STEP: usize = 4096;
    let mut left = one.len();
    while left >= STEP && one[left - STEP..left] == other[left - STEP..left] {
        left -= STEP;
    }
    let same = one[..left].iter().rev().zip(other[..left].iter().rev());
    one.len() - left + same.take_while(|(a, b)| a == b).count()
}

/// The start of the line above the line of an offset.
fn line_start_above(text: &[u8], at: usize) -> usize {
    let mut starts = memchr::memchr2_iter(b'\n', b'\r', &text[..at])
        .rev()
        .map(|i| i + 1)
        .filter(|&end| !matches!(text.get(end), Some(b'\n' | b'\r')));
    starts.nth(1).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_before_stay_and_words_behind_move() {
        let old = b"N1\nN2\nN3 X1.\nN4\nN5\nN6\n";
        let new = b"N1\nN2\nN3 X1.\nG4\nX22.\nN4\nN5\nN6\n";
        let shift = TextShift::between(old, new);
        assert_eq!(shift.lines(), 2);
        assert_eq!(shift.range(TextRange::new(3, 5)), Some(TextRange::new(3, 5)));
        let last = TextRange::new(19, 21);
        let moved = shift.range(last).map(|range| range.slice(new));
        assert_eq!((last.slice(old), moved), (&b"N6"[..], Some(&b"N6"[..])));
        assert!(shift.leaves(TextRange::new(0, 3)) && !shift.leaves(TextRange::new(0, 7)));
        assert!(shift.leaves(TextRange::new(19, 22)) && !shift.leaves(TextRange::new(13, 16)));
        assert_eq!(shift.place(19, 6), Some((27, 8)));
    }

    #[test]
    fn words_that_went_are_nowhere() {
        let shift = TextShift::between(b"G0 X1.\nG1 Y2.\nM30\n", b"G0 X1.\nM30\n");
        assert_eq!(shift.lines(), -1);
        let gone = shift.range(TextRange::new(10, 13));
        assert_eq!(gone, None);
    }

    #[test]
    fn a_text_that_is_the_same_leaves_everything() {
        let text = b"G0 X1.\r\nM30\r\n";
        let shift = TextShift::between(text, text);
        assert_eq!(shift.lines(), 0);
        for at in 0..=text.len() as u32 {
            assert_eq!(shift.place(at, 1), Some((at, 1)));
        }
        let shift = TextShift::between(b"", b"G0\n");
        assert_eq!(shift.place(0, 1), Some((3, 2)), "what the end was is the end");
    }

    #[test]
    fn half_a_line_end_is_no_line() {
        let shift = TextShift::between(b"A\rB\rC\rD\r", b"A\r\nB\rC\rD\r");
        assert_eq!(shift.lines(), 0);
        let shift = TextShift::between(b"A\r\nB\r\nC\r\nD", b"A\r\nB\r\nC\r\r\nD");
        assert_eq!(shift.lines(), 1);
    }
}

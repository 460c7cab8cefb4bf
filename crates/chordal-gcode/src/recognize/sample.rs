//! The parts of a text that are examined: of a very long one its start, its end and some parts between.

use std::ops::Range;

/// Size of the part at the start, with most signs, bytes.
const HEAD: usize = 96 << 10;

/// Size of the part at the end, bytes.
const TAIL: usize = 32 << 10;

/// Number of parts between.
const BETWEEN: usize = 8;
/// Size of each part between, bytes.
const PART: usize = 8 << 10;

/// The parts in order. Each starts and ends at a line; a line longer than a part is cut.
pub fn parts(text: &[u8]) -> Vec<Range<usize>> {
    if text.len() <= HEAD + TAIL + BETWEEN * PART {
        return std::iter::once(0..text.len()).collect();
    }
    let (from, to) = (HEAD, text.len() - TAIL);
    let step = (to - from) / BETWEEN;
    let between = (0..BETWEEN).map(|index| from + index * step + step / 2);
    let head = std::iter::once(0..line_start(text, HEAD));
    let mut parts: Vec<Range<usize>> = head.collect();
    parts.extend(between.map(|at| line_start(text, at)..line_start(text, at + PART)));
    parts.push(line_start(text, to)..text.len());
    parts
}

/// The start of the next line after an offset, or the offset itself when the line is too long.
fn line_start(text: &[u8], at: usize) -> usize {
    let near = &text[at..text.len().min(at + PART)];
    memchr::memchr2(b'\n', b'\r', near).map_or(at, |end| at + end + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_begin_with_lines_and_do_not_overlap() {
        let text = b"G1 X10.000 Y20.000\n".repeat(60_000);
        let parts = parts(&text);
        assert_eq!(parts.len(), BETWEEN + 2);
        assert!(parts.windows(2).all(|pair| pair[0].end <= pair[1].start));
        assert!(parts.iter().all(|part| text[part.clone()].starts_with(b"G1")));
        assert_eq!(parts.last().map(|part| part.end), Some(text.len()));
    }

    #[test]
    fn a_short_text_is_one_part() {
        assert_eq!(parts(b"G0"), std::iter::once(0..2).collect::<Vec<_>>());
    }
}

//! A text with its name, and the lines and columns in it.

use std::borrow::Cow;
use std::sync::{Mutex, OnceLock, PoisonError};

/// The line index stores one offset per this many lines: the index of a gigabyte of short lines then takes about six
/// megabytes, and a look-up counts at most this many lines.
const LINES_PER_MARK: u32 = 64;

/// A text with its name. The bytes are stored unchanged (as a `Cow`, so that a mapped file is not copied); the line
/// index is built at its first use.
#[derive(Debug)]
pub struct Source<'a> {
    name: String,
    text: Cow<'a, [u8]>,
    marks: OnceLock<Vec<u32>>,
    /// The last computed offset with its line and column. The next one is mostly a little further on, perhaps in a
    /// very long line.
    counted: Mutex<Option<(u32, LineColumn)>>,
}

/// A line and column as displayed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub struct LineColumn {
    /// The line, from 1.
    pub line: u32,
    /// The column, from 1, in characters.
    pub column: u32,
}

impl<'a> Source<'a> {
    /// A text with the name that messages show.
    pub fn new(name: impl Into<String>, text: impl Into<Cow<'a, [u8]>>) -> Source<'a> {
        let (name, text) = (name.into(), text.into());
        Source { name, text, marks: OnceLock::new(), counted: Mutex::new(None) }
    }

    /// The name that messages show.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The whole text.
    pub fn text(&self) -> &[u8] {
        &self.text
    }

    /// Returns the text without its name.
    pub fn into_text(self) -> Cow<'a, [u8]> {
        self.text
    }

    fn marks(&self) -> &[u32] {
        self.marks.get_or_init(|| {
            let mut marks = vec![0];
            let mut line = 0u32;
            for end in line_ends(&self.text) {
                line += 1;
                if line.is_multiple_of(LINES_PER_MARK) {
                    marks.push(end as u32);
                }
            }
            marks
        })
    }

    /// The line (from 1) that contains the byte at `offset`.
    pub fn line_of(&self, offset: u32) -> u32 {
        let marks = self.marks();
        let mark = marks.partition_point(|&start| start <= offset) - 1;
        let from = marks[mark] as usize;
        let to = (offset as usize).min(self.text.len());
        let inside = line_ends(&self.text[from..]).take_while(|&end| from + end <= to).count();
        mark as u32 * LINES_PER_MARK + inside as u32 + 1
    }

    /// The offset of the first byte of a line (from 1); the end of the text for lines after the last.
    pub fn line_start(&self, line: u32) -> u32 {
        let index = line.saturating_sub(1);
        let mark = (index / LINES_PER_MARK) as usize;
        let Some(&from) = self.marks().get(mark) else { return self.text.len() as u32 };
        let rest = index % LINES_PER_MARK;
        if rest == 0 {
            return from;
        }
        line_ends(&self.text[from as usize..])
            .nth(rest as usize - 1)
            .map_or(self.text.len() as u32, |end| from + end as u32)
    }

    /// The bytes of a line (from 1) without its line end.
    pub fn line_text(&self, line: u32) -> &[u8] {
        let start = self.line_start(line) as usize;
        let rest = &self.text[start.min(self.text.len())..];
        let end = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
        &rest[..end]
    }

    /// The line and the column of a byte offset.
    pub fn line_column(&self, offset: u32) -> LineColumn {
        let mut counted = self.counted.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(place) = counted.and_then(|last| self.counted_on(last, offset)) {
            *counted = Some((offset, place));
            return place;
        }
        let line = self.line_of(offset);
        let start = self.line_start(line) as usize;
        let head = &self.text[start..(offset as usize).clamp(start, self.text.len())];
        let Ok(text) = std::str::from_utf8(head) else {
            let column = String::from_utf8_lossy(head).chars().count() as u32 + 1;
            return LineColumn { line, column };
        };
        let place = LineColumn { line, column: text.chars().count() as u32 + 1 };
        *counted = (offset as usize <= self.text.len()).then_some((offset, place));
        place
    }

    /// The line and column of an offset on the same line after a known one; `None` on another line or when the text
    /// between is not UTF-8.
    fn counted_on(&self, (from, place): (u32, LineColumn), offset: u32) -> Option<LineColumn> {
        let between = self.text.get(from as usize..offset as usize)?;
        // After a line end, the same offset may count as the end of a line or as the beginning of the next.
        if memchr::memchr2(b'\n', b'\r', between).is_some() {
            return None;
        }
        let more = std::str::from_utf8(between).ok()?.chars().count() as u32;
        Some(LineColumn { column: place.column + more, ..place })
    }
}

/// The offsets after each line end. Line ends are LF, CR LF, a single CR, and LF CR CR, which controls punch.
pub fn line_ends(text: &[u8]) -> impl Iterator<Item = usize> + '_ {
    let mut done = 0;
    memchr::memchr2_iter(b'\n', b'\r', text).filter_map(move |at| {
        let begins = at >= done;
        if begins {
            done = at + line_end_length(&text[at..]);
        }
        begins.then_some(done)
    })
}

/// The length of the line end at the beginning of `text`, bytes.
#[inline]
pub fn line_end_length(text: &[u8]) -> usize {
    match text {
        [b'\r', b'\n', ..] => 2,
        [b'\n', b'\r', b'\r', ..] => 3,
        _ => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_with_lf_crlf_and_cr() {
        let source = Source::new("t", &b"a\nbb\r\nc\rd"[..]);
        let starts: Vec<u32> = (1..=5).map(|line| source.line_start(line)).collect();
        assert_eq!(starts, [0, 2, 6, 8, 9]);
        let lines: Vec<u32> = (0..9).map(|offset| source.line_of(offset)).collect();
        assert_eq!(lines, [1, 1, 2, 2, 2, 2, 3, 3, 4]);
        assert_eq!(source.line_text(2), b"bb");
        assert_eq!(source.line_text(9), b"");
    }

    #[test]
    fn a_punched_line_end_is_one() {
        let source = Source::new("t", &b"a\n\r\rbb\n\r\r\n\r\rc\n\rd"[..]);
        let starts: Vec<u32> = (1..=6).map(|line| source.line_start(line)).collect();
        assert_eq!(starts, [0, 4, 9, 12, 14, 15]);
        assert_eq!([3, 4, 8, 12].map(|offset| source.line_of(offset)), [1, 2, 2, 4]);
        assert_eq!(source.line_text(2), b"bb");
    }

    #[test]
    fn far_lines_are_found_from_the_marks() {
        let text: String = (1..=5000).map(|n| format!("N{n}\n")).collect();
        let source = Source::new("t", text.as_bytes());
        for line in [1, 511, 512, 513, 1024, 4999, 5000] {
            assert_eq!(source.line_text(line), format!("N{line}").as_bytes());
            assert_eq!(source.line_of(source.line_start(line)), line);
        }
    }

    #[test]
    fn places_do_not_depend_on_what_was_asked_before() {
        let odd = b"a\xc3\x98\xff b\r\n\xe2\x82 X\n\r\rc\rG1 \xe2\x82\xac X1 Y2\n\nend".as_slice();
        let ends = odd.len() as u32 + 3;
        let fresh = |offset| Source::new("t", odd).line_column(offset);
        let asked = Source::new("t", odd);
        let mut at = 7;
        for _ in 0..2000 {
            at = (at * 31 + 17) % 1009;
            let from = at % ends;
            for offset in [from, from + 1, from + 3, from] {
                assert_eq!(asked.line_column(offset), fresh(offset), "{offset}");
            }
        }
    }

    #[test]
    fn columns_count_characters() {
        let source = Source::new("t", "(Ø) X1".as_bytes());
        assert_eq!(source.line_column(5), LineColumn { line: 1, column: 5 });
    }
}

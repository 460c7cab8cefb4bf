//! Texts by name, and the lines and columns in them.

use std::borrow::Cow;
use std::sync::OnceLock;

use crate::appended::Appended;
use crate::{FileId, Span};

/// Every this many lines the line index keeps one offset: a gigabyte of short lines
/// then costs about half a megabyte of index, and a look-up counts at most this many.
const LINES_PER_MARK: u32 = 512;

/// A text and its name. The bytes are kept as they came (`Cow`, so that a mapped file
/// is not copied); the line index is made on the first question.
#[derive(Debug)]
pub struct Source<'a> {
    name: String,
    text: Cow<'a, [u8]>,
    marks: OnceLock<Vec<u32>>,
}

/// A place as people count it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub struct LineColumn {
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1, in characters.
    pub column: u32,
}

impl<'a> Source<'a> {
    /// A text under a name that messages show.
    pub fn new(name: impl Into<String>, text: impl Into<Cow<'a, [u8]>>) -> Source<'a> {
        Source { name: name.into(), text: text.into(), marks: OnceLock::new() }
    }

    /// The name that messages show.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The whole text.
    pub fn text(&self) -> &[u8] {
        &self.text
    }

    /// The text alone.
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

    /// Line (from 1) that holds the byte at `offset`.
    pub fn line_of(&self, offset: u32) -> u32 {
        let marks = self.marks();
        let mark = marks.partition_point(|&start| start <= offset) - 1;
        let from = marks[mark] as usize;
        let to = (offset as usize).min(self.text.len());
        let inside = line_ends(&self.text[from..]).take_while(|&end| from + end <= to).count();
        mark as u32 * LINES_PER_MARK + inside as u32 + 1
    }

    /// Offset of the first byte of a line (from 1); the end of the text for lines past it.
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

    /// Line and column of a byte.
    pub fn line_column(&self, offset: u32) -> LineColumn {
        let line = self.line_of(offset);
        let start = self.line_start(line) as usize;
        let head = &self.text[start..(offset as usize).clamp(start, self.text.len())];
        LineColumn { line, column: String::from_utf8_lossy(head).chars().count() as u32 + 1 }
    }
}

/// Offsets just past each line end: LF, CR LF and a lone CR all end a line.
pub(crate) fn line_ends(text: &[u8]) -> impl Iterator<Item = usize> + '_ {
    memchr::memchr2_iter(b'\n', b'\r', text)
        .filter(|&at| !(text[at] == b'\r' && text.get(at + 1) == Some(&b'\n')))
        .map(|at| at + 1)
}

/// The texts of a job, by [`FileId`].
#[derive(Debug, Default)]
pub struct SourceMap<'a> {
    sources: Vec<Source<'a>>,
    appended: Appended,
}

impl<'a> SourceMap<'a> {
    /// No texts yet.
    pub fn new() -> SourceMap<'a> {
        SourceMap::default()
    }

    /// Adds a text and returns its number. All are added before one is appended.
    pub fn add(&mut self, source: Source<'a>) -> FileId {
        self.sources.push(source);
        FileId(self.sources.len() as u32 - 1)
    }

    /// Keeps a text that a run has come by and returns its number: the same one for the same
    /// name and text. `None` beyond 10,000 texts or 64 MiB.
    pub fn append(&self, name: &str, text: &str) -> Option<FileId> {
        let place = self.appended.place(name, text)?;
        u32::try_from(self.sources.len() + place).ok().map(FileId)
    }

    /// The texts that were appended, in order.
    pub fn appended(&self) -> impl Iterator<Item = &Source<'a>> {
        self.appended.iter().map(|source| -> &Source<'a> { source })
    }

    /// The text of a number that this map gave out.
    pub fn get(&self, file: FileId) -> Option<&Source<'a>> {
        let place = file.0 as usize;
        self.sources.get(place).or_else(|| self.appended.get(place - self.sources.len()))
    }

    /// The texts that were added, in order.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &Source<'a>)> {
        self.sources.iter().enumerate().map(|(index, source)| (FileId(index as u32), source))
    }

    /// The words of a span, as text for people (bytes that are not UTF-8 are replaced).
    pub fn words(&self, span: Span) -> Cow<'_, str> {
        self.get(span.file)
            .map_or(Cow::Borrowed(""), |s| String::from_utf8_lossy(span.range.slice(s.text())))
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
    fn far_lines_are_found_from_the_marks() {
        let text: String = (1..=5000).map(|n| format!("N{n}\n")).collect();
        let source = Source::new("t", text.as_bytes());
        for line in [1, 511, 512, 513, 1024, 4999, 5000] {
            assert_eq!(source.line_text(line), format!("N{line}").as_bytes());
            assert_eq!(source.line_of(source.line_start(line)), line);
        }
    }

    #[test]
    fn an_appended_text_is_kept_once_and_read_like_any() {
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.nc", &b"M120"[..]));
        let first = sources.append("M120", "G4 P1.");
        let source = first.and_then(|file| sources.get(file)).map(Source::text);
        assert_eq!((first, source), (Some(FileId(1)), Some(&b"G4 P1."[..])));
        assert_eq!(sources.append("M121", "G4 P1."), Some(FileId(2)));
        assert_eq!(sources.append("M120", "G4 P1."), first);
        assert_eq!(sources.append("M120", "G4 P2."), Some(FileId(3)));
        assert_eq!(sources.get(FileId(4)).map(Source::name), None);
        assert_eq!((sources.iter().count(), sources.appended().count()), (1, 3));
    }

    #[test]
    fn appended_texts_have_a_bound() {
        let sources = SourceMap::new();
        let half = "G1\n".repeat(12 << 20);
        assert!(sources.append("a", &half).is_some());
        assert!(sources.append("b", &half).is_none());
        assert!(sources.append("a", &half).is_some(), "it is there already");
        let most = (0..20_000).take_while(|n| sources.append("n", &n.to_string()).is_some());
        assert_eq!(most.count(), 9_999);
    }

    #[test]
    fn columns_count_characters() {
        let source = Source::new("t", "(Ø) X1".as_bytes());
        assert_eq!(source.line_column(5), LineColumn { line: 1, column: 5 });
    }
}

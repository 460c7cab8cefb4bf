//! Where a span is, as people count.

use chordal::diagnostics::LineColumn;
use chordal::{SourceMap, Span};

/// A span as file, lines and columns. The end is the column after the last character.
#[derive(Clone, Debug, PartialEq)]
pub struct SourceLocation<'a> {
    /// The name of the text.
    pub file: &'a str,
    /// Its first character.
    pub start: LineColumn,
    /// After its last character.
    pub end: LineColumn,
}

/// The place of a span; `None` for the span that stands for the program as a whole, and
/// outside the text.
pub fn place<'a>(span: Span, sources: &'a SourceMap) -> Option<SourceLocation<'a>> {
    if span == Span::default() {
        return None;
    }
    let source = sources.get(span.file)?;
    if span.range.start as usize > source.text().len() {
        return None;
    }
    let start = source.line_column(span.range.start);
    let end = source.line_column(span.range.end.max(span.range.start));
    Some(SourceLocation { file: source.name(), start, end })
}

/// The block of a call: its place, and its text for people.
pub(crate) fn call_text(span: Span, sources: &SourceMap) -> String {
    let words = sources.words(span);
    let words = words.trim();
    match words.char_indices().nth(MAX_CALL) {
        Some((end, _)) => format!("{}…", &words[..end]),
        None => words.into(),
    }
}

const MAX_CALL: usize = 60;

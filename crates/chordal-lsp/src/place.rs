//! Converts positions: the protocol counts lines from 0 and UTF-16 code units, texts count bytes.

use chordal::Source;
use chordal::diagnostics::TextRange;
use chordal_editor::{byte_of, line_and_column};
use lsp_types::{Position, Range};

/// The byte offset of a position; a position after the end of its line gives the line's end.
pub fn offset_of(source: &Source<'_>, place: Position) -> u32 {
    byte_of(source, place.line.saturating_add(1), place.character)
}

/// The position of a byte offset.
pub fn place_of(source: &Source<'_>, offset: u32) -> Position {
    let (line, character) = line_and_column(source, offset);
    Position { line: line - 1, character }
}

/// The protocol range of a byte range.
pub fn range_of(source: &Source<'_>, range: TextRange) -> Range {
    Range { start: place_of(source, range.start), end: place_of(source, range.end) }
}

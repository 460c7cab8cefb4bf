//! Places: the protocol counts lines from 0 and UTF-16 units, texts count bytes.

use chordal::Source;
use chordal::diagnostics::TextRange;
use lsp_types::{Position, Range};

/// The byte of a place; a place behind the end of its line is the line's end.
pub fn offset_of(source: &Source<'_>, place: Position) -> u32 {
    let line = place.line.saturating_add(1);
    let start = source.line_start(line);
    let text = source.line_text(line);
    if text.is_ascii() {
        return start + place.character.min(text.len() as u32);
    }
    let text = String::from_utf8_lossy(text);
    let mut units = 0;
    let mut bytes = 0;
    for letter in text.chars() {
        if units >= place.character {
            break;
        }
        units += letter.len_utf16() as u32;
        bytes += letter.len_utf8() as u32;
    }
    start + bytes
}

/// The place of a byte.
pub fn place_of(source: &Source<'_>, offset: u32) -> Position {
    let offset = offset.min(source.text().len() as u32);
    let line = source.line_of(offset);
    let start = source.line_start(line);
    let head = TextRange::new(start, offset).slice(source.text());
    let units = if head.is_ascii() {
        head.len() as u32
    } else {
        String::from_utf8_lossy(head).encode_utf16().count() as u32
    };
    Position { line: line - 1, character: units }
}

/// The range of some bytes.
pub fn range_of(source: &Source<'_>, range: TextRange) -> Range {
    Range { start: place_of(source, range.start), end: place_of(source, range.end) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_count_utf_16_units() {
        let source = Source::new("t", "G0\n(ä𝄞b) X1\r\nM30".as_bytes());
        let there = |line, character| offset_of(&source, Position { line, character });
        assert_eq!(there(0, 1), 1);
        assert_eq!(there(0, 99), 2, "the end of the line");
        // ä is two bytes and one unit, 𝄞 four bytes and two units.
        assert_eq!(there(1, 2), 6);
        assert_eq!(there(1, 4), 10);
        assert_eq!(there(9, 0), source.text().len() as u32);
        for offset in [0, 1, 2, 3, 4, 6, 10, 11, 12, 17] {
            assert_eq!(offset_of(&source, place_of(&source, offset)), offset);
        }
    }
}

//! Places as editors count them: a line, and in it units of UTF-16. Texts count bytes.

use chordal::Source;
use chordal::diagnostics::TextRange;

/// The byte of a line (from 1) and a column (from 0, UTF-16); a column after the line's end is
/// its end, one within a character is after it.
pub fn byte_of(source: &Source<'_>, line: u32, column: u32) -> u32 {
    let start = source.line_start(line);
    let text = source.line_text(line);
    if text.is_ascii() {
        return start + column.min(text.len() as u32);
    }
    let text = String::from_utf8_lossy(text);
    let mut units = 0;
    let before = text.chars().take_while(|letter| {
        let here = units;
        units += letter.len_utf16() as u32;
        here < column
    });
    start + before.map(char::len_utf8).sum::<usize>() as u32
}

/// The line (from 1) and the column (from 0, UTF-16) of a byte.
pub fn line_and_column(source: &Source<'_>, offset: u32) -> (u32, u32) {
    let offset = offset.min(source.text().len() as u32);
    let line = source.line_of(offset);
    let head = TextRange::new(source.line_start(line), offset).slice(source.text());
    (line, units(head))
}

/// Lines and columns of many places of a text. Those that follow one another cost what lies between them: in a
/// line of a megabyte, counting each from the start of the line would take minutes.
#[derive(Clone, Debug)]
pub struct LineColumnIndex<'s, 't> {
    source: &'s Source<'t>,
    line: u32,
    /// Where the next line begins.
    next_line: u32,
    /// The last place, and its column.
    offset: u32,
    column: u32,
}

impl<'s, 't> LineColumnIndex<'s, 't> {
    /// Of a text.
    pub fn of(source: &'s Source<'t>) -> LineColumnIndex<'s, 't> {
        LineColumnIndex { source, line: 0, next_line: 0, offset: 0, column: 0 }
    }

    /// The line (from 1) and the column (from 0, UTF-16) of a byte.
    pub fn at(&mut self, offset: u32) -> (u32, u32) {
        let offset = offset.min(self.source.text().len() as u32);
        if offset < self.offset || offset >= self.next_line {
            let line = self.source.line_of(offset);
            // Back in a line, or in another one: counted from its start.
            (self.line, self.offset, self.column) = (line, self.source.line_start(line), 0);
            self.next_line = self.source.line_start(line + 1);
        }
        let between = TextRange::new(self.offset, offset).slice(self.source.text());
        self.column += units(between);
        self.offset = offset;
        (self.line, self.column)
    }
}

/// UTF-16 code units of a piece of text.
fn units(text: &[u8]) -> u32 {
    if text.is_ascii() {
        text.len() as u32
    } else {
        String::from_utf8_lossy(text).encode_utf16().count() as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_utf_16_units() {
        let source = Source::new("t", "G0\n(ä𝄞b) X1\r\nM30".as_bytes());
        let there = |line, column| byte_of(&source, line, column);
        assert_eq!(there(1, 1), 1);
        assert_eq!(there(1, 99), 2, "the end of the line");
        // ä is two bytes and one unit, 𝄞 four bytes and two units.
        assert_eq!(there(2, 2), 6);
        assert_eq!(there(2, 4), 10);
        assert_eq!(there(10, 0), source.text().len() as u32);
        let mut places = LineColumnIndex::of(&source);
        for offset in [0, 1, 2, 3, 4, 6, 10, 11, 12, 17, 6, 4, 10, 0, 3, 17, 99] {
            let (line, column) = line_and_column(&source, offset);
            assert_eq!(there(line, column), offset.min(source.text().len() as u32));
            assert_eq!(places.at(offset), (line, column), "{offset}");
        }
    }
}

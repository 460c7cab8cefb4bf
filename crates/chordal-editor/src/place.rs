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
    let column = if head.is_ascii() {
        head.len()
    } else {
        String::from_utf8_lossy(head).encode_utf16().count()
    };
    (line, column as u32)
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
        for offset in [0, 1, 2, 3, 4, 6, 10, 11, 12, 17] {
            let (line, column) = line_and_column(&source, offset);
            assert_eq!(there(line, column), offset);
        }
    }
}

//! The edited text, and the format in which its file is written.
//!
//! The page needs only the order of lines, so the text is stored with LF line ends; the line ends and the encoding of
//! the file are restored when it is saved. Offsets in changes are UTF-16 code units, as in a browser.

use chordal::diagnostics::line_ends;
use chordal::syntax;
use encoding_rs::mem::{decode_latin1, encode_latin1_lossy, is_str_latin1};

use crate::request::TextChange;

/// The character encoding of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FileEncoding {
    Utf8,
    /// An unknown 8-bit encoding: every byte is stored as the character with its number (Latin-1).
    Bytes,
    Utf16Le,
    Utf16Be,
}

/// The format of a file: encoding and line ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextFileForm {
    encoding: FileEncoding,
    mark: bool,
    ending: &'static str,
    /// The file has different line ends; saving writes only the most frequent one.
    pub mixed: bool,
}

/// A character that the encoding of the file does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "line {line} has the character `{character}`, which the file's 8-bit encoding does not have"
)]
pub struct UnencodableCharacter {
    /// The line of the first such character, from 1.
    pub line: usize,
    /// The first such character.
    pub character: char,
}

/// A change whose offsets do not fit the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the change from {from} to {to} does not fit the text of {length} characters")]
pub struct ChangeMismatch {
    from: usize,
    to: usize,
    length: usize,
}

/// A text with the format of its file.
#[derive(Clone, Debug)]
pub struct EditedText {
    text: String,
    form: TextFileForm,
    /// The file is binary: nothing of it is shown or saved.
    pub binary: bool,
}

impl EditedText {
    /// Decodes the bytes of a file.
    pub fn read(bytes: &[u8]) -> EditedText {
        let decoded = syntax::decode(bytes);
        let wide = matches!(bytes, [0xff, 0xfe, ..] | [0xfe, 0xff, ..]);
        let mark = wide || bytes.starts_with(b"\xEF\xBB\xBF");
        let text = if decoded.binary { &b""[..] } else { &decoded.text };
        let (encoding, text) = match (decoded.encoding, std::str::from_utf8(text)) {
            (syntax::Encoding::Utf16Le, _) => {
                (FileEncoding::Utf16Le, String::from_utf8_lossy(text))
            }
            (syntax::Encoding::Utf16Be, _) => {
                (FileEncoding::Utf16Be, String::from_utf8_lossy(text))
            }
            (syntax::Encoding::Bytes, Ok(text)) => (FileEncoding::Utf8, text.into()),
            (syntax::Encoding::Bytes, Err(_)) => (FileEncoding::Bytes, decode_latin1(text)),
        };
        let (ending, mixed) = ending_of(&text);
        let text = with_lf(&text);
        let form = TextFileForm { encoding, mark, ending, mixed };
        EditedText { text, form, binary: decoded.binary }
    }

    /// A text that is only shown and never saved.
    pub fn of(text: String) -> EditedText {
        let form =
            TextFileForm { encoding: FileEncoding::Utf8, mark: false, ending: "\n", mixed: false };
        EditedText { text, form, binary: false }
    }

    /// The text with LF line ends.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The format of the file.
    pub fn form(&self) -> TextFileForm {
        self.form
    }

    /// The bytes to write to the file, in its encoding and with its line ends.
    ///
    /// # Errors The text has a character that the file's encoding lacks.
    pub fn bytes(&self) -> Result<Vec<u8>, UnencodableCharacter> {
        let text = match self.form.ending {
            "\n" => self.text.clone(),
            ending => self.text.replace('\n', ending),
        };
        let mark = |bytes: &[u8]| if self.form.mark { bytes.to_vec() } else { Vec::new() };
        Ok(match self.form.encoding {
            FileEncoding::Utf8 => [mark(b"\xEF\xBB\xBF"), text.into_bytes()].concat(),
            FileEncoding::Bytes => match is_str_latin1(&text) {
                true => encode_latin1_lossy(&text).into_owned(),
                false => return Err(self.unwritable()),
            },
            FileEncoding::Utf16Le => {
                [mark(b"\xFF\xFE"), text.encode_utf16().flat_map(u16::to_le_bytes).collect()]
                    .concat()
            }
            FileEncoding::Utf16Be => {
                [mark(b"\xFE\xFF"), text.encode_utf16().flat_map(u16::to_be_bytes).collect()]
                    .concat()
            }
        })
    }

    fn unwritable(&self) -> UnencodableCharacter {
        let wide = |line: &str| line.chars().find(|character| *character as u32 > 0xff);
        let mut lines = self.text.split('\n').enumerate();
        let found = lines.find_map(|(index, line)| Some((index + 1, wide(line)?)));
        let (line, character) = found.unwrap_or((1, '?'));
        UnencodableCharacter { line, character }
    }

    /// Applies changes in order; their offsets refer to the text before all of them.
    ///
    /// # Errors A change does not fit; the text is then unchanged.
    pub fn apply(&mut self, changes: &[TextChange]) -> Result<(), ChangeMismatch> {
        let mut places = Utf16Offsets::new(&self.text);
        let mut changed = String::with_capacity(self.text.len() + 64);
        let mut copied = 0;
        for change in changes {
            let misfit = || {
                let length = self.text.encode_utf16().count();
                ChangeMismatch { from: change.from, to: change.to, length }
            };
            let from = places.byte_of(change.from).ok_or_else(misfit)?;
            let to = places.byte_of(change.to).ok_or_else(misfit)?;
            if from < copied || to < from {
                return Err(misfit());
            }
            changed.push_str(&self.text[copied..from]);
            changed.push_str(&with_lf(&change.insert));
            copied = to;
        }
        changed.push_str(&self.text[copied..]);
        self.text = changed;
        Ok(())
    }
}

/// Converts UTF-16 offsets, in ascending order, to byte offsets.
struct Utf16Offsets<'a> {
    text: &'a str,
    ascii: bool,
    byte: usize,
    unit: usize,
}

impl<'a> Utf16Offsets<'a> {
    fn new(text: &'a str) -> Utf16Offsets<'a> {
        Utf16Offsets { text, ascii: text.is_ascii(), byte: 0, unit: 0 }
    }

    fn byte_of(&mut self, unit: usize) -> Option<usize> {
        if self.ascii {
            return (unit <= self.text.len()).then_some(unit);
        }
        let mut rest = self.text[self.byte..].chars();
        while self.unit < unit {
            let character = rest.next()?;
            self.byte += character.len_utf8();
            self.unit += character.len_utf16();
        }
        (self.unit == unit).then_some(self.byte)
    }
}

/// The most frequent line end, and whether there are others.
fn ending_of(text: &str) -> (&'static str, bool) {
    let bytes = text.as_bytes();
    // `max_by_key` takes the last of equal counts, so the order is reversed: LF wins, also for a file without line
    // ends.
    let mut kinds = [(0, "\n"), (0, "\r\n"), (0, "\r"), (0, "\n\r\r")];
    let mut start = 0;
    for end in line_ends(bytes) {
        let last = bytes[start..end].iter().rposition(|byte| !matches!(byte, b'\n' | b'\r'));
        let ending = &text[last.map_or(start, |last| start + last + 1)..end];
        if let Some(kind) = kinds.iter_mut().find(|(_, kind)| *kind == ending) {
            kind.0 += 1;
        }
        start = end;
    }
    let mixed = kinds.iter().filter(|(count, _)| *count > 0).count() > 1;
    let most = kinds.into_iter().rev().max_by_key(|(count, _)| *count);
    (most.map_or("\n", |(_, ending)| ending), mixed)
}

fn with_lf(text: &str) -> String {
    if !text.contains('\r') {
        return text.into();
    }
    text.replace("\n\r\r", "\n").replace("\r\n", "\n").replace('\r', "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn change(from: usize, to: usize, insert: &str) -> TextChange {
        TextChange { from, to, insert: insert.into() }
    }

    #[test]
    fn a_file_that_is_not_changed_is_written_as_it_was() {
        let utf16: Vec<u8> =
            "\u{feff}G0 X1\r\n(ä)\r\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        for bytes in [
            &b"G0 X1\nM30\n"[..],
            b"%\r\nO1\r\nM30\r\n%\r\n",
            b"G0\rX1\rM30",
            b"\xEF\xBB\xBFG0 (\xC3\xA4)\n",
            b"G0 (\xE4\x83)\r\nM30\r\n",
            b"G0\n\r\rM30\n\r\r",
            b"",
            b"no end",
            &utf16,
        ] {
            let document = EditedText::read(bytes);
            assert!(!document.text().contains('\r'));
            assert!(!document.form().mixed);
            assert_eq!(document.bytes().unwrap(), bytes);
        }
        assert!(EditedText::read(b"G0\r\nX1\n").form().mixed);
    }

    #[test]
    fn changes_count_as_a_browser_does() {
        let mut document = EditedText::read("(😀ä)\nX1\n".as_bytes());
        // The face is two units.
        document.apply(&[change(3, 4, "b"), change(6, 8, "Y2\r\nZ3")]).unwrap();
        assert_eq!(document.text(), "(😀b)\nY2\nZ3\n");
        document.apply(&[change(0, 12, "")]).unwrap();
        assert_eq!(document.text(), "");
    }

    #[test]
    fn changes_that_do_not_fit_change_nothing() {
        let mut document = EditedText::read("(😀)".as_bytes());
        for changes in [
            &[change(0, 5, "x")][..],
            &[change(2, 2, "x")],
            &[change(3, 3, "a"), change(1, 1, "b")],
            &[change(3, 1, "a")],
            &[change(usize::MAX, usize::MAX, "a")],
        ] {
            assert!(document.apply(changes).is_err());
            assert_eq!(document.text(), "(😀)");
        }
        let mut document = EditedText::read(b"X1");
        assert!(document.apply(&[change(1, 3, "")]).is_err());
        assert!(document.apply(&[change(2, 1, "")]).is_err());
    }

    #[test]
    fn a_character_that_the_file_cannot_hold_is_reported() {
        let mut document = EditedText::read(b"G0\n(\xE4)\n");
        document.apply(&[change(4, 4, "ß→")]).unwrap();
        let error = document.bytes().unwrap_err();
        assert_eq!((error.line, error.character), (2, '→'));
    }
}

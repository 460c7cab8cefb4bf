//! Finds the encoding of a file from its content.

use std::borrow::Cow;

/// The encoding of a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Encoding {
    /// ASCII or UTF-8, with or without a byte order mark, or an 8-bit national encoding whose special characters are in
    /// comments.
    Bytes,
    /// UTF-16, low byte first.
    Utf16Le,
    /// UTF-16, high byte first.
    Utf16Be,
}

/// A text in the form that the reader needs.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Decoded<'a> {
    /// One byte per ASCII character. It is a copy only if the file was UTF-16.
    pub text: Cow<'a, [u8]>,
    /// The encoding of the file.
    pub encoding: Encoding,
    /// The bytes do not look like a program but like binary data (an archive, a picture).
    pub binary: bool,
}

/// The number of bytes that are examined to find the encoding.
const SAMPLE: usize = 64 * 1024;

/// Finds the encoding of a file from its content.
///
/// A UTF-8 byte order mark is removed. UTF-16 (recognized by its mark, or because every other byte is NUL) is converted
/// to UTF-8. Everything else is used as bytes: in the usual encodings programs are ASCII outside of comments, and
/// comments keep their bytes.
pub fn decode(bytes: &[u8]) -> Decoded<'_> {
    if let Some(rest) = bytes.strip_prefix(b"\xEF\xBB\xBF") {
        return plain(rest);
    }
    match utf16(bytes) {
        Some((encoding, rest)) => {
            let decoder = if encoding == Encoding::Utf16Le {
                encoding_rs::UTF_16LE
            } else {
                encoding_rs::UTF_16BE
            };
            let (text, _) = decoder.decode_without_bom_handling(rest);
            let binary = looks_binary(text.as_bytes());
            Decoded { text: Cow::Owned(text.into_owned().into_bytes()), encoding, binary }
        }
        None => plain(bytes),
    }
}

fn plain(bytes: &[u8]) -> Decoded<'_> {
    let binary = looks_binary(bytes);
    Decoded { text: Cow::Borrowed(bytes), encoding: Encoding::Bytes, binary }
}

/// Recognizes UTF-16 by its mark, or because one byte of its pairs is almost always NUL and the other almost never. (In
/// NUL padding, which some controls write, both bytes are NUL.)
fn utf16(bytes: &[u8]) -> Option<(Encoding, &[u8])> {
    if let Some(rest) = bytes.strip_prefix(b"\xFF\xFE") {
        return Some((Encoding::Utf16Le, rest));
    }
    if let Some(rest) = bytes.strip_prefix(b"\xFE\xFF") {
        return Some((Encoding::Utf16Be, rest));
    }
    let sample = &bytes[..bytes.len().min(SAMPLE) & !1];
    let pairs = sample.len() / 2;
    if pairs < 4 {
        return None;
    }
    let (mut low, mut high) = (0, 0);
    for pair in sample.chunks_exact(2) {
        low += usize::from(pair[0] == 0 && pair[1] != 0);
        high += usize::from(pair[1] == 0 && pair[0] != 0);
    }
    if high * 10 > pairs * 8 {
        Some((Encoding::Utf16Le, bytes))
    } else if low * 10 > pairs * 8 {
        Some((Encoding::Utf16Be, bytes))
    } else {
        None
    }
}

/// Whether there are control characters that do not occur in programs. NUL (padding), tape codes (DC1–DC4), tab, form
/// feed, line ends and the old end-of-file mark do occur.
fn looks_binary(text: &[u8]) -> bool {
    let sample = &text[..text.len().min(SAMPLE)];
    let strange = sample
        .iter()
        .filter(|&&b| b < 0x20 && !matches!(b, 0 | 9..=13 | 0x11..=0x14 | 0x1a | 0x7f))
        .count();
    strange * 20 > sample.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_and_wide_characters_are_recognized() {
        let program = "%\nO1\nG1 X1.\nM30\n%\n";
        let le: Vec<u8> = program.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let be: Vec<u8> = program.encode_utf16().flat_map(u16::to_be_bytes).collect();
        let marked = [b"\xFF\xFE".as_slice(), &le].concat();
        for (bytes, encoding) in
            [(&le, Encoding::Utf16Le), (&be, Encoding::Utf16Be), (&marked, Encoding::Utf16Le)]
        {
            let decoded = decode(bytes);
            assert_eq!(decoded.encoding, encoding);
            assert_eq!(decoded.text, program.as_bytes());
        }
        let utf8 = [b"\xEF\xBB\xBF".as_slice(), program.as_bytes()].concat();
        assert_eq!(decode(&utf8).text, program.as_bytes());
    }

    #[test]
    fn padding_and_national_comments_are_text_and_pictures_are_not() {
        let padded = [b"\0\0\0\0%\nO1\n".as_slice(), &[0; 40]].concat();
        assert!(!decode(&padded).binary);
        assert_eq!(decode(&padded).encoding, Encoding::Bytes);
        assert!(!decode(b"O1 (\x83v\x83\x8d\x83O)\nG0 X1.\n").binary);
        assert!(decode(b"\x89PNG\r\n\x1a\n\x00\x00\x00\x0dIHDR\x01\x02\x03\x04\x05\x06").binary);
    }
}

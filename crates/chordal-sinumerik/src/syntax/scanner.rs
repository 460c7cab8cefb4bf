//! A cursor over the bytes of a line that knows the lexical elements: blanks, names, numbers, texts.

use std::borrow::Cow;

use chordal_diagnostics::TextRange;

use super::number_literal::{NumberLiteral, read_number};

/// A cursor over one line. It stops at the end of the line, where every byte reads as 0.
#[derive(Clone, Copy)]
pub(super) struct LineScanner<'t> {
    text: &'t [u8],
    /// The offset of the next byte.
    pub at: usize,
    end: usize,
}

/// True for the first byte of a name.
pub(super) fn begins_name(byte: u8) -> bool {
    byte.is_ascii_alphabetic() || byte == b'_' || byte == b'$'
}

fn is_name_part(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

impl<'t> LineScanner<'t> {
    /// A cursor over the bytes from `at` up to `end`, which must not be greater than the length of the text.
    pub fn new(text: &'t [u8], at: usize, end: usize) -> LineScanner<'t> {
        LineScanner { text, at, end: end.min(text.len()) }
    }

    /// The next byte; 0 at the end of the line.
    #[inline]
    pub fn peek(&self) -> u8 {
        self.peek_after(0)
    }

    /// The byte `distance` bytes after the next one; 0 after the end of the line.
    #[inline]
    pub fn peek_after(&self, distance: usize) -> u8 {
        let at = self.at + distance;
        if at < self.end { self.text[at] } else { 0 }
    }

    /// The line from the next byte on.
    pub fn rest(&self) -> &'t [u8] {
        self.text.get(self.at..self.end).unwrap_or(&[])
    }

    /// The range from `start` up to the next byte.
    pub fn range_from(&self, start: usize) -> TextRange {
        TextRange::new(start as u32, self.at.max(start) as u32)
    }

    /// The bytes of a range of the text.
    pub fn slice(&self, range: TextRange) -> &'t [u8] {
        range.slice(self.text)
    }

    /// The text of a range of ASCII characters, in upper case.
    pub fn upper(&self, range: TextRange) -> String {
        String::from_utf8(self.slice(range).to_ascii_uppercase()).unwrap_or_default()
    }

    /// The name of an address in upper case; most are letters, which need no memory of their own.
    pub fn address_name(&self, range: TextRange) -> Cow<'static, str> {
        const LETTERS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
        match self.slice(range) {
            [letter] if letter.is_ascii_alphabetic() => {
                let place = usize::from(letter.to_ascii_uppercase() - b'A');
                Cow::Borrowed(&LETTERS[place..=place])
            }
            _ => Cow::Owned(self.upper(range)),
        }
    }

    /// Skips blanks, control characters and `&`, which is a blank (Fundamentals 11/2006, 2.1).
    #[inline]
    pub fn skip_blanks(&mut self) {
        while self.at < self.end && is_blank(self.text[self.at]) {
            self.at += 1;
        }
    }

    /// The next byte that is no blank; 0 at the end of the line. The blanks are skipped.
    #[inline]
    pub fn next_byte(&mut self) -> u8 {
        self.skip_blanks();
        self.peek()
    }

    /// True when only blanks and a comment follow. The blanks are skipped.
    pub fn is_at_end(&mut self) -> bool {
        self.skip_blanks();
        self.at >= self.end || self.text[self.at] == b';'
    }

    /// Skips blanks and then `byte`; false without it.
    pub fn take(&mut self, byte: u8) -> bool {
        let is_next = self.next_byte() == byte && self.at < self.end;
        self.at += usize::from(is_next);
        is_next
    }

    /// Skips blanks and then an equals sign that is not the first of `==`; false without it.
    pub fn take_equals(&mut self) -> bool {
        let is_next = self.next_byte() == b'=' && self.peek_after(1) != b'=';
        self.at += usize::from(is_next);
        is_next
    }

    /// Reads a name as the control splits it: a letter before anything but a letter or an underscore is an address of its
    /// own (`X10`), every other name keeps its digits (`$TC_DP6`, `MY_VAR2`). `None` when no name begins here.
    pub fn read_name(&mut self) -> Option<TextRange> {
        let start = self.at;
        let first = self.peek();
        if !begins_name(first) {
            return None;
        }
        let second = self.peek_after(1);
        if first.is_ascii_alphabetic() && !second.is_ascii_alphabetic() && second != b'_' {
            self.at += 1;
            return Some(self.range_from(start));
        }
        self.skip_name();
        Some(self.range_from(start))
    }

    /// Reads a name with all of its digits, a letter with digits, too: `L10`. `None` when no name begins here.
    pub fn read_whole_name(&mut self) -> Option<TextRange> {
        let start = self.at;
        if !begins_name(self.peek()) {
            return None;
        }
        self.skip_name();
        Some(self.range_from(start))
    }

    fn skip_name(&mut self) {
        while self.peek() == b'$' {
            self.at += 1;
        }
        while is_name_part(self.peek()) {
            self.at += 1;
        }
    }

    /// Skips blanks and then the name `word`, which is in upper case; false without it.
    pub fn take_word(&mut self, word: &str) -> bool {
        self.skip_blanks();
        let is_next = self.is_word(word);
        self.at += if is_next { word.len() } else { 0 };
        is_next
    }

    /// True when the name `word` is next, in either case.
    pub fn is_word(&self, word: &str) -> bool {
        let rest = self.rest();
        rest.len() >= word.len()
            && rest[..word.len()].eq_ignore_ascii_case(word.as_bytes())
            && !is_name_part(self.peek_after(word.len()))
    }

    /// The number of digits that follow.
    pub fn count_digits(&self) -> usize {
        self.rest().iter().take_while(|byte| byte.is_ascii_digit()).count()
    }

    /// Reads digits as a whole number; `None` without digits and above the range, where nothing is skipped.
    pub fn read_digits(&mut self) -> Option<u32> {
        let count = self.count_digits();
        let digits = &self.rest()[..count];
        let value = digits.iter().try_fold(0_u32, |value, digit| {
            value.checked_mul(10)?.checked_add(u32::from(digit - b'0'))
        })?;
        self.at += count;
        (count > 0).then_some(value)
    }

    /// Reads a number without its sign; `None` when none begins here.
    #[inline]
    pub fn read_number(&mut self) -> Option<NumberLiteral> {
        let (length, number) = read_number(self.rest())?;
        self.at += length;
        Some(number)
    }

    /// Skips a text in quotation marks, which begins here; false when it is not closed, and then the line ends.
    pub fn skip_text(&mut self) -> bool {
        self.at += 1;
        while let Some(close) = memchr::memchr(b'"', self.rest()) {
            self.at += close + 1;
            if self.peek() != b'"' {
                return true;
            }
            self.at += 1;
        }
        self.at = self.end;
        false
    }

    /// Skips what follows up to a comment or the end of the line.
    pub fn skip_to_comment(&mut self) {
        while let Some(next) = memchr::memchr2(b'"', b';', self.rest()) {
            self.at += next;
            if self.peek() == b';' {
                return;
            }
            self.skip_text();
        }
        self.at = self.end;
    }
}

/// True for blanks, control characters and `&`.
pub(super) fn is_blank(byte: u8) -> bool {
    byte <= b' ' || byte == b'&' || byte == 0x7f
}

/// The text of bytes between quotation marks: a doubled mark is one. Bytes that are no UTF-8 are Latin-1, the code page
/// of older controls.
pub(super) fn decoded_text(bytes: &[u8]) -> String {
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text.to_string(),
        Err(_) => bytes.iter().map(|byte| char::from(*byte)).collect(),
    };
    if text.contains("\"\"") { text.replace("\"\"", "\"") } else { text }
}

//! Plain lines: blocks of nothing but a number, G0 or G1, coordinates and a feed. CAM programs consist of them, so they are
//! read without a list of statements.

use chordal_diagnostics::{TextRange, line_end_length};

use super::number_literal::{NumberLiteral, read_number};
use super::reader::BlockReader;

/// A value with its text.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PlainValue {
    /// The number as it is written.
    pub value: f64,
    /// The word.
    pub range: TextRange,
}

/// A block of nothing but a number, G0 or G1, coordinates of X, Y and Z, and F, each at most once.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PlainLine {
    /// The line without its end.
    pub range: TextRange,
    /// Its line, from 1.
    pub line: u32,
    /// The block number; `None` without.
    pub number: Option<u32>,
    /// G0 (`true`) or G1; `None` where neither is written.
    pub is_rapid: Option<bool>,
    /// X, Y and Z.
    pub axes: [Option<PlainValue>; 3],
    /// F.
    pub feed: Option<PlainValue>,
}

impl BlockReader<'_> {
    /// Goes on at the next line that may name a program: those of letters with numbers alone name none.
    pub fn skip_lines_without_calls(&mut self) {
        let rest = self.rest();
        let (mut start, mut lines) = (0, 0);
        let mut was_letter = false;
        let mut at = 0;
        while let Some(byte) = rest.get(at) {
            at += 1;
            let class = CLASS_OF_BYTE[usize::from(*byte)];
            if class == ByteClass::Other {
                was_letter = false;
                continue;
            }
            if class == ByteClass::LineEnd {
                at += line_end_length(&rest[at - 1..]) - 1;
                (start, lines, was_letter) = (at, lines + 1, false);
                continue;
            }
            if was_letter || class == ByteClass::LetterOfCall {
                return self.advance_lines(start, lines);
            }
            was_letter = true;
        }
        self.advance_lines(rest.len(), lines);
    }

    /// Reads the next line if it is a plain one, with G0 or G1 where it `needs_motion`; otherwise `None`, and nothing is
    /// read.
    pub fn next_plain(&mut self, needs_motion: bool) -> Option<PlainLine> {
        let start = self.offset();
        let rest = self.rest();
        let mut found = PlainLine {
            range: TextRange::new(start, start),
            line: self.line(),
            number: None,
            is_rapid: None,
            axes: [None; 3],
            feed: None,
        };
        let length = read_plain(rest, start, &mut found)?;
        if needs_motion && found.is_rapid.is_none() {
            return None;
        }
        found.range.end = start + length as u32;
        let end = if length < rest.len() { line_end_length(&rest[length..]) } else { 0 };
        self.advance_lines(length + end, u32::from(end > 0));
        Some(found)
    }
}

/// What a byte says about whether its line may name a program: such a line has two letters next to each other, or an L.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ByteClass {
    Other,
    Letter,
    LetterOfCall,
    LineEnd,
}

const CLASS_OF_BYTE: [ByteClass; 256] = {
    let mut classes = [ByteClass::Other; 256];
    let mut byte = 0;
    while byte < classes.len() {
        classes[byte] = match byte as u8 {
            b'L' | b'l' => ByteClass::LetterOfCall,
            b'A'..=b'Z' | b'a'..=b'z' | b'_' => ByteClass::Letter,
            b'\n' | b'\r' => ByteClass::LineEnd,
            _ => ByteClass::Other,
        };
        byte += 1;
    }
    classes
};

/// Reads the words of a line; the length of the line without its end. `None` for any other line.
fn read_plain(text: &[u8], start: u32, found: &mut PlainLine) -> Option<usize> {
    let mut at = 0;
    let mut is_first = true;
    loop {
        let letter = match text.get(at) {
            None | Some(b'\n' | b'\r') => break,
            Some(b' ' | b'\t') => {
                at += 1;
                continue;
            }
            Some(letter) => letter.to_ascii_uppercase(),
        };
        let word = at;
        at += 1;
        let is_negative = text.get(at) == Some(&b'-');
        at += usize::from(is_negative);
        let (length, number) = read_number(&text[at..])?;
        at += length;
        // What follows must be a blank, the next letter or the end: no `=`, no bracket, no label.
        if !matches!(text.get(at), None | Some(b' ' | b'\t' | b'\n' | b'\r' | b'A'..=b'Z' | b'a'..=b'z'))
        {
            return None;
        }
        let range = TextRange::new(start + word as u32, start + at as u32);
        let value = match number {
            NumberLiteral::Whole(whole) => whole as f64,
            NumberLiteral::Decimal(decimal) => decimal,
        };
        let value = PlainValue { value: if is_negative { -value } else { value }, range };
        let slot = match letter {
            b'N' if is_first && !is_negative => {
                let NumberLiteral::Whole(whole) = number else { return None };
                found.number = Some(u32::try_from(whole).ok()?);
                is_first = false;
                continue;
            }
            b'G' => {
                let is_rapid = match number {
                    NumberLiteral::Whole(0) => true,
                    NumberLiteral::Whole(1) => false,
                    _ => return None,
                };
                if is_negative || found.is_rapid.replace(is_rapid).is_some() {
                    return None;
                }
                is_first = false;
                continue;
            }
            b'X' | b'Y' | b'Z' => &mut found.axes[usize::from(letter - b'X')],
            b'F' => &mut found.feed,
            _ => return None,
        };
        if slot.replace(value).is_some() || !value.value.is_finite() {
            return None;
        }
        is_first = false;
    }
    (found.axes.iter().any(Option::is_some) || found.feed.is_some()).then_some(at)
}

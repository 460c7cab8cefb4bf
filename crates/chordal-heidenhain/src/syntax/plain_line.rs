//! Lines that move straight to numbers, which are most of a posted program: read without tokens, to the same blocks.

use chordal_command::CompensationSide;
use chordal_diagnostics::TextRange;

use super::ast::{
    AXIS_WORDS, FeedValue, FeedWord, KlartextBlock, KlartextStatement, MachineFunction,
    PathFunction, PathWords,
};
use super::operands::{OperandWord, WordOperand};

/// Axes whose words are read here: X Y Z A B C.
const PLAIN_AXES: usize = 6;
/// Digits of a block number, or of an M function, at most.
const MAX_DIGITS: usize = 9;

/// Digits of a whole number that is exact in double precision.
const EXACT_DIGITS: usize = 15;
/// Powers of ten, which are exact in double precision.
const POWERS_OF_TEN: [f64; EXACT_DIGITS + 1] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

/// The place in a line.
struct LineScan<'t> {
    text: &'t [u8],
    at: usize,
    end: usize,
}

impl LineScan<'_> {
    fn peek(&self) -> Option<u8> {
        (self.at < self.end).then(|| self.text[self.at])
    }

    fn skip_blanks(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t')) {
            self.at += 1;
        }
    }

    /// At the end of the line, or at a blank.
    fn is_at_break(&self) -> bool {
        matches!(self.peek(), None | Some(b' ' | b'\t'))
    }

    /// An unsigned whole number.
    fn whole(&mut self) -> Option<u32> {
        let start = self.at;
        while self.peek().is_some_and(|byte| byte.is_ascii_digit()) {
            self.at += 1;
        }
        let digits = &self.text[start..self.at];
        if digits.is_empty() || digits.len() > MAX_DIGITS {
            return None;
        }
        std::str::from_utf8(digits).ok()?.parse().ok()
    }

    /// A number with a sign and a point, up to a blank or the end.
    fn number(&mut self) -> Option<f64> {
        let is_negative = self.peek() == Some(b'-');
        self.at += usize::from(matches!(self.peek(), Some(b'+' | b'-')));
        let start = self.at;
        let (mut digits, mut point) = (0_u64, None);
        while let Some(byte) = self.peek() {
            match byte {
                b'0'..=b'9' => {
                    digits = digits.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
                }
                b'.' if point.is_none() => point = Some(self.at),
                _ => break,
            }
            self.at += 1;
        }
        if !self.is_at_break() {
            return None;
        }
        let places = point.map_or(0, |point| self.at - point - 1);
        let length = self.at - start - usize::from(point.is_some());
        let value = match length {
            0 => return None,
            // Both are exact, so that the quotient is the nearest number to the decimal.
            1..=EXACT_DIGITS => digits as f64 / POWERS_OF_TEN[places],
            _ => std::str::from_utf8(&self.text[start..self.at]).ok()?.parse().ok()?,
        };
        Some(if is_negative { -value } else { value })
    }

    fn range_from(&self, start: usize) -> TextRange {
        TextRange::new(start as u32, self.at as u32)
    }

    /// Reads a word into its place; `None` for one that is not plain.
    fn word(&mut self, words: &mut PathWords) -> Option<()> {
        let start = self.at;
        let letter = self.peek()?;
        self.at += 1;
        let axis = AXIS_WORDS[..PLAIN_AXES].iter().position(|axis| axis.as_bytes() == [letter]);
        if let Some(axis) = axis {
            let value = WordOperand::Number(self.number()?);
            let word = OperandWord { is_incremental: false, value, range: self.range_from(start) };
            return words.axes[axis].replace(word).is_none().then_some(());
        }
        match letter {
            b'F' => {
                let value = match self.text[self.at..self.end].starts_with(b"MAX") {
                    true => {
                        self.at += 3;
                        FeedValue::Rapid
                    }
                    false => FeedValue::Value(WordOperand::Number(self.number()?)),
                };
                let feed = FeedWord { value, range: self.range_from(start) };
                (self.is_at_break() && words.feed.replace(feed).is_none()).then_some(())
            }
            b'R' if self.peek() == Some(b'0') => {
                self.at += 1;
                let side = (CompensationSide::Off, self.range_from(start));
                (self.is_at_break() && words.side.replace(side).is_none()).then_some(())
            }
            b'M' => {
                let number = self.whole()?;
                // These take words of their own.
                if !self.is_at_break() || matches!(number, 103 | 118 | 120 | 128 | 140) {
                    return None;
                }
                let range = self.range_from(start);
                words.functions.push(MachineFunction { number, value: None, is_max: false, range });
                Some(())
            }
            _ => None,
        }
    }
}

/// The block of a line (without blanks at its ends) of a conversational program; `None` if it is not plain.
pub fn plain_line(text: &[u8], range: TextRange, line: u32) -> Option<KlartextBlock> {
    let mut scan = LineScan { text, at: range.start as usize, end: range.end as usize };
    let number = match scan.peek()? {
        b'0'..=b'9' => Some(scan.whole()?),
        _ => None,
    };
    if number.is_some() {
        scan.is_at_break().then_some(())?;
        scan.skip_blanks();
    }
    (scan.peek()? == b'L').then_some(())?;
    scan.at += 1;
    scan.is_at_break().then_some(())?;
    let mut words = Box::<PathWords>::default();
    loop {
        scan.skip_blanks();
        if scan.at == scan.end {
            break;
        }
        scan.word(&mut words)?;
    }
    let statement = KlartextStatement::Path(PathFunction::Line, words);
    Some(KlartextBlock { range, line, number, is_skippable: false, statement, faults: Vec::new() })
}

#[cfg(test)]
mod tests {
    use super::super::parser::{KlartextReader, block_of_lines};
    use super::super::reader::LineReader;
    use super::*;

    /// The block by the long way.
    fn block(text: &[u8]) -> KlartextBlock {
        let lines = LineReader::new(text).next().expect("a line");
        block_of_lines(text, &lines)
    }

    #[test]
    fn plain_lines_are_the_same_blocks() {
        for text in [
            "12 L X+1.5 Y-2 Z.5 R0 FMAX M3",
            "L X10 Y20. F500",
            "  7   L   A-12.5 C+360 F1200.5   ",
            "9 L Z+100 FMAX M5 M9",
            "8 L M30",
            "5 L",
        ] {
            let bytes = text.as_bytes();
            let trimmed = LineReader::new(bytes).next().expect("a line").range;
            let plain = plain_line(bytes, trimmed, 1);
            assert_eq!(plain.as_ref(), Some(&block(bytes)), "{text}");
            assert_eq!(KlartextReader::new(bytes).next(), plain);
        }
    }

    #[test]
    fn numbers_are_the_nearest_to_their_decimals() {
        let mut state = 7_u64;
        for round in 0..100_000 {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let (digits, places) = (state >> (14 + round % 50), round % 9);
            let text = format!("-{}.{:0places$}", digits / 7, digits % 10_u64.pow(places as u32));
            let mut scan = LineScan { text: text.as_bytes(), at: 0, end: text.len() };
            let expected: f64 = text.parse().expect("a number");
            assert_eq!(scan.number(), Some(expected), "{text}");
        }
    }

    #[test]
    fn others_are_left_to_the_long_way() {
        for text in [
            "12 L IX+1",
            "12 L X+Q1",
            "12 L X1,5",
            "12 L X+1 X+2",
            "12 L X+1 ; remark",
            "12 L X+1 ~",
            "12 L X+1 RL",
            "12 L X--1",
            "12 L X",
            "12 L M140 MB MAX",
            "12 LP PR5",
            "12L X+1",
            "/12 L X+1",
            "L X1Y2",
            "L FMAXT 2",
        ] {
            let range = TextRange::new(0, text.len() as u32);
            assert_eq!(plain_line(text.as_bytes(), range, 1), None, "{text}");
        }
    }
}

//! A line as a firmware reads it: what it drops, and numbers of few digits in single precision.

use chordal_diagnostics::TextRange;
use chordal_dialect::firmware::{FirmwareError, LineRules, SlashMeaning};
use chordal_syntax::Decimal;

/// A word: its value as the firmware computes with it, and as it was read.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct ReadWord {
    pub letter: u8,
    pub value: f32,
    pub number: Decimal,
    pub range: TextRange,
}

/// What is wrong, and where, with what was measured.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct LineFault {
    pub refusal: FirmwareError,
    pub range: TextRange,
    pub measured: Option<String>,
}

impl LineFault {
    pub fn new(refusal: FirmwareError, range: TextRange) -> LineFault {
        LineFault { refusal, range, measured: None }
    }
}

/// The characters of a line that count, each with its offset in the text.
#[derive(Debug)]
pub(super) struct FirmwareLine<'a> {
    characters: Vec<(u8, u32)>,
    at: usize,
    rules: &'a LineRules,
}

impl<'a> FirmwareLine<'a> {
    /// Drops blanks and comments, and slashes where they are not kept: a comment in parentheses ends at the first `)`
    /// or with the line. `deletes`: block delete is on.
    ///
    /// # Errors
    /// More characters than the line of the firmware holds.
    pub fn of(
        text: &[u8],
        from: u32,
        rules: &'a LineRules,
        deletes: bool,
    ) -> Result<FirmwareLine<'a>, LineFault> {
        let mut line = FirmwareLine { characters: Vec::new(), at: 0, rules };
        let mut in_comment = false;
        for (byte, offset) in text.iter().zip(from..) {
            match byte {
                b')' if in_comment => in_comment = false,
                _ if in_comment => {}
                b'(' => in_comment = true,
                b';' => break,
                0..=b' ' => {}
                // Taken out of the stream as they arrive: status, feed hold, resume.
                b'?' | b'!' | b'~' => {}
                b'/' if rules.slash != SlashMeaning::Kept => {
                    let takes_line =
                        line.is_empty() && rules.slash == SlashMeaning::Deletes && deletes;
                    if takes_line {
                        return Ok(line);
                    }
                }
                _ => line.characters.push((byte.to_ascii_uppercase(), offset)),
            }
        }
        let counted =
            if rules.counts_blanks { text.trim_ascii_end().len() } else { line.characters.len() };
        if counted > rules.longest {
            let first = match line.characters.get(rules.longest) {
                Some((_, first)) if !rules.counts_blanks => *first,
                _ => from + rules.longest as u32,
            };
            return Err(LineFault {
                measured: Some(format!("it has {counted}")),
                ..LineFault::new(FirmwareError::TooLong, TextRange::new(first, first + 1))
            });
        }
        Ok(line)
    }

    /// Nothing is on it.
    pub fn is_empty(&self) -> bool {
        self.characters.is_empty()
    }

    /// A percent sign that marks the program. Firmware that does not read it never meets it: senders drop it.
    pub fn is_mark(&self) -> bool {
        matches!(self.characters[..], [(b'%', _)])
    }

    /// The text of a system command (`$H`), without its `$`.
    pub fn command(&self) -> Option<String> {
        let ((b'$', _), rest) = self.characters.split_first()? else { return None };
        Some(rest.iter().map(|(byte, _)| char::from(*byte)).collect())
    }

    /// Goes on after so many characters.
    pub fn skip(&mut self, count: usize) {
        self.at = count;
    }

    fn peek(&self) -> Option<(u8, u32)> {
        self.characters.get(self.at).copied()
    }

    /// The next word.
    pub fn word(&mut self) -> Option<Result<ReadWord, LineFault>> {
        let (letter, begin) = self.peek()?;
        let own = TextRange::new(begin, begin + 1);
        if !letter.is_ascii_uppercase() {
            return Some(Err(LineFault::new(FirmwareError::NoLetter, own)));
        }
        self.at += 1;
        let Some((value, number)) = self.number() else {
            return Some(Err(LineFault::new(FirmwareError::NoNumber, own)));
        };
        let (_, last) = self.characters[self.at - 1];
        Some(Ok(ReadWord { letter, value, number, range: TextRange::new(begin, last + 1) }))
    }

    /// A sign, digits, a point and digits. Of more digits than count those before the point are zeros, and
    /// those after it are not there.
    fn number(&mut self) -> Option<(f32, Decimal)> {
        let negative = matches!(self.peek(), Some((b'-', _)));
        if matches!(self.peek(), Some((b'+' | b'-', _))) {
            self.at += 1;
        }
        let (mut digits, mut whole, mut exponent, mut has_point) = (0_u32, 0_u32, 0_i32, false);
        let mut is_number = false;
        while let Some((byte, _)) = self.peek() {
            match byte {
                b'0'..=b'9' => {
                    is_number = true;
                    let in_front = whole == 0 && byte == b'0' && !has_point;
                    digits += u32::from(self.rules.zeros_count || !in_front);
                    if digits <= self.rules.digits {
                        exponent -= i32::from(has_point);
                        whole = whole.wrapping_mul(10).wrapping_add(u32::from(byte - b'0'));
                    } else {
                        exponent += i32::from(!has_point);
                    }
                }
                b'.' if !has_point => has_point = true,
                _ => break,
            }
            self.at += 1;
        }
        is_number.then(|| {
            (single(whole, exponent, negative), decimal(whole, exponent, has_point, negative))
        })
    }
}

/// In steps of hundredths, as the firmware takes them.
fn single(whole: u32, exponent: i32, negative: bool) -> f32 {
    let mut value = whole as f32;
    let mut left = exponent;
    while left <= -2 && value != 0.0 {
        value *= 0.01;
        left += 2;
    }
    if left < 0 {
        value *= 0.1;
    }
    // Beyond that every number is infinite.
    for _ in 0..left.clamp(0, 50) {
        value *= 10.0;
    }
    if negative { -value } else { value }
}

fn decimal(whole: u32, exponent: i32, has_point: bool, negative: bool) -> Decimal {
    // A literal of more than eighteen digits is far beyond any machine.
    let zeros = 10_i64.pow(exponent.clamp(0, 9) as u32);
    let size = i64::from(whole).saturating_mul(zeros);
    let mantissa = if negative { -size } else { size };
    Decimal { mantissa, scale: exponent.min(0).unsigned_abs() as u8, has_point, negative }
}

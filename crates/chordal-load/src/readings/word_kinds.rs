//! The kinds of words in a text, used to choose a part of a long text that represents all of it.

use std::collections::HashSet;

/// Codes below this number, in tenths, are stored as bits.
const CODE_BITS: usize = 2_048;

/// G and M codes that call or jump, in tenths: their targets may be anywhere in the text.
const CALL_CODES: [(u8, u32); 9] = [
    (b'G', 650),
    (b'G', 660),
    (b'G', 661),
    (b'G', 670),
    (b'M', 960),
    (b'M', 970),
    (b'M', 980),
    (b'M', 990),
    (b'M', 1980),
];

/// The kinds of words in a text: letters with a whole number, letters with a decimal point, and codes. The motions of
/// a text can differ between controls only when they interpret one of these differently.
#[derive(Debug)]
pub struct WordKinds {
    /// The letters of words without and with a decimal point, as bits; A is the lowest bit.
    whole: u32,
    decimal: u32,
    /// G and M codes, as bits numbered by ten times the code.
    codes: [[u64; CODE_BITS / 64]; 2],
    large_codes: HashSet<(u8, u32)>,
    /// There is a macro statement or expression.
    statements: bool,
    /// The number of program heads.
    programs: u32,
}

impl Default for WordKinds {
    fn default() -> WordKinds {
        WordKinds {
            whole: 0,
            decimal: 0,
            codes: [[0; CODE_BITS / 64]; 2],
            large_codes: HashSet::new(),
            statements: false,
            programs: 0,
        }
    }
}

impl WordKinds {
    /// Reads a text or a line of it; `true` when it has a new kind of word.
    pub fn read(&mut self, text: &[u8]) -> bool {
        let mut is_new = false;
        let mut at = 0;
        while let Some(byte) = text.get(at).copied() {
            at = match byte {
                b'(' => comment_end(text, at),
                b';' => line_end(text, at),
                b'A'..=b'Z' | b'a'..=b'z' => self.word(text, at, &mut is_new),
                b'#' | b'[' | b'=' => {
                    is_new |= !self.statements;
                    self.statements = true;
                    at + 1
                }
                _ => at + 1,
            };
        }
        is_new
    }

    /// Whether some word or statement may call, jump or repeat (as `L` does on some controls), or there is more than
    /// one program.
    pub fn jumps(&self) -> bool {
        self.statements
            || self.programs > 1
            || (self.whole | self.decimal) & letter_bit(b'L') != 0
            || CALL_CODES.iter().any(|(letter, tenths)| self.has_code(*letter, *tenths))
    }

    fn has_code(&self, letter: u8, tenths: u32) -> bool {
        let tenths = tenths as usize;
        self.codes[code_row(letter)][tenths / 64] & (1 << (tenths % 64)) != 0
    }

    /// Adds a code; `true` when it is new.
    fn add_code(&mut self, letter: u8, tenths: u32) -> bool {
        if tenths as usize >= CODE_BITS {
            return self.large_codes.insert((letter, tenths));
        }
        let is_new = !self.has_code(letter, tenths);
        let tenths = tenths as usize;
        self.codes[code_row(letter)][tenths / 64] |= 1 << (tenths % 64);
        is_new
    }

    fn word(&mut self, text: &[u8], at: usize, is_new: &mut bool) -> usize {
        let letter = text[at].to_ascii_uppercase();
        let start = at + 1;
        let length = text[start..].iter().position(|byte| !IS_OF_NUMBER[usize::from(*byte)]);
        let end = length.map_or(text.len(), |length| start + length);
        let number = &text[start..end];
        match letter {
            b'G' | b'M' => {
                *is_new |= self.add_code(letter, tenths_of(number));
                return end;
            }
            b'N' => return end,
            b'O' => {
                self.programs += 1;
                return end;
            }
            _ => {}
        }
        let bit = letter_bit(letter);
        if self.whole & self.decimal & bit != 0 {
            return end;
        }
        // A zero is the same in all units.
        let is_decimal =
            number.contains(&b'.') || !number.iter().any(|byte| matches!(byte, b'1'..=b'9'));
        let letters = if is_decimal { &mut self.decimal } else { &mut self.whole };
        *is_new |= *letters & bit == 0;
        *letters |= bit;
        end
    }
}

/// By byte, whether it may be in the number of a word. A table, because the whole of a long text is read with it.
const IS_OF_NUMBER: [bool; 256] = {
    let (mut table, bytes) = ([false; 256], b"0123456789.-+ ");
    let mut index = 0;
    while index < bytes.len() {
        table[bytes[index] as usize] = true;
        index += 1;
    }
    table
};

/// The number of a code in tenths: 541 for `54.1`.
fn tenths_of(number: &[u8]) -> u32 {
    let mut digits = number.iter().filter(|byte| byte.is_ascii_digit() || **byte == b'.');
    let value = digits
        .by_ref()
        .take_while(|byte| **byte != b'.')
        .fold(0_u32, |value, byte| value.saturating_mul(10).saturating_add(u32::from(byte - b'0')));
    let tenth = digits.next().filter(|byte| byte.is_ascii_digit());
    value.saturating_mul(10).saturating_add(tenth.map_or(0, |byte| u32::from(byte - b'0')))
}

fn letter_bit(letter: u8) -> u32 {
    1 << (letter - b'A')
}

fn code_row(letter: u8) -> usize {
    usize::from(letter == b'M')
}

fn comment_end(text: &[u8], at: usize) -> usize {
    memchr::memchr3(b')', b'\n', b'\r', &text[at..]).map_or(text.len(), |end| at + end + 1)
}

fn line_end(text: &[u8], at: usize) -> usize {
    memchr::memchr2(b'\n', b'\r', &text[at..]).map_or(text.len(), |end| at + end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_whole_number_is_another_kind_than_a_decimal() {
        let is_new = |line: &[u8]| {
            let mut kinds = WordKinds::default();
            kinds.read(b"G1 X1.5 Y0 F100\nG0 Z2.\n");
            kinds.read(line)
        };
        assert!(!is_new(b"X3.25 Y-1.\n(Z5 IN A COMMENT) ; Z5\nN100 G01 Z0 F5\n"));
        for line in ["X3\n", "G81 X1.\n", "X#1\n", "M300\n"] {
            assert!(is_new(line.as_bytes()), "{line}");
        }
    }
}

//! Which kinds of words a text has, so that the end of a long one can be held by its beginning.

use std::collections::HashSet;

/// The kinds of words of a text: letters with a whole number, letters with a decimal point, codes. What a text
/// moves may differ between controls only where they read one of these differently.
#[derive(Debug, Default)]
pub struct WordKinds {
    /// The letters of words without and with a decimal point, A in the lowest bit.
    whole: u32,
    decimal: u32,
    /// G and M codes by letter and ten times their number.
    codes: HashSet<(u8, u32)>,
    /// Something else than words: a macro statement.
    statements: bool,
}

impl WordKinds {
    /// Those of a text.
    pub fn of(text: &[u8]) -> WordKinds {
        let mut kinds = WordKinds::default();
        let mut at = 0;
        while let Some(byte) = text.get(at).copied() {
            at = match byte {
                b'(' => comment_end(text, at),
                b';' => line_end(text, at),
                b'A'..=b'Z' | b'a'..=b'z' => kinds.word(text, at),
                b'#' | b'[' | b'=' => {
                    kinds.statements = true;
                    at + 1
                }
                _ => at + 1,
            };
        }
        kinds
    }

    /// Every kind of the other is here too.
    pub fn covers(&self, other: &WordKinds) -> bool {
        other.whole & !self.whole == 0
            && other.decimal & !self.decimal == 0
            && (self.statements || !other.statements)
            && other.codes.is_subset(&self.codes)
    }

    fn word(&mut self, text: &[u8], at: usize) -> usize {
        let letter = text[at].to_ascii_uppercase();
        let mut end = at + 1;
        let (mut value, mut tenths, mut digits_after) = (0_u32, 0_u32, None::<u32>);
        let mut is_zero = true;
        while let Some(byte) = text.get(end).copied() {
            match byte {
                b'0'..=b'9' => {
                    is_zero &= byte == b'0';
                    let digit = u32::from(byte - b'0');
                    match digits_after {
                        None => value = value.saturating_mul(10).saturating_add(digit),
                        Some(0) => tenths = digit,
                        Some(_) => {}
                    }
                    digits_after = digits_after.map(|count| count + 1);
                }
                b'.' if digits_after.is_none() => digits_after = Some(0),
                b'-' | b'+' | b' ' => {}
                _ => break,
            }
            end += 1;
        }
        let bit = 1_u32 << (letter - b'A');
        match letter {
            b'G' | b'M' => {
                self.codes.insert((letter, value.saturating_mul(10).saturating_add(tenths)));
            }
            b'N' | b'O' => {}
            // Nothing reads a zero in another unit.
            _ if digits_after.is_some() || is_zero => self.decimal |= bit,
            _ => self.whole |= bit,
        }
        end
    }
}

fn comment_end(text: &[u8], at: usize) -> usize {
    let end = text[at..].iter().position(|byte| matches!(byte, b')' | b'\n' | b'\r'));
    end.map_or(text.len(), |end| at + end + 1)
}

fn line_end(text: &[u8], at: usize) -> usize {
    text[at..]
        .iter()
        .position(|byte| matches!(byte, b'\n' | b'\r'))
        .map_or(text.len(), |end| at + end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_whole_number_is_another_kind_than_a_decimal() {
        let head = WordKinds::of(b"G1 X1.5 Y0 F100\nG0 Z2.\n");
        assert!(
            head.covers(&WordKinds::of(b"X3.25 Y-1.\n(Z5 IN A COMMENT) ; Z5\nN100 G01 Z0 F5\n"))
        );
        assert!(!head.covers(&WordKinds::of(b"X3\n")));
        assert!(!head.covers(&WordKinds::of(b"G81 X1.\n")));
        assert!(!head.covers(&WordKinds::of(b"X#1\n")));
    }
}

//! Decimal numbers with all their digits, so that a conversion of units rounds only once.

/// A decimal number exactly as written: `digits` (0 to 9 each) times ten to the power `exponent`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ExactDecimal {
    negative: bool,
    digits: Vec<u8>,
    exponent: i64,
}

/// An exact factor: `digits` times ten to the power `exponent`, divided by `denominator`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ExactFactor {
    pub(crate) digits: &'static str,
    pub(crate) exponent: i64,
    pub(crate) denominator: u64,
}

/// More digits than any midpoint between two doubles has. Of further digits it only matters for the rounding whether all
/// are zero.
const QUOTIENT_DIGITS: usize = 800;

impl ExactDecimal {
    /// Reads the number at the start of a text: the number and the rest of the text. `None` if there is none.
    pub(crate) fn read(text: &str) -> Option<(ExactDecimal, &str)> {
        let bytes = text.as_bytes();
        let mut at = 0;
        let negative = bytes.first() == Some(&b'-');
        if matches!(bytes.first(), Some(b'+' | b'-')) {
            at += 1;
        }
        let mut digits = Vec::new();
        let mut exponent = 0i64;
        let mut seen = false;
        let mut point = false;
        while let Some(&byte) = bytes.get(at) {
            match byte {
                b'0'..=b'9' => {
                    seen = true;
                    if byte != b'0' || !digits.is_empty() {
                        digits.push(byte - b'0');
                    }
                    exponent -= i64::from(point);
                }
                b'.' if !point => point = true,
                _ => break,
            }
            at += 1;
        }
        if !seen {
            return None;
        }
        if matches!(bytes.get(at), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
            let from = at + 1 + sign;
            let count =
                bytes[from.min(bytes.len())..].iter().take_while(|b| b.is_ascii_digit()).count();
            if count > 0 {
                // Any exponent beyond a few hundred gives zero or is out of range.
                let size =
                    text[from..from + count].parse::<i64>().unwrap_or(i64::MAX).min(1_000_000);
                exponent += if bytes[at + 1] == b'-' { -size } else { size };
                at = from + count;
            }
        }
        Some((ExactDecimal { negative, digits, exponent }, &text[at..]))
    }

    /// The number times a factor, rounded once; infinite if it is out of range.
    pub(crate) fn times(&self, factor: ExactFactor) -> f64 {
        let product = multiply(&self.digits, factor.digits.as_bytes());
        let (quotient, extra) = divide(&product, factor.denominator);
        let exponent = self.exponent + factor.exponent - extra;
        let mut text = String::with_capacity(quotient.len() + 8);
        if self.negative {
            text.push('-');
        }
        text.push('0');
        text.extend(quotient.iter().map(|digit| char::from(b'0' + digit)));
        text.push_str(&format!("e{exponent}"));
        text.parse().unwrap_or(f64::INFINITY)
    }
}

/// The product of digits and the digits of an ASCII number.
fn multiply(digits: &[u8], number: &[u8]) -> Vec<u8> {
    let mut product = vec![0u32; digits.len() + number.len()];
    for (i, a) in digits.iter().rev().enumerate() {
        let mut carry = 0;
        for (j, b) in number.iter().rev().enumerate() {
            let sum = product[i + j] + u32::from(*a) * u32::from(b - b'0') + carry;
            product[i + j] = sum % 10;
            carry = sum / 10;
        }
        product[i + number.len()] += carry;
    }
    product.iter().rev().map(|digit| *digit as u8).collect()
}

/// Digits divided by a small number: the digits of the quotient and how many of them are decimals. A remainder is
/// represented by a last digit 1.
fn divide(digits: &[u8], by: u64) -> (Vec<u8>, i64) {
    if by == 1 {
        return (digits.to_vec(), 0);
    }
    let mut quotient = Vec::with_capacity(digits.len());
    let mut rest = 0u64;
    for digit in digits {
        let value = rest * 10 + u64::from(*digit);
        quotient.push((value / by) as u8);
        rest = value % by;
    }
    let mut extra = 0;
    while rest != 0 && (extra as usize) < QUOTIENT_DIGITS {
        let value = rest * 10;
        quotient.push((value / by) as u8);
        rest = value % by;
        extra += 1;
    }
    if rest != 0 {
        quotient.push(1);
        extra += 1;
    }
    (quotient, extra)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times(text: &str, digits: &'static str, exponent: i64, denominator: u64) -> f64 {
        let (number, rest) = ExactDecimal::read(text).expect("a number");
        assert_eq!(rest, "");
        number.times(ExactFactor { digits, exponent, denominator })
    }

    #[test]
    fn one_rounding() {
        assert_eq!(times("0.5", "254", -1, 1), 12.7);
        assert_eq!(times("-.1", "254", -1, 1), -2.54);
        assert_eq!(times("7.", "254", -1, 1), 177.8);
        assert_eq!(times("1", "1", 0, 3), 1.0 / 3.0);
        assert_eq!(times("1e3", "254", -1, 60), 25400.0 / 60.0);
        assert_eq!(times("000", "254", -1, 60), 0.0);
        assert_eq!(times("1e999999999999", "1", 0, 1), f64::INFINITY);
        assert_eq!(times("1e-999999999999", "1", 0, 1), 0.0);
    }

    #[test]
    fn the_rest_is_handed_back() {
        assert_eq!(ExactDecimal::read("5em").expect("a number").1, "em");
        assert_eq!(ExactDecimal::read("5.5.5").expect("a number").1, ".5");
        assert!(ExactDecimal::read(".").is_none());
        assert!(ExactDecimal::read("-").is_none());
        assert!(ExactDecimal::read("").is_none());
    }
}

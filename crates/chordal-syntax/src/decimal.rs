//! Exact decimal numbers, as written in the program.

use std::fmt;

/// A number as written: sign, digits, and whether there is a decimal point.
///
/// `X10` and `X10.` differ on some controls, and `.1` has no exact binary form, so the literal is kept until the rules of
/// the control define its value.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub struct Decimal {
    /// The digits without the point, with the sign.
    pub mantissa: i64,
    /// The number of digits after the point.
    pub scale: u8,
    /// A point was written.
    pub has_point: bool,
    /// A minus sign was written (a separate flag because of `-0`).
    pub negative: bool,
}

/// The powers of ten that are exact as a double.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// The powers of ten that fit into an `i64`.
const WHOLE_POWERS: [i64; 19] = {
    let mut powers = [1; 19];
    let mut at = 1;
    while at < powers.len() {
        powers[at] = powers[at - 1] * 10;
        at += 1;
    }
    powers
};

/// All integers up to this are exact as a double.
const EXACT: u64 = 1 << 53;

impl Decimal {
    /// A whole number written without a point.
    pub const fn integer(value: i64) -> Decimal {
        Decimal { mantissa: value, scale: 0, has_point: false, negative: value < 0 }
    }

    /// The nearest double.
    #[inline]
    pub fn to_f64(self) -> f64 {
        self.times(1, 0)
    }

    /// The nearest double to `self · factor / 10^extra_scale`: a conversion of units with only one rounding (inch to
    /// millimetre is `times(254, 1)`).
    #[inline]
    pub fn times(self, factor: i64, extra_scale: u8) -> f64 {
        if self.mantissa == 0 {
            return 0.0;
        }
        if let Some(product) = self.mantissa.checked_mul(factor)
            && product.unsigned_abs() <= EXACT
        {
            // Both operands are exact, so the division rounds once.
            if let Some(power) = POWERS.get((self.scale + extra_scale) as usize) {
                return product as f64 / power;
            }
        }
        self.times_slowly(factor, extra_scale)
    }

    #[cold]
    fn times_slowly(self, factor: i64, extra_scale: u8) -> f64 {
        let wide = i128::from(self.mantissa) * i128::from(factor);
        // The parser of the standard library rounds correctly for any length.
        format!("{wide}e-{}", u32::from(self.scale) + u32::from(extra_scale))
            .parse()
            .unwrap_or(f64::NAN)
    }

    /// The value as a whole number (`5` and `5.0`); `None` if it is not one.
    #[inline]
    pub fn to_integer(self) -> Option<i64> {
        if self.scale == 0 {
            return Some(self.mantissa);
        }
        let power = 10_i64.checked_pow(u32::from(self.scale))?;
        (self.mantissa % power == 0).then(|| self.mantissa / power)
    }

    /// The number of its digits, at least that of those after the point.
    pub fn digits(self) -> u8 {
        let size = self.mantissa.unsigned_abs();
        let more = |power: &&i64| size >= power.unsigned_abs();
        let written = WHOLE_POWERS.iter().take_while(more).count().max(1) as u8;
        written.max(self.scale)
    }

    /// The number with only `decimals` decimals, first truncated and then rounded (half away from zero); `None` if all
    /// further decimals are zeros.
    #[inline]
    pub fn at_decimals(self, decimals: u8) -> Option<(Decimal, Decimal)> {
        let power = *WHOLE_POWERS.get(usize::from(self.scale.checked_sub(decimals)?))?;
        let (whole, rest) = (self.mantissa / power, self.mantissa % power);
        if rest == 0 {
            return None;
        }
        let up = i64::from(rest.abs() >= power / 2) * rest.signum();
        let with = |mantissa| Decimal { mantissa, scale: decimals, ..self };
        Some((with(whole), with(whole + up)))
    }

    /// True for `0`, `-0.00` and the like.
    #[inline]
    pub const fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    /// Reads digits and at most one point; digits after the 18th are dropped. `None` if there are no digits, or more
    /// than 18 before the point.
    pub(crate) fn parse_long(text: &[u8]) -> Option<Decimal> {
        let zeros = text.iter().take_while(|byte| **byte == b'0').count();
        let text = &text[zeros.min(text.len().saturating_sub(1))..];
        let point = text.contains(&b'.');
        Decimal::parse(&text[..text.len().min(18 + usize::from(point))])
            .filter(|_| text.iter().position(|byte| *byte == b'.').unwrap_or(text.len()) <= 18)
    }

    /// Reads a whole text as a number; `None` if it is not one.
    pub fn parse(text: &[u8]) -> Option<Decimal> {
        let (number, length) = scan(text)?;
        (length == text.len()).then_some(number)
    }
}

/// The largest number of digits that are kept; a double has fewer.
const MAX_DIGITS: usize = 18;

/// Reads `[+-]digits[.digits]` at the start of `text`: the number and its length in bytes. It is rounded to 18 digits.
/// `None` if there is no digit, or more than 18 before the point.
pub(crate) fn scan(text: &[u8]) -> Option<(Decimal, usize)> {
    let sign = text.first().copied().unwrap_or(0);
    let negative = sign == b'-';
    scan_any(text, usize::from(negative || sign == b'+'), negative)
}

/// The number of bytes that [`scan_short`] reads.
pub(crate) const SHORT_BYTES: usize = 16;

/// Reads a number of at most eight bytes after the sign, including the point: almost every number of a program. The eight
/// bytes are processed as one integer, from which the point is removed. `None` for other numbers, which [`scan`] reads.
#[inline]
pub(crate) fn scan_short(text: &[u8; SHORT_BYTES]) -> Option<(Decimal, usize)> {
    let negative = text[0] == b'-';
    let signed = negative | (text[0] == b'+');
    let wide = u128::from_le_bytes(*text);
    let bytes = (if signed { wide >> 8 } else { wide }) as u64;
    let values = bytes ^ 0x3030_3030_3030_3030;
    let strange = strange_bytes(values);
    let rest = strange & strange.wrapping_sub(1);
    if rest == 0 {
        return None;
    }
    // The highest bit of a byte is its flag.
    let bits = strange.trailing_zeros() - 7;
    let has_point = (values >> bits) & 0xFF == u64::from(b'.' ^ 0x30);
    let (digits, digit_bits, end_bits) = if has_point {
        let end_bits = rest.trailing_zeros() - 7;
        let before = (1 << bits) - 1;
        ((values & before) | ((values >> 8) & !before), end_bits - 8, end_bits)
    } else {
        (values, bits, bits)
    };
    if digit_bits == 0 {
        return None;
    }
    let value = join(digits << (64 - digit_bits)) as i64;
    let number = Decimal {
        mantissa: if negative { -value } else { value },
        scale: ((digit_bits - bits.min(digit_bits)) / 8) as u8,
        has_point,
        negative,
    };
    Some((number, end_bits as usize / 8 + usize::from(signed)))
}

/// Sets the highest bit of each byte that is not a digit; `values` are the bytes minus `0`.
#[inline]
const fn strange_bytes(values: u64) -> u64 {
    // There are no carries between bytes: seven bits are compared, and the eighth is combined separately.
    (((values & 0x7F7F_7F7F_7F7F_7F7F) + 0x7676_7676_7676_7676) | values) & 0x8080_8080_8080_8080
}

fn scan_any(text: &[u8], start: usize, negative: bool) -> Option<(Decimal, usize)> {
    let mut at = start;
    let (whole, whole_digits) = digits(text, at);
    at += whole_digits;
    let (mut value, mut scale) = (whole, 0);
    let has_point = text.get(at) == Some(&b'.');
    if has_point {
        at += 1;
        let (part, part_digits) = digits(text, at);
        at += part_digits;
        scale = part_digits;
        value = value.wrapping_mul(TENS[scale.min(19)]).wrapping_add(part);
    }
    let count = whole_digits + scale;
    if count == 0 {
        return None;
    }
    if count > MAX_DIGITS {
        return scan_long(text, start, whole_digits, scale, negative).map(|number| (number, at));
    }
    let mantissa = if negative { -(value as i64) } else { value as i64 };
    Some((Decimal { mantissa, scale: scale as u8, has_point, negative }, at))
}

/// Reads a number with many digits: leading zeros do not count, and excess digits are rounded.
#[cold]
fn scan_long(
    text: &[u8],
    start: usize,
    whole_digits: usize,
    part_digits: usize,
    negative: bool,
) -> Option<Decimal> {
    let whole = &text[start..start + whole_digits];
    let zeros = whole.iter().take_while(|byte| **byte == b'0').count();
    let whole = &whole[zeros..];
    if whole.len() > MAX_DIGITS {
        return None;
    }
    let point = start + whole_digits;
    let part = text.get(point + 1..point + 1 + part_digits).unwrap_or(&[]);
    let kept = part.len().min(MAX_DIGITS - whole.len());
    let (value, _) = digits(&[whole, &part[..kept]].concat(), 0);
    let up = part.get(kept).is_some_and(|byte| *byte >= b'5');
    let value = (value + u64::from(up)) as i64;
    let mantissa = if negative { -value } else { value };
    let has_point = text.get(point) == Some(&b'.');
    Some(Decimal { mantissa, scale: kept as u8, has_point, negative })
}

const TENS: [u64; 20] = {
    let mut table = [1; 20];
    let mut index = 1;
    while index < 20 {
        table[index] = table[index - 1] * 10;
        index += 1;
    }
    table
};

/// The value and the count of the digits at `at`.
fn digits(text: &[u8], at: usize) -> (u64, usize) {
    let rest = text.get(at..).unwrap_or(&[]);
    let digits = rest.iter().take_while(|byte| byte.is_ascii_digit());
    digits.fold((0, 0), |(value, count): (u64, usize), byte| {
        (value.wrapping_mul(10).wrapping_add(u64::from(byte - b'0')), count + 1)
    })
}

/// The number of eight digits, one per byte, with the first in the lowest byte.
#[inline]
const fn join(digits: u64) -> u64 {
    let pairs = (digits.wrapping_mul(10).wrapping_add(digits >> 8)) & 0x00FF_00FF_00FF_00FF;
    let fours = (pairs.wrapping_mul(100).wrapping_add(pairs >> 16)) & 0x0000_FFFF_0000_FFFF;
    (fours.wrapping_mul(10_000).wrapping_add(fours >> 32)) & 0xFFFF_FFFF
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = self.mantissa.unsigned_abs().to_string();
        let scale = usize::from(self.scale);
        let sign = if self.negative { "-" } else { "" };
        if digits.len() > scale {
            let (whole, rest) = digits.split_at(digits.len() - scale);
            let point = if self.has_point { "." } else { "" };
            write!(f, "{sign}{whole}{point}{rest}")
        } else {
            write!(f, "{sign}.{digits:0>scale$}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Decimal {
        Decimal::parse(text.as_bytes()).unwrap()
    }

    #[test]
    fn keeps_what_was_written() {
        assert!(read("10.").has_point && !read("10").has_point);
        for text in ["10.", "10", "-.5", "0.125", ".0357", "-0", "100000.0001"] {
            let shown = read(text).to_string();
            assert_eq!(read(&shown), read(text), "{text} shown as {shown}");
        }
        for digits in 1..=18 {
            let text = &"123456789012345678"[..digits];
            assert_eq!(read(text).mantissa.to_string(), text);
            assert_eq!(read(&format!("-{text}.")).mantissa.to_string(), format!("-{text}"));
            assert_eq!(scan(format!("{text}X1.2345678").as_bytes()).unwrap().1, digits);
            // The same number wherever its point stands and whatever follows.
            for point in 0..=digits {
                let sign = ["", "-", "+"][point % 3];
                let number = format!("{sign}{}.{}", &text[..point], &text[point..]);
                for tail in ["", " ", "Y-1.", "\n\n\n\n\n\n\n\n", "\u{e9}9999999"] {
                    let text_and_tail = format!("{number}{tail}");
                    let (read, length) = scan(text_and_tail.as_bytes()).unwrap();
                    assert_eq!(length, number.len());
                    if let Some(head) = text_and_tail.as_bytes().first_chunk::<SHORT_BYTES>()
                        && let Some(short) = scan_short(head)
                    {
                        assert_eq!(short, (read, length));
                    }
                    assert_eq!(read.mantissa.unsigned_abs().to_string(), text);
                    assert_eq!(read.negative, sign == "-");
                    assert_eq!(usize::from(read.scale), digits - point);
                }
            }
        }
        for text in ["", "-", ".", "1..2", "1e5", "1234567890123456789"] {
            assert_eq!(Decimal::parse(text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn more_digits_than_a_double_tells_are_rounded() {
        let pi = "3.14159265358979323846264338327950288";
        assert_eq!(read(pi).to_f64(), std::f64::consts::PI);
        assert_eq!(read(&format!("-{pi}")).to_f64(), -std::f64::consts::PI);
        assert_eq!(read("0000000000000000000000012.5").to_f64(), 12.5);
        assert_eq!(read("00000000000000000000000007"), Decimal::integer(7));
        assert_eq!(read(".1000000000000000000000").to_f64(), 0.1);
        assert_eq!(read("1.9999999999999999999").to_f64(), 2.0);
        assert_eq!(
            scan(b"0.00000000000000000000001X").map(|(n, at)| (n.to_f64(), at)),
            Some((0.0, 25))
        );
    }

    #[test]
    fn converts_with_one_rounding() {
        assert_eq!(read(".1").to_f64(), 0.1);
        assert_eq!(read("0.5").times(254, 1), 12.7);
        assert_eq!(read("-3.4585").times(254, 1), -87.8459);
        assert_eq!(read("999999999999999.999").times(254, 1), 25399999999999999.9746);
        assert_eq!(read("12.").to_integer(), Some(12));
        assert_eq!(read("12.5").to_integer(), None);
    }
}

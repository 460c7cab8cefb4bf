use std::fmt;

/// A number as it was written: sign, digits, and whether there was a decimal point.
///
/// `X10` and `X10.` differ on some controls, and `.1` has no exact binary form, so the
/// literal is kept until a control says what it means.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub struct Decimal {
    /// The digits without the point, with the sign.
    pub mantissa: i64,
    /// Digits behind the point.
    pub scale: u8,
    /// A point was written.
    pub has_point: bool,
    /// A minus sign was written (kept apart, for `-0`).
    pub negative: bool,
}

/// Powers of ten that a double holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// Integers up to here have an exact double.
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

    /// The nearest double to `self · factor / 10^extra_scale`: a conversion of units with
    /// a single rounding (inch to millimetre is `times(254, 1)`).
    #[inline]
    pub fn times(self, factor: i64, extra_scale: u8) -> f64 {
        if self.mantissa == 0 {
            return 0.0;
        }
        if let Some(product) = self.mantissa.checked_mul(factor)
            && product.unsigned_abs() <= EXACT
        {
            // Both operands are exact, so the division rounds once.
            return product as f64 / POWERS[(self.scale + extra_scale) as usize % 23];
        }
        self.times_slowly(factor, extra_scale)
    }

    #[cold]
    fn times_slowly(self, factor: i64, extra_scale: u8) -> f64 {
        let wide = i128::from(self.mantissa) * i128::from(factor);
        // The standard library's parser rounds correctly for any length.
        format!("{wide}e-{}", u32::from(self.scale) + u32::from(extra_scale))
            .parse()
            .unwrap_or(f64::NAN)
    }

    /// The value as a whole number, when it is one (`5` and `5.0`).
    #[inline]
    pub fn to_integer(self) -> Option<i64> {
        if self.scale == 0 {
            return Some(self.mantissa);
        }
        let power = 10_i64.checked_pow(u32::from(self.scale))?;
        (self.mantissa % power == 0).then(|| self.mantissa / power)
    }

    /// True for `0`, `-0.00` and the like.
    #[inline]
    pub const fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    /// Reads a whole text as a number; `None` when it is anything else.
    pub fn parse(text: &[u8]) -> Option<Decimal> {
        let (number, length) = scan(text)?;
        (length == text.len()).then_some(number)
    }
}

/// Reads `[+-]digits[.digits]` at the head of `text`: the number and its length in bytes.
/// `None` when there is no digit, or more digits than 18 (no control keeps that many).
pub(crate) fn scan(text: &[u8]) -> Option<(Decimal, usize)> {
    let mut at = 0;
    let negative = match text.first() {
        Some(b'-') => {
            at = 1;
            true
        }
        Some(b'+') => {
            at = 1;
            false
        }
        _ => false,
    };
    let (mut value, mut digits, first) = (0u64, 0usize, at);
    while let Some(digit) = text.get(at).map(|b| b.wrapping_sub(b'0')).filter(|d| *d < 10) {
        value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
        at += 1;
    }
    digits += at - first;
    let mut scale = 0;
    let has_point = text.get(at) == Some(&b'.');
    if has_point {
        at += 1;
        let first = at;
        while let Some(digit) = text.get(at).map(|b| b.wrapping_sub(b'0')).filter(|d| *d < 10) {
            value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
            at += 1;
        }
        scale = at - first;
        digits += scale;
    }
    if digits == 0 || digits > 18 {
        return None;
    }
    let mantissa = if negative { -(value as i64) } else { value as i64 };
    Some((Decimal { mantissa, scale: scale as u8, has_point, negative }, at))
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
        for text in ["", "-", ".", "1..2", "1e5", "1234567890123456789"] {
            assert_eq!(Decimal::parse(text.as_bytes()), None, "{text}");
        }
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

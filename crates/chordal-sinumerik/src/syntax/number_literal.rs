//! Numbers: `10`, `1.5`, `.5`, `10.`, `1.5EX-3`, and the constants `'H1F'` and `'B101'`.

/// The value of a number.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum NumberLiteral {
    /// Without a decimal point and an exponent.
    Whole(i64),
    /// With a decimal point or an exponent, or too large for a whole number.
    Decimal(f64),
}

impl NumberLiteral {
    /// The number with the other sign.
    pub fn negated(self) -> NumberLiteral {
        match self {
            NumberLiteral::Whole(value) => NumberLiteral::Whole(-value),
            NumberLiteral::Decimal(value) => NumberLiteral::Decimal(-value),
        }
    }
}

/// The greatest power of ten that a floating-point number holds exactly.
const MAX_EXACT_POWER: i32 = 22;

const POWERS: [f64; MAX_EXACT_POWER as usize + 1] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// A mantissa up to this holds one more digit.
const MAX_MANTISSA_BEFORE_DIGIT: u64 = (u64::MAX - 9) / 10;

/// The parts of a number before they are joined.
#[derive(Default)]
struct NumberParts {
    /// All digits as one whole number, while they fit.
    mantissa: u64,
    /// The digits do not fit in the mantissa.
    is_long: bool,
    /// The digits after the point.
    decimals: i32,
    has_point: bool,
}

/// Reads a number at the beginning of `text`: its length in bytes and its value. `None` when none begins here.
pub(super) fn read_number(text: &[u8]) -> Option<(usize, NumberLiteral)> {
    let mut parts = NumberParts::default();
    let mut length = add_digits(text, &mut parts);
    let has_digits = length > 0;
    if text.get(length) == Some(&b'.') {
        let decimals = add_digits(&text[length + 1..], &mut parts);
        if !has_digits && decimals == 0 {
            return None;
        }
        parts.has_point = true;
        parts.decimals = i32::try_from(decimals).unwrap_or(i32::MAX / 2);
        length += 1 + decimals;
    }
    if length == 0 {
        return None;
    }
    let digits = &text[..length];
    let exponent = read_exponent(&text[length..]);
    length += exponent.map_or(0, |(bytes, _)| bytes);
    let has_exponent = exponent.is_some();
    let exponent = exponent.map_or(0, |(_, value)| value);
    let is_whole = !parts.has_point && !has_exponent && !parts.is_long;
    if let Some(whole) = i64::try_from(parts.mantissa).ok().filter(|_| is_whole) {
        return Some((length, NumberLiteral::Whole(whole)));
    }
    Some((length, NumberLiteral::Decimal(joined(&parts, digits, exponent))))
}

/// Adds the digits at the beginning of `text` to the mantissa and returns their number.
fn add_digits(text: &[u8], parts: &mut NumberParts) -> usize {
    let mut count = 0;
    while let Some(digit) = text.get(count).filter(|byte| byte.is_ascii_digit()) {
        match parts.mantissa <= MAX_MANTISSA_BEFORE_DIGIT {
            true => parts.mantissa = parts.mantissa * 10 + u64::from(digit - b'0'),
            false => parts.is_long = true,
        }
        count += 1;
    }
    count
}

/// Reads `EX`, a sign and digits: the bytes and the value. `None` without.
fn read_exponent(text: &[u8]) -> Option<(usize, i32)> {
    if !text.get(..2)?.eq_ignore_ascii_case(b"EX") {
        return None;
    }
    let sign = matches!(text.get(2), Some(b'+' | b'-'));
    let start = 2 + usize::from(sign);
    let digits = text[start..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let value = text[start..start + digits].iter().fold(0_i32, |value, digit| {
        value.saturating_mul(10).saturating_add(i32::from(digit - b'0')).min(99_999)
    });
    let value = if text.get(2) == Some(&b'-') { -value } else { value };
    (digits > 0).then_some((start + digits, value))
}

/// The nearest floating-point number. A mantissa below 2^53 and an exact power of ten give it with one rounding; other
/// numbers are converted from their digits.
fn joined(parts: &NumberParts, digits: &[u8], exponent: i32) -> f64 {
    let scale = exponent.saturating_sub(parts.decimals);
    if !parts.is_long && parts.mantissa < 1 << 53 && scale.abs() <= MAX_EXACT_POWER {
        let power = POWERS[scale.unsigned_abs() as usize];
        let mantissa = parts.mantissa as f64;
        return if scale < 0 { mantissa / power } else { mantissa * power };
    }
    let digits = String::from_utf8_lossy(digits);
    format!("{digits}e{exponent}").parse().unwrap_or(f64::INFINITY)
}

/// The value of what is between the apostrophes of `'H1F'` or `'B101'`, as the 32 bits of an INT. `None` for anything
/// else.
pub(super) fn bit_constant(text: &[u8]) -> Option<i64> {
    let (first, digits) = text.split_first()?;
    let radix = match first.to_ascii_uppercase() {
        b'H' => 16,
        b'B' => 2,
        _ => return None,
    };
    let digits = std::str::from_utf8(digits).ok()?;
    if digits.starts_with('+') {
        return None;
    }
    let bits = u32::from_str_radix(digits, radix).ok()?;
    Some(i64::from(bits.cast_signed()))
}

//! Numbers as text: rounded to nine decimals, without trailing zeros.

/// Above this, nine decimals are more than a double holds, and the usual text is exact.
const SCALABLE: f64 = 4.0e6;

/// Appends a number: the shortest decimal within 5e-10, never `-0`; `null` where there is
/// none.
pub(crate) fn push_number(out: &mut Vec<u8>, value: f64) {
    if !push_finite(out, value) {
        out.extend_from_slice(b"null");
    }
}

/// Appends a number; nothing, and false, where there is none.
pub(crate) fn push_finite(out: &mut Vec<u8>, value: f64) -> bool {
    if !value.is_finite() {
        return false;
    }
    if value.abs() >= SCALABLE {
        // Rust's own text of a double never has an exponent.
        out.extend_from_slice(format!("{value}").as_bytes());
        return true;
    }
    let scaled = (value * 1e9).round() as i64;
    if scaled < 0 {
        out.push(b'-');
    }
    let scaled = scaled.unsigned_abs();
    push_integer(out, scaled / 1_000_000_000);
    push_decimals(out, (scaled % 1_000_000_000) as u32);
    true
}

/// Appends a number with exactly six decimals, and 0 for what is none.
pub(crate) fn push_fixed(out: &mut Vec<u8>, value: f64) {
    let value = if value.is_finite() { value } else { 0.0 };
    if value.abs() >= 4.0e9 {
        out.extend_from_slice(format!("{value:.6}").as_bytes());
        return;
    }
    let scaled = (value * 1e6).round() as i64;
    if scaled < 0 {
        out.push(b'-');
    }
    let scaled = scaled.unsigned_abs();
    push_integer(out, scaled / 1_000_000);
    out.push(b'.');
    push_digits(out, (scaled % 1_000_000) as u32, 6);
}

/// Appends a whole number.
pub(crate) fn push_integer(out: &mut Vec<u8>, mut value: u64) {
    let mut digits = [0u8; 20];
    let mut at = digits.len();
    loop {
        at -= 1;
        digits[at] = b'0' + (value % 10) as u8;
        value /= 10;
        if value == 0 {
            break;
        }
    }
    out.extend_from_slice(&digits[at..]);
}

fn push_decimals(out: &mut Vec<u8>, billionths: u32) {
    if billionths == 0 {
        return;
    }
    out.push(b'.');
    push_digits(out, billionths, 9);
    while out.last() == Some(&b'0') {
        out.pop();
    }
}

fn push_digits(out: &mut Vec<u8>, mut value: u32, count: usize) {
    let mut digits = [b'0'; 9];
    for digit in digits[..count].iter_mut().rev() {
        *digit = b'0' + (value % 10) as u8;
        value /= 10;
    }
    out.extend_from_slice(&digits[..count]);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(value: f64) -> String {
        let mut out = Vec::new();
        push_number(&mut out, value);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn the_shortest_decimal_is_written() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (-4e-10, "0"),
            (-6e-10, "-0.000000001"),
            (25.4, "25.4"),
            (-0.1, "-0.1"),
            (0.1 + 0.2, "0.3"),
            (100.0, "100"),
            (39.898227, "39.898227"),
            (123_456_789.123_456, "123456789.123456"),
            (1e15, "1000000000000000"),
            (f64::NAN, "null"),
            (f64::NEG_INFINITY, "null"),
        ];
        for (value, expected) in cases {
            assert_eq!(text(value), expected);
        }
    }

    #[test]
    fn six_decimals_are_always_six() {
        let cases = [(1.5, "1.500000"), (-1e-7, "0.000000"), (f64::NAN, "0.000000")];
        for (value, expected) in cases {
            let mut out = Vec::new();
            push_fixed(&mut out, value);
            assert_eq!(String::from_utf8(out).unwrap(), expected);
        }
    }

    #[test]
    fn numbers_read_back_within_half_a_billionth() {
        let mut value = 1e-9;
        while value < 1e9 {
            let read: f64 = text(value).parse().unwrap();
            assert!((read - value).abs() <= 5.1e-10 + value * 2e-16, "{value} became {read}");
            value *= -1.000_7;
            value = value.abs() + 1.23e-9;
        }
    }
}

//! Pieces of SVG: numbers, escaped texts.

/// Appends a coordinate with at most two decimals.
pub(super) fn push_px(out: &mut String, value: f64) {
    let hundredths = (value * 100.0).round().clamp(-1e15, 1e15) as i64;
    if hundredths < 0 {
        out.push('-');
    }
    let hundredths = hundredths.unsigned_abs();
    out.push_str(itoa(&mut [0; 20], hundredths / 100));
    let rest = hundredths % 100;
    if rest > 0 {
        out.push('.');
        out.push((b'0' + (rest / 10) as u8) as char);
        if !rest.is_multiple_of(10) {
            out.push((b'0' + (rest % 10) as u8) as char);
        }
    }
}

fn itoa(digits: &mut [u8; 20], mut value: u64) -> &str {
    let mut at = digits.len();
    loop {
        at -= 1;
        digits[at] = b'0' + (value % 10) as u8;
        value /= 10;
        if value == 0 {
            break;
        }
    }
    std::str::from_utf8(&digits[at..]).unwrap_or("0")
}

/// A coordinate as text.
pub(super) fn px(value: f64) -> String {
    let mut out = String::new();
    push_px(&mut out, value);
    out
}

/// Text that may stand in XML: what XML cannot hold is replaced.
pub(super) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            control if control.is_control() => out.push('\u{fffd}'),
            other => out.push(other),
        }
    }
    out
}

/// A number for people with so many decimals, and a true minus sign.
pub(super) fn label(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|byte| byte == b'0' || byte == b'.') => rest.into(),
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_short() {
        let texts: Vec<String> =
            [0.0, -0.001, 1.5, -12.25, 3.999, 100.0, 0.05].map(px).into_iter().collect();
        assert_eq!(texts, ["0", "0", "1.5", "-12.25", "4", "100", "0.05"]);
    }

    #[test]
    fn labels_have_no_negative_zero() {
        assert_eq!(label(-0.001, 1), "0.0");
        assert_eq!(label(-1.5, 1), "−1.5");
    }
}

//! The text of DPRNT.

use chordal_diagnostics::TextRange;

/// Number of digits before and after the point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct NumberFormat {
    pub whole: u8,
    pub decimals: u8,
}

/// A part of the text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum OutputPart {
    Text(u8),
    /// A variable and its format; `None` when the format cannot be read.
    Value {
        expression: TextRange,
        format: Option<NumberFormat>,
    },
}

/// The next part of the text between the brackets of DPRNT: `*` prints a blank, blanks are ignored. `None` at the end.
pub(crate) fn next_part(text: &[u8], rest: &mut TextRange) -> Option<OutputPart> {
    loop {
        let byte = *rest.slice(text).first()?;
        match byte {
            b' ' | b'\t' => rest.start += 1,
            b'*' => {
                rest.start += 1;
                return Some(OutputPart::Text(b' '));
            }
            b'#' => return Some(value(text, rest)),
            byte => {
                rest.start += 1;
                return Some(OutputPart::Text(byte));
            }
        }
    }
}

/// `#1[44]`, `#[#1+2][44]`, `##1[44]`.
fn value(text: &[u8], rest: &mut TextRange) -> OutputPart {
    let start = rest.start;
    let words = rest.slice(text);
    let mut at = words.iter().take_while(|b| matches!(b, b'#' | b' ')).count();
    if words.get(at) == Some(&b'[') {
        at += bracket(&words[at..]);
    } else {
        at += words[at..].iter().take_while(|b| b.is_ascii_digit()).count();
    }
    let expression = TextRange::new(start, start + at as u32);
    at += words[at..].iter().take_while(|b| **b == b' ').count();
    let mut format = None;
    if words.get(at) == Some(&b'[') {
        let length = bracket(&words[at..]);
        let digits: Vec<u8> = words[at + 1..(at + length).max(at + 1)]
            .iter()
            .filter(|b| b.is_ascii_digit())
            .map(|b| b - b'0')
            .collect();
        if let [whole, decimals] = digits[..] {
            format = Some(NumberFormat { whole, decimals });
        }
        at += length;
    }
    rest.start = start + at as u32;
    OutputPart::Value { expression, format }
}

/// Length of a bracket with its content.
fn bracket(words: &[u8]) -> usize {
    let mut depth = 0usize;
    for (at, byte) in words.iter().enumerate() {
        match byte {
            b'[' => depth += 1,
            b']' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    words.len()
}

/// Writes a number rounded to its decimals, with trailing zeros. `blanks` pads the whole part with blanks to its number
/// of digits (Fanuc); otherwise it is as long as needed (Haas).
pub(crate) fn write_number(line: &mut String, value: f64, format: NumberFormat, blanks: bool) {
    let decimals = usize::from(format.decimals);
    let rounded = super::functions::round_to(value, format.decimals);
    let digits = format!("{:.decimals$}", rounded.abs());
    let negative = rounded < 0.0;
    if negative {
        line.push('-');
    } else if blanks {
        line.push(' ');
    }
    if blanks {
        let whole = digits.split('.').next().unwrap_or("").len();
        for _ in whole..usize::from(format.whole) {
            line.push(' ');
        }
    }
    line.push_str(&digits);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(value: f64, whole: u8, decimals: u8, blanks: bool) -> String {
        let mut line = String::new();
        write_number(&mut line, value, NumberFormat { whole, decimals }, blanks);
        line
    }

    #[test]
    fn numbers_as_a_haas_prints_them() {
        // Mill Operator's Manual 2017: #1=123.456789, `X-#1[35]` prints X-123.45679.
        assert_eq!(written(123.456789, 3, 5, false), "123.45679");
        assert_eq!(written(123.456789, 1, 0, false), "123");
        assert_eq!(written(1.5, 4, 4, false), "1.5000");
        assert_eq!(written(-0.00001, 4, 4, false), "0.0000");
        assert_eq!(written(-2.0, 4, 1, false), "-2.0");
    }

    #[test]
    fn leading_zeros_are_blanks_on_a_fanuc() {
        assert_eq!(written(12.5, 4, 3, true), "   12.500");
        assert_eq!(written(-12.5, 4, 3, true), "-  12.500");
        assert_eq!(written(123_456.0, 2, 0, true), " 123456");
    }

    #[test]
    fn parts_of_the_text() {
        let text = b"X-#1[35]*T#[2+1][20]/";
        let mut rest = TextRange::new(0, text.len() as u32);
        let mut parts = Vec::new();
        while let Some(part) = next_part(text, &mut rest) {
            parts.push(part);
        }
        let value = |start, end, whole, decimals| OutputPart::Value {
            expression: TextRange::new(start, end),
            format: Some(NumberFormat { whole, decimals }),
        };
        let expected = [
            OutputPart::Text(b'X'),
            OutputPart::Text(b'-'),
            value(2, 4, 3, 5),
            OutputPart::Text(b' '),
            OutputPart::Text(b'T'),
            value(10, 16, 2, 0),
            OutputPart::Text(b'/'),
        ];
        assert_eq!(parts, expected);
    }

    #[test]
    fn places_that_cannot_be_read() {
        for text in [&b"#1"[..], b"#1[4]", b"#1[", b"#1[444]"] {
            let mut rest = TextRange::new(0, text.len() as u32);
            let part = next_part(text, &mut rest);
            assert!(matches!(part, Some(OutputPart::Value { format: None, .. })), "{part:?}");
        }
    }
}

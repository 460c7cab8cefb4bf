//! Reads files in which a control has written its macro variables.
//!
//! There are four forms, which are distinguished line by line: Fanuc (`G10L85P500(4029000000000000)`, the bits of a
//! double; older: `#500=[a*65536+b]/134217728`), Mitsubishi (`#500=12.5`), Haas (`N500 V12.5`) and LinuxCNC (`5220
//! 1.0`).

use std::collections::BTreeMap;

/// The largest number of lines; a file with more is not from a control.
const MAX_LINES: usize = 200_000;

/// The largest number of characters of a bad line in a message.
const MAX_SHOWN: usize = 40;

/// The variables of a control.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VariableDump {
    /// Values by number; `None`: the variable is vacant.
    pub values: BTreeMap<u32, Option<f64>>,
    /// The lines that cannot be read.
    pub bad_lines: Vec<BadLine>,
}

/// A line in none of the forms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadLine {
    /// Its number, from 1.
    pub line: usize,
    /// Its text, shortened if it is long.
    pub text: String,
}

/// The content of a line.
enum DumpEntry {
    Value(u32, Option<f64>),
    /// A head, a name or an end.
    Nothing,
}

/// Reads a file of variables. `None` if the first line with content has none of the forms: then it is another kind of
/// file.
pub fn read_variable_dump(bytes: &[u8]) -> Option<VariableDump> {
    let mut dump = VariableDump::default();
    let end = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
    for (index, line) in bytes.split(|byte| *byte == end).enumerate() {
        let number = index + 1;
        if number > MAX_LINES {
            break;
        }
        let text = String::from_utf8_lossy(line);
        let text =
            text.trim_matches(|c: char| c.is_whitespace() || matches!(c, '\0' | '\u{feff}' | ';'));
        match parse_line(text) {
            Some(DumpEntry::Value(number, value)) => {
                dump.values.insert(number, value);
            }
            Some(DumpEntry::Nothing) => {}
            None if dump.values.is_empty() => return None,
            None => {
                let text = text.chars().take(MAX_SHOWN).collect();
                dump.bad_lines.push(BadLine { line: number, text });
            }
        }
    }
    (!dump.values.is_empty()).then_some(dump)
}

fn parse_line(line: &str) -> Option<DumpEntry> {
    let upper = line.to_ascii_uppercase();
    let compact: String = upper.chars().filter(|c| !c.is_whitespace()).collect();
    let is_head = |rest: &str| {
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        digits > 0 && matches!(rest.as_bytes().get(digits), None | Some(b'('))
    };
    let idle = compact.is_empty()
        || compact.starts_with(['%', '('])
        || compact.starts_with("SETVN")
        || matches!(compact.as_str(), "M02" | "M2" | "M30" | "M99")
        || compact.strip_prefix(['O', ':']).is_some_and(is_head);
    if idle {
        return Some(DumpEntry::Nothing);
    }
    if let Some(rest) = compact.strip_prefix("G10L85P") {
        return of_fanuc(rest);
    }
    if let Some(rest) = compact.strip_prefix('#') {
        let (number, value) = rest.split_once('=')?;
        return Some(DumpEntry::Value(number_of(number)?, assigned(value)?));
    }
    if let Some(rest) = compact.strip_prefix('N') {
        let (number, value) = match rest.split_once('V') {
            Some(pair) => pair,
            // The end of a Haas file.
            None => return number_of(rest).map(|_| DumpEntry::Nothing),
        };
        let number = number_of(number)?;
        // N0 is a checksum.
        return match number {
            0 => Some(DumpEntry::Nothing),
            _ => Some(DumpEntry::Value(number, Some(finite(value)?))),
        };
    }
    let mut parts = line.split_whitespace();
    let (number, value) = (parts.next()?, parts.next()?);
    match parts.next() {
        None => Some(DumpEntry::Value(number_of(number)?, Some(finite(value)?))),
        Some(_) => None,
    }
}

/// Reads `500(4029000000000000)`, in some versions with a comment after it.
fn of_fanuc(rest: &str) -> Option<DumpEntry> {
    let (number, rest) = rest.split_once('(')?;
    let (bits, _) = rest.split_once(')')?;
    let number = number_of(number)?;
    if bits.len() != 16 || !bits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return None;
    }
    let bits = u64::from_str_radix(bits, 16).ok()?;
    if bits == u64::MAX {
        return Some(DumpEntry::Value(number, None));
    }
    let value = f64::from_bits(bits);
    value.is_finite().then_some(DumpEntry::Value(number, Some(value)))
}

/// Reads the right side of an assignment: a number, `#0` for vacant, or `[a*65536+b]/134217728`.
fn assigned(value: &str) -> Option<Option<f64>> {
    // A name or a comment may follow it.
    let value = value.split('(').next().unwrap_or(value);
    if matches!(value, "#0" | "") {
        return Some(None);
    }
    if let Some(number) = finite(value) {
        return Some(Some(number));
    }
    let (sum, divisor) = value.split_once('/')?;
    let sum = sum.strip_prefix('[')?.strip_suffix(']')?;
    let (product, rest) = match sum.rfind(['+', '-']).filter(|at| *at > 0) {
        Some(at) if !sum[..at].ends_with('*') => (&sum[..at], finite(&sum[at..])?),
        _ => (sum, 0.0),
    };
    let product = match product.split_once('*') {
        Some((a, b)) => finite(a)? * finite(b)?,
        None => finite(product)?,
    };
    let result = (product + rest) / finite(divisor)?;
    result.is_finite().then_some(Some(result))
}

fn number_of(text: &str) -> Option<u32> {
    let is_whole = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    if is_whole { text.parse().ok() } else { None }
}

/// Reads a number as controls write it: digits, a decimal point or comma, a sign. `None` if it is not finite.
fn finite(text: &str) -> Option<f64> {
    let text = text.strip_prefix('+').unwrap_or(text).replace(',', ".");
    let plain =
        |byte: u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'E' | b'e' | b'+');
    if !text.bytes().all(plain) {
        return None;
    }
    text.parse::<f64>().ok().filter(|number| number.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Vec<(u32, Option<f64>)> {
        let dump = read_variable_dump(text.as_bytes()).expect(text);
        assert_eq!(dump.bad_lines, [], "{text}");
        dump.values.into_iter().collect()
    }

    #[test]
    fn the_bits_of_a_fanuc() {
        let text = "%\r\nG10L85P500(4029000000000000) \r\nG10L85P501(FFFFFFFFFFFFFFFF)(EMPTY)\r\n\
                    G10L85P502(BFE0000000000000)(-0.5)\r\nSETVN500[FEED]\r\nM02\r\n%";
        assert_eq!(values(text), [(500, Some(12.5)), (501, None), (502, Some(-0.5))]);
        assert_eq!(values("G10 L85 P999 (3FF0000000000000)%"), [(999, Some(1.0))]);
    }

    #[test]
    fn assignments_of_older_fanucs_and_mitsubishi() {
        assert_eq!(
            values("#500=12.5\n#501=-3\n#502=#0"),
            [(500, Some(12.5)), (501, Some(-3.0)), (502, None)]
        );
        // 1.5 = (3072 × 65536 + 0) / 134217728.
        assert_eq!(
            values("O9999\n#500=[3072*65536+0]/134217728\n#501=#0\nM30"),
            [(500, Some(1.5)), (501, None)]
        );
        assert_eq!(values("#700 = 2,75 (NAME)\n"), [(700, Some(2.75))]);
    }

    #[test]
    fn lines_of_a_haas() {
        let text = "%\nN0 V12345\nN500 V1.5\nN10501 V-2\nN9999\n%\n";
        assert_eq!(values(text), [(500, Some(1.5)), (10501, Some(-2.0))]);
        assert_eq!(values("N500V.25"), [(500, Some(0.25))]);
        assert_eq!(values("N100 V0.\nN101 V3."), [(100, Some(0.0)), (101, Some(3.0))]);
    }

    #[test]
    fn lines_of_linuxcnc() {
        assert_eq!(
            values("31\t4.25\n5161 0.000000\n5220 1.000000\n"),
            [(31, Some(4.25)), (5161, Some(0.0)), (5220, Some(1.0)),]
        );
        assert_eq!(values("3000   -1e-3"), [(3000, Some(-0.001))]);
        assert_eq!(values("\n\n  100  2  \n"), [(100, Some(2.0))]);
    }

    #[test]
    fn bad_lines_have_their_numbers() {
        let text = "%\r\nG10L85P500(4029000000000000)\r\nG10L85P501(40290000)\r\nhello\r\n#502=1/0\r\n\
                    G10L85P503(7FF0000000000000)\r\n#504=2.5\r\n";
        let dump = read_variable_dump(text.as_bytes()).unwrap();
        assert_eq!(dump.values.keys().copied().collect::<Vec<_>>(), [500, 504]);
        let lines: Vec<usize> = dump.bad_lines.iter().map(|bad| bad.line).collect();
        assert_eq!(lines, [3, 4, 5, 6]);
        assert_eq!(dump.bad_lines[1].text, "hello");
    }

    #[test]
    fn other_files_are_none_of_variables() {
        for text in [
            "",
            "%\n%",
            "variables of the plant\n#500=1",
            "<TOOL/>",
            "x 1",
            "1 2 3",
            "{\"a\": 1}",
            "G10L2P1X0",
        ] {
            assert_eq!(read_variable_dump(text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn no_bytes_make_it_panic() {
        let pieces: [&[u8]; 16] = [
            b"G10L85P",
            b"(",
            b")",
            b"#",
            b"=",
            b"[",
            b"]",
            b"/",
            b"*",
            b"+",
            b"-",
            b"500",
            b"\xff\xfe",
            b"\r",
            b"\n",
            b"N1V",
        ];
        let mut state = 12345u64;
        for _ in 0..20_000 {
            let mut bytes = Vec::new();
            for _ in 0..12 {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                bytes.extend_from_slice(pieces[(state >> 60) as usize]);
                if state >> 40 & 3 == 0 {
                    bytes.push((state >> 32) as u8);
                }
            }
            let dump = read_variable_dump(&bytes);
            let values = dump.into_iter().flat_map(|dump| dump.values.into_values());
            assert!(values.flatten().all(f64::is_finite));
        }
    }
}

//! Numbers and parameters as a head writes them.

use std::collections::BTreeSet;

use chordal_diagnostics::TextRange;
use chordal_kernel::plain_number;

use crate::syntax::{KlartextToken, KlartextTokenKind, ParameterBank, ParameterName, scan_tokens};
use crate::values::ParameterStore;

/// Digits of a parameter that a control keeps (TNC 640 user's manual 34059x, Q parameters).
const PARAMETER_DIGITS: f64 = 15.0;

/// How far a number may be from its text: below what two runs are compared with.
const EXACT: f64 = 2e-10;

/// A number with at most so many digits after the point; `None` where it has more.
pub(super) fn exact_number(value: f64, digits: usize) -> Option<String> {
    let text = (0..=digits)
        .map(|digits| plain_number(value, digits))
        .find(|text| text.parse::<f64>().is_ok_and(|read| (read - value).abs() <= EXACT))?;
    Some(if text.starts_with('-') { text } else { format!("+{text}") })
}

/// A parameter's value, with as many digits as a control keeps.
pub(super) fn parameter_number(value: f64) -> String {
    let before_point = value.abs().max(1.0).log10().floor() + 1.0;
    let digits = (PARAMETER_DIGITS - before_point).max(0.0) as usize;
    let text = plain_number(value, digits);
    if text.starts_with('-') { text } else { format!("+{text}") }
}

/// A parameter in a text.
struct ParameterPlace {
    name: ParameterName,
    /// Its text with a sign before it.
    range: TextRange,
    /// The sign before it.
    sign: Option<u8>,
    /// It gets a value.
    is_target: bool,
}

fn scanned(text: &[u8], parts: &[TextRange]) -> Vec<KlartextToken> {
    let mut tokens = Vec::new();
    parts.iter().for_each(|part| scan_tokens(text, *part, &mut tokens));
    tokens
}

fn parameters_in(text: &[u8], parts: &[TextRange]) -> Vec<ParameterPlace> {
    let tokens = scanned(text, parts);
    let mut found = Vec::new();
    for (at, pair) in tokens.windows(2).enumerate() {
        let (KlartextTokenKind::Word(word), KlartextTokenKind::Number(number)) =
            (&pair[0].kind, &pair[1].kind)
        else {
            continue;
        };
        let Some(bank) = ParameterBank::of_letters(word) else { continue };
        let sign = at.checked_sub(1).and_then(|before| match tokens[before].kind {
            KlartextTokenKind::Sign(sign @ (b'+' | b'-')) => Some((sign, tokens[before].range)),
            _ => None,
        });
        let own = pair[0].range.cover(pair[1].range);
        found.push(ParameterPlace {
            name: ParameterName { bank, number: *number as u32 },
            range: sign.map_or(own, |(_, range)| range.cover(own)),
            sign: sign.map(|(sign, _)| sign),
            is_target: matches!(
                tokens.get(at + 2).map(|token| &token.kind),
                Some(KlartextTokenKind::Sign(b'='))
            ),
        });
    }
    found
}

/// Whether a text names a parameter.
pub(super) fn has_parameter(text: &[u8], parts: &[TextRange]) -> bool {
    !parameters_in(text, parts).is_empty()
}

/// Adds the parameters that a text reads.
pub(super) fn add_reads(text: &[u8], parts: &[TextRange], reads: &mut BTreeSet<ParameterName>) {
    let read = parameters_in(text, parts).into_iter().filter(|place| !place.is_target);
    reads.extend(read.map(|place| place.name));
}

/// Adds the parameters that a text names.
pub(super) fn add_names(text: &[u8], parts: &[TextRange], names: &mut BTreeSet<ParameterName>) {
    names.extend(parameters_in(text, parts).into_iter().map(|place| place.name));
}

/// The text of a block with values in place of the parameters that it reads, and without its number; `None` where one has no
/// value.
pub(super) fn text_with_values(
    text: &[u8],
    range: TextRange,
    parts: &[TextRange],
    parameters: &ParameterStore,
) -> Option<String> {
    let mut written = Vec::new();
    let mut at = range.start;
    let first = scanned(text, parts).into_iter().next();
    if let Some(first) = first.filter(|first| matches!(first.kind, KlartextTokenKind::Number(_))) {
        at = first.range.end;
    }
    for place in parameters_in(text, parts).into_iter().filter(|place| !place.is_target) {
        let value = match place.name.bank {
            ParameterBank::Text => format!("\"{}\"", parameters.text(place.name.number)?),
            _ => {
                let value = parameters.number(place.name)?;
                parameter_number(if place.sign == Some(b'-') { 0.0 - value } else { value })
            }
        };
        written.extend_from_slice(TextRange::new(at, place.range.start).slice(text));
        // A value never runs into the letters before it.
        if written.last().is_some_and(|last| last.is_ascii_digit()) {
            written.push(b' ');
        }
        written.extend_from_slice(value.as_bytes());
        at = place.range.end;
    }
    written.extend_from_slice(TextRange::new(at, range.end).slice(text));
    Some(String::from_utf8_lossy(&written).trim().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_that_they_need() {
        assert_eq!(exact_number(10.5, 5).as_deref(), Some("+10.5"));
        assert_eq!(exact_number(-0.000_01, 5).as_deref(), Some("-0.00001"));
        assert_eq!(exact_number(1.0 / 3.0, 5), None);
        assert_eq!(parameter_number(1.0 / 3.0), "+0.33333333333333");
        assert_eq!(parameter_number(-2.0), "-2");
    }

    #[test]
    fn values_stand_in_place_of_parameters() {
        let text = b"12 CYCL DEF 7.1 X-Q5 IY+Q6 F Q7";
        let range = TextRange::new(0, text.len() as u32);
        let mut parameters = ParameterStore::default();
        parameters.set_shared(5, -2.5);
        parameters.set_shared(6, 0.1);
        parameters.set_shared(7, 100.0);
        let written = text_with_values(text, range, &[range], &parameters);
        assert_eq!(written.as_deref(), Some("CYCL DEF 7.1 X+2.5 IY+0.1 F +100"));
        assert_eq!(text_with_values(text, range, &[range], &ParameterStore::default()), None);
    }

    #[test]
    fn cycle_data_are_no_reads() {
        let text = b"CYCL DEF 200 Q200=+2 Q201=-Q5";
        let range = TextRange::new(0, text.len() as u32);
        let mut reads = BTreeSet::new();
        add_reads(text, &[range], &mut reads);
        let names: Vec<u32> = reads.into_iter().map(|name| name.number).collect();
        assert_eq!(names, [5]);
    }
}

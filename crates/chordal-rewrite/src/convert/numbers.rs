//! Numbers as the new control reads them.

use chordal::control::table::DwellWord;
use chordal::control::{Control, DecimalPoint, Units};
use chordal::syntax::Decimal;

use crate::source::{WordStyle, digits_of_arcs};

impl WordStyle {
    /// What stands between words.
    pub(crate) fn gap(self) -> &'static str {
        if self.spaced { " " } else { "" }
    }
}

/// A length in program units: at most so many digits after the point, which is always written.
pub(crate) fn length(mm: f64, units: Units, digits: usize, style: WordStyle) -> String {
    let value = match units {
        Units::Inch => mm / 25.4,
        Units::Millimetre => mm,
    };
    plain(value, digits, style)
}

/// A number with a point and without useless zeros.
pub(crate) fn plain(value: f64, digits: usize, style: WordStyle) -> String {
    let text = format!("{value:.digits$}");
    let text = if text.contains('.') { text.trim_end_matches('0').to_string() } else { text + "." };
    with_zero_style(&text, style.leading_zero)
}

/// A number without a sign if it is zero, and without the zero before its point unless the program writes that zero.
pub(crate) fn with_zero_style(text: &str, leading_zero: bool) -> String {
    let size = text.trim_start_matches('-');
    let is_zero = size.bytes().all(|byte| matches!(byte, b'0' | b'.'));
    let sign = if is_zero { "" } else { &text[..text.len() - size.len()] };
    match size.strip_prefix("0.").filter(|part| !leading_zero && !part.is_empty()) {
        Some(part) => format!("{sign}.{part}"),
        None => format!("{sign}{size}"),
    }
}

/// A feed to six figures: those of helices are computed.
pub(crate) fn feed(value: f64, style: WordStyle) -> String {
    let digits = (5.0 - value.abs().max(1e-3).log10().floor()).clamp(1.0, 7.0) as usize;
    plain(value, digits, style)
}

/// Digits that a control keeps of a length.
pub(crate) fn digits(control: &Control, units: Units) -> usize {
    let digits = match units {
        Units::Inch => control.parameters.rules.increment_digits_inch,
        Units::Millimetre => control.parameters.rules.increment_digits_mm,
    };
    usize::from(digits_of_arcs(control, units, digits))
}

/// How many digits after its end a number without a point has.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum DigitRule {
    Length,
    Angle,
    Feed,
}

fn hidden_digits(kind: DigitRule, control: &Control, units: Units) -> u8 {
    let parameters = &control.parameters;
    let whole = parameters.decimal_point == DecimalPoint::Calculator;
    match (kind, units) {
        (DigitRule::Feed, Units::Inch) => parameters.feed_digits_inch,
        (DigitRule::Feed, Units::Millimetre) => 0,
        _ if whole => 0,
        (DigitRule::Angle, _) => 3,
        (DigitRule::Length, Units::Inch) => parameters.rules.increment_digits_inch,
        (DigitRule::Length, Units::Millimetre) => parameters.rules.increment_digits_mm,
    }
}

/// The same number for another control; nothing where it may stay as it is.
pub(crate) fn carried_over(
    number: Decimal,
    kind: DigitRule,
    units: Units,
    controls: [&Control; 2],
) -> Option<String> {
    let [from, to] = controls.map(|control| hidden_digits(kind, control, units));
    if number.has_point || from == to || number.is_zero() {
        return None;
    }
    Some(with_point(number, from))
}

/// A number written with its point, `hidden` digits of it after the point.
fn with_point(number: Decimal, hidden: u8) -> String {
    let scale = usize::from(number.scale + hidden);
    let digits = format!("{:0>width$}", number.mantissa.unsigned_abs(), width = scale + 1);
    let (whole, part) = digits.split_at(digits.len() - scale);
    let part = part.trim_end_matches('0');
    let whole = if whole == "0" && !part.is_empty() { "" } else { whole };
    let sign = if number.mantissa < 0 { "-" } else { "" };
    format!("{sign}{whole}.{part}")
}

/// The word of a dwell of so many seconds.
pub(crate) fn dwell_word(seconds: f64, control: &Control) -> Option<String> {
    let by_p = control.dwell_words().find(|word| word.letter == b'P');
    Some(time_word(seconds, by_p.or_else(|| control.dwell_words().next())?))
}

/// A time as a word counts it: a whole number where it is one.
pub(crate) fn time_word(seconds: f64, word: DwellWord) -> String {
    let letter = char::from(word.letter);
    let units = seconds / word.integer_s;
    if (units - units.round()).abs() < 1e-6 && units < 1e9 {
        return format!("{letter}{:.0}", units.round());
    }
    let text = format!("{:.6}", seconds / word.point_s);
    format!("{letter}{}", text.trim_end_matches('0'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_put_where_they_are_hidden() {
        let read = |text: &str| Decimal::parse(text.as_bytes()).unwrap();
        assert_eq!(with_point(read("10"), 0), "10.");
        assert_eq!(with_point(read("10"), 3), ".01");
        assert_eq!(with_point(read("-12500"), 4), "-1.25");
        assert_eq!(with_point(read("5"), 4), ".0005");
    }

    #[test]
    fn values_are_written_as_programmers_do() {
        let style = WordStyle { spaced: true, leading_zero: false, two_digits: false };
        assert_eq!(length(12.7, Units::Inch, 4, style), ".5");
        assert_eq!(length(-25.4, Units::Inch, 4, style), "-1.");
        assert_eq!(length(-0.00001, Units::Millimetre, 3, style), "0.");
        assert_eq!(plain(0.5, 3, WordStyle { leading_zero: true, ..style }), "0.5");
    }
}

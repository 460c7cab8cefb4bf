//! Numbers written as the program writes its own.

use chordal::Control;
use chordal::control::{DecimalPoint, ExcessDecimals, Units};

use crate::blocks::blocks_of;
use crate::convert::numbers::with_zero_style;
use crate::source::digits_of_arcs;

/// More decimals than these are not written, whatever the program does.
const MAX_DECIMALS: u8 = 6;

/// How a program writes numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct NumberStyle {
    /// `0.5` and not `.5`.
    leading_zero: bool,
    /// The most decimals of a length.
    decimals: u8,
    /// Decimals that lengths are rounded to at least, in inch and in millimetres.
    usual: [u8; 2],
    /// Decimals that the control keeps, in inch and in millimetres.
    kept: [u8; 2],
    /// Blanks stand between words.
    pub(super) spaced: bool,
    /// Whole numbers end with a point.
    pub(super) with_point: bool,
}

impl NumberStyle {
    pub(super) fn of(text: &[u8], control: &Control) -> NumberStyle {
        let (mut zeros, mut bare, mut decimals, mut points, mut none) =
            (0u32, 0u32, 0u8, 0u32, 0u32);
        let (mut spaced, mut tight) = (0u32, 0u32);
        for block in blocks_of(text, control) {
            for pair in block.words.windows(2) {
                if pair[0].range.end < pair[1].range.start { spaced += 1 } else { tight += 1 }
            }
            for word in &block.words {
                let Some(number) = word.number().filter(|_| b"XYZIJKR".contains(&word.letter))
                else {
                    continue;
                };
                decimals = decimals.max(number.scale);
                if number.has_point {
                    points += 1
                } else if !number.is_zero() {
                    none += 1
                }
                let slice = word.range.slice(text);
                let Some(point) = slice.iter().position(|byte| *byte == b'.') else { continue };
                match slice[..point].last() {
                    Some(b'0') if point < 2 || !slice[point - 2].is_ascii_digit() => zeros += 1,
                    Some(byte) if byte.is_ascii_digit() => {}
                    _ => bare += 1,
                }
            }
        }
        NumberStyle {
            leading_zero: zeros >= bare,
            decimals,
            usual: [(Units::Inch, 4), (Units::Millimetre, 3)]
                .map(|(units, usual)| digits_of_arcs(control, units, usual)),
            kept: [Units::Inch, Units::Millimetre].map(|units| kept(control, units)),
            spaced: spaced >= tight,
            with_point: points >= none
                || control.parameters.decimal_point != DecimalPoint::Calculator,
        }
    }

    /// Decimals that a length in these units is rounded to where it does not come out even.
    pub(super) fn digits(&self, units: Units) -> u8 {
        let usual = self.usual[usize::from(units == Units::Millimetre)];
        self.decimals.clamp(usual, MAX_DECIMALS).min(self.kept(units))
    }

    /// More decimals than these the control does not take as they are written.
    pub(super) fn kept(&self, units: Units) -> u8 {
        self.kept[usize::from(units == Units::Millimetre)]
    }

    /// A number with `least` decimals and as many more as it needs; rounded to `digits` where it
    /// needs too many.
    pub(super) fn number(&self, value: f64, least: u8, digits: u8, point: bool) -> String {
        let even = (least..=digits.max(least)).find(|count| {
            let power = 10f64.powi(i32::from(*count));
            let scaled = value * power;
            (scaled - scaled.round()).abs() <= 1e-12 * power.max(scaled.abs())
        });
        let mut text = match even {
            Some(count) => format!("{value:.*}", usize::from(count)),
            None => {
                let text = format!("{value:.*}", usize::from(digits.max(least)));
                let keep = text.find('.').map_or(text.len(), |at| at + 1 + usize::from(least));
                let used = text.trim_end_matches('0').len().max(keep);
                text[..used.min(text.len())].to_string()
            }
        };
        if !text.contains('.') && point {
            text.push('.');
        }
        if !point {
            text = text.trim_end_matches('.').to_string();
        }
        with_zero_style(&text, self.leading_zero)
    }

    /// The separator between words.
    pub(super) fn gap(&self) -> &'static str {
        if self.spaced { " " } else { "" }
    }
}

/// Where what it does with more is not known, it is taken to compute with all of them.
fn kept(control: &Control, units: Units) -> u8 {
    match control.parameters.excess_decimals {
        ExcessDecimals::Unknown => MAX_DECIMALS,
        _ => control.parameters.kept_decimals(units),
    }
}

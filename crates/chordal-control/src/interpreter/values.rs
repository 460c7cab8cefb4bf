//! Words into numbers: units, decimal points, registers.

use chordal_diagnostics::{Applicability, Code, Diagnostic, Fix};
use chordal_syntax::{Block, Decimal, Value, Word};

use super::Interpreter;
use crate::command::number_text;
use crate::parameters::DecimalPoint;

/// Axis of a letter: 0–5 for X Y Z A B C, 255 for others.
pub(super) const AXIS_OF: [u8; 256] = {
    let mut table = [255; 256];
    let letters = b"XYZABC";
    let mut index = 0;
    while index < letters.len() {
        table[letters[index] as usize] = index as u8;
        index += 1;
    }
    table
};

/// Below this many least increments a number without a point is suspicious by itself.
const SUSPICIOUS_INCREMENTS: u64 = 100;

/// Below this many it is when the program writes points elsewhere.
const SUSPICIOUS_AMONG_POINTS: u64 = 10_000;

impl Interpreter<'_> {
    /// The literal of a word, or of the register it names.
    #[inline(always)]
    pub(super) fn literal(&self, word: &Word) -> Option<Decimal> {
        match word.value {
            Value::Number(number) => Some(number),
            Value::Register { index, negative } => {
                let mut value = self.state.registers[index as usize];
                if negative {
                    value.mantissa = -value.mantissa;
                    value.negative = !value.negative;
                }
                Some(value)
            }
            Value::Expression(_) | Value::Missing => None,
        }
    }

    /// True for a word of the value zero.
    pub(super) fn is_zero(&self, word: &Word) -> bool {
        self.literal(word).is_some_and(|number| number.mantissa == 0)
    }

    /// A length word in mm.
    #[inline(always)]
    pub(super) fn length(&mut self, word: &Word) -> Option<f64> {
        let number = self.literal(word)?;
        if !number.has_point {
            self.check_point(word, number);
        } else {
            self.told.points_seen = true;
        }
        Some(self.state.scale.length(number))
    }

    /// A word of an axis: mm, or rad for rotary axes.
    #[inline(always)]
    pub(super) fn axis_value(&mut self, word: &Word, axis: usize) -> Option<f64> {
        if axis < 3 {
            return self.length(word);
        }
        Some(self.state.scale.angle(self.literal(word)?))
    }

    /// Numbers without a point are told where they are likely a slip.
    #[inline]
    fn check_point(&mut self, word: &Word, number: Decimal) {
        let size = number.mantissa.unsigned_abs();
        if size == 0 || self.control.parameters.decimal_point == DecimalPoint::Calculator {
            return;
        }
        let limit =
            if self.told.points_seen { SUSPICIOUS_AMONG_POINTS } else { SUSPICIOUS_INCREMENTS };
        if size < limit {
            self.report_missing_point(word, number);
        }
    }

    #[cold]
    fn report_missing_point(&mut self, word: &Word, number: Decimal) {
        let letter = word.letter as char;
        let meant = self.length_text(self.state.scale.length(number));
        let span = self.span(word.range);
        let with_point = format!("{letter}{number}.");
        self.report(
            Diagnostic::new(
                Code::MissingDecimalPoint,
                span,
                format!("`{letter}{number}` without a decimal point is {meant} on this control"),
            )
            .label("no decimal point")
            .help(format!("write `{with_point}` if whole units are meant"))
            .fix(Fix {
                title: format!("write `{with_point}`"),
                span,
                replacement: with_point,
                applicability: Applicability::Unsafe,
            }),
        );
    }

    /// A whole number not below zero; anything else is told.
    pub(super) fn count(&mut self, word: &Word) -> Option<u32> {
        let number = self.literal(word)?;
        let whole = number.to_integer().and_then(|n| u32::try_from(n).ok());
        if whole.is_none() {
            let letter = word.letter as char;
            self.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("`{letter}` takes a whole number, not {number}"),
                )
                .help(format!("write `{letter}` with a whole number that is not negative")),
            );
        }
        whole
    }

    /// The count of a letter of the block, if it is there.
    pub(super) fn count_of(&mut self, block: &Block, letter: u8) -> Option<u32> {
        let word = *block.last(letter)?;
        self.count(&word)
    }

    /// The length of a letter of the block, if it is there.
    pub(super) fn length_of(&mut self, block: &Block, letter: u8) -> Option<f64> {
        let word = *block.last(letter)?;
        self.length(&word)
    }

    /// A length for people, in the program's units.
    pub(super) fn length_text(&self, mm: f64) -> String {
        match self.state.units {
            crate::command::Units::Inch => format!("{} in", trim(mm / 25.4, 4)),
            crate::command::Units::Millimetre => format!("{} mm", trim(mm, 3)),
        }
    }
}

/// A number with at least some digits that matter: more decimals when it is small.
pub(super) fn trim(value: f64, decimals: usize) -> String {
    let mut decimals = decimals;
    while decimals < 9 && value != 0.0 && value.abs() < 10f64.powi(1 - decimals as i32) {
        decimals += 1;
    }
    number_text(value, decimals)
}

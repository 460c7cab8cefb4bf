//! Words with other values, in the style of the text that they stand in.

use std::cell::Cell;

use chordal::control::{Action, Units};
use chordal::syntax::{Block, BlockKind, Decimal, Word, WordValue};
use chordal::{Control, Job};

use super::edit::{TransformRefusal, with_number};
use super::number::NumberStyle;
use crate::blocks::blocks_of;
use crate::source::first_text;
use crate::word_address::BlockControl;

/// Writes words of one text.
pub(super) struct WordWriter<'a> {
    pub(super) text: &'a [u8],
    pub(super) control: &'a Control,
    pub(super) style: NumberStyle,
    /// The largest length by which a value was rounded, mm.
    rounded_mm: Cell<f64>,
}

impl<'a> WordWriter<'a> {
    pub(super) fn new(job: &'a Job<'_>) -> WordWriter<'a> {
        let (text, control) = (first_text(job), job.control());
        WordWriter {
            text,
            control,
            style: NumberStyle::of(text, control),
            rounded_mm: Cell::new(0.0),
        }
    }

    /// The blocks of words in order.
    pub(super) fn word_blocks(&self) -> impl Iterator<Item = Block> + use<'a> {
        blocks_of(self.text, self.control).filter(|block| block.kind == BlockKind::Words)
    }

    /// How far paths may be apart for the digits that are written, mm: an arc has its end, its centre
    /// and its start, each rounded along two axes.
    pub(super) fn tolerance_mm(&self) -> f64 {
        // The levels of a roughing cycle add up what its depth was rounded by.
        let ends = if self.control.table.turns() { 24.0 } else { 6.0 };
        ends * self.rounded_mm.get()
    }

    /// The length of a literal, mm.
    pub(super) fn length_mm(&self, units: Units, number: Decimal) -> f64 {
        let kept =
            if number.has_point { self.control.parameters.kept(number, units) } else { number };
        kept.to_f64() * self.control.length_unit_mm(units, number.has_point)
    }

    /// A length as a number of a word that had another one.
    pub(super) fn length(&self, mm: f64, units: Units, old: Option<Decimal>, more: u8) -> String {
        let kept = self.style.kept(units);
        let digits = self.style.digits(units).max(more).min(kept);
        if let Some(old) = old.filter(|old| !old.has_point) {
            let whole = mm / self.control.length_unit_mm(units, false);
            if (whole - whole.round()).abs() < 1e-9 * whole.abs().max(1.0) && old.scale == 0 {
                return format!("{}", whole.round() as i64);
            }
        }
        let unit = units.mm();
        // Who writes a zero at the end writes as many decimals everywhere.
        let padded = |old: &Decimal| old.has_point && old.mantissa % 10 == 0;
        let least = old.filter(padded).map_or(0, |old| old.scale.min(kept));
        let point = self.style.with_point || old.is_some_and(|old| old.has_point);
        let number = self.style.number(mm / unit, least, digits, point);
        let written: f64 = number.parse().unwrap_or(f64::NAN);
        let off = (written * unit - mm).abs();
        if off > 1e-10 * mm.abs().max(1.0) {
            let half = 0.5 * unit * 0.1f64.powi(i32::from(digits.max(least)));
            self.rounded_mm.set(self.rounded_mm.get().max(half.max(off)));
        }
        number
    }

    /// A word of length whose value becomes `factor` times its own plus `plus` mm.
    pub(super) fn scaled_length(
        &self,
        block: &Block,
        word: &Word,
        units: (Units, Units),
        factor: f64,
        plus: f64,
    ) -> Result<String, TransformRefusal> {
        match word.value {
            WordValue::Number(number) => {
                let mm = self.length_mm(units.0, number) * factor + plus;
                let more = if plus == 0.0 { 0 } else { decimals(plus / units.1.mm()) };
                Ok(with_number(self.text, word, &self.length(mm, units.1, Some(number), more)))
            }
            WordValue::Expression(range) => {
                let factor = factor * units.0.mm() / units.1.mm();
                let plus = plus / units.1.mm();
                let old = String::from_utf8_lossy(range.slice(self.text)).trim().to_string();
                let head = String::from_utf8_lossy(
                    chordal::diagnostics::TextRange::new(word.range.start, range.start)
                        .slice(self.text),
                );
                Ok(format!("{head}{}", self.expression(&old, factor, plus)))
            }
            WordValue::Register { .. } | WordValue::Missing => Err(TransformRefusal::new(
                self.text,
                block,
                format!("the value of `{}` is not written in the block", self.word(word)),
                "write its value as a number",
            )),
        }
    }

    /// A length that counts least increments, `factor` times as long: a whole number of those of the second unit.
    pub(super) fn counted(
        &self,
        block: &Block,
        word: &Word,
        units: (Units, Units),
        factor: f64,
    ) -> Result<String, TransformRefusal> {
        let rules = &self.control.parameters.rules;
        let Some(number) = word.number() else {
            return Err(TransformRefusal::new(
                self.text,
                block,
                format!("`{}` is computed, and counts least increments", self.word(word)),
                "write its value as a number",
            ));
        };
        let least = rules.least_increment(units.1);
        let mm = number.to_f64() * rules.least_increment(units.0) * factor;
        let count = (mm / least).round();
        let off = (count * least - mm).abs();
        if off > 1e-10 {
            self.rounded_mm.set(self.rounded_mm.get().max(off));
        }
        Ok(with_number(self.text, word, &format!("{count:.0}")))
    }

    fn expression(&self, old: &str, factor: f64, plus: f64) -> String {
        let number = |value: f64| self.style.number(value, 0, 6, true);
        let one = if old.starts_with('-') { format!("[{old}]") } else { old.to_string() };
        let sum = |product: String| match plus {
            0.0 => format!("[{product}]"),
            plus if plus < 0.0 => format!("[{product}-{}]", number(-plus)),
            plus => format!("[{product}+{}]", number(plus)),
        };
        if factor == 1.0 {
            sum(one)
        } else if factor == -1.0 {
            format!("[{}-{one}]", number(plus))
        } else {
            sum(format!(
                "{one}*{}",
                if factor < 0.0 { format!("[{}]", number(factor)) } else { number(factor) }
            ))
        }
    }

    /// The G code that does something, as the control's own table names it.
    pub(super) fn g_code(&self, action: Action) -> Option<String> {
        self.control.g_codes().find(|row| row.action == action).map(|row| row.name(b'G'))
    }

    /// A word as it is written.
    pub(super) fn word(&self, word: &Word) -> String {
        String::from_utf8_lossy(word.range.slice(self.text)).into_owned()
    }

    /// A code word with another number, its zeros kept: `G02` becomes `G03`.
    pub(super) fn code(&self, word: &Word, tenths: u16) -> String {
        let old = self.word(word);
        let number = old.trim_start_matches(|letter: char| !letter.is_ascii_digit());
        let wide = number.split('.').next().unwrap_or("").len();
        let whole = format!("{:0wide$}", tenths / 10);
        let new =
            if tenths.is_multiple_of(10) { whole } else { format!("{whole}.{}", tenths % 10) };
        with_number(self.text, word, &new)
    }
}

/// How many decimals a number needs, six at most.
fn decimals(value: f64) -> u8 {
    (0..6u8)
        .find(|count| {
            let scaled = value * 10f64.powi(i32::from(*count));
            (scaled - scaled.round()).abs() < 1e-9
        })
        .unwrap_or(6)
}

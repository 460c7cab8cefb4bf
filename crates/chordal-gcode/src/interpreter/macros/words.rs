//! Replaces expressions after address letters by numbers.

use chordal_command::Units;
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_syntax::{Block, Decimal, Letters, Word, WordValue as Written};

use super::super::Interpreter;
use crate::macros::evaluate::{EvaluationError, ValuePurpose};
use crate::macros::functions::round;
use crate::macros::value::{MacroValue, UnknownCause};

/// Addresses that take whole numbers.
const WHOLE: Letters = Letters::of("NOLMSTHD");

/// Those of them where decimals are probably a mistake.
const REPORTED_WHEN_ROUNDED: Letters = Letters::of("LMTHD");

/// Largest value after an address, in units of its last digit: a double is exact up to 9e15.
const MAX_ADDRESS_VALUE: f64 = 1e15;

impl Interpreter<'_> {
    /// True when a word of the block uses a register with an unknown value.
    pub(in super::super) fn has_unset_register(&self, block: &Block) -> bool {
        let is_unset = |word: &Word| match word.value {
            Written::Register { index, .. } => self.registers[index as usize].is_none(),
            _ => false,
        };
        self.control.table.lexicon.registers && block.words.iter().any(is_unset)
    }

    /// Replaces the expressions of a block by their values. A word with a vacant value is removed with its address. The
    /// words of a macro call stay, since its arguments are not rounded. True when words with unknown values other than F
    /// were removed.
    pub(in super::super) fn resolve_words(&mut self, block: &mut Block) -> bool {
        block.expressions = false;
        let units = self.units_of(block);
        let call = self.is_macro_call(block);
        let mut words = std::mem::take(&mut self.macros.words);
        let mut unknown: Vec<(Word, UnknownCause)> = Vec::new();
        words.clear();
        words.extend_from_slice(&block.words);
        words.extend_from_slice(&block.polar);
        block.truncate(0);
        for (at, word) in words.iter().enumerate() {
            let Written::Expression(range) = word.value else {
                match self.unset_register(word, &words[..at]) {
                    Some(cause) => {
                        self.note_unknown(MacroValue::Unknown(cause), word.range);
                        unknown.push((*word, cause));
                    }
                    None => block.push_any(*word),
                }
                continue;
            };
            if call && !matches!(word.letter, b'G' | b'P' | b'L') {
                block.expressions = true;
                block.push(*word);
                continue;
            }
            let digits = self.digits_of(word.letter, units);
            let round_digits = self.rules().round_words.then_some(digits);
            let purpose = ValuePurpose { round_digits, condition: false };
            let value = match self.word_value(range, purpose) {
                Some(MacroValue::Vacant) => continue,
                Some(MacroValue::Unknown(cause)) => {
                    unknown.push((*word, cause));
                    continue;
                }
                Some(MacroValue::Number(value)) => self.decimal_of(word, value, digits),
                None => None,
            };
            let value = value.map_or(Written::Missing, Written::Number);
            block.push_any(Word { value, ..*word });
        }
        self.macros.words = words;
        if !unknown.is_empty() {
            self.take_unknown_words(block, &unknown);
        }
        unknown.iter().any(|(word, _)| word.letter != b'F')
    }

    /// The units of the words of the block.
    fn units_of(&self, block: &Block) -> Units {
        let own = block.all(b'G').filter_map(|word| {
            let code = chordal_dialect::code_number(word.number()?)?;
            self.control.g_code(code)?.action.units()
        });
        own.last().unwrap_or(self.kernel.state.units)
    }

    /// The value of the expression in a range of the text; `None` when it has none, which is reported.
    pub(super) fn word_value(
        &mut self,
        range: TextRange,
        purpose: ValuePurpose,
    ) -> Option<MacroValue> {
        let mut parser = self.take_parser();
        parser.start(self.reader.text(), self.file, range);
        let expression = parser.expression();
        let value = if parser.problems.is_empty() {
            self.value_of(&parser, expression, purpose)
        } else {
            self.report_problems(&mut parser);
            None
        };
        self.macros.parser = parser;
        value
    }

    /// Number of decimals of an address.
    fn digits_of(&self, letter: u8, units: Units) -> u8 {
        let parameters = &self.control.parameters;
        match letter {
            b'G' => 1,
            b'@' | b'^' => 9,
            letter if WHOLE.has(letter) => 0,
            b'E' if self.control.table.work_names.by_e => 0,
            b'A' | b'B' | b'C' | b'P' => 3,
            _ => match units {
                Units::Inch => parameters.rules.increment_digits_inch,
                Units::Millimetre => parameters.rules.increment_digits_mm,
            },
        }
    }

    /// A value as if it were written after its address; `None` when it is too large, which is reported.
    fn decimal_of(&mut self, word: &Word, value: f64, digits: u8) -> Option<Decimal> {
        let whole = round(value);
        let is_whole = (value - whole).abs() < 1e-4 && whole.abs() < MAX_ADDRESS_VALUE;
        let letter = word.letter;
        let counts = digits == 0 || letter == b'P';
        if counts && (is_whole || digits == 0 && self.rules().round_words) {
            if !is_whole {
                self.check_rounded(word, value, whole);
            }
            if whole.abs() < MAX_ADDRESS_VALUE {
                return Some(Decimal::integer(whole as i64));
            }
        }
        let digits = if self.rules().round_words { digits } else { exact_digits(value) };
        let scaled = value * 10f64.powi(i32::from(digits));
        let scaled = round(scaled);
        if scaled.abs() > MAX_ADDRESS_VALUE {
            self.report_fault(EvaluationError::new(
                Code::NumberOverflow,
                word.range,
                format!("{value} is too large for `{}`", letter as char),
                "check the values that it is computed from",
            ));
            return None;
        }
        Some(shortest(scaled as i64, digits))
    }

    fn check_rounded(&mut self, word: &Word, value: f64, whole: f64) {
        if !REPORTED_WHEN_ROUNDED.has(word.letter) {
            return;
        }
        let letter = word.letter as char;
        let diagnostic = Diagnostic::new(
            Code::WordRounded,
            self.span(word.range),
            format!("`{letter}` needs a whole number, and this is {value}"),
        )
        .label(format!("taken as {letter}{whole}"))
        .help("write ROUND or FIX if that is meant");
        self.report_once(diagnostic);
    }
}

/// As many decimals as a double can represent exactly.
fn exact_digits(value: f64) -> u8 {
    let mut digits = 12;
    while digits > 0 && value.abs() * 10f64.powi(i32::from(digits)) > MAX_ADDRESS_VALUE {
        digits -= 1;
    }
    digits
}

/// A value with all its decimals; `None` when it is too large.
pub(super) fn decimal(value: f64) -> Option<Decimal> {
    let digits = exact_digits(value);
    let scaled = round(value * 10f64.powi(i32::from(digits)));
    (scaled.abs() <= MAX_ADDRESS_VALUE).then(|| shortest(scaled as i64, digits))
}

/// The number without trailing zeros.
fn shortest(mut mantissa: i64, mut scale: u8) -> Decimal {
    while scale > 0 && mantissa % 10 == 0 {
        mantissa /= 10;
        scale -= 1;
    }
    Decimal { mantissa, scale, has_point: true, negative: mantissa < 0 }
}

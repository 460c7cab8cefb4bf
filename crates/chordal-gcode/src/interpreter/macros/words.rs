//! Numbers in the place of expressions behind address letters.

use chordal_command::Units;
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_syntax::{Block, Decimal, Letters, Word, WordValue as Written};

use super::super::Interpreter;
use crate::macros::evaluate::{EvaluationError, ValuePurpose};
use crate::macros::functions::round;
use crate::macros::value::{MacroValue, UnknownCause};

/// Addresses that take whole numbers.
const WHOLE: Letters = Letters::of("NOLMSTHD");

/// Those of them where decimals are likely a slip.
const REPORTED_WHEN_ROUNDED: Letters = Letters::of("LMTHD");

/// Largest value behind an address, in units of its last digit.
const MAX_ADDRESS_VALUE: f64 = 1e15;

impl Interpreter<'_> {
    /// Whether a block has a word with a register that holds what nobody knows.
    pub(in super::super) fn has_unset_register(&self, block: &Block) -> bool {
        let is_unset = |word: &Word| match word.value {
            Written::Register { index, .. } => self.registers[index as usize].is_none(),
            _ => false,
        };
        self.control.table.lexicon.registers && block.words.iter().any(is_unset)
    }

    /// Puts the values of a block's expressions in their places. A word whose value is null is
    /// dropped, address and all. The words of a macro call stay: its arguments are not rounded.
    /// True when words of unknown values were left out that are more than a feed.
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

    /// Units that hold for the block's own words.
    fn units_of(&self, block: &Block) -> Units {
        let own = block.all(b'G').filter_map(|word| {
            let code = chordal_dialect::code_number(word.number()?)?;
            self.control.g_code(code)?.action.units()
        });
        own.last().unwrap_or(self.kernel.state.units)
    }

    /// The value of the expression at a place of the text.
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

    /// Decimals of an address.
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

    /// A value as if it had been written behind its address.
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

/// As many decimals as a double holds.
fn exact_digits(value: f64) -> u8 {
    let mut digits = 12;
    while digits > 0 && value.abs() * 10f64.powi(i32::from(digits)) > MAX_ADDRESS_VALUE {
        digits -= 1;
    }
    digits
}

/// A value with all its decimals; `None` where it is too large.
pub(super) fn decimal(value: f64) -> Option<Decimal> {
    let digits = exact_digits(value);
    let scaled = round(value * 10f64.powi(i32::from(digits)));
    (scaled.abs() <= MAX_ADDRESS_VALUE).then(|| shortest(scaled as i64, digits))
}

/// The number without zeros at its end.
fn shortest(mut mantissa: i64, mut scale: u8) -> Decimal {
    while scale > 0 && mantissa % 10 == 0 {
        mantissa /= 10;
        scale -= 1;
    }
    Decimal { mantissa, scale, has_point: true, negative: mantissa < 0 }
}

//! Converts words to numbers: units, decimal points, registers.

use chordal_diagnostics::{Applicability, Code, Diagnostic, Fix};
use chordal_dialect::{DecimalPoint, ExcessDecimals};
use chordal_machine::AXIS_LETTERS;
use chordal_syntax::{Block, Decimal, Letters, Word, WordValue};

use super::Interpreter;

/// Axis index of a letter: 0–5 for X Y Z A B C, 255 for others.
pub(super) const AXIS_OF: [u8; 256] = {
    let mut table = [255; 256];
    let letters = AXIS_LETTERS.as_bytes();
    let mut index = 0;
    while index < letters.len() {
        table[letters[index] as usize] = index as u8;
        index += 1;
    }
    table
};

/// A number without a point below this many least increments is always suspicious.
const SUSPICIOUS_INCREMENTS: u64 = 100;

/// Length of a letter and four digits: every control accepts numbers of blocks and programs up to this length.
const MIN_LONG_NUMBER: u32 = 5;

/// The letters of numbers that name blocks and programs.
const NUMBERS: Letters = Letters::of("NO");

/// No control refuses a whole number below this for its number of digits.
const LARGEST_OF_FEW_DIGITS: u64 = 10_000_000;

/// A number without a point below this many least increments is suspicious if the program writes points elsewhere.
const SUSPICIOUS_AMONG_POINTS: u64 = 10_000;

/// A length of a cycle below this many is suspicious: `G71 U2` for a pass of 2 mm.
const SUSPICIOUS_IN_CYCLE: u64 = 10;

impl Interpreter<'_> {
    /// The literal of a word, or of the register it names.
    #[inline(always)]
    pub(super) fn literal(&self, word: &Word) -> Option<Decimal> {
        match word.value {
            WordValue::Number(number) => Some(number),
            WordValue::Register { index, negative } => {
                let mut value = self.registers[index as usize]?;
                if negative {
                    value.mantissa = -value.mantissa;
                    value.negative = !value.negative;
                }
                Some(value)
            }
            WordValue::Expression(_) | WordValue::Missing => None,
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
            self.reported.points_seen = true;
            if number.scale > self.scale.decimals {
                return Some(self.length_beyond_increment(word, number));
            }
            // A control that uses every decimal has no limit of digits.
            if number.mantissa.unsigned_abs() >= LARGEST_OF_FEW_DIGITS
                && self.control.parameters.excess_decimals != ExcessDecimals::Exact
            {
                self.check_whole_digits(word, number);
            }
        }
        Some(self.scale.length(number))
    }

    /// A length with more decimals than the least increment, mm; reports it if they matter.
    #[cold]
    fn length_beyond_increment(&mut self, word: &Word, number: Decimal) -> f64 {
        let control = self.control;
        let parameters = &control.parameters;
        if parameters.most_digits > 0 && number.digits() > parameters.most_digits {
            self.report_too_many_digits(word, parameters.most_digits);
        }
        let as_written = parameters.excess_decimals == ExcessDecimals::Unknown;
        if as_written && self.reported.excess_decimals {
            return self.scale.length(number);
        }
        let kept = parameters.kept(number, self.kernel.state.units);
        // Trailing zeros do not count.
        let says_more = match as_written {
            true => number.at_decimals(self.scale.decimals).is_some(),
            false => kept != number,
        };
        if says_more && !self.reported.excess_decimals {
            self.reported.excess_decimals = true;
            self.report_excess_decimals(word, number, kept);
        }
        self.scale.length(kept)
    }

    /// Reports a whole number with more digits than the control accepts.
    #[cold]
    fn check_whole_digits(&mut self, word: &Word, number: Decimal) {
        let most = self.control.parameters.most_digits;
        if most > 0 && number.digits() > most {
            self.report_too_many_digits(word, most);
        }
    }

    fn report_excess_decimals(&mut self, word: &Word, number: Decimal, kept: Decimal) {
        let letter = word.letter as char;
        let increment = self.control.parameters.rules.least_increment(self.kernel.state.units);
        let increment = self.kernel.length_text(increment);
        let what = if kept == number {
            "it is not known whether this control rounds or cuts; computed as written".to_string()
        } else {
            format!("this control takes {letter}{kept}")
        };
        self.kernel.report(
            Diagnostic::new(
                Code::ExcessDecimals,
                self.span(word.range),
                format!(
                    "`{letter}{number}` has decimals below the least increment {increment}: {what}"
                ),
            )
            .label("the first one in this program")
            .help("write no more decimals than the control has; see the setting `excess_decimals`"),
        );
    }

    fn report_too_many_digits(&mut self, word: &Word, most: u8) {
        // Counted in the text, as a literal stores at most eighteen digits.
        let written = word.range.slice(self.reader.text());
        let digits = written.iter().filter(|byte| byte.is_ascii_digit()).count();
        self.kernel.report(
            Diagnostic::new(
                Code::TooManyDigits,
                self.span(word.range),
                format!("a number with {digits} digits; this control accepts {most}"),
            )
            .label(format!("at most {most} digits"))
            .help("write fewer decimals"),
        );
    }

    /// A length of a drilling, turning or threading cycle, mm. Manuals give such words in least increments, so a missing
    /// point is no mistake unless the value is very small.
    pub(super) fn length_in_cycle(&mut self, word: &Word) -> Option<f64> {
        let number = self.literal(word)?;
        if number.has_point || number.mantissa.unsigned_abs() < SUSPICIOUS_IN_CYCLE {
            return self.length(word);
        }
        Some(self.scale.length(number))
    }

    /// The same by its letter; `None` without the word.
    pub(super) fn cycle_length(&mut self, block: &Block, letter: u8) -> Option<f64> {
        let word = *block.last(letter)?;
        self.length_in_cycle(&word)
    }

    /// The value of an axis word, mm, or rad for rotary axes; a diameter becomes a radius.
    #[inline(always)]
    pub(super) fn axis_value(&mut self, word: &Word, axis: usize) -> Option<f64> {
        if axis < 3 {
            return Some(self.length(word)? * self.per_word[axis]);
        }
        Some(self.scale.angle(self.literal(word)?))
    }

    /// Reports a number without a point that is probably a mistake.
    #[inline]
    fn check_point(&mut self, word: &Word, number: Decimal) {
        let size = number.mantissa.unsigned_abs();
        if size >= LARGEST_OF_FEW_DIGITS {
            self.check_whole_digits(word, number);
        }
        if size == 0 || self.control.parameters.decimal_point == DecimalPoint::Calculator {
            return;
        }
        let limit =
            if self.reported.points_seen { SUSPICIOUS_AMONG_POINTS } else { SUSPICIOUS_INCREMENTS };
        if size < limit {
            self.report_length_without_point(word, number);
        }
    }

    #[cold]
    fn report_length_without_point(&mut self, word: &Word, number: Decimal) {
        let meant = self.kernel.length_text(self.scale.length(number));
        self.report_missing_point(word, number, &meant);
    }

    /// The value of an angle word, such as that of polar coordinates, degrees.
    pub(super) fn word_degrees(&mut self, word: &Word) -> Option<f64> {
        let number = self.literal(word)?;
        let degrees = self.scale.degrees(number);
        // Probably meant as whole degrees, but the control counts in thousandths.
        if !number.has_point && self.reported.points_seen && degrees != number.to_f64() {
            let size = number.mantissa.unsigned_abs();
            if size > 0 && size < SUSPICIOUS_AMONG_POINTS {
                self.report_missing_point(word, number, &format!("{degrees}°"));
            }
        }
        Some(degrees)
    }

    #[cold]
    fn report_missing_point(&mut self, word: &Word, number: Decimal, meant: &str) {
        let letter = word.letter as char;
        let span = self.span(word.range);
        let with_point = format!("{letter}{number}.");
        self.kernel.report(
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

    /// A whole number that is not negative; any other value is reported.
    pub(super) fn count(&mut self, word: &Word) -> Option<u32> {
        let number = self.literal(word)?;
        let whole = number.to_integer().and_then(|n| u32::try_from(n).ok());
        if whole.is_none() {
            let letter = word.letter as char;
            self.kernel.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("`{letter}` needs a whole number, not {number}"),
                )
                .help(format!("write `{letter}` with a whole number that is not negative")),
            );
        }
        whole
    }

    /// The number of an offset or a tool; reports one above the largest. `None` without the word.
    pub(super) fn count_up_to(&mut self, block: &Block, letter: u8, largest: u32) -> Option<u32> {
        let word = *block.last(letter)?;
        let number = self.count(&word)?;
        if largest > 0 && number > largest {
            let (letter, title) = (letter as char, self.control.table.title);
            self.kernel.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("{title} has no {letter}{number}: the last one is {letter}{largest}"),
                )
                .help(format!("write {letter} with a number from 0 to {largest}")),
            );
        }
        Some(number)
    }

    /// Compares N and O, which come first in their block, with the largest number.
    #[inline]
    pub(super) fn check_numbers(&mut self, block: &Block) {
        if !block.letters().meets(NUMBERS) {
            return;
        }
        for index in 0..block.words.len().min(2) {
            let word = &block.words[index];
            let is_signed =
                || word.letter == b'N' && word.number().is_some_and(|number| number.negative);
            if self.control.parameters.strict_words && is_signed() {
                let span = self.span(word.range);
                self.report_refused(
                    Diagnostic::new(Code::BadNumber, span, "a line number below zero")
                        .help("write N and digits"),
                    "Bad format unsigned integer",
                );
            }
            let word = &block.words[index];
            if matches!(word.letter, b'N' | b'O') && word.range.len() > MIN_LONG_NUMBER {
                let word = *word;
                self.check_long_number(&word);
            }
        }
    }

    /// True for a word that names a program, `<SUB_A>`.
    pub(super) fn is_name(&self, word: &Word) -> bool {
        word.range.slice(self.reader.text()).starts_with(b"<")
    }

    #[cold]
    fn check_long_number(&mut self, word: &Word) {
        let largest = match word.letter {
            b'N' => self.control.parameters.largest_numbers.block,
            _ => self.control.parameters.largest_numbers.program,
        };
        let Some(number) = self.literal(word).filter(|_| largest > 0) else { return };
        if self.is_name(word) {
            return;
        }
        if number.to_f64() > f64::from(largest) {
            let letter = word.letter as char;
            self.kernel.report(
                Diagnostic::new(
                    Code::TooManyDigits,
                    self.span(word.range),
                    format!("{letter}{number} is above the largest number, {letter}{largest}"),
                )
                .help("write a number with fewer digits"),
            );
        }
    }

    /// The whole number of a letter of the block; `None` without the word.
    pub(super) fn count_of(&mut self, block: &Block, letter: u8) -> Option<u32> {
        let word = *block.last(letter)?;
        self.count(&word)
    }

    /// The value of an axis letter of the block, mm or rad; `None` without the word.
    pub(super) fn axis_value_of(&mut self, block: &Block, axis: usize) -> Option<f64> {
        let word = *block.last(AXIS_LETTERS.as_bytes()[axis])?;
        self.axis_value(&word, axis)
    }

    /// The length of a letter of the block, mm; `None` without the word.
    pub(super) fn length_of(&mut self, block: &Block, letter: u8) -> Option<f64> {
        let word = *block.last(letter)?;
        self.length(&word)
    }
}

pub(super) use chordal_command::telling_number as trim;

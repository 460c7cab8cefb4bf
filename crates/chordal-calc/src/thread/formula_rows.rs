//! Rows of a calculation that are filled in from their formulas.

use crate::calculation::{QuantityKind, WorkedCalculation};

/// Adds lengths to a calculation. Each stands with its formula, and with the formula in which the symbols that came
/// before it are numbers.
pub(super) struct FormulaRows<'w> {
    worked: &'w mut WorkedCalculation,
    /// The unit of the numbers, mm.
    unit_mm: f64,
    number: &'w dyn Fn(f64) -> String,
    symbols: Vec<(String, String)>,
}

impl<'w> FormulaRows<'w> {
    /// For numbers in a unit, written in this way, and the symbols that are known.
    pub fn new(
        worked: &'w mut WorkedCalculation,
        unit_mm: f64,
        number: &'w dyn Fn(f64) -> String,
        known: &[(&str, f64)],
    ) -> FormulaRows<'w> {
        let mut rows = FormulaRows { worked, unit_mm, number, symbols: Vec::new() };
        known.iter().for_each(|(symbol, value)| rows.know(symbol, *value));
        rows
    }

    /// Takes the number of a symbol from here on.
    pub fn know(&mut self, symbol: &str, value: f64) {
        self.symbols.insert(0, (symbol.into(), (self.number)(value)));
    }

    /// A number on the way.
    pub fn intermediate(&mut self, symbol: &str, meaning: &str, value: f64, formula: &str) {
        self.intermediate_of(symbol, meaning, value, [formula, formula]);
    }

    /// The same where another formula is filled in than the one that is shown.
    pub fn intermediate_of(&mut self, symbol: &str, meaning: &str, value: f64, of: [&str; 2]) {
        self.result_of(symbol, meaning, value, of);
        self.worked.steps.last_mut().into_iter().for_each(|step| step.result = false);
    }

    /// A requested number.
    pub fn result(&mut self, symbol: &str, meaning: &str, value: f64, formula: &str) {
        self.result_of(symbol, meaning, value, [formula, formula]);
    }

    /// The same where another formula is filled in than the one that is shown.
    pub fn result_of(&mut self, symbol: &str, meaning: &str, value: f64, of: [&str; 2]) {
        let (value_mm, filled) = (value * self.unit_mm, self.filled(of[1]));
        self.worked.result(symbol, meaning, QuantityKind::Length, value_mm, of[0], filled);
        self.know(symbol, value);
    }

    /// The limits of a class in one sentence: of a diameter and of the pitch diameter.
    pub fn note_limits(
        &mut self,
        class: &str,
        [diameter, source]: [&str; 2],
        limits: [f64; 2],
        pitch: [f64; 2],
    ) {
        let [first, last] = limits.map(self.number);
        let [pitch_first, pitch_last] = pitch.map(self.number);
        self.worked.note(format!(
            "{class}: {diameter} {first} to {last}, pitch {pitch_first} to {pitch_last} ({source})."
        ));
    }

    /// A formula with numbers for its symbols, without how it is rounded.
    fn filled(&self, formula: &str) -> String {
        let formula = formula.split(", to ").next().unwrap_or(formula);
        let (mut filled, mut word) = (String::new(), String::new());
        for c in formula.chars().chain([' ']) {
            let is_word = c.is_ascii_alphabetic() || c.is_ascii_digit() && !word.is_empty();
            if is_word {
                word.push(c);
                continue;
            }
            let known = self.symbols.iter().find(|(symbol, _)| *symbol == word);
            filled.push_str(known.map_or(&word, |(_, number)| number));
            filled.push(c);
            word.clear();
        }
        filled.pop();
        filled
    }
}

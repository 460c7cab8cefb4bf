//! A calculation as it would stand on paper.

use crate::figure::Figure;
use crate::numbers::{AnswerUnit, degrees, trimmed};

/// What a number measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuantityKind {
    /// A length, mm.
    Length,
    /// An angle, rad.
    Angle,
    /// A number of things, or a ratio.
    Number,
    /// Speed of a spindle, rpm.
    Spindle,
    /// Speed of a tool along its path, mm/s; shown in mm/min or in/min.
    Feed,
    /// Speed of a cutting edge, mm/s; shown in m/min or ft/min.
    Surface,
    /// Volume in a time, mm³/s; shown in cm³/min or in³/min.
    Removal,
}

impl QuantityKind {
    /// A value in the unit that is shown.
    pub fn shown(self, value: f64, units: AnswerUnit) -> f64 {
        let mm = units.mm();
        match self {
            QuantityKind::Length => value / mm,
            QuantityKind::Angle => value.to_degrees(),
            QuantityKind::Number | QuantityKind::Spindle => value,
            QuantityKind::Feed => value * 60.0 / mm,
            QuantityKind::Surface => match units {
                AnswerUnit::Inch => value * 60.0 / (12.0 * mm),
                AnswerUnit::Millimetre => value * 60.0 / 1000.0,
            },
            QuantityKind::Removal => match units {
                AnswerUnit::Inch => value * 60.0 / (mm * mm * mm),
                AnswerUnit::Millimetre => value * 60.0 / 1000.0,
            },
        }
    }

    /// The name of that unit; a number has none.
    pub const fn unit(self, units: AnswerUnit) -> Option<&'static str> {
        Some(match (self, units) {
            (QuantityKind::Length, _) => units.name(),
            (QuantityKind::Angle, _) => "deg",
            (QuantityKind::Number, _) => return None,
            (QuantityKind::Spindle, _) => "rpm",
            (QuantityKind::Feed, AnswerUnit::Inch) => "in/min",
            (QuantityKind::Feed, AnswerUnit::Millimetre) => "mm/min",
            (QuantityKind::Surface, AnswerUnit::Inch) => "ft/min",
            (QuantityKind::Surface, AnswerUnit::Millimetre) => "m/min",
            (QuantityKind::Removal, AnswerUnit::Inch) => "in\u{b3}/min",
            (QuantityKind::Removal, AnswerUnit::Millimetre) => "cm\u{b3}/min",
        })
    }
}

/// A number with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The letter of the formulas: `ΔX`.
    pub symbol: String,
    /// What it is.
    pub meaning: String,
    /// mm, rad, or as its kind says.
    pub value: f64,
    /// What it measures.
    pub kind: QuantityKind,
}

impl Quantity {
    /// The number with its unit.
    pub fn text(&self, units: AnswerUnit) -> String {
        match self.kind {
            QuantityKind::Length => units.length(self.value),
            QuantityKind::Angle => degrees(self.value),
            QuantityKind::Number => trimmed(self.value, 6),
            QuantityKind::Spindle
            | QuantityKind::Feed
            | QuantityKind::Surface
            | QuantityKind::Removal => {
                let number = trimmed(self.kind.shown(self.value, units), 3);
                format!("{number} {}", self.kind.unit(units).unwrap_or_default())
            }
        }
    }
}

/// One line of a calculation.
#[derive(Clone, Debug, PartialEq)]
pub struct CalculationStep {
    /// What comes out.
    pub quantity: Quantity,
    /// The formula: `CR·tan(θ/2)`.
    pub formula: String,
    /// The formula with the numbers: `0.25·tan(60°/2)`.
    pub filled: String,
    /// True when it was asked for, false on the way to it.
    pub result: bool,
}

/// A calculation with its figure.
#[derive(Clone, Debug, PartialEq)]
pub struct WorkedCalculation {
    /// What was calculated.
    pub title: String,
    /// The unit of its texts.
    pub units: AnswerUnit,
    /// What was given.
    pub inputs: Vec<Quantity>,
    /// The way and the results, in order.
    pub steps: Vec<CalculationStep>,
    /// What to know in addition to the numbers.
    pub notes: Vec<String>,
    /// The drawing.
    pub figure: Figure,
}

impl WorkedCalculation {
    pub(crate) fn new(title: impl Into<String>, units: AnswerUnit) -> WorkedCalculation {
        WorkedCalculation {
            title: title.into(),
            units,
            inputs: Vec::new(),
            steps: Vec::new(),
            notes: Vec::new(),
            figure: Figure::default(),
        }
    }

    /// The asked number of this symbol: mm, rad or plain.
    pub fn value(&self, symbol: &str) -> Option<f64> {
        self.step(symbol).map(|step| step.quantity.value)
    }

    /// The step that gives this symbol.
    pub fn step(&self, symbol: &str) -> Option<&CalculationStep> {
        self.steps.iter().find(|step| step.quantity.symbol == symbol)
    }

    pub(crate) fn input(&mut self, symbol: &str, meaning: &str, kind: QuantityKind, value: f64) {
        self.inputs.push(quantity(symbol, meaning, kind, value));
    }

    /// A number on the way.
    pub(crate) fn intermediate(
        &mut self,
        symbol: &str,
        meaning: &str,
        kind: QuantityKind,
        value: f64,
        formula: &str,
        filled: String,
    ) {
        let quantity = quantity(symbol, meaning, kind, value);
        self.steps.push(CalculationStep {
            quantity,
            formula: formula.into(),
            filled,
            result: false,
        });
    }

    /// A requested number.
    pub(crate) fn result(
        &mut self,
        symbol: &str,
        meaning: &str,
        kind: QuantityKind,
        value: f64,
        formula: &str,
        filled: String,
    ) {
        let quantity = quantity(symbol, meaning, kind, value);
        self.steps.push(CalculationStep {
            quantity,
            formula: formula.into(),
            filled,
            result: true,
        });
    }

    pub(crate) fn note(&mut self, text: impl Into<String>) {
        self.notes.push(text.into());
    }
}

fn quantity(symbol: &str, meaning: &str, kind: QuantityKind, value: f64) -> Quantity {
    // A zero has no sign on paper.
    Quantity { symbol: symbol.into(), meaning: meaning.into(), value: value + 0.0, kind }
}

//! Values of words: numbers and parameters.

use chordal_diagnostics::TextRange;

/// The parameters of a program, by how long they live.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum ParameterBank {
    /// Q.
    Shared,
    /// QL: of the program alone.
    Local,
    /// QR: kept when the control is switched off.
    Retained,
    /// QS: texts.
    Text,
}

/// The name of a parameter.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct ParameterName {
    /// Its bank.
    pub bank: ParameterBank,
    /// Its number.
    pub number: u32,
}

/// A value of a word: a number, or a parameter with a sign.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum WordOperand {
    /// A number.
    Number(f64),
    /// A parameter.
    Parameter {
        /// It is negated.
        is_negative: bool,
        /// The parameter.
        name: ParameterName,
    },
}

/// A word with a value.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct OperandWord {
    /// It is a distance from the last position (`I`).
    pub is_incremental: bool,
    /// Its value.
    pub value: WordOperand,
    /// Its text.
    pub range: TextRange,
}

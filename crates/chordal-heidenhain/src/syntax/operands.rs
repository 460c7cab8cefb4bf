//! Values of words: numbers and parameters.

use std::fmt;

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

impl ParameterBank {
    const ALL: [ParameterBank; 4] =
        [ParameterBank::Shared, ParameterBank::Local, ParameterBank::Retained, ParameterBank::Text];

    /// The letters of its parameters.
    pub const fn letters(self) -> &'static str {
        match self {
            ParameterBank::Shared => "Q",
            ParameterBank::Local => "QL",
            ParameterBank::Retained => "QR",
            ParameterBank::Text => "QS",
        }
    }

    /// The bank of these letters.
    pub fn of_letters(letters: &str) -> Option<ParameterBank> {
        ParameterBank::ALL.into_iter().find(|bank| bank.letters() == letters)
    }
}

/// The name of a parameter.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct ParameterName {
    /// Its bank.
    pub bank: ParameterBank,
    /// Its number.
    pub number: u32,
}

impl ParameterName {
    /// Whether the control itself sets it: tool, spindle, results of probing.
    pub fn is_of_control(&self) -> bool {
        self.bank == ParameterBank::Shared && (100..200).contains(&self.number)
    }
}

impl fmt::Display for ParameterName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.bank.letters(), self.number)
    }
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

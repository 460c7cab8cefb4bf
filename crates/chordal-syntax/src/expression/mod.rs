//! Expressions of macro languages: text → steps for a stack, with spans.
//!
//! An expression becomes a list of steps in the order in which a stack machine takes them
//! (`#1+2*3` is `1, read, 2, 3, ×, +`), so that carrying it out needs no recursion and no
//! memory of its own, however long the line is. Reading never fails: what cannot be read is a
//! problem with the steps.

mod grammar;
mod parse;

pub use grammar::{BracketStyle, MacroGrammar, OperatorRow, operator};
pub use parse::ExpressionParser;

use chordal_diagnostics::TextRange;

/// An operator between two values.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "the names say it")]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Modulo,
    And,
    Or,
    Xor,
    Equal,
    NotEqual,
    Greater,
    GreaterOrEqual,
    Less,
    LessOrEqual,
}

impl Operator {
    /// True for EQ, NE, GT, GE, LT and LE.
    pub const fn is_comparison(self) -> bool {
        matches!(
            self,
            Operator::Equal
                | Operator::NotEqual
                | Operator::Greater
                | Operator::GreaterOrEqual
                | Operator::Less
                | Operator::LessOrEqual
        )
    }
}

/// A function.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "the names say it")]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    /// Of one argument, or of two (`ATAN[y]/[x]`).
    Atan,
    Sqrt,
    Abs,
    /// BCD digits to a number.
    Bin,
    /// A number to BCD digits.
    Bcd,
    Round,
    /// Rounds to the places that a setting of the control gives (Fadal RND).
    RoundPlaces,
    Fix,
    Fup,
    Ln,
    Exp,
    /// ADP: adds a decimal point.
    AddPoint,
    Power,
    /// A parameter of the control: `PRM[no]`, `PRM[no]/[axis]`.
    Parameter,
    /// -1 or +1.
    Sign,
    Not,
    /// True when a named variable is set.
    Exists,
}

/// What a step does with the stack.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum StackOp {
    /// Pushes a literal.
    Number(f64),
    /// Pushes what could not be read: the value is not known.
    Unreadable,
    /// Takes a number and pushes the variable of that number.
    Read,
    /// Pushes the named variable (`#<name>`); the range is the name.
    ReadNamed(TextRange),
    /// Takes a number and pushes the letter variable of that place in the grammar's list.
    Letters(u8),
    /// Takes a value and pushes its negative.
    Negate,
    /// Takes two values.
    Binary(Operator),
    /// Takes one value, or two where `two` is set.
    Call {
        /// The function.
        function: Function,
        /// Two arguments.
        two: bool,
    },
}

/// One step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ExpressionStep {
    /// What it does.
    pub op: StackOp,
    /// The text that it comes from, operands included.
    pub range: TextRange,
}

/// An expression: some steps of an [`ExpressionParser`].
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Expression {
    pub(crate) first: u32,
    pub(crate) end: u32,
    /// Its text.
    pub range: TextRange,
}

impl Expression {
    /// True where nothing was there to read.
    pub fn is_empty(&self) -> bool {
        self.first == self.end
    }
}

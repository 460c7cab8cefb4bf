//! Expressions of macro languages: compiles text to steps for a stack machine, with spans.
//!
//! An expression becomes a list of steps in the order in which a stack machine executes them (`#1+2*3` is `1, read, 2,
//! 3, ×, +`), so that evaluating it needs no recursion and no additional memory, even for a long line. Reading never
//! fails: unreadable text gives a diagnostic and a step without a known value.

mod grammar;
mod parse;

pub use grammar::{BracketStyle, MacroGrammar, OperatorRow, operator};
pub use parse::ExpressionParser;

use chordal_diagnostics::TextRange;

/// A binary operator.
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
    /// The arc tangent of one argument, or of two (`ATAN[y]/[x]`).
    Atan,
    Sqrt,
    Abs,
    /// Converts BCD to binary.
    Bin,
    /// Converts binary to BCD.
    Bcd,
    Round,
    /// Rounds to the number of decimals in a setting of the control (Fadal RND).
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
    /// The sign, -1 or +1.
    Sign,
    Not,
    /// True if a named variable is defined.
    Exists,
}

/// The operation of a step on the stack.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum StackOp {
    /// Pushes a literal.
    Number(f64),
    /// Pushes an unknown value for text that could not be read.
    Unreadable,
    /// Pops a number and pushes the variable with that number.
    Read,
    /// Pushes the named variable (`#<name>`); the range is the name.
    ReadNamed(TextRange),
    /// Pops a number and pushes the letter variable with this index in the list of the grammar.
    Letters(u8),
    /// Pops a value and pushes its negative.
    Negate,
    /// Pops two values and pushes the result.
    Binary(Operator),
    /// Pops one value, or two if `two` is set, and pushes the result.
    Call {
        /// The function.
        function: Function,
        /// It has two arguments.
        two: bool,
    },
}

/// One step of an expression.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ExpressionStep {
    /// The operation.
    pub op: StackOp,
    /// The text that it comes from, including its operands.
    pub range: TextRange,
}

/// An expression: a range of the steps of an [`ExpressionParser`].
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Expression {
    pub(crate) first: u32,
    pub(crate) end: u32,
    /// Its text.
    pub range: TextRange,
}

impl Expression {
    /// True if there was no text to read.
    pub fn is_empty(&self) -> bool {
        self.first == self.end
    }
}

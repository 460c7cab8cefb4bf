//! How a control writes expressions: brackets, operators, functions.

use super::{Function, Operator};

/// The brackets of expressions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BracketStyle {
    /// `[ ]`; `( )` is a comment.
    Square,
    /// `( )`.
    Round,
}

/// An operator as a control writes it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OperatorRow {
    /// Upper case (`AND`, `+`, `<|>`). A longer one stands before one that begins it.
    pub text: &'static str,
    /// What it does.
    pub operator: Operator,
    /// A higher level binds tighter.
    pub level: u8,
}

/// How a control writes expressions and macro statements. Part of its [`Lexicon`].
///
/// [`Lexicon`]: crate::Lexicon
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MacroGrammar {
    /// The brackets.
    pub brackets: BracketStyle,
    /// The operators.
    pub operators: &'static [OperatorRow],
    /// The functions by name, upper case.
    pub functions: &'static [(&'static str, Function)],
    /// Functions may be cut to two letters (`RO`, `FI`, `FU`), WHILE and GOTO too.
    pub abbreviations: bool,
    /// `##1` is the variable whose number stands in #1.
    pub chained: bool,
    /// `#<name>`.
    pub names: bool,
    /// Operators stand inside brackets only (LinuxCNC).
    pub operators_in_brackets_only: bool,
    /// Variables written as letters and a number (Fadal `V1`, `FX(V10)`); a longer one stands
    /// before one that begins it. The place in the list is [`StackOp::Letters`](super::StackOp)'s number.
    pub letter_variables: &'static [&'static str],
    /// Deepest nesting of brackets, those of functions and conditions counted; more is an
    /// alarm. `None` where no limit is known.
    pub bracket_limit: Option<u8>,
}

/// Writes a row of a table of operators.
pub const fn operator(text: &'static str, operator: Operator, level: u8) -> OperatorRow {
    OperatorRow { text, operator, level }
}

/// AND binds like `*`, OR and XOR like `+`: `IF[#120AND4EQ4]` is `[#120 AND 4] EQ 4`, as a
/// probe maker's programs for Fanuc use it.
const MACRO_B_OPERATORS: &[OperatorRow] = &[
    operator("MOD", Operator::Modulo, 3),
    operator("AND", Operator::And, 3),
    operator("*", Operator::Multiply, 3),
    operator("/", Operator::Divide, 3),
    operator("XOR", Operator::Xor, 2),
    operator("OR", Operator::Or, 2),
    operator("+", Operator::Add, 2),
    operator("-", Operator::Subtract, 2),
    operator("EQ", Operator::Equal, 1),
    operator("NE", Operator::NotEqual, 1),
    operator("GE", Operator::GreaterOrEqual, 1),
    operator("GT", Operator::Greater, 1),
    operator("LE", Operator::LessOrEqual, 1),
    operator("LT", Operator::Less, 1),
];

const MACRO_B_FUNCTIONS: &[(&str, Function)] = &[
    ("SIN", Function::Sin),
    ("COS", Function::Cos),
    ("TAN", Function::Tan),
    ("ASIN", Function::Asin),
    ("ACOS", Function::Acos),
    ("ATAN", Function::Atan),
    ("ATN", Function::Atan),
    ("SQRT", Function::Sqrt),
    ("SQR", Function::Sqrt),
    ("ABS", Function::Abs),
    ("BIN", Function::Bin),
    ("BCD", Function::Bcd),
    ("ROUND", Function::Round),
    ("FIX", Function::Fix),
    ("FUP", Function::Fup),
    ("LN", Function::Ln),
    ("EXP", Function::Exp),
    ("ADP", Function::AddPoint),
    ("POW", Function::Power),
    ("PRM", Function::Parameter),
];

impl MacroGrammar {
    /// Custom macro B, from which the others differ.
    pub const MACRO_B: MacroGrammar = MacroGrammar {
        brackets: BracketStyle::Square,
        operators: MACRO_B_OPERATORS,
        functions: MACRO_B_FUNCTIONS,
        abbreviations: true,
        chained: false,
        names: false,
        operators_in_brackets_only: false,
        letter_variables: &[],
        bracket_limit: Some(5),
    };

    /// The opening and the closing bracket.
    pub const fn bracket_bytes(&self) -> (u8, u8) {
        match self.brackets {
            BracketStyle::Square => (b'[', b']'),
            BracketStyle::Round => (b'(', b')'),
        }
    }
}

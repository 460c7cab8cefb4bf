//! The grammar of expressions of a control: brackets, operators, functions.

use super::{Function, Operator};

/// The brackets of expressions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BracketStyle {
    /// `[ ]`; `( )` is a comment.
    Square,
    /// `( )`.
    Round,
}

/// An operator in the grammar of a control.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OperatorRow {
    /// Its text in upper case (`AND`, `+`, `<|>`). In a table, a longer text comes before one that is its beginning.
    pub text: &'static str,
    /// The operation.
    pub operator: Operator,
    /// Its precedence: a higher level binds more tightly.
    pub level: u8,
}

/// The grammar of expressions and macro statements of a control. Part of its [`Lexicon`].
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
    /// Functions may be abbreviated to two letters (`RO`, `FI`, `FU`), and so may WHILE and GOTO.
    pub abbreviations: bool,
    /// `##1` is the variable whose number is the value of #1.
    pub chained: bool,
    /// There are named variables (`#<name>`).
    pub names: bool,
    /// Operators are allowed only inside brackets (LinuxCNC).
    pub operators_in_brackets_only: bool,
    /// Variables written as letters and a number (Fadal `V1`, `FX(V10)`); longer letters come before those that are their
    /// beginning. The index in the list is the number of [`StackOp::Letters`](super::StackOp).
    pub letter_variables: &'static [&'static str],
    /// The deepest nesting of brackets, including those of functions and conditions; more is an alarm. `None` if no
    /// limit is known.
    pub bracket_limit: Option<u8>,
}

/// A row of a table of operators.
pub const fn operator(text: &'static str, operator: Operator, level: u8) -> OperatorRow {
    OperatorRow { text, operator, level }
}

/// AND has the precedence of `*`, OR and XOR that of `+`: `IF[#120AND4EQ4]` is `[#120 AND 4] EQ 4`, as in the Fanuc
/// programs of a probe manufacturer.
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
    /// Custom macro B, on which the other grammars are based.
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

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

const fn op(text: &'static str, operator: Operator, level: u8) -> OperatorRow {
    OperatorRow { text, operator, level }
}

/// AND binds like `*`, OR and XOR like `+`: `IF[#120AND4EQ4]` is `[#120 AND 4] EQ 4`, as a
/// probe maker's programs for Fanuc use it.
const MACRO_B_OPERATORS: &[OperatorRow] = &[
    op("MOD", Operator::Modulo, 3),
    op("AND", Operator::And, 3),
    op("*", Operator::Multiply, 3),
    op("/", Operator::Divide, 3),
    op("XOR", Operator::Xor, 2),
    op("OR", Operator::Or, 2),
    op("+", Operator::Add, 2),
    op("-", Operator::Subtract, 2),
    op("EQ", Operator::Equal, 1),
    op("NE", Operator::NotEqual, 1),
    op("GE", Operator::GreaterOrEqual, 1),
    op("GT", Operator::Greater, 1),
    op("LE", Operator::LessOrEqual, 1),
    op("LT", Operator::Less, 1),
];

/// LinuxCNC "Overview", binary operators.
const LINUXCNC_OPERATORS: &[OperatorRow] = &[
    op("**", Operator::Power, 5),
    op("*", Operator::Multiply, 4),
    op("/", Operator::Divide, 4),
    op("MOD", Operator::Modulo, 4),
    op("+", Operator::Add, 3),
    op("-", Operator::Subtract, 3),
    op("EQ", Operator::Equal, 2),
    op("NE", Operator::NotEqual, 2),
    op("GE", Operator::GreaterOrEqual, 2),
    op("GT", Operator::Greater, 2),
    op("LE", Operator::LessOrEqual, 2),
    op("LT", Operator::Less, 2),
    op("AND", Operator::And, 1),
    op("XOR", Operator::Xor, 1),
    op("OR", Operator::Or, 1),
];

/// The RS274/NGC interpreter of before LinuxCNC: AND, OR and XOR bind like `+`.
const RS274_OPERATORS: &[OperatorRow] = &[
    op("**", Operator::Power, 3),
    op("*", Operator::Multiply, 2),
    op("/", Operator::Divide, 2),
    op("MOD", Operator::Modulo, 2),
    op("+", Operator::Add, 1),
    op("-", Operator::Subtract, 1),
    op("AND", Operator::And, 1),
    op("XOR", Operator::Xor, 1),
    op("OR", Operator::Or, 1),
];

/// Fadal manual 2003, section 18.
const FADAL_OPERATORS: &[OperatorRow] = &[
    op("*", Operator::Multiply, 4),
    op("/", Operator::Divide, 4),
    op("+", Operator::Add, 3),
    op("-", Operator::Subtract, 3),
    op("<|>", Operator::NotEqual, 2),
    op("<>", Operator::NotEqual, 2),
    op("<=", Operator::LessOrEqual, 2),
    op(">=", Operator::GreaterOrEqual, 2),
    op("<", Operator::Less, 2),
    op(">", Operator::Greater, 2),
    op("=", Operator::Equal, 2),
    op("EQ", Operator::Equal, 2),
    op("NE", Operator::NotEqual, 2),
    op("GE", Operator::GreaterOrEqual, 2),
    op("GT", Operator::Greater, 2),
    op("LE", Operator::LessOrEqual, 2),
    op("LT", Operator::Less, 2),
    op("AND", Operator::And, 1),
    op("OR", Operator::Or, 1),
];

const FANUC_FUNCTIONS: &[(&str, Function)] = &[
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

const HAAS_FUNCTIONS: &[(&str, Function)] = &[
    ("SIN", Function::Sin),
    ("COS", Function::Cos),
    ("TAN", Function::Tan),
    ("ASIN", Function::Asin),
    ("ACOS", Function::Acos),
    ("ATAN", Function::Atan),
    ("SQRT", Function::Sqrt),
    ("ABS", Function::Abs),
    ("ROUND", Function::Round),
    ("FIX", Function::Fix),
];

const MITSUBISHI_FUNCTIONS: &[(&str, Function)] = &[
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
    ("RND", Function::Round),
    ("FIX", Function::Fix),
    ("FUP", Function::Fup),
    ("LN", Function::Ln),
    ("EXP", Function::Exp),
];

const LINUXCNC_FUNCTIONS: &[(&str, Function)] = &[
    ("SIN", Function::Sin),
    ("COS", Function::Cos),
    ("TAN", Function::Tan),
    ("ASIN", Function::Asin),
    ("ACOS", Function::Acos),
    ("ATAN", Function::Atan),
    ("SQRT", Function::Sqrt),
    ("ABS", Function::Abs),
    ("ROUND", Function::Round),
    ("FIX", Function::Fix),
    ("FUP", Function::Fup),
    ("LN", Function::Ln),
    ("EXP", Function::Exp),
    ("EXISTS", Function::Exists),
];

const FADAL_FUNCTIONS: &[(&str, Function)] = &[
    ("SIN", Function::Sin),
    ("COS", Function::Cos),
    ("TAN", Function::Tan),
    ("ATN", Function::Atan),
    ("SQR", Function::Sqrt),
    ("ABS", Function::Abs),
    ("INT", Function::Fix),
    ("RND", Function::RoundPlaces),
    ("SGN", Function::Sign),
    ("NOT", Function::Not),
];

/// Tables and registers of the Fadal, manual 2003 section 18.
const FADAL_VARIABLES: &[&str] = &[
    "AX", "AY", "AZ", "AA", "AB", "AC", "PX", "PY", "PZ", "PA", "PB", "FX", "FY", "FZ", "FA", "FB",
    "CP", "CR", "CC", "TT", "TU", "TN", "TL", "VF", "HO", "V", "R", "H", "D", "G", "I", "O",
];

impl MacroGrammar {
    /// Macro B of Fanuc.
    pub const FANUC: MacroGrammar = MacroGrammar {
        brackets: BracketStyle::Square,
        operators: MACRO_B_OPERATORS,
        functions: FANUC_FUNCTIONS,
        abbreviations: true,
        chained: false,
        names: false,
        operators_in_brackets_only: false,
        letter_variables: &[],
        bracket_limit: Some(5),
    };

    /// Haas: the functions of the NGC manual.
    pub const HAAS: MacroGrammar =
        MacroGrammar { functions: HAAS_FUNCTIONS, bracket_limit: None, ..MacroGrammar::FANUC };

    /// Mitsubishi M700/M800.
    pub const MITSUBISHI: MacroGrammar = MacroGrammar {
        functions: MITSUBISHI_FUNCTIONS,
        abbreviations: false,
        ..MacroGrammar::FANUC
    };

    /// LinuxCNC.
    pub const LINUXCNC: MacroGrammar = MacroGrammar {
        operators: LINUXCNC_OPERATORS,
        functions: LINUXCNC_FUNCTIONS,
        abbreviations: false,
        chained: true,
        names: true,
        operators_in_brackets_only: true,
        bracket_limit: None,
        ..MacroGrammar::FANUC
    };

    /// Mach3: numbered parameters alone, and no comparisons.
    pub const MACH3: MacroGrammar =
        MacroGrammar { operators: RS274_OPERATORS, names: false, ..MacroGrammar::LINUXCNC };

    /// Fadal `#` lines.
    pub const FADAL: MacroGrammar = MacroGrammar {
        brackets: BracketStyle::Round,
        operators: FADAL_OPERATORS,
        functions: FADAL_FUNCTIONS,
        abbreviations: false,
        letter_variables: FADAL_VARIABLES,
        bracket_limit: None,
        ..MacroGrammar::FANUC
    };

    /// The opening and the closing bracket.
    pub const fn bracket_bytes(&self) -> (u8, u8) {
        match self.brackets {
            BracketStyle::Square => (b'[', b']'),
            BracketStyle::Round => (b'(', b')'),
        }
    }
}

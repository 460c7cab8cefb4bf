//! Macros of Fadal CNC 88.

use crate::vocabulary::*;

/// User Manual (April 2003), section 18. A macro line has no NC words, and a comparison has no value.
pub(super) static MACROS: MacroRules = MacroRules {
    form: MacroForm::Lines,
    fix: RoundingRule::TowardZero,
    modulo_positive: false,
    comparison_is_value: false,
    mixed_blocks: false,
    index_tolerance: 0.5,
    ..MacroRules::NONE
};

/// The expressions of lines that begin with `#`.
pub(super) static GRAMMAR: MacroGrammar = MacroGrammar {
    brackets: BracketStyle::Round,
    operators: OPERATORS,
    functions: FUNCTIONS,
    abbreviations: false,
    letter_variables: VARIABLES,
    bracket_limit: None,
    ..MacroGrammar::MACRO_B
};

/// User Manual (April 2003), section 18.
const OPERATORS: &[OperatorRow] = &[
    operator("*", Operator::Multiply, 4),
    operator("/", Operator::Divide, 4),
    operator("+", Operator::Add, 3),
    operator("-", Operator::Subtract, 3),
    operator("<|>", Operator::NotEqual, 2),
    operator("<>", Operator::NotEqual, 2),
    operator("<=", Operator::LessOrEqual, 2),
    operator(">=", Operator::GreaterOrEqual, 2),
    operator("<", Operator::Less, 2),
    operator(">", Operator::Greater, 2),
    operator("=", Operator::Equal, 2),
    operator("EQ", Operator::Equal, 2),
    operator("NE", Operator::NotEqual, 2),
    operator("GE", Operator::GreaterOrEqual, 2),
    operator("GT", Operator::Greater, 2),
    operator("LE", Operator::LessOrEqual, 2),
    operator("LT", Operator::Less, 2),
    operator("AND", Operator::And, 1),
    operator("OR", Operator::Or, 1),
];

const FUNCTIONS: &[(&str, Function)] = &[
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

/// The names of tables and registers in expressions, in the same section.
const VARIABLES: &[&str] = &[
    "AX", "AY", "AZ", "AA", "AB", "AC", "PX", "PY", "PZ", "PA", "PB", "FX", "FY", "FZ", "FA", "FB",
    "CP", "CR", "CC", "TT", "TU", "TN", "TL", "VF", "HO", "V", "R", "H", "D", "G", "I", "O",
];

//! Parameters and expressions of Mach3: as LinuxCNC's, without named parameters and flow control.

use super::super::linuxcnc::{GRAMMAR as FAMILY_GRAMMAR, MACROS as FAMILY};
use crate::vocabulary::*;

pub(super) static MACROS: MacroRules = MacroRules {
    o_flow: false,
    comments_act: false,
    locals: 0,
    common: VARIABLES,
    system: SYSTEM,
    ..FAMILY
};

/// Numbers up to #10320 that no system parameter has.
const VARIABLES: &[VariableRange] = &[
    volatile(1, 1999),
    volatile(2006, 5160),
    volatile(5167, 5180),
    volatile(5187, 5190),
    volatile(5197, 5210),
    volatile(5217, 5219),
];

const SYSTEM: &[SystemRow] = &[
    system(2000, 2005, SystemVariable::ProbePosition),
    system(5161, 5166, SystemVariable::Home),
    system(5181, 5186, SystemVariable::SecondHome),
    system(5211, 5216, SystemVariable::Preset),
    system(5220, 5220, SystemVariable::WorkSystem),
    system(5221, 5340, SystemVariable::WorkTable),
];

/// Numbered parameters alone, without comparisons.
pub(super) static GRAMMAR: MacroGrammar =
    MacroGrammar { operators: OPERATORS, names: false, ..FAMILY_GRAMMAR };

/// As in the RS274/NGC interpreter before LinuxCNC: AND, OR and XOR have the precedence of `+`.
const OPERATORS: &[OperatorRow] = &[
    operator("**", Operator::Power, 3),
    operator("*", Operator::Multiply, 2),
    operator("/", Operator::Divide, 2),
    operator("MOD", Operator::Modulo, 2),
    operator("+", Operator::Add, 1),
    operator("-", Operator::Subtract, 1),
    operator("AND", Operator::And, 1),
    operator("XOR", Operator::Xor, 1),
    operator("OR", Operator::Or, 1),
];

//! Macro variables and functions of Mitsubishi M700 and M800.

use crate::vocabulary::*;

/// Mitsubishi M700/M800 (M700V Programming Manual, pp. 308–389).
pub(super) static MACROS: MacroRules = MacroRules {
    common: COMMON,
    system: SYSTEM,
    last_loop: 127,
    loop_depth: 27,
    alarm_base: 0,
    alarm_last: 9999,
    modal_groups: super::super::fanuc::MODAL_GROUPS,
    ..MacroRules::MACRO_B
};

const COMMON: &[VariableRange] = &[volatile(100, 199), non_volatile(400, 999), non_volatile(900_000, 907_399)];

const SYSTEM: &[SystemRow] = &[
    system(1000, 1035, SystemVariable::Input),
    system(1100, 1135, SystemVariable::Output),
    system(2001, 2200, SystemVariable::LengthWear),
    system(2201, 2400, SystemVariable::LengthGeometry),
    system(2401, 2600, SystemVariable::RadiusGeometry),
    system(2601, 2800, SystemVariable::RadiusWear),
    system(3000, 3000, SystemVariable::Alarm),
    system(3001, 3002, SystemVariable::Timer),
    system(3003, 3004, SystemVariable::Suppression),
    system(3006, 3006, SystemVariable::Message),
    system(3011, 3011, SystemVariable::Date),
    system(3012, 3012, SystemVariable::Time),
    system(3901, 3902, SystemVariable::NotSimulated),
    system(4001, 4021, SystemVariable::ModalGroup),
    system(4107, 4107, SystemVariable::ModalWord(b'D')),
    system(4109, 4109, SystemVariable::ModalWord(b'F')),
    system(4111, 4111, SystemVariable::ModalWord(b'H')),
    system(4113, 4113, SystemVariable::ModalWord(b'M')),
    system(4114, 4114, SystemVariable::ModalWord(b'N')),
    system(4115, 4115, SystemVariable::ModalWord(b'O')),
    system(4119, 4119, SystemVariable::ModalWord(b'S')),
    system(4120, 4120, SystemVariable::ModalWord(b'T')),
    system(4201, 4221, SystemVariable::ModalGroup),
    system(4302, 4320, SystemVariable::ModalGroup),
    // Modal information of the block that an interruption-type macro interrupted.
    system(4401, 4520, SystemVariable::NotSimulated),
    system(5001, 5006, SystemVariable::BlockEnd),
    system(5021, 5026, SystemVariable::MachinePosition),
    system(5041, 5046, SystemVariable::WorkPosition),
    system(5061, 5066, SystemVariable::SkipPosition),
    system(5081, 5086, SystemVariable::NotSimulated),
    system(5101, 5106, SystemVariable::NotSimulated),
    system(5201, 5206, SystemVariable::ExternalOffset),
    system(5221, 5326, SystemVariable::WorkOffsets),
    system(7001, 7946, SystemVariable::ExtendedOffsets),
    system(10001, 10999, SystemVariable::LengthWear),
    system(11001, 11999, SystemVariable::LengthGeometry),
    system(16001, 16999, SystemVariable::RadiusGeometry),
    system(17001, 17999, SystemVariable::RadiusWear),
    system(101_001, 107_000, SystemVariable::ExtendedOffsets),
];

/// Functions have their whole names: `SQRT` or `SQR`, but not `RO` for `ROUND`.
pub(super) static GRAMMAR: MacroGrammar =
    MacroGrammar { functions: FUNCTIONS, abbreviations: false, ..MacroGrammar::MACRO_B };

const FUNCTIONS: &[(&str, Function)] = &[
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

//! Macro variables and functions of Haas mills.

use crate::vocabulary::*;

/// Haas NGC (Mill Operator's Manual 2017, Macros).
pub(super) static MACROS: MacroRules = MacroRules {
    common: COMMON,
    system: SYSTEM,
    atan_full_circle: false,
    asin_full_circle: false,
    comparison_is_value: true,
    then: ThenClause::Anything,
    mixed_blocks: true,
    call_depth: 9,
    argument_scale: ArgumentScale::ByLetter,
    alarm_base: 1000,
    alarm_last: 999,
    output_blanks: false,
    output_needs_open: false,
    modal_groups: GROUPS,
    m_alias_programs: 9000,
    m_alias_arguments: false,
    ..MacroRules::MACRO_B
};

/// Modal groups 1 to 16, as #4001 to #4016 report them.
const GROUPS: &[ModalGroup] = &[
    ModalGroup::Motion,
    ModalGroup::Plane,
    ModalGroup::Distance,
    ModalGroup::Fixed(0), // 4: not used
    ModalGroup::FeedMode,
    ModalGroup::Units,
    ModalGroup::Compensation,
    ModalGroup::Length,
    ModalGroup::Cycle,
    ModalGroup::ReturnLevel,
    ModalGroup::Fixed(50), // 11: scaling off
    ModalGroup::WorkOffset,
    ModalGroup::Fixed(0), // 13: not used
    ModalGroup::Fixed(0), // 14: not used
    ModalGroup::Fixed(64), // 15: exact stop off
    ModalGroup::Fixed(69), // 16: rotation off
];

/// #100–199, #500–699 and #800–999 are other names of #10100–10199, #10500–10699 and #10800–10999.
const COMMON: &[VariableRange] =
    &[alias(100, 199, 10100), alias(500, 699, 10500), alias(800, 999, 10800), non_volatile(10000, 10999)];

const SYSTEM: &[SystemRow] = &[
    system(1000, 1063, SystemVariable::Input),
    system(1064, 1068, SystemVariable::Input),
    system(1080, 1097, SystemVariable::Input),
    system(1100, 1155, SystemVariable::Output),
    // Flutes and vibration of tools.
    system(1601, 2000, SystemVariable::NotSimulated),
    system(2001, 2200, SystemVariable::LengthGeometry),
    system(2201, 2400, SystemVariable::LengthWear),
    system(2401, 2600, SystemVariable::RadiusGeometry),
    system(2601, 2800, SystemVariable::RadiusWear),
    system(3000, 3000, SystemVariable::Alarm),
    system(3001, 3002, SystemVariable::Timer),
    system(3003, 3004, SystemVariable::Suppression),
    system(3006, 3006, SystemVariable::Message),
    system(3011, 3011, SystemVariable::Date),
    system(3012, 3012, SystemVariable::Time),
    system(3020, 3025, SystemVariable::Timer),
    system(3026, 3026, SystemVariable::Tool),
    system(3027, 3027, SystemVariable::SpindleSpeed),
    system(3028, 3029, SystemVariable::NotSimulated),
    system(3030, 3033, SystemVariable::Output),
    // Actual diameters and coolant positions of tools.
    system(3201, 3600, SystemVariable::NotSimulated),
    system(3901, 3902, SystemVariable::NotSimulated),
    system(4001, 4021, SystemVariable::ModalGroup),
    system(4101, 4126, SystemVariable::ModalArgument),
    system(5001, 5006, SystemVariable::BlockEnd),
    system(5021, 5026, SystemVariable::MachinePosition),
    system(5041, 5046, SystemVariable::WorkPosition),
    system(5061, 5066, SystemVariable::SkipPosition),
    system(5081, 5086, SystemVariable::ActiveToolOffset),
    system(5201, 5206, SystemVariable::ExternalOffset),
    system(5221, 5326, SystemVariable::WorkOffsets),
    // Times, lives and loads of tools.
    system(5401, 5999, SystemVariable::NotSimulated),
    system(6198, 6198, SystemVariable::Constant(1_000_000)),
    system(7001, 7386, SystemVariable::ExtendedOffsets),
    system(8500, 8599, SystemVariable::NotSimulated),
    system(11000, 11255, SystemVariable::Input),
    system(12000, 12255, SystemVariable::Output),
    system(14001, 15966, SystemVariable::ExtendedOffsets),
    system(20000, 29999, SystemVariable::Setting),
];

/// The functions of the NGC manual; brackets may be nested to any depth.
pub(super) static GRAMMAR: MacroGrammar =
    MacroGrammar { functions: FUNCTIONS, bracket_limit: None, ..MacroGrammar::MACRO_B };

const FUNCTIONS: &[(&str, Function)] = &[
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

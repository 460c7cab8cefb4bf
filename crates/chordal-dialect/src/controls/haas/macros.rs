//! The macro language of Haas mill.

use crate::vocabulary::*;

/// Haas NGC (Mill Operator's Manual 2017, Macros).
pub(super) static MACROS: MacroRules = MacroRules {
    common: COMMON,
    system: SYSTEM,
    atan_full_circle: false,
    asin_full_circle: false,
    comparison_is_value: true,
    then: Then::Anything,
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

/// Groups 1 to 16 of a Haas; 12 is that of the work offsets.
const GROUPS: &[ModalGroup] = &[
    ModalGroup::Motion,
    ModalGroup::Plane,
    ModalGroup::Distance,
    ModalGroup::Fixed(0),
    ModalGroup::FeedMode,
    ModalGroup::Units,
    ModalGroup::Compensation,
    ModalGroup::Length,
    ModalGroup::Cycle,
    ModalGroup::ReturnLevel,
    ModalGroup::Fixed(50),
    ModalGroup::WorkOffset,
    ModalGroup::Fixed(0),
    ModalGroup::Fixed(0),
    ModalGroup::Fixed(64),
    ModalGroup::Fixed(69),
];

/// #100–199, #500–699 and #800–999 are the first names of #10000 + n.
const COMMON: &[VariableRange] =
    &[alias(100, 199, 10100), alias(500, 699, 10500), alias(800, 999, 10800), kept(10000, 10999)];

const SYSTEM: &[SystemRow] = &[
    system(1000, 1063, System::Input),
    system(1064, 1068, System::Input),
    system(1080, 1097, System::Input),
    system(1100, 1155, System::Kept),
    // Flutes and vibration of tools.
    system(1601, 2000, System::MachineState),
    system(2001, 2200, System::Length),
    system(2201, 2400, System::LengthWear),
    system(2401, 2600, System::Radius),
    system(2601, 2800, System::RadiusWear),
    system(3000, 3000, System::Alarm),
    system(3001, 3002, System::Timer),
    system(3003, 3004, System::Switch),
    system(3006, 3006, System::Message),
    system(3011, 3011, System::Date),
    system(3012, 3012, System::Time),
    system(3020, 3025, System::Timer),
    system(3026, 3026, System::Tool),
    system(3027, 3027, System::SpindleSpeed),
    system(3028, 3029, System::MachineState),
    system(3030, 3033, System::Kept),
    // Actual diameters and coolant positions of tools.
    system(3201, 3600, System::MachineState),
    system(3901, 3902, System::MachineState),
    system(4001, 4021, System::ModalGroup),
    system(4101, 4126, System::ModalArgument),
    system(5001, 5006, System::BlockEnd),
    system(5021, 5026, System::MachinePosition),
    system(5041, 5046, System::WorkPosition),
    system(5061, 5066, System::SkipPosition),
    system(5081, 5086, System::ActiveToolOffset),
    system(5201, 5206, System::ExternalOffset),
    system(5221, 5326, System::WorkOffsets),
    // Times, lives and loads of tools.
    system(5401, 5999, System::MachineState),
    system(6198, 6198, System::Constant(1_000_000)),
    system(7001, 7386, System::ExtendedOffsets),
    system(8500, 8599, System::MachineState),
    system(11000, 11255, System::Input),
    system(12000, 12255, System::Kept),
    system(14001, 15966, System::ExtendedOffsets),
    system(20000, 29999, System::Setting),
];

//! The macro rules of Fanuc, Haas and Mitsubishi.

use crate::macros::rules::{
    ArgumentScale, MacroRules, ModalGroup, System, SystemRow, Then, VariableRange, alias, common,
    system,
};

/// Fanuc custom macro B (B-63684EN, B-63944EN), and where the manuals were not at hand what
/// probe makers' programs rely on.
pub(super) static FANUC: MacroRules = MacroRules {
    common: FANUC_COMMON,
    system: FANUC_SYSTEM,
    modal_groups: FANUC_GROUPS,
    ..MacroRules::MACRO_B
};

/// Groups 1 to 17 of a Fanuc; 14 is that of the work offsets.
const FANUC_GROUPS: &[ModalGroup] = &[
    ModalGroup::Motion,
    ModalGroup::Plane,
    ModalGroup::Distance,
    ModalGroup::Fixed(23),
    ModalGroup::FeedMode,
    ModalGroup::Units,
    ModalGroup::Compensation,
    ModalGroup::Length,
    ModalGroup::Cycle,
    ModalGroup::ReturnLevel,
    ModalGroup::Fixed(50),
    ModalGroup::ModalCall,
    ModalGroup::Fixed(97),
    ModalGroup::WorkOffset,
    ModalGroup::Fixed(64),
    ModalGroup::Fixed(69),
    ModalGroup::Fixed(15),
];

/// Groups 1 to 16 of a Haas; 12 is that of the work offsets.
const HAAS_GROUPS: &[ModalGroup] = &[
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

/// #150–199 and #532–999 are an option that most machines have.
const FANUC_COMMON: &[VariableRange] = &[common(100, 199), common(500, 999)];

const FANUC_SYSTEM: &[SystemRow] = &[
    system(1000, 1035, System::Input),
    system(1100, 1135, System::Kept),
    system(2500, 2506, System::OffsetsOfAxis(0)),
    system(2600, 2606, System::OffsetsOfAxis(1)),
    system(2700, 2706, System::OffsetsOfAxis(2)),
    system(2800, 2806, System::OffsetsOfAxis(3)),
    system(3000, 3000, System::Alarm),
    system(3001, 3002, System::Timer),
    system(3003, 3005, System::Kept),
    system(3006, 3006, System::Message),
    system(3011, 3011, System::Date),
    system(3012, 3012, System::Time),
    system(3901, 3902, System::Kept),
    system(4001, 4030, System::ModalGroup),
    system(4102, 4102, System::ModalWord(b'B')),
    system(4107, 4107, System::ModalWord(b'D')),
    system(4109, 4109, System::ModalWord(b'F')),
    system(4111, 4111, System::ModalWord(b'H')),
    system(4113, 4113, System::ModalWord(b'M')),
    system(4114, 4114, System::ModalWord(b'N')),
    system(4115, 4115, System::ModalWord(b'O')),
    system(4119, 4119, System::ModalWord(b'S')),
    system(4120, 4120, System::ModalWord(b'T')),
    system(4130, 4130, System::ModalWord(b'P')),
    system(4201, 4230, System::ModalGroup),
    system(5001, 5006, System::BlockEnd),
    system(5021, 5026, System::MachinePosition),
    system(5041, 5046, System::WorkPosition),
    system(5061, 5066, System::SkipPosition),
    system(5081, 5086, System::ActiveToolOffset),
    system(5201, 5206, System::ExternalOffset),
    system(5221, 5326, System::WorkOffsets),
    system(7001, 7946, System::ExtendedOffsets),
    system(10001, 10999, System::LengthWear),
    system(11001, 11999, System::Length),
    system(12001, 12999, System::RadiusWear),
    system(13001, 13999, System::Radius),
    system(14001, 19986, System::ExtendedOffsets),
];

/// Haas NGC (Mill Operator's Manual 2017, Macros).
pub(super) static HAAS: MacroRules = MacroRules {
    common: HAAS_COMMON,
    system: HAAS_SYSTEM,
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
    modal_groups: HAAS_GROUPS,
    m_alias_programs: 9000,
    m_alias_arguments: false,
    ..MacroRules::MACRO_B
};

/// #100–199, #500–699 and #800–999 are the first names of #10000 + n.
const HAAS_COMMON: &[VariableRange] =
    &[alias(100, 199, 10100), alias(500, 699, 10500), alias(800, 999, 10800), common(10000, 10999)];

const HAAS_SYSTEM: &[SystemRow] = &[
    system(1000, 1063, System::Input),
    system(1064, 1068, System::Input),
    system(1080, 1097, System::Input),
    system(1100, 1155, System::Kept),
    system(2001, 2200, System::Length),
    system(2201, 2400, System::LengthWear),
    system(2401, 2600, System::Radius),
    system(2601, 2800, System::RadiusWear),
    system(3000, 3000, System::Alarm),
    system(3001, 3002, System::Timer),
    system(3003, 3004, System::Kept),
    system(3006, 3006, System::Message),
    system(3011, 3011, System::Date),
    system(3012, 3012, System::Time),
    system(3020, 3025, System::Timer),
    system(3026, 3026, System::Tool),
    system(3027, 3027, System::SpindleSpeed),
    system(3030, 3033, System::Kept),
    system(3901, 3902, System::Kept),
    system(4001, 4021, System::ModalGroup),
    system(4101, 4126, System::ModalArgument),
    system(5001, 5006, System::BlockEnd),
    system(5021, 5026, System::MachinePosition),
    system(5041, 5046, System::WorkPosition),
    system(5061, 5066, System::SkipPosition),
    system(5081, 5086, System::ActiveToolOffset),
    system(5201, 5206, System::ExternalOffset),
    system(5221, 5326, System::WorkOffsets),
    system(6198, 6198, System::Constant(1_000_000)),
    system(7001, 7386, System::ExtendedOffsets),
    system(8500, 8599, System::Kept),
    system(11000, 11255, System::Input),
    system(12000, 12255, System::Kept),
    system(14001, 15966, System::ExtendedOffsets),
    system(20000, 29999, System::Setting),
];

/// Mitsubishi M700/M800 (M700V Programming Manual, pp. 308–389).
pub(super) static MITSUBISHI: MacroRules = MacroRules {
    common: MITSUBISHI_COMMON,
    system: MITSUBISHI_SYSTEM,
    last_loop: 127,
    loop_depth: 27,
    alarm_base: 0,
    alarm_last: 9999,
    modal_groups: FANUC_GROUPS,
    ..MacroRules::MACRO_B
};

const MITSUBISHI_COMMON: &[VariableRange] =
    &[common(100, 199), common(400, 999), common(900_000, 907_399)];

const MITSUBISHI_SYSTEM: &[SystemRow] = &[
    system(1000, 1035, System::Input),
    system(1100, 1135, System::Kept),
    system(2001, 2200, System::LengthWear),
    system(2201, 2400, System::Length),
    system(2401, 2600, System::Radius),
    system(2601, 2800, System::RadiusWear),
    system(3000, 3000, System::Alarm),
    system(3001, 3002, System::Timer),
    system(3003, 3004, System::Kept),
    system(3006, 3006, System::Message),
    system(3011, 3011, System::Date),
    system(3012, 3012, System::Time),
    system(3901, 3902, System::Kept),
    system(4001, 4021, System::ModalGroup),
    system(4107, 4107, System::ModalWord(b'D')),
    system(4109, 4109, System::ModalWord(b'F')),
    system(4111, 4111, System::ModalWord(b'H')),
    system(4113, 4113, System::ModalWord(b'M')),
    system(4114, 4114, System::ModalWord(b'N')),
    system(4115, 4115, System::ModalWord(b'O')),
    system(4119, 4119, System::ModalWord(b'S')),
    system(4120, 4120, System::ModalWord(b'T')),
    system(4201, 4221, System::ModalGroup),
    system(4302, 4320, System::ModalGroup),
    system(5001, 5006, System::BlockEnd),
    system(5021, 5026, System::MachinePosition),
    system(5041, 5046, System::WorkPosition),
    system(5061, 5066, System::SkipPosition),
    system(5201, 5206, System::ExternalOffset),
    system(5221, 5326, System::WorkOffsets),
    system(7001, 7946, System::ExtendedOffsets),
    system(10001, 10999, System::LengthWear),
    system(11001, 11999, System::Length),
    system(16001, 16999, System::Radius),
    system(17001, 17999, System::RadiusWear),
    system(101_001, 107_000, System::ExtendedOffsets),
];

//! The macro language of Mitsubishi M700 and M800.

use crate::vocabulary::*;

/// Mitsubishi M700/M800 (M700V Programming Manual, pp. 308–389).
pub(super) static MACROS: MacroRules = MacroRules {
    common: COMMON,
    system: SYSTEM,
    last_loop: 127,
    loop_depth: 27,
    alarm_base: 0,
    alarm_last: 9999,
    modal_groups: super::super::fanuc::GROUPS,
    ..MacroRules::MACRO_B
};

const COMMON: &[VariableRange] = &[common(100, 199), kept(400, 999), kept(900_000, 907_399)];

const SYSTEM: &[SystemRow] = &[
    system(1000, 1035, System::Input),
    system(1100, 1135, System::Kept),
    system(2001, 2200, System::LengthWear),
    system(2201, 2400, System::Length),
    system(2401, 2600, System::Radius),
    system(2601, 2800, System::RadiusWear),
    system(3000, 3000, System::Alarm),
    system(3001, 3002, System::Timer),
    system(3003, 3004, System::Switch),
    system(3006, 3006, System::Message),
    system(3011, 3011, System::Date),
    system(3012, 3012, System::Time),
    system(3901, 3902, System::MachineState),
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
    // The block that an interruption left.
    system(4401, 4520, System::MachineState),
    system(5001, 5006, System::BlockEnd),
    system(5021, 5026, System::MachinePosition),
    system(5041, 5046, System::WorkPosition),
    system(5061, 5066, System::SkipPosition),
    system(5081, 5086, System::MachineState),
    system(5101, 5106, System::MachineState),
    system(5201, 5206, System::ExternalOffset),
    system(5221, 5326, System::WorkOffsets),
    system(7001, 7946, System::ExtendedOffsets),
    system(10001, 10999, System::LengthWear),
    system(11001, 11999, System::Length),
    system(16001, 16999, System::Radius),
    system(17001, 17999, System::RadiusWear),
    system(101_001, 107_000, System::ExtendedOffsets),
];

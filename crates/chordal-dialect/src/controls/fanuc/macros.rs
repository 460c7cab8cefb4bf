//! Macro variables of Fanuc 0i and 30i.

use crate::vocabulary::*;

/// Fanuc custom macro B: B-63684EN and B-63944EN, and what macros of probe makers use beyond these.
pub(in crate::controls) static MACROS: MacroRules =
    MacroRules { common: COMMON, system: SYSTEM, modal_groups: MODAL_GROUPS, ..MacroRules::MACRO_B };

/// Modal groups 1 to 17, as #4001 to #4017 report them.
pub(in crate::controls) const MODAL_GROUPS: &[ModalGroup] = &[
    ModalGroup::Motion,
    ModalGroup::Plane,
    ModalGroup::Distance,
    ModalGroup::Fixed(23), // 4: stored stroke check off
    ModalGroup::FeedMode,
    ModalGroup::Units,
    ModalGroup::Compensation,
    ModalGroup::Length,
    ModalGroup::Cycle,
    ModalGroup::ReturnLevel,
    ModalGroup::Fixed(50), // 11: scaling off
    ModalGroup::ModalCall,
    ModalGroup::Fixed(97), // 13: no constant surface speed
    ModalGroup::WorkOffset,
    ModalGroup::Fixed(64), // 15: cutting mode
    ModalGroup::Fixed(69), // 16: coordinate rotation off
    ModalGroup::Fixed(15), // 17: polar coordinates off
];

/// #150–199 and #532–999 are an option that most machines have; #98000–98999 are an option of the 30i.
const COMMON: &[VariableRange] = &[volatile(100, 199), non_volatile(500, 999), non_volatile(98000, 98999)];

const SYSTEM: &[SystemRow] = &[
    system(1000, 1035, SystemVariable::Input),
    system(1100, 1135, SystemVariable::Output),
    // Tool offsets 1 to 200 of memory A; in memory C the length wear, and from #2201 on the geometry.
    system(2001, 2400, SystemVariable::ToolOffsetByMemory),
    system(2500, 2506, SystemVariable::WorkOffsetsOfAxis(0)),
    system(2600, 2606, SystemVariable::WorkOffsetsOfAxis(1)),
    system(2700, 2706, SystemVariable::WorkOffsetsOfAxis(2)),
    system(2800, 2806, SystemVariable::WorkOffsetsOfAxis(3)),
    system(3000, 3000, SystemVariable::Alarm),
    system(3001, 3002, SystemVariable::Timer),
    system(3003, 3004, SystemVariable::Suppression),
    system(3005, 3005, SystemVariable::Setting),
    system(3006, 3006, SystemVariable::Message),
    system(3007, 3008, SystemVariable::NotSimulated),
    system(3011, 3011, SystemVariable::Date),
    system(3012, 3012, SystemVariable::Time),
    system(3901, 3902, SystemVariable::NotSimulated),
    system(4001, 4030, SystemVariable::ModalGroup),
    system(4102, 4102, SystemVariable::ModalWord(b'B')),
    system(4107, 4107, SystemVariable::ModalWord(b'D')),
    system(4109, 4109, SystemVariable::ModalWord(b'F')),
    system(4111, 4111, SystemVariable::ModalWord(b'H')),
    system(4113, 4113, SystemVariable::ModalWord(b'M')),
    system(4114, 4114, SystemVariable::ModalWord(b'N')),
    system(4115, 4115, SystemVariable::ModalWord(b'O')),
    system(4119, 4119, SystemVariable::ModalWord(b'S')),
    system(4120, 4120, SystemVariable::ModalWord(b'T')),
    system(4130, 4130, SystemVariable::ModalWord(b'P')),
    system(4201, 4230, SystemVariable::ModalGroup),
    // Modal information of the block that an interruption-type macro interrupted.
    system(4401, 4530, SystemVariable::NotSimulated),
    // Twenty numbers for each kind of position, one per axis; six axes are simulated.
    system(5001, 5006, SystemVariable::BlockEnd),
    system(5007, 5020, SystemVariable::NotSimulated),
    system(5021, 5026, SystemVariable::MachinePosition),
    system(5027, 5040, SystemVariable::NotSimulated),
    system(5041, 5046, SystemVariable::WorkPosition),
    system(5047, 5060, SystemVariable::NotSimulated),
    system(5061, 5066, SystemVariable::SkipPosition),
    system(5067, 5080, SystemVariable::NotSimulated),
    system(5081, 5086, SystemVariable::ActiveToolOffset),
    // From #5101 on servo lag, from #5121 on handle interruption, from #5181 on distance to go.
    system(5087, 5200, SystemVariable::NotSimulated),
    system(5201, 5206, SystemVariable::ExternalOffset),
    system(5207, 5220, SystemVariable::NotSimulated),
    system(5221, 5326, SystemVariable::WorkOffsets),
    system(5327, 5500, SystemVariable::NotSimulated),
    system(7001, 7946, SystemVariable::ExtendedOffsets),
    system(10001, 10999, SystemVariable::LengthWear),
    system(11001, 11999, SystemVariable::LengthGeometry),
    system(12001, 12999, SystemVariable::RadiusWear),
    system(13001, 13999, SystemVariable::RadiusGeometry),
    system(14001, 19986, SystemVariable::ExtendedOffsets),
    // The positions and work offsets again with fifty numbers each, for up to fifty axes (30i).
    system(100001, 100006, SystemVariable::BlockEnd),
    system(100051, 100056, SystemVariable::MachinePosition),
    system(100101, 100106, SystemVariable::WorkPosition),
    system(100151, 100156, SystemVariable::SkipPosition),
    system(100201, 100206, SystemVariable::ActiveToolOffset),
    system(100301, 100306, SystemVariable::ExternalOffset),
    system_with_stride(50, 100351, 100606, SystemVariable::WorkOffsets),
    system_with_stride(50, 101001, 115956, SystemVariable::ExtendedOffsets),
];

//! The macro language of Fanuc 0i.

use crate::vocabulary::*;

/// Fanuc custom macro B (B-63684EN, B-63944EN), and where the manuals were not at hand what
/// probe makers' programs rely on.
pub(in crate::controls) static MACROS: MacroRules =
    MacroRules { common: COMMON, system: SYSTEM, modal_groups: GROUPS, ..MacroRules::MACRO_B };

/// Groups 1 to 17 of a Fanuc; 14 is that of the work offsets.
pub(in crate::controls) const GROUPS: &[ModalGroup] = &[
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

/// #150–199 and #532–999 are an option that most machines have; #98000 on is one of the 30i.
const COMMON: &[VariableRange] = &[common(100, 199), kept(500, 999), kept(98000, 98999)];

const SYSTEM: &[SystemRow] = &[
    system(1000, 1035, System::Input),
    system(1100, 1135, System::Kept),
    // Tool offsets 1 to 200 of memory A; in memory C the length wear, and from #2201 on the geometry.
    system(2001, 2400, System::OffsetOfMemory),
    system(2500, 2506, System::OffsetsOfAxis(0)),
    system(2600, 2606, System::OffsetsOfAxis(1)),
    system(2700, 2706, System::OffsetsOfAxis(2)),
    system(2800, 2806, System::OffsetsOfAxis(3)),
    system(3000, 3000, System::Alarm),
    system(3001, 3002, System::Timer),
    system(3003, 3004, System::Switch),
    system(3005, 3005, System::Setting),
    system(3006, 3006, System::Message),
    system(3007, 3008, System::MachineState),
    system(3011, 3011, System::Date),
    system(3012, 3012, System::Time),
    system(3901, 3902, System::MachineState),
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
    // The block that an interruption left.
    system(4401, 4530, System::MachineState),
    // Up to twenty axes; servo lag from #5101 on, shifts by the handwheel from #5121 on, distances to go from #5181 on.
    system(5001, 5006, System::BlockEnd),
    system(5007, 5020, System::MachineState),
    system(5021, 5026, System::MachinePosition),
    system(5027, 5040, System::MachineState),
    system(5041, 5046, System::WorkPosition),
    system(5047, 5060, System::MachineState),
    system(5061, 5066, System::SkipPosition),
    system(5067, 5080, System::MachineState),
    system(5081, 5086, System::ActiveToolOffset),
    system(5087, 5200, System::MachineState),
    system(5201, 5206, System::ExternalOffset),
    system(5207, 5220, System::MachineState),
    system(5221, 5326, System::WorkOffsets),
    system(5327, 5500, System::MachineState),
    system(7001, 7946, System::ExtendedOffsets),
    system(10001, 10999, System::LengthWear),
    system(11001, 11999, System::Length),
    system(12001, 12999, System::RadiusWear),
    system(13001, 13999, System::Radius),
    system(14001, 19986, System::ExtendedOffsets),
    // The same for machines of up to fifty axes (30i): fifty numbers for each.
    system(100001, 100006, System::BlockEnd),
    system(100051, 100056, System::MachinePosition),
    system(100101, 100106, System::WorkPosition),
    system(100151, 100156, System::SkipPosition),
    system(100201, 100206, System::ActiveToolOffset),
    system(100301, 100306, System::ExternalOffset),
    system_by(50, 100351, 100606, System::WorkOffsets),
    system_by(50, 101001, 115956, System::ExtendedOffsets),
];

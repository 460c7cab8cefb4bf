//! The macro language of LinuxCNC (RS274/NGC).

use crate::vocabulary::*;

/// "Overview", numbered and named parameters, expressions, binary operators, functions.
pub(in crate::controls) static MACROS: MacroRules = MacroRules {
    form: MacroForm::OWords,
    comments_act: true,
    locals: 30,
    common: VARIABLES,
    system: SYSTEM,
    equal_tolerance: 1e-6,
    ..MacroRules::NONE
};

/// Those of the program, and the room between those of the control. The control's file of parameters keeps those
/// that stand in it.
const VARIABLES: &[VariableRange] = &[
    common(31, 5020),
    common(5030, 5060),
    common(5071, 5160),
    common(5170, 5180),
    common(5190, 5209),
    common(5391, 5398),
    common(5414, 5419),
    common(5429, 5601),
];

/// The axes U, V and W, of which Chordal knows nothing, stay as they are written.
const SYSTEM: &[SystemRow] = &[
    system(5021, 5026, System::MachinePosition),
    system(5027, 5029, System::Kept),
    system(5061, 5066, System::ProbePosition),
    system(5067, 5069, System::Kept),
    system(5070, 5070, System::ProbeResult),
    system(5161, 5166, System::Home),
    system(5167, 5169, System::Kept),
    system(5181, 5186, System::SecondHome),
    system(5187, 5189, System::Kept),
    system(5210, 5210, System::PresetActs),
    system(5211, 5216, System::Preset),
    system(5217, 5219, System::Kept),
    system(5220, 5220, System::WorkSystem),
    system(5221, 5390, System::WorkTable),
    // What M66 has read.
    system(5399, 5399, System::MachineState),
    system(5400, 5400, System::Tool),
    system(5401, 5406, System::SpindleTool),
    system(5407, 5409, System::Constant(0)),
    system(5410, 5410, System::ToolDiameter),
    system(5411, 5413, System::Constant(0)),
    system(5420, 5425, System::BlockEnd),
    system(5426, 5428, System::Constant(0)),
];

//! Parameters and expressions of Mach3: those of LinuxCNC's family without names and flow control.

use super::super::linuxcnc::MACROS as FAMILY;
use crate::vocabulary::*;

pub(super) static MACROS: MacroRules = MacroRules {
    o_flow: false,
    comments_act: false,
    locals: 0,
    common: VARIABLES,
    system: SYSTEM,
    ..FAMILY
};

/// Those of the program, up to #10320, and the room between those of the control.
const VARIABLES: &[VariableRange] = &[
    common(1, 1999),
    common(2006, 5160),
    common(5167, 5180),
    common(5187, 5190),
    common(5197, 5210),
    common(5217, 5219),
];

const SYSTEM: &[SystemRow] = &[
    system(2000, 2005, System::ProbePosition),
    system(5161, 5166, System::Home),
    system(5181, 5186, System::SecondHome),
    system(5211, 5216, System::Preset),
    system(5220, 5220, System::WorkSystem),
    system(5221, 5340, System::WorkTable),
];

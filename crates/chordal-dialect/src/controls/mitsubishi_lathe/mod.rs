//! Mitsubishi M700 and M800, L system: lathes with X as a diameter.

mod alarms;
mod recognition;
mod settings;

use super::fanuc_lathe::FANUC;
use super::mitsubishi::{LATHE_ALARMS, LATHE_MACROS, LEXICON};
use crate::vocabulary::*;

/// Mitsubishi M700 and M800, L system, G code list 2.
pub static TABLE: ControlTable = ControlTable {
    name: "mitsubishi-lathe",
    title: "Mitsubishi lathe",
    source: "Mitsubishi M70 and M700 alarm lists; the cycles as on Fanuc lathes",
    lexicon: Lexicon { channels: true, ..LEXICON },
    parameters: PARAMETERS,
    settings: settings::SETTINGS,
    alarms: LATHE_ALARMS,
    turning_alarms: alarms::TURNING,
    face: Some(&super::mitsubishi::surface::FACE),
    cylinder: Some(&super::mitsubishi::surface::CYLINDER),
    macros: LATHE_MACROS,
    program_numbers: ProgramNumbers { largest: 99999999, digits: 4, required: true },
    call_start_label: Some(b'H'),
    evidence: recognition::EVIDENCE,
    default_machine: "mitsubishi-lathe",
    ..FANUC
};

/// Parameters of Fanuc lathes, except for what the L system has differently.
const PARAMETERS: Parameters = Parameters {
    nesting: 8,
    live_tool_p: 0,
    second_spindle_p: 0,
    rules: Rules {
        turning: TurningRules {
            // G71 takes H for pockets, and A for a contour in another program.
            pockets_by: Some(b'H'),
            contour_program: true,
            thread_words_take_point: true,
            ..super::fanuc_lathe::PARAMETERS.rules.turning
        },
        // As with parameter #11028 on.
        arc: ArcRules {
            semicircle_of_long_radius: true,
            ..super::fanuc_lathe::PARAMETERS.rules.arc
        },
        ..super::fanuc_lathe::PARAMETERS.rules
    },
    ..super::fanuc_lathe::PARAMETERS
};

//! Haas lathes, NGC: ST, DS, SL and TL.

mod codes;
mod recognition;
mod rules;
mod settings;

use super::haas::{LATHE_ALARMS, LATHE_MACROS, LEXICON};
use crate::vocabulary::*;

/// Haas lathe, NGC.
pub static TABLE: ControlTable = ControlTable {
    name: "haas-lathe",
    title: "Haas lathe",
    source: "Haas lathe manual: G71, G76, tool nose compensation, imaginary tool tip",
    lexicon: LEXICON,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    alarms: LATHE_ALARMS,
    scale_unit: 1.0,
    set_data: SET_DATA,
    // P is in seconds with a point, in milliseconds without.
    dwell: &[DwellWord { letter: b'P', integer_s: 0.001, point_s: 1.0, takes_point: true }],
    dwell_alone_stops: false,
    order: BlockOrder {
        steps: BUILDER_STEPS,
        source: "usual: spindle and coolant go on before the motion, and off after it",
        certainty: Certainty::Practice,
    },
    open_m_codes: false,
    last_of_group_counts: false,
    work_names: WorkNaming { extended: "G154", first: 1, by_e: false },
    program_numbers: ProgramNumbers { largest: 99999, digits: 5, required: true },
    call_start_label: None,
    macros: LATHE_MACROS,
    turning_alarms: &[],
    systems: &[],
    face: Some(&super::haas::surface::FACE),
    cylinder: Some(&super::haas::surface::CYLINDER),
    radial_cycles: &[1950, 1960, 2410, 2420, 2430, 2450, 2460, 2490],
    live_taps: &[950, 1860, 1950, 1960],
    second_spindle: &[(b'G', 140), (b'G', 1990), (b'M', 1100), (b'M', 1430), (b'M', 1440)],
    evidence: recognition::EVIDENCE,
    default_machine: "haas-lathe",
    ..super::fanuc_lathe::FANUC
};

const SET_DATA: &[(u16, DataTarget)] = &[
    (2, DataTarget::WorkOffset),
    (10, DataTarget::TurningTool { wear: false }),
    (11, DataTarget::TurningTool { wear: true }),
    (20, DataTarget::ExtendedWorkOffset),
];

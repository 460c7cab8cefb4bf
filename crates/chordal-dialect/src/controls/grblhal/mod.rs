//! grblHAL: the family of GRBL on 32-bit boards.

mod alarms;
mod codes;
mod firmware;
mod macros;
mod post;
mod recognition;
mod rules;
mod settings;

use crate::vocabulary::*;

/// grblHAL.
pub static TABLE: ControlTable = ControlTable {
    name: "grblhal",
    title: "grblHAL",
    source: "grblHAL, its source and its list of error codes",
    lexicon: LEXICON,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    alarms: alarms::ALARMS,
    scale_unit: 1.0,
    motion: MotionModality::Exclusive,
    distance_left_to_right: false,
    line_repeat: LineRepeat::None,
    subroutines: Subroutines::None,
    fixed_routines: &[],
    axis_letters: "XYZ",
    arc_turns: ArcTurns::Total,
    strict_center_words: false,
    set_data: SET_DATA,
    dwell: super::grbl::DWELL,
    dwell_alone_stops: false,
    open_m_codes: false,
    last_of_group_counts: false,
    alone: &[],
    firmware: Some(&firmware::FIRMWARE),
    word_rules: &[],
    spatial: None,
    face: None,
    cylinder: None,
    spindle_stops_at_tool_change: false,
    work_names: WorkNaming { extended: "G59", by_e: false },
    program_numbers: ProgramNumbers { largest: 0, digits: 1, required: false },
    call_start_label: None,
    macros: &macros::MACROS,
    turning_alarms: &[],
    systems: &[],
    radial_cycles: &[],
    live_taps: &[],
    second_spindle: &[],
    kind: Some(&recognition::KIND),
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "grblhal",
};

/// Comments as the family has them, and O words, parameters and expressions where the build has them.
const LEXICON: Lexicon =
    Lexicon { o_words: true, grammar: &MacroGrammar::LINUXCNC, ..super::grbl::LEXICON };

const SET_DATA: &[(u16, DataTarget)] = &[
    (0, DataTarget::Reload),
    (1, DataTarget::ToolTable),
    (2, DataTarget::WorkOffset),
    (10, DataTarget::ToolFromPosition),
    (11, DataTarget::ToolFromFixture),
    (20, DataTarget::WorkOffsetFromPosition),
];

//! Mitsubishi M700 and M800.

mod alarms;
mod codes;
mod macros;
mod post;
pub(in crate::controls) mod recognition;
mod rules;
mod settings;
pub(in crate::controls) mod surface;

pub(in crate::controls) use self::alarms::ALARMS as LATHE_ALARMS;

use crate::vocabulary::*;

/// Mitsubishi M700 and M800.
pub static TABLE: ControlTable = ControlTable {
    name: "mitsubishi",
    title: "Mitsubishi M700/M800",
    source: "M700V/M70V Series Programming Manual",
    lexicon: LEXICON,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    alarms: alarms::ALARMS,
    scale_unit: 0.000_001,
    arc_turns: ArcTurns::BeyondAngle,
    set_data: SET_DATA,
    dwell: DWELL,
    open_m_codes: true,
    last_of_group_counts: true,
    spatial: Some(&rules::SPATIAL),
    tilted_plane: rules::TILTED_PLANE,
    face: Some(&surface::FACE),
    cylinder: Some(&surface::CYLINDER),
    program_numbers: ProgramNumbers { largest: 99999999, digits: 4, required: true },
    call_start_label: Some(b'H'),
    macros: &macros::MACROS,
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "mitsubishi-m700",
    ..ControlTable::COMMON
};

/// The macro rules that Mitsubishi lathes share.
pub(in crate::controls) const LATHE_MACROS: &MacroRules = &macros::MACROS;

pub(in crate::controls) const LEXICON: Lexicon =
    Lexicon { grammar: &macros::GRAMMAR, ..Lexicon::COMMON };

const SET_DATA: &[(u16, DataTarget)] = &[
    (2, DataTarget::WorkOffset),
    (10, DataTarget::Tool(ToolValue::Length)),
    (11, DataTarget::Tool(ToolValue::LengthWear)),
    (12, DataTarget::Tool(ToolValue::Radius)),
    (13, DataTarget::Tool(ToolValue::RadiusWear)),
    (20, DataTarget::ExtendedWorkOffset),
    (50, DataTarget::Lines),
    (70, DataTarget::Lines),
];

const DWELL: &[DwellWord] = &[
    DwellWord { letter: b'P', integer_s: 0.001, point_s: 0.001, takes_point: true },
    DwellWord { letter: b'X', integer_s: 0.001, point_s: 1.0, takes_point: true },
    DwellWord { letter: b'U', integer_s: 0.001, point_s: 1.0, takes_point: true },
];

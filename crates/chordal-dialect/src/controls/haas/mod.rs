//! Haas mill, NGC.

mod alarms;
mod codes;
mod macros;
mod post;
pub(crate) mod recognition;
mod rules;
mod settings;
pub(in crate::controls) mod surface;

pub(in crate::controls) use self::alarms::ALARMS as LATHE_ALARMS;

use crate::vocabulary::*;

/// Haas mill, NGC.
pub static TABLE: ControlTable = ControlTable {
    name: "haas",
    title: "Haas NGC mill",
    source: "Haas Mill NGC Operator's Manual (2017)",
    lexicon: LEXICON,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    alarms: alarms::ALARMS,
    line_repeat: LineRepeat::Anywhere,
    strict_center_words: true,
    set_data: SET_DATA,
    dwell: DWELL,
    order: BlockOrder {
        steps: BUILDER_STEPS,
        source: "usual: spindle and coolant go on before the motion, and off after it",
        certainty: Certainty::Practice,
    },
    alone: &[1000, 1010],
    cylinder: Some(&surface::CYLINDER),
    work_names: WorkNaming { extended: "G154", first: 1, by_e: false },
    program_numbers: ProgramNumbers { largest: 99999, digits: 5, required: true },
    macros: &macros::MACROS,
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "haas-vf2",
    ..ControlTable::COMMON
};

/// The macro rules that Haas lathes share.
pub(in crate::controls) const LATHE_MACROS: &MacroRules = &macros::MACROS;

pub(in crate::controls) const LEXICON: Lexicon =
    Lexicon { grammar: &macros::GRAMMAR, named_programs: false, ..Lexicon::COMMON };

const SET_DATA: &[(u16, DataTarget)] = &[
    (2, DataTarget::WorkOffset),
    (10, DataTarget::Tool(ToolValue::Length)),
    (11, DataTarget::Tool(ToolValue::LengthWear)),
    (12, DataTarget::Tool(ToolValue::Radius)),
    (13, DataTarget::Tool(ToolValue::RadiusWear)),
    (20, DataTarget::ExtendedWorkOffset),
];

// P is in seconds with a point, in milliseconds without.
const DWELL: &[DwellWord] = &[DwellWord { letter: b'P', integer_s: 0.001, point_s: 1.0, takes_point: true }];

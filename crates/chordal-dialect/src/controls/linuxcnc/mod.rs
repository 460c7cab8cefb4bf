//! LinuxCNC (RS274/NGC), version 2.9.

mod alarms;
mod codes;
mod macros;
mod post;
mod recognition;
pub(in crate::controls) mod rules;
mod settings;
mod words;

pub(in crate::controls) use macros::{GRAMMAR, MACROS};
pub(in crate::controls) use rules::PARAMETERS;

use crate::vocabulary::*;

/// LinuxCNC (RS274/NGC), version 2.9.
pub static TABLE: ControlTable = MILL;

/// Mills and lathes have one interpreter: a lathe differs in the modes at power-on.
pub(in crate::controls) const MILL: ControlTable = ControlTable {
    name: "linuxcnc",
    title: "LinuxCNC",
    source: "LinuxCNC G-code reference, version 2.9",
    lexicon: LEXICON,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: PARAMETERS,
    settings: settings::SETTINGS,
    alarms: alarms::ALARMS,
    arc_turns: ArcTurns::Total,
    strict_center_words: true,
    set_data: SET_DATA,
    dwell: DWELL,
    order: BlockOrder {
        steps: RS274_STEPS,
        source: "LinuxCNC documentation 2.9, G-code overview: order of execution",
        certainty: Certainty::Documented,
    },
    word_rules: words::WORD_RULES,
    // interp_check.cc: `fabs(number) >= 360` on an axis with WRAPPED_ROTARY.
    rollover_beyond_turn: Some("Invalid absolute position {value} for wrapped rotary axis {axis}"),
    work_names: WorkNaming { extended: "G59", first: 1, by_e: false },
    program_numbers: ProgramNumbers { largest: 99999, digits: 1, required: false },
    macros: &MACROS,
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "linuxcnc-mill",
    ..ControlTable::COMMON
};

pub(in crate::controls) const LEXICON: Lexicon = Lexicon {
    strict_comments: true,
    semicolon: Semicolon::Comment,
    blanks_in_numbers: true,
    o_words: true,
    program_heads: false,
    named_programs: false,
    polar_words: true,
    grammar: &GRAMMAR,
    ..Lexicon::COMMON
};

const SET_DATA: &[(u16, DataTarget)] = &[
    (0, DataTarget::Reload),
    (1, DataTarget::ToolTable),
    (2, DataTarget::WorkOffset),
    (10, DataTarget::ToolFromPosition),
    (11, DataTarget::ToolFromFixture),
    (20, DataTarget::WorkOffsetFromPosition),
];

const DWELL: &[DwellWord] = &[DwellWord { letter: b'P', integer_s: 1.0, point_s: 1.0, takes_point: true }];

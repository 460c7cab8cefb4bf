//! GRBL 1.1: small routers, mills and lasers.

mod alarms;
mod codes;
pub(in crate::controls) mod firmware;
mod post;
mod recognition;
pub(in crate::controls) mod rules;
pub(in crate::controls) mod settings;

use crate::vocabulary::*;

/// GRBL 1.1.
pub static TABLE: ControlTable = FAMILY;

/// The table that its relatives on larger boards are based on; they differ in codes, settings and answers.
pub(in crate::controls) const FAMILY: ControlTable = ControlTable {
    name: "grbl",
    title: "GRBL",
    source: "GRBL 1.1h, its source and its list of error codes",
    lexicon: LEXICON,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    alarms: alarms::ALARMS,
    axis_letters: "XYZ",
    set_data: SET_DATA,
    dwell: DWELL,
    order: BlockOrder {
        steps: GRBL_STEPS,
        source: "grbl/gcode.c, version 1.1h: the steps in which a line is carried out",
        certainty: Certainty::Documented,
    },
    firmware: Some(&firmware::FIRMWARE),
    work_names: WorkNaming { extended: "G59", first: 1, by_e: false },
    program_numbers: ProgramNumbers { largest: 0, digits: 1, required: false },
    kind: Some(&recognition::KIND),
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "grbl",
    ..ControlTable::COMMON
};

/// Comments alone: `firmware.rs` says how lines are divided into words.
const LEXICON: Lexicon = Lexicon {
    parenthesis: ParenthesisComment::ToEndOfLine,
    semicolon: Semicolon::Comment,
    blanks_in_numbers: true,
    program_heads: false,
    named_programs: false,
    ..Lexicon::COMMON
};

/// The lexicon of builds with parameters, expressions and O words.
pub(in crate::controls) const LEXICON_OF_EXPRESSIONS: Lexicon = Lexicon {
    // A statement may follow a comment; the rules of `firmware.rs` do not cover statements.
    parenthesis: ParenthesisComment::Closed,
    o_words: true,
    grammar: &super::linuxcnc::GRAMMAR,
    ..LEXICON
};

const SET_DATA: &[(u16, DataTarget)] =
    &[(2, DataTarget::WorkOffset), (20, DataTarget::WorkOffsetFromPosition)];

/// P in seconds, with or without a point.
const DWELL: &[DwellWord] =
    &[DwellWord { letter: b'P', integer_s: 1.0, point_s: 1.0, takes_point: true }];

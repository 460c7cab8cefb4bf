//! Marlin 2 on routers and lasers. Programs for printers with Marlin are recognized, but not read.

mod alarms;
mod codes;
mod line;
mod post;
mod recognition;
mod rules;
mod settings;

use crate::vocabulary::*;

/// Marlin 2 on a router or a laser.
pub static TABLE: ControlTable = ControlTable {
    name: "marlin",
    title: "Marlin",
    source: "Marlin 2.1, its documentation and its source",
    lexicon: LEXICON,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    alarms: alarms::ALARMS,
    axis_letters: "XYZ",
    arc_turns: ArcTurns::Extra,
    dwell: DWELL,
    dwell_alone_stops: true,
    order: BlockOrder {
        steps: BUILDER_STEPS,
        source: "a line is one command with its words",
        certainty: Certainty::Documented,
    },
    command_line: Some(&line::COMMAND_LINE),
    work_names: WorkNaming { extended: "G59", first: 1, by_e: false },
    program_numbers: ProgramNumbers { largest: 0, digits: 1, required: false },
    kind: Some(&recognition::KIND),
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "marlin-router",
    ..ControlTable::COMMON
};

/// Comments and words as an editor shows them; `line.rs` says how lines are read.
const LEXICON: Lexicon = Lexicon {
    parenthesis: ParenthesisComment::ToEndOfLine,
    semicolon: Semicolon::Comment,
    program_heads: false,
    named_programs: false,
    ..Lexicon::COMMON
};

/// S is in seconds and P in milliseconds; with both, S counts. Without either G4 waits until the moves before it end.
const DWELL: &[DwellWord] = &[
    DwellWord { letter: b'S', integer_s: 1.0, point_s: 1.0, takes_point: true },
    DwellWord { letter: b'P', integer_s: 0.001, point_s: 0.001, takes_point: true },
];

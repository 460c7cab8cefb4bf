//! Mach3 Mill (Artsoft), whose interpreter is an older relative of LinuxCNC's.

mod alarms;
mod codes;
mod macros;
mod post;
mod recognition;
mod rules;
mod settings;
mod words;

use super::linuxcnc::{LEXICON as FAMILY_LEXICON, MILL as FAMILY};
use crate::vocabulary::*;

/// Mach3 Mill.
pub static TABLE: ControlTable = ControlTable {
    name: "mach3",
    title: "Mach3",
    source: "Mach3 Mill, reference of its G and M codes; its posts",
    lexicon: LEXICON,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    alarms: alarms::ALARMS,
    arc_turns: ArcTurns::None,
    set_data: SET_DATA,
    order: BlockOrder {
        steps: RS274_STEPS,
        source: "Using Mach3Mill, chapter 10: order of execution, as in RS274/NGC (version 3, table 8)",
        certainty: Certainty::Documented,
    },
    // An M code that the reference does not list is a macro of the machine, a file such as `M100.m1s`.
    open_m_codes: true,
    word_rules: words::WORD_RULES,
    work_names: WorkNaming { extended: "G59", first: 7, by_e: false },
    macros: &macros::MACROS,
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "mach3-mill",
    ..FAMILY
};

/// `O5` is a label for M98; a file is one program.
const LEXICON: Lexicon = Lexicon { polar_words: false, grammar: &macros::GRAMMAR, ..FAMILY_LEXICON };

const SET_DATA: &[(u16, DataTarget)] = &[(1, DataTarget::ToolTable), (2, DataTarget::WorkOffset)];

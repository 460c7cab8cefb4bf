//! Marlin 2: routers and lasers. Printers with Marlin are recognized and not read.

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
    scale_unit: 1.0,
    motion: MotionModality::Exclusive,
    distance_left_to_right: false,
    line_repeat: LineRepeat::None,
    subroutines: SubroutineForm::None,
    fixed_routines: &[],
    axis_letters: "XYZ",
    arc_turns: ArcTurns::Extra,
    strict_center_words: false,
    set_data: &[],
    dwell: DWELL,
    dwell_alone_stops: true,
    order: BlockOrder {
        steps: BUILDER_STEPS,
        source: "a line is one command with its words",
        certainty: Certainty::Documented,
    },
    open_m_codes: false,
    last_of_group_counts: false,
    alone: &[],
    firmware: None,
    command_line: Some(&line::COMMAND_LINE),
    word_rules: &[],
    spatial: None,
    face: None,
    cylinder: None,
    work_names: WorkNaming { extended: "G59", first: 1, by_e: false },
    program_numbers: ProgramNumbers { largest: 0, digits: 1, required: false },
    call_start_label: None,
    macros: &MacroRules::NONE,
    turning_alarms: &[],
    systems: &[],
    radial_cycles: &[],
    live_taps: &[],
    second_spindle: &[],
    kind: Some(&recognition::KIND),
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "marlin-router",
};

/// A line is read as a whole (`line.rs`); this is what comments and words look like in an editor.
const LEXICON: Lexicon = Lexicon {
    parenthesis: ParenthesisComment::ToEndOfLine,
    strict_comments: false,
    semicolon: Semicolon::Comment,
    star_comment: false,
    registers: false,
    macro_lines: false,
    blanks_in_numbers: false,
    o_words: false,
    program_heads: false,
    named_programs: false,
    polar_words: false,
    channels: false,
    grammar: &MacroGrammar::FANUC,
};

/// S is in seconds and P in milliseconds; S counts where both are written. Without either the moves before it end.
const DWELL: &[DwellWord] = &[
    DwellWord { letter: b'S', integer_s: 1.0, point_s: 1.0, takes_point: true },
    DwellWord { letter: b'P', integer_s: 0.001, point_s: 0.001, takes_point: true },
];

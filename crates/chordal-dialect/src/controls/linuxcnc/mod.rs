//! LinuxCNC (RS274/NGC), version 2.9.

mod alarms;
mod codes;
mod macros;
mod post;
mod recognition;
pub(in crate::controls) mod rules;
mod settings;
mod words;

pub(in crate::controls) use macros::MACROS;
pub(in crate::controls) use rules::PARAMETERS;

use crate::vocabulary::*;
use chordal_machine::AXIS_LETTERS;

/// LinuxCNC (RS274/NGC), version 2.9.
pub static TABLE: ControlTable = MILL;

/// Its machines have one interpreter: that of a lathe differs in what acts at power-on.
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
    scale_unit: 1.0,
    motion: MotionModality::Exclusive,
    distance_left_to_right: false,
    line_repeat: LineRepeat::None,
    subroutines: SubroutineForm::None,
    fixed_routines: &[],
    axis_letters: AXIS_LETTERS,
    arc_turns: ArcTurns::Total,
    strict_center_words: true,
    set_data: SET_DATA,
    dwell: DWELL,
    dwell_alone_stops: false,
    order: BlockOrder {
        steps: RS274_STEPS,
        source: "LinuxCNC documentation 2.9, G-code overview: order of execution",
        certainty: Certainty::Documented,
    },
    open_m_codes: false,
    last_of_group_counts: false,
    alone: &[],
    firmware: None,
    command_line: None,
    word_rules: words::WORD_RULES,
    spatial: None,
    face: None,
    cylinder: None,
    work_names: WorkNaming { extended: "G59", first: 1, by_e: false },
    program_numbers: ProgramNumbers { largest: 99999, digits: 1, required: false },
    call_start_label: None,
    macros: &MACROS,
    turning_alarms: &[],
    systems: &[],
    radial_cycles: &[],
    live_taps: &[],
    second_spindle: &[],
    kind: None,
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "linuxcnc-mill",
};

pub(in crate::controls) const LEXICON: Lexicon = Lexicon {
    parenthesis: ParenthesisComment::Closed,
    strict_comments: true,
    semicolon: Semicolon::Comment,
    star_comment: false,
    registers: false,
    macro_lines: false,
    blanks_in_numbers: true,
    o_words: true,
    program_heads: false,
    named_programs: false,
    polar_words: true,
    channels: false,
    grammar: &MacroGrammar::LINUXCNC,
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

//! Fadal CNC 88, Format 1 and 2.

mod alarms;
mod codes;
mod macros;
mod post;
mod recognition;
mod rules;
mod settings;

use crate::vocabulary::*;
use chordal_machine::AXIS_LETTERS;

/// Fadal CNC 88, Format 1 and 2.
pub static TABLE: ControlTable = ControlTable {
    name: "fadal",
    title: "Fadal CNC 88",
    source: "Fadal User Manual (April 2003) sections 10, 13, 15, 18; Fadal code card",
    lexicon: LEXICON,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    alarms: alarms::ALARMS,
    scale_unit: 1.0,
    motion: MotionModality::Armed,
    distance_left_to_right: true,
    line_repeat: LineRepeat::MainProgram,
    subroutines: SubroutineForm::LetterL,
    fixed_routines: FIXED_ROUTINES,
    axis_letters: AXIS_LETTERS,
    arc_turns: ArcTurns::None,
    strict_center_words: false,
    set_data: SET_DATA,
    dwell: DWELL,
    dwell_alone_stops: false,
    order: BlockOrder {
        steps: BUILDER_STEPS,
        source: "usual; which M codes act after the motion was not found in the manual",
        certainty: Certainty::Trade,
    },
    open_m_codes: false,
    last_of_group_counts: false,
    alone: &[530, 920],
    firmware: None,
    command_line: None,
    word_rules: &[],
    spatial: None,
    face: None,
    cylinder: None,
    work_names: WorkNaming { extended: "E", first: 1, by_e: true },
    program_numbers: ProgramNumbers { largest: 9999, digits: 1, required: false },
    call_start_label: None,
    macros: &macros::MACROS,
    turning_alarms: &[],
    systems: &[],
    radial_cycles: &[],
    live_taps: &[],
    second_spindle: &[],
    kind: None,
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "fadal-4020",
};

const LEXICON: Lexicon = Lexicon {
    parenthesis: ParenthesisComment::ToEndOfLine,
    strict_comments: false,
    semicolon: Semicolon::EndOfBlock,
    star_comment: true,
    registers: true,
    macro_lines: true,
    blanks_in_numbers: false,
    o_words: false,
    program_heads: true,
    named_programs: false,
    polar_words: false,
    channels: false,
    grammar: &MacroGrammar::FADAL,
};

const SET_DATA: &[(u16, DataTarget)] = &[
    (2, DataTarget::WorkOffset),
    (10, DataTarget::Tool(ToolValue::Length)),
    (12, DataTarget::Tool(ToolValue::Radius)),
    (13, DataTarget::IntoRegister),
    (14, DataTarget::IntoRegister),
    (15, DataTarget::IntoRegister),
    (100, DataTarget::Register),
    (101, DataTarget::Register),
    (102, DataTarget::Register),
    (103, DataTarget::Register),
    (104, DataTarget::Register),
    (105, DataTarget::Register),
    (106, DataTarget::Register),
    (107, DataTarget::Register),
    (108, DataTarget::Register),
    (109, DataTarget::Register),
];

const DWELL: &[DwellWord] = &[DwellWord { letter: b'P', integer_s: 0.001, point_s: 0.001, takes_point: true }];

/// User Manual (April 2003), sections 6 and 18.
const FIXED_ROUTINES: &[(u32, FixedRoutine)] = &[
    (91, FixedRoutine::Probe),
    (92, FixedRoutine::Engrave),
    (93, FixedRoutine::BoltCircle),
    (94, FixedRoutine::Bore(TurnDirection::Ccw)),
    (95, FixedRoutine::Bore(TurnDirection::Cw)),
    (96, FixedRoutine::Rectangle(TurnDirection::Ccw)),
    (97, FixedRoutine::Rectangle(TurnDirection::Cw)),
    (98, FixedRoutine::Circle(TurnDirection::Ccw)),
    (99, FixedRoutine::Circle(TurnDirection::Cw)),
];

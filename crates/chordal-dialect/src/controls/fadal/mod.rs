//! Fadal CNC 88, Format 1 and 2.

mod alarms;
mod codes;
mod macros;
mod post;
mod recognition;
mod rules;
mod settings;

use crate::vocabulary::*;

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
    motion: MotionModality::Armed,
    distance_left_to_right: true,
    line_repeat: LineRepeat::MainProgram,
    subroutines: SubroutineForm::LetterL,
    fixed_routines: FIXED_ROUTINES,
    set_data: SET_DATA,
    dwell: DWELL,
    order: BlockOrder {
        steps: BUILDER_STEPS,
        source: "usual; which M codes act after the motion was not found in the manual",
        certainty: Certainty::Practice,
    },
    alone: &[530, 920],
    work_names: WorkNaming { extended: "E", first: 1, by_e: true },
    program_numbers: ProgramNumbers { largest: 9999, digits: 1, required: false },
    macros: &macros::MACROS,
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "fadal-4020",
    ..ControlTable::COMMON
};

const LEXICON: Lexicon = Lexicon {
    parenthesis: ParenthesisComment::ToEndOfLine,
    star_comment: true,
    registers: true,
    macro_lines: true,
    named_programs: false,
    grammar: &macros::GRAMMAR,
    ..Lexicon::COMMON
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

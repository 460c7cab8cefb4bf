//! Haas mill, NGC.

use chordal_diagnostics::Code;
use chordal_machine::AXIS_LETTERS;
use chordal_syntax::{Lexicon, MacroGrammar};

mod codes;
mod settings;

use self::codes::{G_CODES, M_CODES};
use self::settings::SETTINGS;
use super::compensation;
use crate::command::RapidPath;
use crate::cycle_rules::{
    BoreRules, CycleRules, DefinitionFires, FiringWords, MissingLevel, PeckDwell, PeckRules,
    ShiftWords, TapRules, ZeroRepeats,
};
use crate::parameters::{CenterAndRadius, DecimalPoint, OffsetKind, Parameters};
use crate::path_modes::PathRules;
use crate::table::{
    ArcTurns, ControlTable, DataTarget, DwellWord, Evidence, LineRepeat, MotionModality,
    ProgramNumbers, Sign, Subroutines,
};

/// Haas mill, NGC.
pub static HAAS: ControlTable = ControlTable {
    name: "haas",
    title: "Haas NGC mill",
    source: "Haas Mill NGC Operator's Manual (2017)",
    lexicon: LEXICON,
    g_codes: G_CODES,
    m_codes: M_CODES,
    parameters: PARAMETERS,
    settings: SETTINGS,
    alarms: ALARMS,
    motion: MotionModality::Exclusive,
    distance_left_to_right: false,
    line_repeat: LineRepeat::Anywhere,
    subroutines: Subroutines::None,
    axis_letters: AXIS_LETTERS,
    work_offset_by_e: false,
    arc_turns: ArcTurns::None,
    strict_center_words: true,
    set_data: SET_DATA,
    dwell: DWELL,
    last_of_group_counts: false,
    alone: &[],
    spindle_stops_at_tool_change: true,
    extended_offset_code: "G154",
    program_numbers: ProgramNumbers { largest: 99999, digits: 5, required: true },
    call_start_label: None,
    macros: &super::macro_b::HAAS,
    evidence: EVIDENCE,
};

const LEXICON: Lexicon = Lexicon { grammar: &MacroGrammar::HAAS, ..Lexicon::FANUC_STYLE };

const PARAMETERS: Parameters = Parameters {
    decimal_point: DecimalPoint::LeastIncrement,
    center_and_radius: CenterAndRadius::RadiusWins,
    rapid: RapidPath::DogLeg,
    radius_offsets: OffsetKind::Diameter,
    nesting: 9,
    max_repeats: 99,
    chip_break_mm: 0.508,
    peck_clearance_mm: 0.508,
    length_must_match_tool: true,
    bare_home_moves_all: true,
    return_label_in_callee: true,
    preset_clears_shift: true,
    cycles: CYCLES,
    compensation: compensation::HAAS,
    path: PATH,
    ..Parameters::COMMON
};

// Setting 85 is 0.025 in; what the levels of smoothness make of it is a choice.
const PATH: PathRules = PathRules {
    rounding_mm: Some(0.635),
    level_parts: [1.0, 0.5, 0.2],
    level: 2,
    ..PathRules::COMMON
};

const CYCLES: CycleRules = CycleRules {
    fires_on: FiringWords::Place,
    // Setting 28 on.
    definition: DefinitionFires::Always,
    missing_r: MissingLevel::Current,
    zero_repeats: ZeroRepeats::PlaceOnly,
    dwell_point_s: 1.0,
    peck: PeckRules {
        decreasing: true,
        return_after_k: true,
        dwell: PeckDwell::Bottom,
        ..CycleRules::COMMON.peck
    },
    tap: TapRules { out_factor_by_j: true, ..CycleRules::COMMON.tap },
    bore: BoreRules { shift: ShiftWords::QOrVector, ..CycleRules::COMMON.bore },
    ..CycleRules::COMMON
};

const SET_DATA: &[(u16, DataTarget)] = &[
    (2, DataTarget::WorkOffset),
    (10, DataTarget::Length),
    (11, DataTarget::LengthWear),
    (12, DataTarget::Radius),
    (13, DataTarget::RadiusWear),
    (20, DataTarget::ExtendedWorkOffset),
];

// With a point P is seconds, without one milliseconds.
const DWELL: &[DwellWord] = &[DwellWord { letter: b'P', integer_s: 0.001, point_s: 1.0 }];

const ALARMS: &[(Code, &str)] = &[
    (Code::InsideArcTooSmall, "alarm 342 CUTTER COMP PATH TOO SMALL"),
    (Code::CompensationInterference, "alarm 342 CUTTER COMP PATH TOO SMALL"),
    (Code::NoOffsetIntersection, "alarm 342 CUTTER COMP PATH TOO SMALL"),
    (Code::LeadInTooShort, "alarm 342 CUTTER COMP PATH TOO SMALL"),
    (Code::CompensationPlane, "alarm 344 cutter compensation with G18 and G19"),
    (Code::RadiusMismatch, "alarm 304 INVALID I, J, OR K IN G02 OR G03"),
    (Code::RadiusTooShort, "alarm 302 INVALID R CODE"),
    (Code::CenterOutsidePlane, "alarm 303 INVALID X, Y, OR Z IN G02 OR G03"),
    (
        Code::CompensationOnArc,
        "alarm 340 or 341 cutter compensation beginning or ending with G02 or G03",
    ),
    (Code::PlaneChangeInCompensation, "alarm 344 cutter compensation with G18 and G19"),
    (Code::ProgramWithoutEnd, "alarm 312 PROGRAM END"),
    (Code::LengthOffsetOfOtherTool, "alarm 332 H and T not matched"),
    (Code::PocketWithoutGeometry, "alarm 314 SUBPROGRAM NOT IN MEMORY"),
    (Code::PocketGeometry, "alarm 370 POCKET DEFINITION ERROR"),
    (Code::BadVariable, "503"),
    (Code::UnbalancedBrackets, "504"),
    (Code::DivisionByZero, "508"),
    (Code::BadExpression, "510"),
    (Code::LoopMismatch, "524"),
    (Code::BadArgument, "529"),
    (Code::MacroNesting, "531"),
    (Code::BadOutput, "535"),
];

const EVIDENCE: &[Evidence] = &[
    Evidence { sign: Sign::G(1540), weight: 8, reason: "G154 chooses an extended work offset" },
    Evidence { sign: Sign::G(1870), weight: 6, reason: "G187 sets smoothness" },
    Evidence { sign: Sign::G(1500), weight: 6, reason: "G150 mills a pocket" },
    Evidence { sign: Sign::G(1030), weight: 6, reason: "G103 limits look-ahead" },
    Evidence { sign: Sign::M(970), weight: 4, reason: "M97 calls within the program" },
    Evidence {
        sign: Sign::MachineCoordinatesWithOthers,
        weight: 4,
        reason: "G53 G49 in one block",
    },
    Evidence { sign: Sign::FiveDigitProgram, weight: 3, reason: "a program number of five digits" },
    Evidence { sign: Sign::G(530), weight: 1, reason: "G53 homes an axis" },
];

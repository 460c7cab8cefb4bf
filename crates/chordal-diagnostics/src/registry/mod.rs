//! The codes of all diagnostics. A code never changes its meaning and is never used again.
//!
//! One file per family; each entry holds the number, the name, the severity, one line that
//! says what it is, and the text that `chordal explain` prints.

mod compensation;
mod cycles;
mod machine;
mod macros;
mod motion;
mod pockets;
mod program;
mod reading;
mod words;

use crate::Severity;

/// What the registry knows of a code.
#[derive(Clone, Copy, Debug)]
pub struct CodeInfo {
    /// The code itself.
    pub code: Code,
    /// Stable number, `CH401`.
    pub id: &'static str,
    /// Stable name, `radius-mismatch`.
    pub name: &'static str,
    /// Severity unless a control makes it another.
    pub severity: Severity,
    /// One line.
    pub summary: &'static str,
    /// Paragraphs: what it means, why it matters, what to do, an example.
    pub explanation: &'static str,
}

/// Declares the enum and checks at compile time that each variant has its entry.
macro_rules! codes {
    ($($variant:ident => $family:ident :: $entry:ident,)*) => {
        /// The code of a diagnostic.
        #[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
        #[allow(missing_docs, reason = "each entry of the registry is the documentation")]
        pub enum Code { $($variant,)* }

        impl Code {
            /// All codes in the order of their numbers.
            pub const ALL: &'static [Code] = &[$(Code::$variant,)*];

            /// Said once in a file: what holds for all its numbers.
            pub const fn is_said_once(self) -> bool {
                matches!(self, Code::ExcessDecimals)
            }

            /// What the registry knows of it.
            pub fn info(self) -> &'static CodeInfo {
                match self { $(Code::$variant => &$family::$entry,)* }
            }
        }
    };
}

codes! {
    BadNumber => reading::BAD_NUMBER,
    MissingAddress => reading::MISSING_ADDRESS,
    LetterForDigit => reading::LETTER_FOR_DIGIT,
    UnclosedComment => reading::UNCLOSED_COMMENT,
    UnexpectedCharacter => reading::UNEXPECTED_CHARACTER,
    RepeatedWord => reading::REPEATED_WORD,
    NotAProgram => reading::NOT_A_PROGRAM,
    EmptyProgram => reading::EMPTY_PROGRAM,
    MissingValue => reading::MISSING_VALUE,
    NestedComment => reading::NESTED_COMMENT,
    LooksLikeRemark => reading::LOOKS_LIKE_REMARK,
    MissingSubprogram => program::MISSING_SUBPROGRAM,
    MissingLabel => program::MISSING_LABEL,
    NestingTooDeep => program::NESTING_TOO_DEEP,
    EndlessLoop => program::ENDLESS_LOOP,
    ProgramWithoutEnd => program::PROGRAM_WITHOUT_END,
    RepeatNotAllowed => program::REPEAT_NOT_ALLOWED,
    CallNotAllowed => program::CALL_NOT_ALLOWED,
    ReturnWithoutCall => program::RETURN_WITHOUT_CALL,
    DuplicateProgram => program::DUPLICATE_PROGRAM,
    HeaderOutOfPlace => program::HEADER_OUT_OF_PLACE,
    BudgetReached => program::BUDGET_REACHED,
    ShopCodeRefused => program::SHOP_CODE_REFUSED,
    RepeatsStandStill => program::REPEATS_STAND_STILL,
    EndsElsewhere => program::ENDS_ELSEWHERE,
    UnknownCode => words::UNKNOWN_CODE,
    SameGroup => words::SAME_GROUP,
    BadWordValue => words::BAD_WORD_VALUE,
    UnusedWord => words::UNUSED_WORD,
    MissingDecimalPoint => words::MISSING_DECIMAL_POINT,
    NotSimulated => words::NOT_SIMULATED,
    NotAlone => words::NOT_ALONE,
    MissingWord => words::MISSING_WORD,
    NoSuchAxis => words::NO_SUCH_AXIS,
    ExcessDecimals => words::EXCESS_DECIMALS,
    TooManyDigits => words::TOO_MANY_DIGITS,
    RadiusMismatch => motion::RADIUS_MISMATCH,
    RadiusTooShort => motion::RADIUS_TOO_SHORT,
    FullCircleByRadius => motion::FULL_CIRCLE_BY_RADIUS,
    CenterOutsidePlane => motion::CENTER_OUTSIDE_PLANE,
    NoCenter => motion::NO_CENTER,
    MissingFeed => motion::MISSING_FEED,
    FeedOverLimit => motion::FEED_OVER_LIMIT,
    RadiusOverLimit => motion::RADIUS_OVER_LIMIT,
    CenterAndRadius => motion::CENTER_AND_RADIUS,
    SpiralTurns => motion::SPIRAL_TURNS,
    NoSpirals => motion::NO_SPIRALS,
    ZeroRadius => motion::ZERO_RADIUS,
    SpindleStopped => motion::SPINDLE_STOPPED,
    NearlyTangent => motion::NEARLY_TANGENT,
    RotaryOverLimit => motion::ROTARY_OVER_LIMIT,
    RotaryInArc => motion::ROTARY_IN_ARC,
    RapidAfterArc => motion::RAPID_AFTER_ARC,
    ClearanceInIncremental => motion::CLEARANCE_IN_INCREMENTAL,
    CompensationOnArc => compensation::ON_ARC,
    CompensationWithoutOffset => compensation::WITHOUT_OFFSET,
    PlaneChangeInCompensation => compensation::PLANE_CHANGE,
    CompensationAtEnd => compensation::AT_END,
    InsideArcTooSmall => compensation::INSIDE_ARC_TOO_SMALL,
    CompensationInterference => compensation::INTERFERENCE,
    NoOffsetIntersection => compensation::NO_INTERSECTION,
    LeadInTooShort => compensation::LEAD_IN_TOO_SHORT,
    SideChangeRefused => compensation::SIDE_CHANGE,
    CompensationPlane => compensation::PLANE,
    CompensationTwice => compensation::TWICE,
    NewOffsetRefused => compensation::NEW_OFFSET,
    LookAheadLost => compensation::LOOK_AHEAD_LOST,
    SpiralInCompensation => compensation::SPIRAL,
    ShiftInCompensation => compensation::SHIFT,
    InterferenceAvoided => compensation::AVOIDED,
    FullTurnLost => compensation::TURN_LOST,
    TooManyIdleBlocks => compensation::TOO_MANY_IDLE,
    ReferenceInCompensation => compensation::REFERENCE,
    ToolChangeInCompensation => compensation::TOOL_CHANGE,
    CutterGouges => compensation::GOUGE,
    CutterGougesAtLead => compensation::GOUGE_AT_LEAD,
    SideAmbiguous => compensation::SIDE_AMBIGUOUS,
    GougeSearchLimit => compensation::GOUGE_SEARCH_LIMIT,
    CompensationSideDoubtful => compensation::SIDE_DOUBTFUL,
    ContourNotChecked => compensation::NOT_CHECKED,
    FalseInterferenceAlarm => compensation::FALSE_ALARM,
    TravelExceeded => machine::TRAVEL_EXCEEDED,
    RapidIntoPart => machine::RAPID_INTO_PART,
    OffsetNotSet => machine::OFFSET_NOT_SET,
    LengthOffsetOfOtherTool => machine::LENGTH_OFFSET_OF_OTHER_TOOL,
    BadSetting => machine::BAD_SETTING,
    SpindleOverLimit => machine::SPINDLE_OVER_LIMIT,
    BadExpression => macros::BAD_EXPRESSION,
    UnbalancedBrackets => macros::UNBALANCED_BRACKETS,
    BracketsTooDeep => macros::BRACKETS_TOO_DEEP,
    UnsupportedMacro => macros::UNSUPPORTED_MACRO,
    BadStatement => macros::BAD_STATEMENT,
    BadVariable => macros::BAD_VARIABLE,
    ReadOnlyVariable => macros::READ_ONLY_VARIABLE,
    DivisionByZero => macros::DIVISION_BY_ZERO,
    OutsideDomain => macros::OUTSIDE_DOMAIN,
    NumberOverflow => macros::NUMBER_OVERFLOW,
    ConditionAsValue => macros::CONDITION_AS_VALUE,
    BadLoopNumber => macros::BAD_LOOP_NUMBER,
    LoopMismatch => macros::LOOP_MISMATCH,
    MacroNesting => macros::MACRO_NESTING,
    BadArgument => macros::BAD_ARGUMENT,
    MixedBlock => macros::MIXED_BLOCK,
    ProgramAlarm => macros::PROGRAM_ALARM,
    OutputLimit => macros::OUTPUT_LIMIT,
    BadOutput => macros::BAD_OUTPUT,
    SystemVariable => macros::SYSTEM_VARIABLE,
    WordRounded => macros::WORD_ROUNDED,
    UnsetName => macros::UNSET_NAME,
    ProgramStop => macros::PROGRAM_STOP,
    SkipAssumed => macros::SKIP_ASSUMED,
    DateNotSet => macros::DATE_NOT_SET,
    OutputClosed => macros::OUTPUT_CLOSED,
    NumberOutOfRange => macros::NUMBER_OUT_OF_RANGE,
    MacroLineTooLong => macros::MACRO_LINE_TOO_LONG,
    InputNotAnswered => macros::INPUT_NOT_ANSWERED,
    ProbeWithoutHit => macros::PROBE_WITHOUT_HIT,
    BadProbeMove => macros::BAD_PROBE_MOVE,
    CycleWithoutR => cycles::WITHOUT_R,
    CycleWithoutDepth => cycles::WITHOUT_DEPTH,
    CycleWithoutPeck => cycles::WITHOUT_PECK,
    CycleWithoutDwell => cycles::WITHOUT_DWELL,
    CycleWithoutLead => cycles::WITHOUT_LEAD,
    CycleLevels => cycles::LEVELS,
    CycleInCompensation => cycles::IN_COMPENSATION,
    NoCycle => cycles::NO_CYCLE,
    CycleZeroRepeats => cycles::ZERO_REPEATS,
    CycleInInverseTime => cycles::IN_INVERSE_TIME,
    CycleRotaryWord => cycles::ROTARY_WORD,
    TooManyPecks => cycles::TOO_MANY_PECKS,
    CycleNotDocumented => cycles::NOT_DOCUMENTED,
    NoMotionInForce => cycles::NO_MOTION,
    CycleSpindle => cycles::SPINDLE,
    CycleWithoutShift => cycles::WITHOUT_SHIFT,
    PatternWords => cycles::PATTERN_WORDS,
    CycleDepthIncremental => cycles::DEPTH_INCREMENTAL,
    ImproperFixedRoutine => pockets::IMPROPER_FIXED_ROUTINE,
    PocketTooSmall => pockets::TOO_SMALL,
    PocketWithoutDiameter => pockets::WITHOUT_DIAMETER,
    PocketWithoutGeometry => pockets::WITHOUT_GEOMETRY,
    PocketGeometry => pockets::GEOMETRY,
    PocketRefused => pockets::REFUSED,
    PocketRidges => pockets::RIDGES,
    PocketUnreached => pockets::UNREACHED,
    PocketPathAssumed => pockets::PATH_ASSUMED,
    InternalError => machine::INTERNAL_ERROR,
}

impl Code {
    /// Finds a code by its number (`CH401`, any case) or name (`radius-mismatch`).
    pub fn find(text: &str) -> Option<Code> {
        let matches = |code: &&Code| {
            let info = code.info();
            info.id.eq_ignore_ascii_case(text) || info.name.eq_ignore_ascii_case(text)
        };
        Code::ALL.iter().find(matches).copied()
    }

    /// The stable number, `CH401`.
    pub fn id(self) -> &'static str {
        self.info().id
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_names_are_unique_and_ordered() {
        let ids: Vec<_> = Code::ALL.iter().map(|c| c.id()).collect();
        assert!(ids.windows(2).all(|pair| pair[0] < pair[1]), "{ids:?}");
        let mut names: Vec<_> = Code::ALL.iter().map(|c| c.info().name).collect();
        names.sort_unstable();
        assert!(names.windows(2).all(|pair| pair[0] != pair[1]));
        for code in Code::ALL {
            assert_eq!(code.info().code, *code);
            assert!(!code.info().explanation.trim().is_empty());
        }
    }
}

//! What is known of each code, whichever control has it: a row for each.
//!
//! A row has the problems that the code can cause, the settings that change what it does, the meaning of its words, the
//! role of their numbers and an example. An editor explains a code by it, a transformation finds the words that are
//! lengths, and a conversion finds what may be left out. Each enum of codes has its rows in one file, by one exhaustive
//! `match`.

mod computed;
mod cycle;
mod mode;
mod motion;
mod once;
mod turning;

use chordal_diagnostics::Code;
use chordal_kernel::rules::{CycleFamily, CycleKind, TurnCycle};
use chordal_machine::AXIS_LETTERS;

use crate::action::{Action, AfterCode, BeforeCode, CallCode, LengthCode, ReadingCode};
use crate::parameters::Parameters;
use crate::settings::SettingField;
use crate::table::ControlTable;

pub use computed::dwell_text;
pub use cycle::cycle_word_role;
pub use turning::{TurnFacts, turn_facts};

/// What is known of a code.
#[derive(Clone, Copy, Debug)]
pub struct CodeFacts {
    /// The problems that it can cause by itself; its page shows their alarms.
    pub problems: &'static [Code],
    /// The settings that change what it does.
    pub settings: &'static [SettingField],
    /// What its words mean.
    pub words: WordMeanings,
    /// A block with it as a program would have it, in millimetres, with `{}` for the code itself. Empty for codes that stand
    /// alone, for those that need more than a block, and for those whose words depend on the control's table.
    pub example: &'static str,
    /// What the other words of its block are.
    pub block: BlockSort,
    /// Neither path nor time depends on it: a conversion leaves it out where the new control does not have it.
    pub may_be_left_out: bool,
}

/// What the words of a code mean.
#[derive(Clone, Copy, Debug)]
pub enum WordMeanings {
    /// Letters, and what each of them means. The first row with the letter counts; one without letters is for all of them.
    Rows(&'static [(&'static str, &'static str)]),
    /// The time of a dwell, in the control's units.
    Dwell,
    /// What the control writes with G10.
    Data,
    /// Centre, radius and turns, as the control reads them.
    Arc,
    /// Centre and turns of a spiral that has a code of its own.
    Spiral,
    /// Program and repeats, as the control reads them.
    Call,
    /// The letter switches look-ahead on with one of these values.
    LookAhead {
        /// The letter.
        letter: u8,
        /// The values.
        on: &'static [u32],
    },
    /// Those of a canned cycle, by its family and the rules of the control.
    Cycle(CycleKind),
    /// Those of a cycle of a lathe.
    Turning(TurnCycle),
}

/// What the words of a block with a code are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BlockSort {
    /// The words of a move.
    Move,
    /// Times.
    Dwell,
    /// Values that are written into tables.
    Data,
    /// Machine positions.
    Machine,
    /// Distances by which coordinates are shifted.
    Local,
    /// Arguments of a program.
    Arguments,
    /// Positions, and what says where the holes of a pattern are.
    Pattern,
    /// Positions, and sizes of a pocket.
    Pocket,
}

/// What the number of a word of a cycle is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CycleWordRole {
    /// The same as in a block with a move.
    Move,
    /// A length without a direction.
    Length,
    /// A length without a direction; without a decimal point it counts least increments.
    CountedLength,
    /// [`CountedLength`](Self::CountedLength) where the cycle takes two blocks; no length in its form with one block.
    CountedInTwoBlocks,
    /// A length where it is written with a point; otherwise a count.
    LengthByPoint,
    /// A distance along an axis, by its index.
    Distance(usize),
    /// The lead of a thread.
    Lead,
    /// A length or a direction: nothing but a shift certainly leaves it as it is.
    Doubtful,
    /// No length.
    Other,
}

/// A code of which nothing is known but what its row of the table says.
const PLAIN: CodeFacts = CodeFacts {
    problems: &[],
    settings: &[],
    words: WordMeanings::Rows(&[]),
    example: "",
    block: BlockSort::Move,
    may_be_left_out: false,
};

impl CodeFacts {
    const fn problems(self, problems: &'static [Code]) -> CodeFacts {
        CodeFacts { problems, ..self }
    }

    const fn settings(self, settings: &'static [SettingField]) -> CodeFacts {
        CodeFacts { settings, ..self }
    }

    const fn rows(self, rows: &'static [(&'static str, &'static str)]) -> CodeFacts {
        self.words(WordMeanings::Rows(rows))
    }

    const fn words(self, words: WordMeanings) -> CodeFacts {
        CodeFacts { words, ..self }
    }

    const fn example(self, example: &'static str) -> CodeFacts {
        CodeFacts { example, ..self }
    }

    const fn block(self, block: BlockSort) -> CodeFacts {
        CodeFacts { block, ..self }
    }

    const fn left_out(self) -> CodeFacts {
        CodeFacts { may_be_left_out: true, ..self }
    }
}

impl Action {
    /// What is known of the code on a control.
    pub fn facts(self, table: &ControlTable, parameters: &Parameters) -> CodeFacts {
        match self {
            Action::Reading(code) => reading(code),
            Action::Before(code) => before(code, table),
            Action::Mode(code) => mode::facts(code),
            Action::Length(code) => length(code),
            Action::Motion(code) => motion::facts(code, parameters),
            Action::Cycle(kind) => canned_cycle(kind),
            Action::Once(code) => once::facts(code, parameters),
            Action::After(code) => after(code),
            Action::Call(code) => call(code),
            Action::NoEffect | Action::NotSimulated | Action::NotFollowed => PLAIN,
        }
    }

    /// The meaning of a letter in its block; `None` where the word is accepted without effect on the path, or where no
    /// meaning is on record, as for codes that are not simulated.
    pub fn word_meaning(
        self,
        letter: u8,
        table: &ControlTable,
        parameters: &Parameters,
    ) -> Option<String> {
        computed::meaning(self.facts(table, parameters).words, letter, table, parameters)
    }
}

fn reading(code: ReadingCode) -> CodeFacts {
    match code {
        ReadingCode::Inch | ReadingCode::Millimetre => {
            PLAIN.settings(&[SettingField::UNITS, SettingField::UNIT_CODES])
        }
        ReadingCode::Absolute | ReadingCode::Incremental => {
            PLAIN.settings(&[SettingField::START_DISTANCE])
        }
        ReadingCode::SurfaceSpeed => PLAIN
            .problems(&[Code::SpeedWithoutLimit])
            .rows(&[("D", "limit of the spindle speed, rev/min")]),
        // Centres are written as each control reads them.
        ReadingCode::ArcCenterAbsolute | ReadingCode::ArcCenterIncremental => PLAIN.left_out(),
        ReadingCode::FeedPerTime
        | ReadingCode::FeedInverseTime
        | ReadingCode::FeedPerRevolution
        | ReadingCode::Diameters
        | ReadingCode::Radii
        | ReadingCode::SpindleRpm => PLAIN,
    }
}

fn before(code: BeforeCode, table: &ControlTable) -> CodeFacts {
    match code {
        BeforeCode::ToolChange => {
            PLAIN.problems(&[Code::ToolChangeInCompensation]).example("T2 {}")
        }
        BeforeCode::SetToolNumber => PLAIN
            .problems(&[Code::ToolChangeInCompensation])
            .rows(&[("Q", "number of the tool in the spindle")]),
        BeforeCode::SaveModes { .. } | BeforeCode::RestoreModes | BeforeCode::ForgetModes => {
            PLAIN.problems(&[Code::NoKeptModes])
        }
        BeforeCode::SpindleOrient => {
            PLAIN.rows(&[("RP", "angle, in degrees; it does not change the path")])
        }
        BeforeCode::LiveToolCw | BeforeCode::LiveToolCcw => PLAIN
            .rows(&[("P", "speed of the live tool, revolutions per minute")])
            .example("{} P1500"),
        // In a command line the code begins the line.
        BeforeCode::SpindleCw | BeforeCode::SpindleCcw => {
            PLAIN.example(if table.command_line.is_some() { "{} S1000" } else { "S1000 {}" })
        }
        BeforeCode::CAxisOn
        | BeforeCode::CoolantMist
        | BeforeCode::CoolantFlood
        | BeforeCode::CoolantThroughTool => PLAIN,
    }
}

fn length(code: LengthCode) -> CodeFacts {
    match code {
        LengthCode::Plus | LengthCode::Minus => PLAIN
            .problems(&[Code::OffsetNotSet, Code::LengthOffsetOfOtherTool, Code::TipDisplaced])
            .settings(&[SettingField::LENGTH_MUST_MATCH_TOOL, SettingField::LENGTH_BY_H_ALONE])
            .rows(&[("H", "number of the length offset")])
            .example("{} H1 Z30."),
        LengthCode::ToolCenter => PLAIN
            .problems(&[
                Code::OffsetNotSet,
                Code::LengthOffsetOfOtherTool,
                Code::KinematicsNotKnown,
                Code::TipFeedTooFast,
            ])
            .settings(&[SettingField::LENGTH_MUST_MATCH_TOOL])
            .rows(&[("H", "number of the length offset")])
            .example("{} H1 Z30."),
        LengthCode::AlongTool => PLAIN
            .problems(&[
                Code::OffsetNotSet,
                Code::LengthOffsetOfOtherTool,
                Code::KinematicsNotKnown,
                Code::LengthAlongTool,
            ])
            .settings(&[SettingField::LENGTH_MUST_MATCH_TOOL])
            .rows(&[("H", "number of the length offset")]),
        LengthCode::ToolCenterByVector => PLAIN
            .problems(&[
                Code::OffsetNotSet,
                Code::LengthOffsetOfOtherTool,
                Code::KinematicsNotKnown,
                Code::ToolVector,
                Code::SwingingTool,
                Code::TipFeedTooFast,
            ])
            .settings(&[SettingField::LENGTH_MUST_MATCH_TOOL])
            .rows(&[
                ("H", "number of the length offset"),
                (
                    "I, J, K",
                    "direction from the tip to the holder, in this block and those after it",
                ),
            ])
            .example("{} H1 Z30."),
        LengthCode::Add => PLAIN
            .problems(&[Code::OffsetNotSet, Code::LengthOffsetOfOtherTool, Code::TipDisplaced])
            .rows(&[("H", "number of the tool whose offsets are added")]),
        LengthCode::FromAxes => PLAIN
            .problems(&[Code::TipDisplaced])
            .rows(&[(AXIS_LETTERS, "offset of the tool along this axis")]),
        LengthCode::Cancel => PLAIN.problems(&[Code::TipDisplaced]),
    }
}

fn canned_cycle(kind: CycleKind) -> CodeFacts {
    let facts = PLAIN.words(WordMeanings::Cycle(kind)).problems(&[
        Code::CycleWithoutR,
        Code::CycleWithoutDepth,
        Code::CycleWithoutPeck,
        Code::CycleWithoutDwell,
        Code::CycleWithoutLead,
        Code::CycleLevels,
        Code::CycleInCompensation,
        Code::CycleZeroRepeats,
        Code::CycleInInverseTime,
        Code::CycleRotaryWord,
        Code::TooManyPecks,
        Code::NoMotionInForce,
        Code::CycleSpindle,
        Code::CycleWithoutShift,
        Code::CycleDepthIncremental,
    ]);
    match kind.family() {
        CycleFamily::ChipBreak => facts.settings(&[SettingField::CHIP_BREAK]),
        CycleFamily::Peck => facts.settings(&[SettingField::PECK_CLEARANCE]),
        CycleFamily::Drill
        | CycleFamily::Tap
        | CycleFamily::Bore
        | CycleFamily::FineBore
        | CycleFamily::BackBore => facts,
    }
}

fn after(code: AfterCode) -> CodeFacts {
    match code {
        AfterCode::RunCycleHere => PLAIN.problems(&[Code::NoCycle]),
        AfterCode::ProgramEnd { .. } => PLAIN.problems(&[Code::CompensationAtEnd]),
        AfterCode::SpindleStop
        | AfterCode::LiveToolStop
        | AfterCode::CoolantOff
        | AfterCode::CoolantThroughToolOff
        | AfterCode::ProgramAgain
        | AfterCode::ProgramStop
        | AfterCode::OptionalStop
        | AfterCode::ShopCode => PLAIN,
    }
}

fn call(code: CallCode) -> CodeFacts {
    const CALL_PROBLEMS: &[Code] =
        &[Code::MissingSubprogram, Code::MissingLabel, Code::NestingTooDeep];
    const RETURN_PROBLEMS: &[Code] = &[Code::MissingLabel, Code::ReturnWithoutCall];
    const CALL_SETTINGS: &[SettingField] = &[SettingField::NESTING, SettingField::PACKED_CALLS];
    match code {
        CallCode::CallProgram => PLAIN
            .problems(CALL_PROBLEMS)
            .settings(CALL_SETTINGS)
            .words(WordMeanings::Call)
            .example("{} P1000"),
        CallCode::CallLabel => PLAIN
            .problems(CALL_PROBLEMS)
            .settings(CALL_SETTINGS)
            .rows(&[("P", "N number at which the call begins"), ("L", "how often it runs")])
            .example("{} P100"),
        CallCode::Return => PLAIN
            .problems(RETURN_PROBLEMS)
            .settings(&[SettingField::RETURN_LABEL_IN_CALLEE])
            .rows(&[("P", "N number in the calling program where it continues")]),
        CallCode::SubroutineEnd => PLAIN.problems(RETURN_PROBLEMS),
        CallCode::MacroCall | CallCode::ModalMacroCall { .. } => PLAIN
            .problems(&[
                Code::MissingSubprogram,
                Code::NestingTooDeep,
                Code::MacroNesting,
                Code::BadArgument,
            ])
            .rows(&[
                ("P", "number of the macro program"),
                ("L", "how often it runs"),
                ("", "argument: a local variable of the macro"),
            ])
            .example(if code == CallCode::MacroCall { "{} P1000 A1. B2." } else { "" })
            .block(BlockSort::Arguments),
    }
}

//! Runs an NC program the way its control would run it.
//!
//! A [`Job`] is a program and a machine. It answers every question that a shell (command line, editor server, page)
//! asks: the commands, the path, the summary, the diagnostics. It returns plain data; files, terminals and sockets
//! are the business of the shells.
//!
//! ```
//! use chordal::{Job, Machine, Source, SourceMap};
//!
//! let mut sources = SourceMap::new();
//! sources.add(Source::new("arc.nc", b"G20 G90 S900 M3\nG1 X0 Y0 F10.\nG3 X1. Y1. R1.\nM30\n".as_slice()));
//! let machine = Machine::from_builtin("haas-vf2").unwrap();
//! let job = Job::new(sources, machine).unwrap();
//! let report = job.report();
//! assert_eq!(report.summary.arcs, 1);
//! assert!((report.summary.feed_length_mm - 25.4 * std::f64::consts::FRAC_PI_2).abs() < 1e-9);
//! ```

#![forbid(unsafe_code)]

/// How a control interprets a program: its rules, its commands, and the run of a program.
pub mod control {
    pub use chordal_command::*;
    pub use chordal_dialect::*;
    pub use chordal_gcode::*;
    pub use chordal_kernel::rules::*;
    pub use chordal_kernel::{
        ANOTHER_KIND, AfterBlock, Alarms, Checkpoint, CompletedRun, ConfiguredControl,
        ControlCandidate, ControlProfile, CustomCode, DrilledHole, EndReason, EvidenceStrength,
        FoundSign, FrameKinds, HoleForm, HoleMotion, InterruptCheck, LiveTool, MIN_LIKELY_WEIGHT,
        Modal, MotionMode, Outcome, PostedKind, PostedProgram, PostedStep, ProgramName,
        ProgramPlace, ProgramSet, ProgramWriter, ProgrammingLanguage, Recognition, RestartFault,
        RestartObstacle, RestartedText, RunOptions, RunSink, SettingError, ShopAnswer, ShopCall,
        ShopCodes, ShopRecord, SplineForm, StartingModes, StateItem, StateValue, TappedHole,
        TextSymbol, TextSymbolKind, Token, TokenClass, ToolValue, TurnPass, UnrepeatedCode,
        VocabularyGroup, WordCompletion, WriterNote, WriterOptions, WrittenLine, WrittenOffset,
        WrittenProgram, is_same_level,
    };

    pub use crate::languages::{
        configured_control, control_profile, control_title, has_program_line, recognize,
        register_language, vocabulary_groups, word_meanings,
    };
}

pub mod collision;
mod comp_range;
mod compensation_sink;
mod first_cut;
mod job;
mod languages;
pub mod motion;
mod other_sides;
mod premises;
mod reading;
mod recheck;
mod report;
pub mod stock;
mod summary;
pub mod time;
pub mod tool_comments;

pub use chordal_diagnostics as diagnostics;
pub use chordal_geometry as geometry;
pub use chordal_machine as machine;
pub use chordal_path as path;
pub use chordal_syntax as syntax;

pub use chordal_command::{Command, CommandKind, Effect, Sink};
pub use chordal_diagnostics::{Code, Diagnostic, Severity, Source, SourceMap, Span};
pub use chordal_dialect::Control;
pub use chordal_kernel::{
    CustomCode, Outcome, RunOptions, RunSink, ShopAnswer, ShopCall, ShopCodes, ShopRecord,
};
pub use chordal_machine::Machine;
pub use chordal_path::{
    BlockRole, CompensationCurve, ContourPiece, PathCommand, PathSink, Segment, SegmentKind,
};
pub use comp_range::{ContourRange, ContourRanges, ControlLimit, OffsetLimit};
pub use job::{Job, JobError};
pub use other_sides::{AlternativeRun, BlockDeleteRuns, MAX_SIDE_RUNS, MAX_STOCK_SIDE_RUNS};
pub use reading::{
    AssumedSetting, ChoiceDifference, ProgramReading, ReadingChoice, ReadingChoices,
};
pub use recheck::CheckMemory;
pub use report::{EVERY_PLACE, KEPT_PER_CODE, OtherSides, Report, RunWatch};
pub use summary::{AxisTravel, Summary, ToolUse};

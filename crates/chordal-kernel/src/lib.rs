//! What any numerical control does, and no text: state, offsets, motion, cycles, pockets.
//!
//! A language reads a program and passes values with their [`Statement`]; the [`Kernel`] moves the
//! machine and emits commands and problems into a sink. [`rules`] are plain data: how one control
//! differs from another.
//!
//! ```
//! use chordal_command::PathMode;
//! use chordal_kernel::rules::{PathRules, StartMode};
//!
//! // A rule is data: this control stops at the end of every block until a program says otherwise.
//! let rules = PathRules { start: StartMode::ExactStop, ..PathRules::COMMON };
//! assert_eq!(rules.start_mode(), PathMode::ExactStop);
//! ```
//!
//! `tests/made_up_language.rs` drives the kernel by a language of eleven words.

#![forbid(unsafe_code)]

mod checkpoint;
mod coordinates;
mod corner_fit;
mod corner_queue;
mod cycles;
mod fixture_offset;
mod frame_checks;
mod frame_codes;
pub mod frames;
mod kernel;
mod language;
mod modal;
mod modes;
mod motion;
pub mod offsets;
mod overrides;
mod part_frame;
mod path_mode;
mod pockets;
pub mod rules;
mod sink;
mod spindle_checks;
mod state;
pub mod state_items;
mod statement;
mod surface;
mod surface_codes;
mod turning;

pub use checkpoint::{Checkpoint, CheckpointMemory};
pub use chordal_kinematics::AngleSign;
pub use coordinates::ToolValue;
pub use corner_queue::{CornerForm, ProgrammedCorner};
pub use cycles::HoleWords;
pub use frames::{FrameKinds, Frames, PolarReading, PolarWords};
pub use kernel::{Alarms, Kernel, KernelMemory, KernelReports};
pub use language::{
    ANOTHER_KIND, CompletedRun, ConfiguredControl, ControlCandidate, ControlProfile, CoolantChange,
    CustomCode, DefinedTool, DrilledHole, EndReason, EvidenceStrength, FoundSign, HoleForm,
    HoleMotion, InterruptCheck, MIN_LIKELY_WEIGHT, Outcome, PostedKind, PostedProgram, PostedStep,
    ProgramName, ProgramPlace, ProgramSet, ProgramWriter, ProgrammingLanguage, Recognition,
    RestartFault, RestartObstacle, RestartedText, RunOptions, SettingError, ShopAnswer, ShopCall,
    ShopCodes, ShopRecord, StartingModes, TappedHole, TextSymbol, TextSymbolKind, Token,
    TokenClass, UnrepeatedCode, VocabularyGroup, WordCompletion, WriterNote, WriterOptions,
    WrittenLengths, WrittenLine, WrittenProgram, are_same_motions, is_same_level, plain_number,
    significant_number, time_number, written_effect,
};
pub use modal::{Modal, MotionMode};
pub use motion::{ArcWords, MisfitArc, SpiralWords, is_over};
pub use offsets::{CoordinatePresets, LengthOffset, Offsets, WrittenOffset};
pub use part_frame::TurnError;
pub use path_mode::PathState;
pub use pockets::{CirclesWords, MAX_RINGS, RegionWords, rings_to_depth, shapes};
pub use sink::{AfterBlock, RunSink};
pub use spindle_checks::hole_at_surface_speed;
pub use state::{
    CycleState, LiveTool, ModalMotion, OverrideState, SplineForm, StartAxes, State, ThreadMemory,
    TurnPass, TurningMemory, UnknownWords,
};
pub use state_items::{StateItem, StateValue};
pub use statement::{Statement, WordMeaning};
pub use surface::{SurfacePlane, SurfaceState};
pub use surface_codes::NewSurface;
pub use turning::{
    ContourEdge, ContourProfile, DescentFault, DescentWords, LineThreadWords, PeckWords,
    RoughWords, ThreadWords,
};

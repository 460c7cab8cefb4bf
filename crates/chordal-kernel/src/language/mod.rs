//! The interface between programming languages of controls and everything above them.
//!
//! Programs of word-address blocks and conversational programs (lines of plain-language text) are read
//! differently; what they make the machine do is the same. A language is a crate that implements three traits:
//!
//! - [`ProgrammingLanguage`]: its controls, the signs of its texts, and the control of a machine file;
//! - [`ConfiguredControl`]: one control with the settings of a machine, which opens texts;
//! - [`ProgramSet`]: the opened texts, which run, and answer the questions of editors.
//!
//! A control to which programs of other languages are converted has a [`ProgramWriter`] as well.
//!
//! A run drives the [`Kernel`](crate::Kernel). Whatever is above a language (checks, planner, stock, editors, reports)
//! uses these traits and needs to know no more of it.

mod configured_control;
mod custom_codes;
mod outcome;
mod posted_program;
mod program_set;
mod program_writer;
mod programming_language;
mod programs;
mod recognition;
mod restarted_text;
mod run_options;
mod tokens;
mod written_words;

pub use configured_control::{ConfiguredControl, ControlProfile, DefinedTool};
pub use custom_codes::{CustomCode, ShopAnswer, ShopCall, ShopCodes, ShopRecord};
pub use outcome::{CompletedRun, EndReason, Outcome};
pub use posted_program::{
    DrilledHole, HoleForm, HoleMotion, PostedKind, PostedProgram, PostedStep, StartingModes,
    TappedHole, are_same_motions, is_same_level,
};
pub use program_set::ProgramSet;
pub use program_writer::{ProgramWriter, WriterNote, WriterOptions, WrittenLine, WrittenProgram};
pub use programming_language::{ProgrammingLanguage, SettingError};
pub use programs::{ProgramName, ProgramPlace};
pub use recognition::{
    ANOTHER_KIND, ControlCandidate, EvidenceStrength, FoundSign, MIN_LIKELY_WEIGHT, Recognition,
};
pub use restarted_text::{RestartFault, RestartObstacle, RestartedText, UnrepeatedCode};
pub use run_options::{InterruptCheck, RunOptions};
pub use tokens::{TextSymbol, TextSymbolKind, Token, TokenClass, VocabularyGroup, WordCompletion};
pub use written_words::{
    CoolantChange, WrittenLengths, plain_number, significant_number, time_number, written_effect,
};

//! How a run ended, and what it leaves in addition to its commands.

use chordal_command::CallPaths;
use chordal_diagnostics::TextRange;

use super::programs::ProgramName;

/// How a run ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EndReason {
    /// The program says so (M2, M30).
    ProgramEnd,
    /// The text ended first.
    EndOfText,
    /// The main program returns (M99) and would begin again.
    Repeats,
    /// A jump to a label that does not exist.
    LostJump,
    /// The program stopped itself with an alarm (`#3000=1 (TEXT)`).
    Alarm,
    /// The budget was used up.
    Budget,
    /// The caller stopped it.
    Interrupted,
    /// It was not run: a macro without the program that calls it.
    NotRun,
}

/// What a run leaves in addition to its commands.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// How it ended.
    pub end: EndReason,
    /// Blocks carried out, repeats counted.
    pub blocks: u64,
    /// The chains of calls.
    pub calls: CallPaths,
    /// The called programs that were not found.
    pub missing_programs: Vec<ProgramName>,
}

/// A run that was not interrupted at a checkpoint.
#[derive(Clone, Debug)]
pub struct CompletedRun {
    /// How it ended, and its totals.
    pub outcome: Outcome,
    /// The part of the first text that was read after the last checkpoint in addition to the blocks in their
    /// order (for labels and subprograms); `None` when there is none.
    pub text_read: Option<TextRange>,
}

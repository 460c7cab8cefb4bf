//! The texts of a job, opened in their language.

use chordal_diagnostics::{Diagnostic, TextRange};

use super::outcome::CompletedRun;
use super::programs::ProgramPlace;
use super::restarted_text::{RestartFault, RestartedText};
use super::tokens::{TextSymbol, Token, WordCompletion};
use crate::checkpoint::Checkpoint;
use crate::sink::RunSink;

/// The programs of some texts on a machine, in the language of its control. The first text is the program that is
/// run; the others may contain its subprograms.
pub trait ProgramSet {
    /// The programs of all texts, in their order: those of the first text come first.
    fn programs(&self) -> &[ProgramPlace];

    /// The index of the program that a call with this number finds, preferably in the first text; `None` without one.
    fn find(&self, key: u32) -> Option<usize> {
        self.programs().iter().position(|program| program.key() == Some(key))
    }

    /// True for a program that cannot be run without its caller.
    fn needs_caller(&self, program: usize) -> bool {
        let _ = program;
        false
    }

    /// Problems of the programs' heads, such as a name that occurs twice.
    fn head_problems(&self) -> Vec<Diagnostic> {
        Vec::new()
    }

    /// Runs the program of an index, from its start or from a checkpoint, and emits its commands and problems into
    /// a sink. `None` when the sink stopped it at a checkpoint.
    fn run(
        &self,
        program: usize,
        from: Option<&Checkpoint>,
        sink: &mut dyn RunSink,
    ) -> Option<CompletedRun>;

    /// The first text so that the program of an index begins at a line of it, from 1; `None` where the language has no
    /// heads of its own.
    fn restarted(&self, program: usize, line: u32) -> Option<Result<RestartedText, RestartFault>> {
        let _ = (program, line);
        None
    }

    /// The tokens of a part of the first text, in order.
    fn tokens(&self, part: TextRange) -> Vec<Token>;

    /// The range of the word at a byte of the first text and its meaning in one line; `None` without a known word
    /// there.
    fn meaning(&self, at: u32) -> Option<(TextRange, String)>;

    /// The named places of the first text, in order.
    fn symbols(&self) -> Vec<TextSymbol> {
        Vec::new()
    }

    /// The words that can be written at a byte of the first text; empty when the language offers none.
    fn completions(&self, at: u32) -> Vec<WordCompletion> {
        let _ = at;
        Vec::new()
    }

    /// The first text with uniform spacing; `None` when the language has no formatter.
    fn formatted(&self) -> Option<String> {
        None
    }
}

//! The interface of a programming language of controls to everything above it.
//!
//! Programs of word-address blocks and conversational programs (lines of plain-language text) are read
//! differently; what they make the machine do is the same. A language reads a program and drives the
//! [`Kernel`](crate::Kernel). Libraries and tools use this trait and need to know no more of the language.

use chordal_command::CallPaths;
use chordal_diagnostics::{Span, TextRange};

use crate::checkpoint::Checkpoint;
use crate::sink::RunSink;

/// One of the programs of a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ProgramPlace {
    /// Its text.
    pub span: Span,
    /// Its number; `None` when it has none.
    pub number: Option<u32>,
    /// A run begins with it; the others run where they are called.
    pub is_main: bool,
}

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
    /// Numbers of called programs that were not found.
    pub missing_programs: Vec<u32>,
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

/// The class of a piece of text, for colours.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum TokenClass {
    /// A comment with its marks.
    Comment,
    /// `%`, folder lines, block delete.
    Mark,
    /// The head of a program.
    Program,
    /// A label: an N word.
    Label,
    /// A code that moves or sets a mode: G.
    GCode,
    /// A code that switches: M.
    MCode,
    /// An axis word: a coordinate.
    Axis,
    /// Feed and speed.
    Speed,
    /// Tools and their offsets.
    Tool,
    /// Any other word.
    Parameter,
    /// A variable or a register.
    Variable,
    /// A word of the language itself.
    Keyword,
    /// A number in a statement.
    Number,
    /// A text in a statement.
    Text,
    /// What cannot be read.
    Unknown,
}

impl TokenClass {
    /// All classes, in the order in which protocols number them.
    pub const ALL: [TokenClass; 15] = [
        TokenClass::Comment,
        TokenClass::Mark,
        TokenClass::Program,
        TokenClass::Label,
        TokenClass::GCode,
        TokenClass::MCode,
        TokenClass::Axis,
        TokenClass::Speed,
        TokenClass::Tool,
        TokenClass::Parameter,
        TokenClass::Variable,
        TokenClass::Keyword,
        TokenClass::Number,
        TokenClass::Text,
        TokenClass::Unknown,
    ];
}

/// A piece of text and its class.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Token {
    /// The text.
    pub range: TextRange,
    /// What it is.
    pub class: TokenClass,
}

/// A language, with the texts and the machine it works on. The first text is the program; the others
/// may contain its subprograms.
pub trait Language {
    /// The programs of the first text, in its order.
    fn programs(&self) -> Vec<ProgramPlace>;

    /// Runs one of them, from its start or from a checkpoint, and emits its commands and problems into a
    /// sink. `None` when the sink stopped it at a checkpoint.
    fn run(
        &self,
        program: usize,
        from: Option<&Checkpoint>,
        sink: &mut dyn RunSink,
    ) -> Option<CompletedRun>;

    /// The tokens of a part of the first text, in order.
    fn tokens(&self, part: TextRange) -> Vec<Token>;

    /// The range of the word at a byte of the first text and its meaning in one line; `None` without a known code there.
    fn meaning(&self, at: u32) -> Option<(TextRange, String)>;
}

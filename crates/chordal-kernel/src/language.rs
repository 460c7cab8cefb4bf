//! What a language of programs is to everything above it.
//!
//! A control whose programs are blocks of words and one whose programs are lines of text in words
//! of a language (conversational) differ in how they are read. What they make the machine do is one
//! thing. A language reads, and drives the [`Kernel`](crate::Kernel); a library or a tool that asks
//! through this trait needs to know no more of it.

use chordal_command::CallPaths;
use chordal_diagnostics::{Span, TextRange};

use crate::checkpoint::Checkpoint;
use crate::sink::RunSink;

/// A program of a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ProgramPlace {
    /// Where it stands.
    pub span: Span,
    /// Its number, where it has one.
    pub number: Option<u32>,
    /// A run begins with it; others are run where they are called.
    pub is_main: bool,
}

/// How a run ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EndReason {
    /// The program says so (M2, M30).
    ProgramEnd,
    /// The text ended first.
    EndOfText,
    /// The main program returns (M99): it would begin again.
    Repeats,
    /// A jump to a place that is not there.
    LostJump,
    /// The program stopped itself with an alarm (`#3000=1 (TEXT)`).
    Alarm,
    /// The budget was used up.
    Budget,
    /// Who ran it wanted it to end.
    Interrupted,
    /// It was not run: a macro without its caller.
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
    /// Numbers of called programs that were not there.
    pub missing_programs: Vec<u32>,
}

/// A run that came to its end.
#[derive(Clone, Debug)]
pub struct CompletedRun {
    /// What it leaves.
    pub outcome: Outcome,
    /// What of the first text was read after the last checkpoint, except the blocks in their order.
    pub text_read: Option<TextRange>,
}

/// What a piece of text is.
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
    /// Where to.
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

/// A language, with the texts and the machine that it is asked about. The first text is the
/// program; the others are where its subprograms may be.
pub trait Language {
    /// The programs of the first text, in its order.
    fn programs(&self) -> Vec<ProgramPlace>;

    /// Runs one of them, from a checkpoint on where one is given, and pushes its commands and
    /// problems into a sink. `None` when the sink has ended it at a checkpoint.
    fn run(
        &self,
        program: usize,
        from: Option<&Checkpoint>,
        sink: &mut dyn RunSink,
    ) -> Option<CompletedRun>;

    /// The pieces of a part of the first text, in its order, for colours.
    fn tokens(&self, part: TextRange) -> Vec<Token>;

    /// What stands at a byte of the first text, in one line for people.
    fn meaning(&self, at: u32) -> Option<(TextRange, String)>;
}

//! What an editor asks about a text: tokens for colours, symbols for the outline, completions.

use chordal_diagnostics::TextRange;

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

/// What a named place of a text is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum TextSymbolKind {
    /// A program.
    Program,
    /// A subprogram.
    Subprogram,
    /// A tool that goes into the spindle.
    Tool,
    /// A place to jump to, or the start of a part that is repeated.
    Label,
}

/// A named place of a text, for an outline.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TextSymbol {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: TextSymbolKind,
    /// The text that it names.
    pub range: TextRange,
    /// The text that belongs to it, from the start of `range` on. An editor folds it.
    pub body: TextRange,
}

/// Words of a language that belong together, for a reference page.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct VocabularyGroup {
    /// What they are: `Cycles`.
    pub title: &'static str,
    /// Each word, and what it does in one line.
    pub words: Vec<WordCompletion>,
}

/// A word that can be written at a place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct WordCompletion {
    /// The word.
    pub word: String,
    /// What it does, in one line.
    pub meaning: String,
}

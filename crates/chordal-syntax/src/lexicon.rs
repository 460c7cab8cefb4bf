//! How a control writes its text: comments, semicolons, registers.

use crate::expression::MacroGrammar;

/// How a `(` comment ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ParenthesisComment {
    /// At `)`, which must be on the same line.
    Closed,
    /// At the end of the line, with or without `)`.
    ToEndOfLine,
}

/// What a semicolon is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Semicolon {
    /// The end of the block; another block may follow on the line.
    EndOfBlock,
    /// A comment to the end of the line.
    Comment,
}

/// How a control writes its text. Part of the control's table; the reader knows no control.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Lexicon {
    /// How a `(` comment ends.
    pub parenthesis: ParenthesisComment,
    /// A `(` inside of a comment, whatever closes it, and a comment before an O word are errors (RS274/NGC).
    pub strict_comments: bool,
    /// What a semicolon is.
    pub semicolon: Semicolon,
    /// `*` starts a comment to the end of the line.
    pub star_comment: bool,
    /// `R` is followed by a register digit, a sign and a value (`R0+1.5`), and a word may
    /// take a register's value (`X+R3`).
    pub registers: bool,
    /// A line that begins with `#` is a macro line.
    pub macro_lines: bool,
    /// Blanks inside a number are skipped (`X1 2.5` is 12.5).
    pub blanks_in_numbers: bool,
    /// `O` words may be flow control (`o100 sub`), not only program heads.
    pub o_words: bool,
    /// `O1234` or `:1234` at the start of a line begins a program; where not, a file is one program.
    pub program_heads: bool,
    /// `<NAME>` heads a program too, and names one in a call (Fanuc 30i).
    pub named_programs: bool,
    /// `@` and `^` are words: a radius and an angle in the plane.
    pub polar_words: bool,
    /// `$2` heads the program of a channel, and `!2L1` waits for one.
    pub channels: bool,
    /// Expressions and macro statements.
    pub grammar: &'static MacroGrammar,
}

impl Lexicon {
    /// What most controls share: those whose programs have numbers and macro B.
    pub const COMMON: Lexicon = Lexicon {
        parenthesis: ParenthesisComment::Closed,
        strict_comments: false,
        semicolon: Semicolon::EndOfBlock,
        star_comment: false,
        registers: false,
        macro_lines: false,
        blanks_in_numbers: false,
        o_words: false,
        program_heads: true,
        named_programs: true,
        polar_words: false,
        channels: false,
        grammar: &MacroGrammar::MACRO_B,
    };
}

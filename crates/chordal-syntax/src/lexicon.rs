//! The lexical rules of a control: comments, semicolons, registers.

use crate::expression::MacroGrammar;

/// How a `(` comment ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ParenthesisComment {
    /// At `)`, which must be on the same line.
    Closed,
    /// At the end of the line, with or without `)`.
    ToEndOfLine,
}

/// The meaning of a semicolon.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Semicolon {
    /// The end of the block; another block may follow on the line.
    EndOfBlock,
    /// A comment to the end of the line.
    Comment,
}

/// The lexical rules of a control. They are part of the table of the control; the reader itself is the same for all.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Lexicon {
    /// How a `(` comment ends.
    pub parenthesis: ParenthesisComment,
    /// A `(` inside of a comment is an error, and so is a comment before an O word (RS274/NGC).
    pub strict_comments: bool,
    /// The meaning of a semicolon.
    pub semicolon: Semicolon,
    /// `*` starts a comment to the end of the line.
    pub star_comment: bool,
    /// `R` is followed by a register digit, a sign and a value (`R0+1.5`), and a word may have the value of a register
    /// (`X+R3`).
    pub registers: bool,
    /// A line that begins with `#` is a macro line.
    pub macro_lines: bool,
    /// Blanks inside a number are ignored (`X1 2.5` is 12.5).
    pub blanks_in_numbers: bool,
    /// `O` words may be flow control (`o100 sub`), not only program numbers.
    pub o_words: bool,
    /// `O1234` or `:1234` at the start of a line begins a program; otherwise a file is one program.
    pub program_heads: bool,
    /// `<NAME>` also begins a program, and names one in a call (Fanuc 30i).
    pub named_programs: bool,
    /// `@` and `^` are words: a polar radius and angle in the plane.
    pub polar_words: bool,
    /// `$2` begins the program of a channel, and `!2L1` waits for a channel.
    pub channels: bool,
    /// The grammar of expressions and macro statements.
    pub grammar: &'static MacroGrammar,
}

impl Lexicon {
    /// The rules of most controls: those with program numbers and macro B.
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

//! How a firmware reads a line as one command with its words (Marlin).
//!
//! The first letter of a line is that of its command. Anything else in the line that looks like a code is a word of
//! that command, and does nothing.

use crate::firmware::OptionalCodes;
use chordal_syntax::Letters;

/// How a firmware reads a line as one command.
#[derive(Clone, Copy, Debug)]
pub struct CommandLine {
    /// Letters that begin a command.
    pub commands: Letters,
    /// M codes that take the rest of their line as a text, in tenths.
    pub texts: &'static [u16],
    /// M codes that take words and then a text, in tenths.
    pub remarks: &'static [u16],
    /// G codes that act on the next command in the same line, in tenths.
    pub prefixes: &'static [u16],
    /// G codes whose axis words need no number, in tenths.
    pub bare_axes: &'static [u16],
    /// Letters that begin a line which continues the previous motion, in builds that keep the motion code.
    pub motion_words: Letters,
    /// Codes that depend on options of the build.
    pub optional: &'static [OptionalCodes],
    /// Codes of other controls that are ignored without a warning: the letter, and the code in tenths.
    pub ignored_codes: &'static [(u8, u16)],
    /// The answer to a line with an unknown command: what is before the text of the line, and what is after it.
    pub unknown: [&'static str; 2],
}

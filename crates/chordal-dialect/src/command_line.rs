//! How a firmware takes a line: as one command with its words (Marlin).
//!
//! The first letter of a line is that of its command. Whatever else has the form of a code in the line is a word of that
//! command, and does nothing.

use crate::firmware::OptionalCodes;
use chordal_syntax::Letters;

/// A line as one command.
#[derive(Clone, Copy, Debug)]
pub struct CommandLine {
    /// Letters that begin a command.
    pub commands: Letters,
    /// M codes that take the rest of their line as a text.
    pub texts: &'static [u16],
    /// M codes that take words, and after them a text.
    pub remarks: &'static [u16],
    /// G codes that act on the command after them in the same line.
    pub prefixes: &'static [u16],
    /// Codes whose axis words need no number, ten times the G number.
    pub bare_axes: &'static [u16],
    /// Letters that begin a line which goes on with the motion before it, where the build remembers that.
    pub motion_words: Letters,
    /// Codes that not every build has.
    pub optional: &'static [OptionalCodes],
    /// Codes of other controls that are not there, and are not missed: the letter, and ten times the number.
    pub not_missed: &'static [(u8, u16)],
    /// What it answers to a line whose command it does not have, before the text of the line and after it.
    pub unknown: [&'static str; 2],
}

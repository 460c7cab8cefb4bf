//! The programs of a text and their names.

use std::fmt;

use chordal_diagnostics::{FileId, Span, TextRange};

/// The name by which a program is called.
#[derive(Clone, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub enum ProgramName {
    /// A number: 1234 is `O1234`.
    Number(u32),
    /// A name, as the language compares it (in one case where case does not count).
    Text {
        /// The name.
        text: Box<str>,
        /// The number that represents it in calls; `None` where calls are compared with the name itself.
        key: Option<u32>,
    },
}

impl ProgramName {
    /// The number; `None` for a name.
    pub fn number(&self) -> Option<u32> {
        match self {
            ProgramName::Number(number) => Some(*number),
            ProgramName::Text { .. } => None,
        }
    }

    /// The number that calls have: that of the program, or the one that represents its name. `None` for other names.
    pub fn key(&self) -> Option<u32> {
        match self {
            ProgramName::Number(number) => Some(*number),
            ProgramName::Text { key, .. } => *key,
        }
    }
}

impl From<String> for ProgramName {
    fn from(text: String) -> ProgramName {
        ProgramName::Text { text: text.into(), key: None }
    }
}

impl fmt::Display for ProgramName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ProgramName::Number(number) => write!(f, "O{number}"),
            ProgramName::Text { text, .. } => f.write_str(text),
        }
    }
}

/// One of the programs of a job.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ProgramPlace {
    /// Its text; the first one is that of the program that is run.
    pub file: FileId,
    /// The name by which it is called; `None` when it has none.
    pub name: Option<ProgramName>,
    /// The text of its name; empty without one.
    pub head: TextRange,
    /// Its whole text.
    pub range: TextRange,
    /// Its first line, from 1.
    pub line: u32,
    /// A run begins with it; the others run where they are called. Never in other texts than the first.
    pub is_main: bool,
}

impl ProgramPlace {
    /// Its number; `None` when it has a name or nothing.
    pub fn number(&self) -> Option<u32> {
        self.name.as_ref().and_then(ProgramName::number)
    }

    /// The number that calls have; `None` when calls do not find it by a number.
    pub fn key(&self) -> Option<u32> {
        self.name.as_ref().and_then(ProgramName::key)
    }

    /// Where its name is.
    pub fn head_span(&self) -> Span {
        self.head.in_file(self.file)
    }

    /// Whether a byte of its text belongs to it.
    pub fn has(&self, offset: u32) -> bool {
        self.range.start <= offset && offset < self.range.end
    }
}

//! The severity of a problem.

/// The severity of a problem, ordered from note to error.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Severity {
    /// Information; nothing is wrong with the program.
    Note,
    /// The control would run the program, but it is probably not what was meant.
    Warning,
    /// The control would stop, or do something other than the text says.
    Error,
}

impl Severity {
    /// The word in messages: `error`, `warning` or `note`.
    pub const fn word(self) -> &'static str {
        match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

//! How bad a problem is.

/// How bad it is. The order is from mild to grave.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Severity {
    /// Something the reader should know; nothing is wrong with the program.
    Note,
    /// The control would run it, and it is probably not what was meant.
    Warning,
    /// The control would stop, or do something else than the text says.
    Error,
}

impl Severity {
    /// The word for people: `error`, `warning`, `note`.
    pub const fn word(self) -> &'static str {
        match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// Numbers that contradict each other.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct CalcError {
    /// What cannot be, with the numbers.
    pub message: String,
    /// What to do about it.
    pub help: String,
}

impl CalcError {
    /// An error from its two texts.
    pub fn new(message: impl Into<String>, help: impl Into<String>) -> CalcError {
        CalcError { message: message.into(), help: help.into() }
    }
}

//! Why a program could not be loaded.

use std::io;

use chordal::machine::MachineError;

/// Why a program or a machine could not be loaded. Problems inside a program are diagnostics instead.
#[derive(Debug, thiserror::Error)]
pub enum LoadError {
    /// A file or folder could not be read.
    #[error("cannot read {file}: {reason}")]
    Read {
        /// The file's name as the caller wrote it.
        file: String,
        /// The operating system's message, or one of this crate.
        reason: String,
    },
    /// A machine file, an assignment or a tool table is wrong.
    #[error("the machine cannot be used")]
    Machine(Vec<MachineError>),
    /// The request names something that does not exist, or a file that is not a program.
    #[error("{message}")]
    Request {
        /// What is wrong.
        message: String,
        /// What to do instead; `None` when there is no suggestion.
        help: Option<String>,
    },
}

impl LoadError {
    /// A file that could not be read.
    pub fn read(file: impl Into<String>, error: &io::Error) -> LoadError {
        LoadError::Read { file: file.into(), reason: reason(error) }
    }

    /// A wrong request, with a suggestion.
    pub(crate) fn wrong(message: impl Into<String>, help: impl Into<String>) -> LoadError {
        LoadError::Request { message: message.into(), help: Some(help.into()) }
    }
}

/// The operating system's message without its error number, such as "(os error 2)", which means nothing to a
/// machinist. The first letter is lowercase.
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let plain = text.rfind(" (os error ").map_or(text.as_str(), |at| &text[..at]);
    let mut chars = plain.chars();
    chars.next().map_or_else(String::new, |first| first.to_lowercase().chain(chars).collect())
}

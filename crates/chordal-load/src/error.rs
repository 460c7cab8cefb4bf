//! Why a program could not be loaded.

use std::io;

use chordal::machine::MachineError;

/// Why a program or a machine could not be loaded. Problems of programs are diagnostics, not this.
#[derive(Debug, thiserror::Error)]
pub enum LoadError {
    /// A file or folder could not be read.
    #[error("cannot read {file}: {reason}")]
    Read {
        /// Its name as the caller gave it.
        file: String,
        /// The system's word, or ours.
        reason: String,
    },
    /// A machine file, an assignment or a tool table is wrong.
    #[error("the machine cannot be used")]
    Machine(Vec<MachineError>),
    /// The request asks for something that is not there, or for a file that is no program.
    #[error("{message}")]
    Request {
        /// What does not go.
        message: String,
        /// What does.
        help: Option<String>,
    },
}

impl LoadError {
    /// A file that could not be read.
    pub fn read(file: impl Into<String>, error: &io::Error) -> LoadError {
        LoadError::Read { file: file.into(), reason: reason(error) }
    }

    /// A wrong request and what to ask for instead.
    pub(crate) fn wrong(message: impl Into<String>, help: impl Into<String>) -> LoadError {
        LoadError::Request { message: message.into(), help: Some(help.into()) }
    }
}

/// The system's message without its number: "(os error 2)" helps nobody at a machine.
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let plain = text.rfind(" (os error ").map_or(text.as_str(), |at| &text[..at]);
    let mut chars = plain.chars();
    chars.next().map_or_else(String::new, |first| first.to_lowercase().chain(chars).collect())
}

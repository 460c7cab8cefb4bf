//! Exit codes, and why a command could not do its work.

use std::io;

use chordal_load::{LoadError, reason};

/// How a command ended, from good to bad: its exit code.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum ExitVerdict {
    /// Nothing to complain of.
    Clean,
    /// Problems in a program.
    Problems,
    /// Wrong use, or a file that cannot be read or written.
    Trouble,
}

/// Why something could not be done at all. Problems of programs are diagnostics, not this.
#[derive(Debug, thiserror::Error)]
pub enum CommandFailure {
    /// A program or a machine could not be loaded, or another file not be read.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// A file could not be written.
    #[error("cannot write {file}: {reason}")]
    Write {
        /// Its name as the user gave it.
        file: String,
        /// The system's word.
        reason: String,
    },
    /// Standard output went away or is full.
    #[error("cannot write to standard output: {}", reason(.0))]
    Out(io::Error),
    /// The command line asks for something that does not go.
    #[error("{message}")]
    Use {
        /// What does not go.
        message: String,
        /// What does.
        help: Option<String>,
    },
}

/// What could not be written to a file, where an error passes through what does not know where it writes.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {file}: {error}")]
pub struct OfFile {
    /// The name as the user gave it.
    pub file: String,
    /// The system's word.
    pub error: io::Error,
}

impl From<io::Error> for CommandFailure {
    /// What knows its file is of that file, all else of standard output.
    fn from(error: io::Error) -> CommandFailure {
        match error.get_ref().and_then(|inner| inner.downcast_ref::<OfFile>()) {
            Some(OfFile { file, error }) => CommandFailure::write(file.as_str(), error),
            None => CommandFailure::Out(error),
        }
    }
}

impl CommandFailure {
    /// A file that could not be read.
    pub fn read(file: impl Into<String>, error: &io::Error) -> CommandFailure {
        LoadError::read(file, error).into()
    }

    /// A file that could not be written.
    pub fn write(file: impl Into<String>, error: &io::Error) -> CommandFailure {
        CommandFailure::Write { file: file.into(), reason: reason(error) }
    }

    /// A wrong use and what to do instead.
    pub fn wrong(message: impl Into<String>, help: impl Into<String>) -> CommandFailure {
        CommandFailure::Use { message: message.into(), help: Some(help.into()) }
    }

    /// Whoever read our output has enough of it: nothing to report.
    pub fn is_closed_pipe(&self) -> bool {
        matches!(self, CommandFailure::Out(error) if error.kind() == io::ErrorKind::BrokenPipe)
    }

    /// What the process ends with.
    pub fn verdict(&self) -> ExitVerdict {
        if self.is_closed_pipe() { ExitVerdict::Clean } else { ExitVerdict::Trouble }
    }
}

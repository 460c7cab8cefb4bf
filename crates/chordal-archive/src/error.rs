//! Why an archive could not be checked at all.

use std::io;
use std::path::{Path, PathBuf};

/// Why an archive could not be done. What is wrong with one of its files is a row of the table.
#[derive(Debug, thiserror::Error)]
pub enum ArchiveError {
    /// A file or folder of the result or of its journal.
    #[error("cannot write {}: {error}", .path.display())]
    Write {
        /// Which.
        path: PathBuf,
        /// The system's word.
        error: io::Error,
    },
    /// A record of the journal is gone or changed while the table was being written.
    #[error("the journal {} has no complete record of {file}; start again, and the file will be checked again", .path.display())]
    Journal {
        /// The journal's folder.
        path: PathBuf,
        /// The file of the archive whose record is missing.
        file: String,
    },
}

impl ArchiveError {
    pub(crate) fn write(path: &Path) -> impl Fn(io::Error) -> ArchiveError + '_ {
        |error| ArchiveError::Write { path: path.to_path_buf(), error }
    }
}

//! Errors that stop the check of a whole archive.

use std::io;
use std::path::{Path, PathBuf};

/// Why an archive could not be checked. A problem with a single file is a row of the table instead.
#[derive(Debug, thiserror::Error)]
pub enum ArchiveError {
    /// A file or folder of the result or of its journal could not be written.
    #[error("cannot write {}: {error}", .path.display())]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// The error of the operating system.
        error: io::Error,
    },
    /// A record of the journal is missing or was changed while the table was being written.
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

//! Whether a file has changed.

use std::fs;
use std::path::PathBuf;
use std::time::SystemTime;

/// A file as a look at it shows it.
#[derive(Clone, PartialEq)]
pub struct FileStamp {
    path: PathBuf,
    /// Length and time; nothing where there is no file.
    found: Option<(u64, Option<SystemTime>)>,
}

impl FileStamp {
    /// A file as it is now.
    pub fn of(path: PathBuf) -> FileStamp {
        let about = fs::metadata(&path).ok();
        let found = about.map(|about| (about.len(), about.modified().ok()));
        FileStamp { path, found }
    }
}

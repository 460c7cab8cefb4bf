//! The file on disk: detects changes, and writes it completely or not at all.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::time::SystemTime;

use chordal_files::FileDraft;
use chordal_view::ProgramRefusal;

/// The length and the modification time of a file: cheap to read, and sufficient to notice most changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ServedFileStamp {
    length: u64,
    modified: Option<SystemTime>,
}

impl ServedFileStamp {
    /// The current stamp of a file; `None` when there is no file.
    pub fn of(path: &Path) -> Option<ServedFileStamp> {
        let about = fs::metadata(path).ok()?;
        Some(ServedFileStamp { length: about.len(), modified: about.modified().ok() })
    }
}

/// Saves a program of a [`ProgramSource`](chordal_view::ProgramSource) to its file.
///
/// # Errors The file cannot be written; it is then unchanged.
pub fn save(path: &Path, bytes: &[u8]) -> Result<(), ProgramRefusal> {
    write(path, bytes).map_err(|error| ProgramRefusal {
        message: format!("cannot write {}: {error}", path.display()),
        help: Some("the file was not changed".into()),
    })
}

/// Writes a file completely or not at all. The old content stays on the disk until the new one is complete.
fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut draft = FileDraft::open(path)?;
    draft.write_all(bytes)?;
    draft.flush()?;
    if chordal_files::is_regular(path) {
        draft.file().sync_all()?;
    }
    draft.put()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_whole_and_a_failure_leaves_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("part.nc");
        fs::write(&path, "old").unwrap();
        let before = ServedFileStamp::of(&path);
        write(&path, b"new text").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new text");
        assert_ne!(ServedFileStamp::of(&path), before);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        assert!(write(folder.path(), b"x").is_err());
    }
}

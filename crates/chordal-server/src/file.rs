//! The file on disk: whether somebody may have changed it, and how it is written whole or not at all.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::time::SystemTime;

use chordal_view::Refusal;

/// What a look at a file gives for nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stamp {
    length: u64,
    modified: Option<SystemTime>,
}

impl Stamp {
    /// Of the file as it is; `None` where there is none.
    pub fn of(path: &Path) -> Option<Stamp> {
        let about = fs::metadata(path).ok()?;
        Some(Stamp { length: about.len(), modified: about.modified().ok() })
    }
}

/// Saves a program of [`chordal_view::Programs`] in its file.
///
/// # Errors
/// Why it is as before.
pub fn save(path: &Path, bytes: &[u8]) -> Result<(), Refusal> {
    write(path, bytes).map_err(|error| Refusal {
        message: format!("cannot write {}: {error}", path.display()),
        help: Some("the file was not changed".into()),
    })
}

/// Writes a file next to it and puts it in its place, with the permissions of the one before. A link
/// stays a link.
///
/// # Errors
/// Those of the file system; the file is then as before.
fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let mut file = tempfile::Builder::new()
        .prefix(".chordal-")
        .tempfile_in(folder.unwrap_or(Path::new(".")))?;
    file.write_all(bytes)?;
    if let Ok(about) = fs::metadata(&path) {
        file.as_file().set_permissions(about.permissions())?;
    }
    file.as_file().sync_all()?;
    file.persist(&path)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_whole_and_a_failure_leaves_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("part.nc");
        fs::write(&path, "old").unwrap();
        let before = Stamp::of(&path);
        write(&path, b"new text").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new text");
        assert_ne!(Stamp::of(&path), before);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        assert!(write(&folder.path().join("none/part.nc"), b"x").is_err());
    }
}

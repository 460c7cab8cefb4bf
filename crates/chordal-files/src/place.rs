//! Where a name leads: over links, to a file, a device or nothing yet.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Links that lead to links, at most; more lead in a circle.
const MAX_LINKS: usize = 40;

/// The name without links: of a file that is there, or of one that will be.
///
/// # Errors
/// Links in a circle, and a folder that cannot be read.
pub fn place_of(path: &Path) -> io::Result<PathBuf> {
    let mut place = path.to_path_buf();
    for _ in 0..MAX_LINKS {
        match fs::read_link(&place) {
            // What a link says is counted from its own folder.
            Ok(next) => place = folder_of(&place).join(next),
            Err(_) => {
                let name = place.file_name().map(PathBuf::from);
                return match (folder_of(&place).canonicalize(), name) {
                    (Ok(folder), Some(name)) => Ok(folder.join(name)),
                    _ => Ok(place),
                };
            }
        }
    }
    Err(io::Error::other("too many links that lead to each other"))
}

/// The folder that a file lies in.
pub(crate) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Nothing, or a file whose content can be put in its place as a whole: no device, no pipe, and none of the names
/// by which a process knows its own open files, such as `/dev/stdout`.
pub fn is_regular(path: &Path) -> bool {
    let is_system = |path: &Path| path.starts_with("/dev") || path.starts_with("/proc");
    if is_system(path) || place_of(path).is_ok_and(|place| is_system(&place)) {
        return false;
    }
    fs::metadata(path).map_or(true, |about| about.is_file())
}

/// Two names of one file; of files that are not there yet, one name in two forms.
pub fn is_same(one: &Path, other: &Path) -> bool {
    #[cfg(unix)]
    if let (Ok(one), Ok(other)) = (fs::metadata(one), fs::metadata(other)) {
        use std::os::unix::fs::MetadataExt;
        return (one.dev(), one.ino()) == (other.dev(), other.ino());
    }
    match (place_of(one), place_of(other)) {
        (Ok(one), Ok(other)) => one == other,
        _ => one == other,
    }
}

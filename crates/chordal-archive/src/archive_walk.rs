//! Lists the files of an archive.

use std::fs;
use std::path::{Path, PathBuf};

/// A file of an archive, or a folder that cannot be read: each gets a row.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ArchiveEntry {
    /// The path, beginning with the folder as the caller named it.
    pub path: PathBuf,
    /// Why a folder cannot be read; `None` for a file.
    pub failure: Option<String>,
}

/// All files of folder trees, and files named directly, sorted by the bytes of their paths and without duplicates.
/// Names that begin with a dot, links to folders, and the paths in `leave_out` are skipped.
pub fn walk(arguments: &[PathBuf], leave_out: &[PathBuf]) -> Vec<ArchiveEntry> {
    let left_out: Vec<PathBuf> =
        leave_out.iter().filter_map(|path| fs::canonicalize(path).ok()).collect();
    let mut entries = Vec::new();
    for argument in arguments {
        if argument.is_dir() {
            search(argument.clone(), &left_out, &mut entries);
        } else {
            entries.push(ArchiveEntry { path: argument.clone(), failure: None });
        }
    }
    entries.sort_by(|a, b| bytes(&a.path).cmp(bytes(&b.path)));
    entries.dedup_by(|a, b| a.path == b.path);
    entries
}

fn bytes(path: &Path) -> &[u8] {
    path.as_os_str().as_encoded_bytes()
}

fn search(folder: PathBuf, left_out: &[PathBuf], entries: &mut Vec<ArchiveEntry>) {
    // A list instead of recursion, because a tree may be deep.
    let mut folders = vec![folder];
    while let Some(folder) = folders.pop() {
        let listed = match fs::read_dir(&folder) {
            Ok(listed) => listed,
            Err(error) => {
                let failure = Some(format!("cannot read the folder: {error}"));
                entries.push(ArchiveEntry { path: folder, failure });
                continue;
            }
        };
        for found in listed.flatten() {
            if found.file_name().as_encoded_bytes().starts_with(b".") {
                continue;
            }
            let path = found.path();
            let Ok(kind) = found.file_type() else { continue };
            if is_left_out(&path, left_out) {
                continue;
            }
            if kind.is_dir() {
                folders.push(path);
            } else if kind.is_file() || (kind.is_symlink() && is_file_or_lost(&path)) {
                entries.push(ArchiveEntry { path, failure: None });
            }
        }
    }
}

/// Whether a link leads to a file or to nothing. A missing file is reported when it is read.
fn is_file_or_lost(link: &Path) -> bool {
    fs::metadata(link).map_or(true, |about| about.is_file())
}

/// Called for every file, so the name is compared before the path is resolved, which is slow.
fn is_left_out(path: &Path, left_out: &[PathBuf]) -> bool {
    left_out.iter().any(|own| {
        own.file_name() == path.file_name()
            && fs::canonicalize(path).is_ok_and(|whole| whole == *own)
    })
}

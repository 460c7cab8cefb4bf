//! Which files the current command has read and will write, so that it overwrites no input and writes no output
//! twice.
//!
//! Programs, subprograms, machine files and the files that these name are read in many places. All of them are read
//! through [`FileAccess`](crate::FileAccess) or [`ProgramText`](crate::ProgramText) and recorded here. Code that
//! writes a file checks this ledger first.

use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

#[cfg(unix)]
type FileIdentity = (u64, u64);
#[cfg(not(unix))]
type FileIdentity = std::path::PathBuf;

#[derive(Default)]
struct FileLedger {
    inputs: std::collections::BTreeSet<FileIdentity>,
    outputs: std::collections::BTreeSet<std::path::PathBuf>,
}

static LEDGER: Mutex<FileLedger> = Mutex::new(FileLedger {
    inputs: std::collections::BTreeSet::new(),
    outputs: std::collections::BTreeSet::new(),
});

fn ledger() -> MutexGuard<'static, FileLedger> {
    LEDGER.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(unix)]
fn identity(path: &Path) -> Option<FileIdentity> {
    use std::os::unix::fs::MetadataExt;
    let about = std::fs::metadata(path).ok()?;
    about.is_file().then(|| (about.dev(), about.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path) -> Option<FileIdentity> {
    path.canonicalize().ok()
}

/// Clears the ledger for a new command.
pub fn begin() {
    *ledger() = FileLedger::default();
}

/// Records that a file was read.
pub(crate) fn note_input(path: &Path) {
    if let Some(identity) = identity(path) {
        ledger().inputs.insert(identity);
    }
}

/// Whether the file was read, under this name or another one (a link).
pub fn is_input(path: &Path) -> bool {
    identity(path).is_some_and(|identity| ledger().inputs.contains(&identity))
}

/// Records that a file will be written; `false` when it was recorded before.
pub fn note_output(path: &Path) -> bool {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new(".")).canonicalize();
    // A link and its target are one file.
    let place = path.canonicalize().ok().or_else(|| Some(folder.ok()?.join(path.file_name()?)));
    ledger().outputs.insert(place.unwrap_or_else(|| path.to_path_buf()))
}

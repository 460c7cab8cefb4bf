//! What a command of this process has read and what it writes, so that no input is written over and no output twice.
//!
//! A program, its subprograms, its machine and the files that these name are read in many places. Each of them goes
//! through [`FileAccess`](crate::FileAccess) or [`ProgramText`](crate::ProgramText) and is noted here; whoever writes a file asks.

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

/// A new command begins: what the one before has read is nothing to it.
pub fn begin() {
    *ledger() = FileLedger::default();
}

/// A file was read.
pub(crate) fn note_input(path: &Path) {
    if let Some(identity) = identity(path) {
        ledger().inputs.insert(identity);
    }
}

/// The file was read, by this name or another.
pub fn is_input(path: &Path) -> bool {
    identity(path).is_some_and(|identity| ledger().inputs.contains(&identity))
}

/// A file is to be written; false where it is to be already.
pub fn note_output(path: &Path) -> bool {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new(".")).canonicalize();
    // A link and what it leads to are one file.
    let place = path.canonicalize().ok().or_else(|| Some(folder.ok()?.join(path.file_name()?)));
    ledger().outputs.insert(place.unwrap_or_else(|| path.to_path_buf()))
}

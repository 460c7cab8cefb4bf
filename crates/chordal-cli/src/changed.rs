//! Which files changed since a commit: git is asked.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use chordal_load::ProgramInput;

use crate::failure::CommandFailure;

/// The inputs whose files changed since a commit, or since it and the present commit parted: those
/// of the working tree, new ones that git does not ignore among them. Deleted files are none.
pub fn only_changed(
    inputs: Vec<ProgramInput>,
    commit: &str,
) -> Result<Vec<ProgramInput>, CommandFailure> {
    let mut roots: BTreeSet<PathBuf> = BTreeSet::new();
    let mut changed: BTreeSet<PathBuf> = BTreeSet::new();
    let mut kept = Vec::new();
    for input in inputs {
        let Some(path) = &input.path else {
            let help = "name files or folders of a git repository";
            return Err(CommandFailure::wrong("--changed-since cannot take standard input", help));
        };
        // What cannot be read is reported when it is to be run.
        let Ok(path) = path.canonicalize() else {
            kept.push(input);
            continue;
        };
        if !roots.iter().any(|root| path.starts_with(root)) {
            let root = top(path.parent().unwrap_or(&path))?;
            changed.extend(changes(&root, commit)?);
            roots.insert(root);
        }
        if changed.contains(&path) {
            kept.push(input);
        }
    }
    Ok(kept)
}

/// The top folder of the repository that a folder is in.
fn top(folder: &Path) -> Result<PathBuf, CommandFailure> {
    let noted = git(folder, ["rev-parse", "--show-toplevel"])?.ok_or_else(|| {
        let message = format!("{} is not in a git repository", folder.display());
        CommandFailure::wrong(message, "--changed-since asks git what changed")
    })?;
    let noted = noted.strip_suffix(b"\n").unwrap_or(&noted);
    let top = path(noted);
    Ok(top.canonicalize().unwrap_or(top))
}

/// The files of a repository that changed.
fn changes(root: &Path, commit: &str) -> Result<Vec<PathBuf>, CommandFailure> {
    let requested = format!("{commit}^{{commit}}");
    let known = git(root, ["rev-parse", "--verify", "--quiet", "--end-of-options", &requested])?;
    let known = known.and_then(|hash| String::from_utf8(hash).ok()).ok_or_else(|| {
        let message = format!("there is no commit `{commit}` in {}", root.display());
        CommandFailure::wrong(
            message,
            "a workflow has to check out the whole history: fetch-depth: 0",
        )
    })?;
    let known = known.trim();
    let base = git(root, ["merge-base", known, "HEAD"])?;
    let base = base.and_then(|hash| String::from_utf8(hash).ok());
    let base = base.as_deref().map_or(known, str::trim);
    let names = ["diff", "--name-only", "--no-renames", "-z", "--diff-filter=d", base, "--"];
    let mut files = listed(root, names)?;
    files.extend(listed(root, ["ls-files", "--others", "--exclude-standard", "-z"])?);
    Ok(files)
}

/// What git lists, each name ended by a zero.
fn listed<const N: usize>(root: &Path, words: [&str; N]) -> Result<Vec<PathBuf>, CommandFailure> {
    let noted = git(root, words)?.ok_or_else(|| {
        let message = format!("git {} failed in {}", words[0], root.display());
        CommandFailure::wrong(message, "run it there to see why")
    })?;
    let names = noted.split(|byte| *byte == 0).filter(|name| !name.is_empty());
    Ok(names.map(|name| root.join(path(name))).collect())
}

/// What git prints; nothing where it says no.
fn git<const N: usize>(folder: &Path, words: [&str; N]) -> Result<Option<Vec<u8>>, CommandFailure> {
    let run = Command::new("git").arg("-C").arg(folder).args(words).output();
    let done = run.map_err(|error: io::Error| {
        let message = format!("git cannot be started: {error}");
        CommandFailure::wrong(message, "--changed-since asks git what changed; install git")
    })?;
    Ok(done.status.success().then_some(done.stdout))
}

#[cfg(unix)]
fn path(name: &[u8]) -> PathBuf {
    use std::os::unix::ffi::OsStrExt;
    PathBuf::from(OsStr::from_bytes(name))
}

#[cfg(not(unix))]
fn path(name: &[u8]) -> PathBuf {
    PathBuf::from(OsStr::new(String::from_utf8_lossy(name).as_ref()))
}

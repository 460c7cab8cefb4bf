//! Finds program files.

use std::borrow::Cow;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use chordal::control::has_program_line;
use chordal::syntax::decode;

use crate::error::LoadError;
use crate::files::FileAccess;
use crate::not_a_program::is_other_file;

/// How much of a file in a folder is read to decide whether it is a program, bytes.
const SAMPLE: u64 = 16 * 1024;

/// File extensions that are found next to programs and never belong to a program.
const NOT_PROGRAMS: &[&str] = &[
    "toml", "md", "svg", "png", "jpg", "jpeg", "gif", "bmp", "dxf", "dwg", "step", "stp", "stl",
    "pdf", "html", "htm", "css", "xml", "csv", "json", "jsonl", "sarif", "canon", "parquet",
    "arrow", "yaml", "yml", "ini", "hal", "tbl", "var", "log", "py", "rs", "js", "ts", "sh", "bat",
    "ps1", "zip", "gz", "7z", "exe", "dll", "lock",
];

/// A program to run, as the caller names it: a file or standard input.
#[derive(Clone, Debug)]
pub struct ProgramInput {
    /// The file; `None` for standard input.
    pub path: Option<PathBuf>,
    /// The folder that the caller named and in which the file was found; `None` when the caller named the file.
    /// `chordal.toml` is looked up from the file's folder up to this one.
    pub root: Option<PathBuf>,
}

impl ProgramInput {
    /// The name for messages.
    pub fn name(&self) -> Cow<'_, str> {
        self.path.as_ref().map_or(Cow::Borrowed("<stdin>"), |path| path.to_string_lossy())
    }

    /// The path relative to the folder that the caller named, or the file's name. Output files in a folder are named
    /// after it.
    pub fn below_root(&self) -> PathBuf {
        let Some(path) = &self.path else { return PathBuf::from("stdin") };
        let below = self.root.as_ref().and_then(|root| path.strip_prefix(root).ok());
        below
            .map(Path::to_path_buf)
            .or_else(|| path.file_name().map(PathBuf::from))
            .unwrap_or_default()
    }
}

/// The programs that the arguments name. A folder means all programs in it and its subfolders. The second value lists
/// what could not be read, and folders without a program.
pub fn find(arguments: &[PathBuf]) -> (Vec<ProgramInput>, Vec<LoadError>) {
    let mut inputs = Vec::new();
    let mut failures = Vec::new();
    for argument in arguments {
        if argument.as_os_str() == "-" {
            inputs.push(ProgramInput { path: None, root: None });
        } else if argument.is_dir() {
            let before = inputs.len() + failures.len();
            search(argument, argument, &mut inputs, &mut failures);
            if inputs.len() + failures.len() == before {
                failures.push(LoadError::wrong(
                    format!("there is no program in {}", argument.display()),
                    "name the file itself to run it anyway",
                ));
            }
        } else {
            inputs.push(ProgramInput { path: Some(argument.clone()), root: None });
        }
    }
    (inputs, failures)
}

/// Collects all programs of a folder, sorted by name. Links to folders are not followed, so the recursion ends.
fn search(
    folder: &Path,
    root: &Path,
    inputs: &mut Vec<ProgramInput>,
    failures: &mut Vec<LoadError>,
) {
    let entries = fs::read_dir(folder).and_then(Iterator::collect::<io::Result<Vec<_>>>);
    let mut entries = match entries {
        Ok(entries) => entries,
        Err(error) => {
            failures.push(LoadError::read(folder.to_string_lossy(), &error));
            return;
        }
    };
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let path = entry.path();
        let hidden = entry.file_name().to_string_lossy().starts_with('.');
        let Ok(kind) = entry.file_type() else { continue };
        if hidden {
            continue;
        } else if kind.is_dir() {
            search(&path, root, inputs, failures);
        } else if path.is_file() && !has_other_ending(&path) {
            match FileAccess::Disk.head(&path, SAMPLE) {
                Ok(sample) if looks_like_program(&sample) => {
                    inputs.push(ProgramInput { path: Some(path), root: Some(root.to_path_buf()) });
                }
                Ok(_) => {}
                Err(error) => failures.push(LoadError::read(path.to_string_lossy(), &error)),
            }
        }
    }
}

/// Whether neither the name nor the content contradicts that the file is a program.
pub(crate) fn may_be_program(files: &FileAccess, path: &Path) -> bool {
    let sample = || files.head(path, SAMPLE);
    !has_other_ending(path) && sample().is_ok_and(|sample| looks_like_program(&sample))
}

/// Whether the extension shows that a file is not a program.
pub fn has_other_ending(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    ending.is_some_and(|ending| NOT_PROGRAMS.contains(&ending.as_str()))
}

/// Whether this beginning of a file looks like a program: it is of no other known kind, and some line begins like one of
/// a program in some language. Used only for files that the caller did not name.
pub fn looks_like_program(sample: &[u8]) -> bool {
    let decoded = decode(sample);
    !decoded.binary && !is_other_file(&decoded.text) && has_program_line(&decoded.text)
}

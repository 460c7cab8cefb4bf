//! The labelled set `tests/recognition`: programs with the control or the language that they are for.

#![allow(
    dead_code,
    clippy::disallowed_methods,
    reason = "reads the programs of the tree; each test uses a part of this"
)]

use std::fs;
use std::path::{Path, PathBuf};

use chordal::Report;
use chordal::diagnostics::Span;
use chordal_load::{Loaded, Request, text};

/// A program of the set.
pub struct Labelled {
    /// The control or the language that it is for.
    pub control: String,
    pub title: String,
    pub text: String,
}

impl Labelled {
    /// The program as it is loaded when nobody says for which control it is.
    pub fn load(&self) -> Loaded {
        load(&self.text)
    }
}

/// A text as it is loaded when nobody says for which control it is.
pub fn load(program: &str) -> Loaded {
    text("part", program.as_bytes().to_vec(), &Request::default()).expect("a program")
}

/// What a check of a loaded text says.
pub fn check(loaded: &Loaded) -> Report {
    loaded.job().expect("a job").check()
}

/// The number of the line in which a place begins, from 1.
pub fn line_of(program: &str, span: Span) -> usize {
    let start = (span.range.start as usize).min(program.len());
    program.as_bytes()[..start].iter().filter(|byte| **byte == b'\n').count() + 1
}

/// Every program of the set, by control.
pub fn programs() -> Vec<Labelled> {
    files().iter().flat_map(|path| programs_of(path)).collect()
}

fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/recognition");
    let entries = fs::read_dir(folder).expect("the set");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("a file").path()).collect();
    files.retain(|path| path.extension().is_some_and(|ending| ending == "txt"));
    files.sort();
    files
}

/// The programs of a file, which is named as their control: each begins after a line `=== title`.
fn programs_of(path: &Path) -> Vec<Labelled> {
    let name = path.file_stem().expect("a name").to_string_lossy();
    let control = name.split('.').next().expect("a control");
    let all = fs::read_to_string(path).expect("a text");
    let parts = all.split("\n=== ").skip(1);
    parts
        .map(|part| {
            let (title, text) = part.split_once('\n').expect("a program");
            let text = format!("{}\n", text.trim_end_matches('\n'));
            Labelled { control: control.into(), title: title.into(), text }
        })
        .collect()
}

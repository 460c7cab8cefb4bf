//! The labelled set `tests/recognition`: a file for each control, named as it, with programs in the manner of the
//! usual posts. Counts how many are recognized.

#![allow(clippy::disallowed_methods, reason = "reads the programs of the tree")]

use std::fs;
use std::path::{Path, PathBuf};

use chordal_load::{Request, text};

/// A program of the set.
struct Labelled {
    control: String,
    title: String,
    text: String,
}

/// So many programs the set holds at least, and so many in a hundred must be right.
const FEWEST: usize = 120;
const RIGHT: usize = 98;

fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/recognition");
    let entries = fs::read_dir(folder).expect("the set");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("a file").path()).collect();
    files.retain(|path| path.extension().is_some_and(|ending| ending == "txt"));
    files.sort();
    files
}

/// The programs of a file: each begins after a line `=== title`.
fn programs(path: &Path) -> Vec<Labelled> {
    let control = path.file_stem().expect("a name").to_string_lossy().into_owned();
    let all = fs::read_to_string(path).expect("a text");
    let parts = all.split("\n=== ").skip(1);
    parts
        .map(|part| {
            let (title, text) = part.split_once('\n').expect("a program");
            Labelled { control: control.clone(), title: title.into(), text: text.into() }
        })
        .collect()
}

#[test]
fn the_labelled_set_is_recognized() {
    let (mut all, mut right) = (0, 0);
    let mut wrong = Vec::new();
    for path in files() {
        let programs = programs(&path);
        let count = programs.len();
        let mut hits = 0;
        for program in programs {
            let bytes = program.text.into_bytes();
            let loaded = text("part", bytes, &Request::default()).expect("a program");
            let found = loaded.control();
            if found == program.control {
                hits += 1;
            } else {
                let why = loaded.chosen.why("").unwrap_or_default();
                wrong.push(format!("{}: {}: {found}: {why}", program.control, program.title));
            }
        }
        println!(
            "{:<14} {hits:>3} of {count:>3}",
            path.file_stem().unwrap_or_default().to_string_lossy()
        );
        (all, right) = (all + count, right + hits);
    }
    println!("{:<14} {right:>3} of {all:>3}", "together");
    assert!(all >= FEWEST, "only {all} programs");
    assert!(right * 100 >= all * RIGHT, "{right} of {all}:\n{}", wrong.join("\n"));
    wrong.iter().for_each(|line| println!("{line}"));
}

/// What is not read is one error that says what it is, and nothing is run.
#[test]
fn what_is_not_read_is_one_error() {
    let mut seen = 0;
    for path in files() {
        for program in programs(&path) {
            let loaded =
                text("part", program.text.into_bytes(), &Request::default()).expect("a program");
            if loaded.not_read().is_none() {
                continue;
            }
            seen += 1;
            let report = loaded.job().expect("a job").check();
            let ids: Vec<&str> =
                report.diagnostics.iter().map(|each| each.code.info().id).collect();
            assert_eq!(ids, ["CH215"], "{}", program.title);
            assert!(!report.verified() && report.outcomes.is_empty(), "{}", program.title);
        }
    }
    assert!(seen > 40, "{seen}");
}

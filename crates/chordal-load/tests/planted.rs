//! Faults that are planted in the right programs of the labelled set: each must be found, with its line.
//!
//! `CHORDAL_PLANTS=N` plants N of each kind in a program instead of the usual number.

#![allow(clippy::disallowed_methods, reason = "the number of plants can be given from outside")]

mod faults;
mod labelled;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use chordal::{Report, Severity};
use faults::Part;
use faults::kinds::{KINDS, Kind};
use faults::turning;
use labelled::{check, line_of, load, programs};

/// Plants of a kind in one program.
const USUAL: usize = 1;

/// So many faults are planted at least, of so many kinds.
const FEWEST: usize = 500;
const FEWEST_KINDS: usize = 15;

/// The right programs: those of the five controls of which a check reports no error.
fn parts() -> Vec<Part> {
    let programs = programs();
    let parts = programs.iter().filter_map(|program| {
        let loaded = program.load();
        let right = loaded.not_read().is_none() && check(&loaded).counts.errors == 0;
        right.then(|| Part::new(&program.title, &loaded))
    });
    parts.collect()
}

/// Codes with their lines.
fn said(report: &Report, text: &str) -> BTreeSet<(usize, &'static str, bool)> {
    let said = report.diagnostics.iter().map(|each| {
        let line = line_of(text, each.primary.span);
        (line, each.code.info().id, each.severity != Severity::Note)
    });
    said.collect()
}

/// The plants of a kind in a program: line and new text of each, and the line that must be reported.
fn plants(kind: &Kind, part: &Part) -> Vec<(usize, String, usize)> {
    let most = std::env::var("CHORDAL_PLANTS").ok().and_then(|text| text.parse().ok());
    let lines = part.lines.iter().filter(|line| line.done.ran || kind.anywhere);
    let all = lines.filter_map(|line| {
        let new = (kind.plant)(part, line)?;
        let place = (kind.place)(part, line)?;
        Some((line.number, new, place))
    });
    let mut all: Vec<_> = all.collect();
    // Evenly over the program.
    let most = most.unwrap_or(USUAL).max(1);
    if all.len() > most {
        let step = all.len() as f64 / most as f64;
        let chosen: BTreeSet<usize> =
            (0..most).map(|index| (index as f64 * step) as usize).collect();
        let mut index = 0;
        all.retain(|_| {
            index += 1;
            chosen.contains(&(index - 1))
        });
    }
    all
}

/// What a firmware says of a block that it judges as a whole, whatever the fault.
const REFUSED: &str = "CH313";

/// A program that has lost the line which sets a variable reads as a macro, and is not run.
const NOT_RUN: &str = "CH729";

#[test]
fn every_planted_fault_is_found_in_its_line() {
    let parts = parts();
    let planted = plant_all(KINDS, &parts);
    assert!(planted >= FEWEST && KINDS.len() >= FEWEST_KINDS, "{planted} plants");
}

/// Languages with statements call most slips of the fingers a statement that cannot be read, or a name that is not
/// defined: their alarms say no more.
const UNREADABLE: [&str; 2] = ["CH704", "CH705"];

/// The lathe programs among the examples, as they are loaded when nobody says for which control they are.
fn turned_parts() -> Vec<Part> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut parts = Vec::new();
    for control in ["fanuc-lathe", "haas-lathe", "linuxcnc-lathe", "mitsubishi-lathe"] {
        let entries = fs::read_dir(folder.join(control)).expect("examples");
        let mut files: Vec<_> = entries.map(|entry| entry.expect("a file").path()).collect();
        files.retain(|file| file.extension().is_some_and(|ending| ending != "toml"));
        files.sort();
        for file in files {
            let text = fs::read_to_string(&file).expect("a text");
            // One with a C axis, or with another system of G codes, is for another machine.
            if text.contains("(machine: fanuc-lathe-") || text.contains("No. 3401") {
                continue;
            }
            let loaded = load(&text);
            let name = file.file_name().expect("a name").to_string_lossy().into_owned();
            assert_eq!(loaded.control(), control, "{name}");
            assert_eq!(check(&loaded).counts.errors, 0, "{control}/{name}");
            parts.push(Part::new(&name, &loaded));
        }
    }
    parts
}

#[test]
fn every_fault_of_a_lathe_program_is_found_in_its_line() {
    let parts = turned_parts();
    assert!(parts.len() >= 25, "{} programs", parts.len());
    let planted = plant_all(turning::KINDS, &parts);
    assert!(planted >= 100, "{planted} plants");
}

/// Plants each kind in each part, and returns how many; each must be found in its line.
fn plant_all(kinds: &[Kind], parts: &[Part]) -> usize {
    let mut missed = Vec::new();
    let (mut all, mut found) = (0, 0);
    for kind in kinds {
        let (mut planted, mut hits) = (0, 0);
        for part in parts.iter().filter(|part| !kind.not_on.contains(&part.control)) {
            let text = part.planted(0, "");
            let before = said(&part.check(&text), &text);
            for (line, new, place) in plants(kind, part) {
                let text = part.planted(line, &new);
                let after = said(&part.check(&text), &text);
                let is_new = |at: usize, id: &str| !before.iter().any(|b| b.0 == at && b.1 == id);
                let right = after.iter().any(|&(at, id, _)| {
                    let is_unreadable =
                        part.control.starts_with("sinumerik") && UNREADABLE.contains(&id);
                    let said = kind.codes.contains(&id) || id == REFUSED || is_unreadable;
                    let in_line = at == place && said;
                    (in_line || id == NOT_RUN && at <= place) && is_new(at, id)
                });
                planted += 1;
                hits += usize::from(right);
                if !right {
                    let fresh: Vec<_> = after.difference(&before).collect();
                    missed.push(format!(
                        "{}: {}, {}, line {line}: `{new}` must be reported in line {place}; new: {fresh:?}",
                        kind.name, part.control, part.title
                    ));
                }
            }
        }
        println!("{:<44} {hits:>4} of {planted:>4}", kind.name);
        assert!(planted > 0, "{} is nowhere planted", kind.name);
        (all, found) = (all + planted, found + hits);
    }
    println!("{:<44} {found:>4} of {all:>4}, in {} programs", "together", parts.len());
    assert!(missed.is_empty(), "{} missed:\n{}", missed.len(), missed.join("\n"));
    all
}

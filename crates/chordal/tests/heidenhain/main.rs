//! Conversational programs with what is expected of them on the line; `tests/heidenhain/README.md` has the format.
//!
//! The first run of the first 68 programs and 89 faults, before anything was mended: 45 programs clean, 855 of 1033
//! expectations, 86 faults. The first run of the set of 120 and 300: 108, 2486 of 2576, 278.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

mod expectations;
mod record;

use std::fs;
use std::path::{Path, PathBuf};

use chordal::{Diagnostic, Severity};
use expectations::{ExpectedPlaneMap, check, check_path};
use record::{is_called, is_transformed, notes, run};

/// Programs without an error or a warning, of all; may only become more.
const MIN_CLEAN: usize = 117;

/// Expectations that hold, of all; may only become more.
const MIN_RIGHT: usize = 2569;

/// Faults that are reported at their line, of all; may only become more.
const MIN_FAULTS: usize = 297;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/heidenhain")
}

/// What a program shows.
struct ProgramResult {
    expectations: usize,
    wrong: Vec<String>,
    problems: Vec<String>,
}

fn text_of(found: &Diagnostic) -> String {
    let alarm = found.alarm.as_deref().unwrap_or("");
    format!("{} [{alarm}] {}", found.code.info().id, found.message)
}

fn check_program(path: &Path) -> ProgramResult {
    let text = fs::read_to_string(path).expect("a program");
    let record = run(path);
    let is_mapped = is_transformed(&text);
    let mut map = ExpectedPlaneMap::default();
    let (mut expectations, mut wrong) = (0, Vec::new());
    for (index, line) in text.lines().enumerate() {
        let number = index as u32 + 1;
        let notes = notes(line);
        map.note(&notes);
        let is_counted = |note: &&String| !matches!(note.as_str(), "clean" | "called");
        expectations += notes.iter().filter(is_counted).count();
        let own_map = is_mapped.then_some(&map);
        for note in &notes {
            if let Err(found) = check(note, number, &notes, &record, own_map) {
                wrong.push(format!("line {number}: `{note}`: {found}"));
            }
        }
        wrong.extend(check_path(&notes, number, line, &record));
    }
    let is_problem = |found: &Diagnostic| found.severity != Severity::Note;
    let problems = record.problems.iter().filter(|(_, found)| is_problem(found));
    let problems = problems.map(|(lines, found)| format!("{lines:?} {}", text_of(found)));
    ProgramResult { expectations, wrong, problems: problems.collect() }
}

fn programs(part: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder().join(part)).expect("the programs");
    let files = entries.map(|entry| entry.expect("a file").path());
    let is_program = |path: &PathBuf| {
        !is_called(path) && path.extension().is_some_and(|own| own == "h" || own == "i")
    };
    let mut files: Vec<PathBuf> = files.filter(is_program).collect();
    files.sort();
    files
}

#[test]
fn right_programs_do_what_they_say() {
    let (mut clean, mut all, mut right) = (0, 0, 0);
    let files = programs("programs");
    for path in &files {
        let result = check_program(path);
        let name = path.file_name().expect("a name").to_string_lossy();
        clean += usize::from(result.problems.is_empty());
        all += result.expectations;
        right += result.expectations - result.wrong.len();
        if !result.problems.is_empty() || !result.wrong.is_empty() {
            println!("{name}: {} of {} wrong", result.wrong.len(), result.expectations);
            result.problems.iter().take(3).for_each(|problem| println!("    ! {problem}"));
            result.wrong.iter().take(3).for_each(|problem| println!("    {problem}"));
        }
    }
    println!("{clean} of {} programs are clean, {right} of {all} expectations hold", files.len());
    assert!(clean >= MIN_CLEAN, "{clean} programs are clean");
    assert!(right >= MIN_RIGHT, "{right} expectations hold");
}

#[test]
fn faults_are_found_at_their_line() {
    let (mut found, mut said, mut sayings) = (0, 0, 0);
    let files = programs("faults");
    for path in &files {
        let text = fs::read_to_string(path).expect("a program");
        let record = run(path);
        let lines: Vec<u32> = text
            .lines()
            .enumerate()
            .filter(|(_, line)| notes(line).iter().any(|note| note == "fault"))
            .map(|(index, _)| index as u32 + 1)
            .collect();
        let says = text
            .lines()
            .flat_map(notes)
            .find_map(|note| note.strip_prefix("says ").map(str::to_string));
        let own = || {
            record.problems.iter().filter(|(at, found)| {
                found.severity != Severity::Note && at.iter().any(|line| lines.contains(line))
            })
        };
        let is_found = own().next().is_some();
        found += usize::from(is_found);
        let is_said = |words: &String| {
            own().any(|(_, found)| found.alarm.as_ref().is_some_and(|alarm| alarm.contains(words)))
        };
        if let Some(words) = &says {
            sayings += 1;
            said += usize::from(is_said(words));
        }
        let name = path.file_name().expect("a name").to_string_lossy();
        if !is_found {
            println!("{name}: not at {lines:?}");
            for (at, problem) in &record.problems {
                println!("    {at:?} {}", text_of(problem));
            }
        } else if says.as_ref().is_some_and(|words| !is_said(words)) {
            println!("{name}: is found and does not say {says:?}");
        }
    }
    println!(
        "{found} of {} faults are found, {said} of {sayings} with the control's words",
        files.len()
    );
    assert!(found >= MIN_FAULTS, "{found} faults are found");
}

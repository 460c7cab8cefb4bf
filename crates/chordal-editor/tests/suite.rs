//! Every program of the suite and the examples: questions at every place answer, and what is
//! reformatted runs the same.

#![allow(clippy::disallowed_methods, reason = "reads the programs of the project")]

use std::fs;
use std::path::{Path, PathBuf};

use chordal::Machine;
use chordal_editor::{EditorProgram, NumberingOptions, TokenClass};

const MACHINES: &[(&str, &str)] = &[
    ("fadal", "fadal-4020"),
    ("haas", "haas-vf2"),
    ("fanuc", "fanuc-30i"),
    ("mitsubishi", "mitsubishi-m700"),
    ("linuxcnc", "linuxcnc-mill"),
];

fn programs() -> Vec<(PathBuf, EditorProgram)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut programs = Vec::new();
    for (folder, machine) in MACHINES {
        for above in ["tests/suite", "examples"] {
            let folder = root.join(above).join(folder);
            let entries = fs::read_dir(&folder).into_iter().flatten();
            for path in entries.map(|entry| entry.expect("an entry").path()) {
                let nc = path.extension().is_some_and(|ending| ending == "nc" || ending == "ngc");
                if nc {
                    let machine = Machine::from_builtin(machine).expect("a machine");
                    let text = fs::read(&path).expect("a program");
                    let name = path.display().to_string();
                    programs
                        .push((path, EditorProgram::new(name, text, machine).expect("a program")));
                }
            }
        }
    }
    assert!(programs.len() > 80, "{} programs", programs.len());
    programs
}

#[test]
fn tokens_are_in_order_and_apart() {
    for (path, program) in programs() {
        let tokens = program.tokens(1, u32::MAX);
        for pair in tokens.windows(2) {
            assert!(pair[0].range.end <= pair[1].range.start, "{}: {pair:?}", path.display());
        }
        // By lines they are the same.
        let lines = program.source().line_of(program.text().len() as u32);
        let by_line: Vec<_> = (1..=lines).flat_map(|line| program.tokens(line, line + 1)).collect();
        assert_eq!(tokens, by_line, "{}", path.display());
    }
}

#[test]
fn every_word_has_an_answer() {
    for (_, program) in programs() {
        let ran = program.ran();
        let (mut asked, mut answered) = (0, 0);
        // Each question runs the program: a few words of each are enough.
        let mut words = program.tokens(1, u32::MAX);
        words.retain(|token| {
            matches!(token.class, TokenClass::GCode | TokenClass::Axis | TokenClass::Speed)
        });
        for token in words.iter().step_by(words.len() / 7 + 1) {
            answered += usize::from(program.hover(token.range.start, Some(&ran)).is_some());
            asked += 1;
            program.completions(token.range.end);
            program.name_at(token.range.start);
        }
        assert_eq!(answered, asked, "{}", program.name());
        program.outline();
    }
}

#[test]
fn what_is_reformatted_runs_the_same() {
    let mut changed = [0, 0];
    for (path, program) in programs() {
        // A refusal is an answer; an edit is proved by the run itself, and here once more by
        // the report.
        let numbering = NumberingOptions { first: 10, step: 5, all: true };
        let edits = [program.spaced(1, u32::MAX), program.renumbered(numbering)];
        for (changed, edits) in changed.iter_mut().zip(edits) {
            let Ok(edits) = edits else { continue };
            *changed += usize::from(!edits.is_empty());
            let edited = program.with_text(program.edited(&edits));
            let (before, after) = (program.ran().report, edited.ran().report);
            assert_eq!(before.summary.feed_length_mm, after.summary.feed_length_mm);
            // By line: a number at the head of a block may come to stand before or within what is underlined.
            let codes = |report: &chordal::Report, text: &[u8]| {
                let line =
                    |at: u32| text[..at as usize].iter().filter(|byte| **byte == b'\n').count();
                let found = report.diagnostics.iter();
                let mut found: Vec<_> = found
                    .map(|one| (line(one.primary.span.range.start), one.code.id(), one.code))
                    .collect();
                found.sort_by_key(|(line, id, _)| (*line, *id));
                found.into_iter().map(|(line, _, code)| (line, code)).collect::<Vec<_>>()
            };
            let (was, is) = (codes(&before, program.text()), codes(&after, edited.text()));
            assert_eq!(was, is, "{}", path.display());
        }
    }
    // Most of the programs are well spaced.
    assert!(changed[0] > 10 && changed[1] > 100, "{changed:?}");
}

//! The labelled set `tests/posts`: programs as some eighty sources write them, with the control and the box of their
//! cuts. It was written from descriptions of the sources and frozen before the recognizer was measured on it.
//!
//! What counts most: no program is silently read so that it moves otherwise than it is meant. Either its box is
//! right, or the program is not verified.

#![allow(clippy::disallowed_methods, reason = "reads the programs of the tree")]

mod post_set;

use std::collections::BTreeMap;

use chordal::machine::ControlName;
use chordal::{Code, Report, Severity};
use chordal_load::{Loaded, Request, text};
use post_set::{PostProgram, programs};

/// So many programs of the controls that are read must be recognized, in a hundred.
const RECOGNIZED_PERCENT: usize = 98;

/// Ends of a box that differ by less are the same, mm: programs round to 0.001 mm or 0.0001 in, and chords of a
/// source lie off its arcs.
const SAME_END_MM: f64 = 0.05;

/// A program of which nobody can tell for which control it is.
const ANY: &str = "any";

/// Whether programs with this label are read.
fn is_read(label: &str) -> bool {
    label == ANY || ControlName::ALL.iter().any(|name| name.as_str() == label)
}

impl PostProgram {
    fn is_read(&self) -> bool {
        is_read(&self.controls[0])
    }

    fn load(&self) -> Loaded {
        load(&self.text)
    }

    fn is_recognized(&self, control: &str) -> bool {
        let any = self.controls[0] == ANY && is_read(control);
        any || self.controls.iter().any(|name| name == control)
    }

    /// The first axis on which a run cuts otherwise, with both boxes.
    fn other_box(&self, report: &Report) -> Option<String> {
        for (letter, ends) in ['X', 'Y', 'Z'].into_iter().zip(self.ends) {
            let Some((low, high)) = ends else { continue };
            let axis = report.summary.axes.iter().find(|axis| axis.letter == letter);
            let cut = axis.and_then(|axis| axis.cut_range);
            // Programs of jscut begin with a cut, and their boxes have its start at zero; nobody knows where it is.
            let start = |end: f64| self.source == "jscut" && end == 0.0;
            let near = |a: f64, b: f64| (a - b).abs() <= SAME_END_MM || start(b);
            if !cut.is_some_and(|(a, b)| near(a, low) && near(b, high)) {
                return Some(format!("{letter} {cut:?} instead of {low} to {high}"));
            }
        }
        None
    }

    fn name(&self) -> String {
        format!("{}: {}", self.source, self.title)
    }
}

fn load(program: &str) -> Loaded {
    text("part", program.as_bytes().to_vec(), &Request::default()).expect("a program")
}

/// Errors that say what Chordal was not given or does not carry out, and nothing of the program.
const NOT_KNOWN: &[Code] =
    &[Code::NotFollowed, Code::MissingSubprogram, Code::PocketWithoutDiameter];

#[test]
fn no_program_is_silently_read_as_another_path() {
    let (mut counts, mut wrong) = (BTreeMap::<String, (usize, usize)>::new(), Vec::new());
    let (mut silent, mut not_known, mut errors) = (Vec::new(), 0, Vec::new());
    for program in programs() {
        let loaded = program.load();
        let control = loaded.control();
        let (right, count) = counts.entry(program.controls[0].clone()).or_default();
        *count += 1;
        if program.is_recognized(control) {
            *right += 1;
        } else {
            wrong.push(format!("{}: {control}", program.name()));
        }
        if !program.is_read() || loaded.not_read().is_some() {
            continue;
        }
        let report = loaded.job().expect("a job").report();
        let first = report
            .diagnostics
            .iter()
            .find(|each| each.severity == Severity::Error && !NOT_KNOWN.contains(&each.code));
        if let Some(first) = first {
            errors.push(format!(
                "{} on {control}: {} {}",
                program.name(),
                first.code.info().id,
                first.message
            ));
        }
        // Where the control stops at an error, the path is cut off and not another one.
        if !report.verified() || first.is_some() {
            not_known += usize::from(!report.verified());
        } else if let Some(other) = program.other_box(&report) {
            silent.push(format!("{} on {control}: {other}", program.name()));
        }
    }
    let sum = |read: bool| {
        counts
            .iter()
            .filter(|(name, _)| is_read(name) == read)
            .fold((0, 0), |sum, (_, each)| (sum.0 + each.0, sum.1 + each.1))
    };
    let ((right, all), (named, others)) = (sum(true), sum(false));
    for (name, (right, count)) in &counts {
        println!("{name:<18} {right:>3} of {count:>3}");
    }
    wrong.iter().for_each(|line| println!("wrong: {line}"));
    errors.iter().for_each(|line| println!("error: {line}"));
    silent.iter().for_each(|line| println!("silent: {line}"));
    println!("control right {right} of {all}; languages that are not read {named} of {others}");
    println!(
        "{not_known} not verified, {} with errors, {} silently another path",
        errors.len(),
        silent.len()
    );
    assert!(silent.is_empty(), "{}", silent.join("\n"));
    assert!(right * 100 >= all * RECOGNIZED_PERCENT, "{right} of {all}");
}

/// What changes nothing about what a program is for: comments, block numbers, blank lines, a retract at the end,
/// line ends.
fn variations(program: &str) -> [(&'static str, String); 5] {
    let lines: Vec<&str> = program.lines().collect();
    let is_block = |line: &str| line.trim_start().starts_with(['G', 'X', 'Y', 'Z']);
    let first = lines.iter().position(|line| is_block(line)).unwrap_or(0);
    let mut comment = lines.clone();
    comment.insert(first + 1, "(CHECK THE FIRST PART)");
    let numbered = program.lines().enumerate().map(|(index, line)| match is_block(line) {
        true => format!("N{} {line}", 10 * index),
        false => line.to_string(),
    });
    let blank: Vec<String> = lines.iter().map(|line| format!("{line}\n")).collect();
    let last = lines.iter().rposition(|line| {
        let code = line.trim().trim_end_matches('.');
        ["M30", "M2", "M02"].iter().any(|end| code.ends_with(end)) && !code.starts_with('(')
    });
    let mut retract = lines.clone();
    retract.insert(last.unwrap_or(lines.len()), "G0 X0.");
    [
        ("a comment", comment.join("\n") + "\n"),
        ("block numbers", numbered.collect::<Vec<_>>().join("\n") + "\n"),
        ("blank lines", blank.join("\n") + "\n"),
        ("a closing move", retract.join("\n") + "\n"),
        ("CR LF", lines.join("\r\n") + "\r\n"),
    ]
}

#[test]
fn what_changes_nothing_does_not_change_the_reading() {
    let (mut count, mut changed) = (0, Vec::new());
    for program in programs().iter().filter(|program| program.is_read()) {
        // A move after subprograms alone makes a program of them.
        if program.ends == [None; 3] {
            continue;
        }
        let before = program.load();
        let verified = before.job().expect("a job").check().verified();
        for (what, text) in variations(&program.text) {
            count += 1;
            let after = load(&text);
            let same = after.job().expect("a job").check().verified() == verified;
            if after.control() != before.control() || !same {
                changed.push(format!(
                    "{} with {what}: {} instead of {}, verified {same}",
                    program.name(),
                    after.control(),
                    before.control()
                ));
            }
        }
    }
    changed.iter().for_each(|line| println!("{line}"));
    println!("{} of {count} variations change the reading", changed.len());
    assert!(changed.is_empty(), "{}", changed.join("\n"));
}

//! The labelled set `tests/recognition`: how many are recognized, and that what is right has no error.

mod labelled;

use std::collections::BTreeMap;

use chordal::Code;
use labelled::{check, line_of, problems, programs};

/// So many programs the set holds at least, and so many in a hundred must be right.
const FEWEST: usize = 300;
const RIGHT: usize = 98;

#[test]
fn the_labelled_set_is_recognized() {
    // Of each control: how many are right, and how many there are.
    let mut counts: BTreeMap<String, (usize, usize)> = BTreeMap::new();
    let mut wrong = Vec::new();
    for program in programs() {
        let loaded = program.load();
        let found = loaded.control();
        let (hits, count) = counts.entry(program.control.clone()).or_default();
        *count += 1;
        if found == program.control {
            *hits += 1;
        } else {
            let why = loaded.chosen.why("").unwrap_or_default();
            wrong.push(format!("{}: {}: {found}: {why}", program.control, program.title));
        }
    }
    for (control, (hits, count)) in &counts {
        println!("{control:<14} {hits:>3} of {count:>3}");
    }
    let right: usize = counts.values().map(|(hits, _)| hits).sum();
    let all: usize = counts.values().map(|(_, count)| count).sum();
    println!("{:<14} {right:>3} of {all:>3}", "together");
    wrong.iter().for_each(|line| println!("{line}"));
    assert!(all >= FEWEST, "only {all} programs");
    assert!(right * 100 >= all * RIGHT, "{right} of {all}:\n{}", wrong.join("\n"));
}

#[test]
fn right_programs_have_no_error() {
    let mut clean = 0;
    let mut count = 0;
    for program in programs() {
        let loaded = program.load();
        if loaded.not_read().is_some() {
            continue;
        }
        count += 1;
        let report = check(&loaded);
        let mut errors = 0;
        for each in problems(&report) {
            let line = line_of(&program.text, each.primary.span);
            let words = program.text.lines().nth(line - 1).unwrap_or_default();
            println!(
                "{:?} {}|{}|{}|{}|{}|{}",
                each.severity,
                program.control,
                program.title,
                each.code.info().id,
                line,
                words,
                each.message
            );
            errors += usize::from(
                each.severity == chordal::Severity::Error
                    && !matches!(
                        each.code,
                        Code::MissingSubprogram | Code::NotFollowed | Code::PocketWithoutDiameter
                    ),
            );
        }
        clean += usize::from(errors == 0);
    }
    println!("{clean} of {count} without an error");
}

/// What is not read is one error that says what it is, and nothing is run.
#[test]
fn what_is_not_read_is_one_error() {
    let mut seen = 0;
    for program in programs() {
        let loaded = program.load();
        if loaded.not_read().is_none() {
            continue;
        }
        seen += 1;
        let report = check(&loaded);
        let ids: Vec<&str> = report.diagnostics.iter().map(|each| each.code.info().id).collect();
        assert_eq!(ids, ["CH215"], "{}", program.title);
        assert!(!report.verified() && report.outcomes.is_empty(), "{}", program.title);
    }
    assert!(seen > 80, "{seen}");
}

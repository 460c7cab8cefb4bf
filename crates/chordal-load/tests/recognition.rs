//! The labelled set `tests/recognition`: how many are recognized, and that what is right has no error.

mod labelled;

use std::collections::BTreeMap;

use chordal::{Code, Severity};
use labelled::{check, line_of, programs};

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

/// What Chordal says of itself: a code that it does not carry out, a program or a diameter that it was not given.
/// Nothing of it says that the program is wrong.
const NOT_KNOWN: &[Code] =
    &[Code::NotFollowed, Code::MissingSubprogram, Code::PocketWithoutDiameter];

/// The programs of the controls that are read are right in every word.
#[test]
fn right_programs_have_no_error() {
    let (mut count, mut not_known) = (0, 0);
    let mut wrong = Vec::new();
    for program in programs() {
        let loaded = program.load();
        if loaded.not_read().is_some() {
            continue;
        }
        count += 1;
        let report = check(&loaded);
        let errors = report.diagnostics.iter().filter(|each| each.severity == Severity::Error);
        let (own, others): (Vec<_>, Vec<_>) =
            errors.partition(|each| NOT_KNOWN.contains(&each.code));
        not_known += usize::from(!own.is_empty());
        for each in others {
            let (line, id) = (line_of(&program.text, each.primary.span), each.code.info().id);
            let (control, title) = (&program.control, &program.title);
            wrong.push(format!("{control}, {title}, line {line}: {id} {}", each.message));
        }
    }
    println!("{count} right programs of the controls that are read, {} errors", wrong.len());
    println!("{not_known} of them with codes, programs or diameters that are not known");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
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
    assert!(seen >= 20, "{seen}");
}

/// Programs of HEIDENHAIN controls that turn tables are run on a machine that has them.
#[test]
fn rotary_axes_choose_the_machine() {
    let text =
        |line: &str| format!("BEGIN PGM A MM\nTOOL CALL 1 Z S800\n{line}\nM30\nEND PGM A MM\n");
    for (line, machine) in [
        ("L X+10 Y+5 R0 FMAX", "heidenhain-mill"),
        ("C X+10 Y+5 DR+", "heidenhain-mill"),
        ("PLANE RESET TURN FMAX", "heidenhain-ac-trunnion"),
        ("L A+0 C+0 FMAX", "heidenhain-ac-trunnion"),
        ("L X+10 IC+30 FMAX", "heidenhain-ac-trunnion"),
        ("C+20 F500 M128", "heidenhain-ac-trunnion"),
        ("L X+10 B+12.5 C-30 FMAX", "heidenhain-bc-trunnion"),
        ("B+12.357 C+5.896 F1000 M128", "heidenhain-bc-trunnion"),
    ] {
        let loaded = labelled::load(&text(line));
        assert_eq!(loaded.control(), "heidenhain", "{line}");
        assert_eq!(loaded.machine().name, machine, "{line}");
    }
}

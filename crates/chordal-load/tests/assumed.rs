//! Limits of a machine that nobody named, and the programs of a memory dump.

use chordal::{Report, Severity};
use chordal_load::{Given, Request, text};

fn check(program: &str, request: &Request) -> Report {
    let loaded = text("part", program.into(), request).expect("a program");
    loaded.job().expect("a job").check()
}

fn on(name: &str) -> Request {
    Request { machine: Some(Given::Name(name.into())), ..Request::default() }
}

fn ids(report: &Report) -> Vec<&str> {
    report.diagnostics.iter().map(|each| each.code.info().id).collect()
}

/// 40 in of X, 9000 rpm and 900 in/min: a VF-2 has 30 in, 8100 rpm and 650 in/min.
const LARGE: &str = "\
%
O0001
G20 G90 G17
G154 P1 G0 X0 Y0
S9000 M3
G1 X40. F900.
X0 F20.
M30
%
";

#[test]
fn limits_of_a_machine_that_nobody_named_are_one_note() {
    let report = check(LARGE, &Request::default());
    assert_eq!(ids(&report), ["CH608"]);
    let note = &report.diagnostics[0];
    assert_eq!(note.severity, Severity::Note);
    for words in ["Haas VF-2", "the travel in X by 10 in", "9000 rpm", "900 in/min"] {
        assert!(note.message.contains(words), "{}", note.message);
    }
    let named = check(LARGE, &on("haas-vf2"));
    assert_eq!(named.counts.notes, 0);
    for id in ["CH601", "CH407", "CH606"] {
        assert!(ids(&named).contains(&id), "{:?}", ids(&named));
    }
}

/// Each program needs 20 in of X, and both together 45 in.
const DUMP: &str = "\
%
O0001
G20 G90 G54 G0 X0 Y0 S900 M3
G1 X20. F20.
M30
O0002
G20 G90 G54 G0 X25. Y0 S900 M3
G1 X45. F20.
M30
%
";

#[test]
fn programs_of_a_memory_are_judged_each_alone() {
    let report = check(DUMP, &on("haas-vf2"));
    assert_eq!(ids(&report), Vec::<&str>::new());
    let wide = DUMP.replace("X45.", "X65.");
    let report = check(&wide, &on("haas-vf2"));
    assert_eq!(ids(&report), ["CH601"]);
    // At the head of the program that needs it.
    let at = report.diagnostics[0].primary.span.range.start as usize;
    assert!(wide[at..].starts_with("O0002"), "{at}");
}

//! Limits of a machine that nobody named, and the programs of a memory dump.

use chordal::{Report, Severity};
use chordal_load::{Request, RequestedMachine, text};

fn check(program: &str, request: &Request) -> Report {
    let loaded = text("part", program.into(), request).expect("a program");
    loaded.job().expect("a job").check()
}

fn on(name: &str) -> Request {
    Request { machine: Some(RequestedMachine::Name(name.into())), ..Request::default() }
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

/// Indexed by B and C, on a Haas that nobody named: a VF-2 has neither.
const FIVE_AXES: &str = "\
%
O05200 (BRACKET)
(HAAS)
G20 G90 G17
T3 M6
S5000 M3
G54 G0 B0. C0.
G43 H3 Z4.
B90. C180.
G1 Z1.9 F40.
G0 Z4.
M30
%
";

#[test]
fn the_assumed_machine_has_the_axes_that_move() {
    let loaded = text("part", FIVE_AXES.into(), &Request::default()).expect("a program");
    assert_eq!(loaded.machine().name, "haas-umc750");
    let counts = loaded.job().expect("a job").check().counts;
    assert_eq!((counts.errors, counts.warnings), (0, 0));
    let why = loaded.chosen.why("Haas NGC mill").expect("nobody named it");
    assert_eq!(
        why,
        "recognized as Haas NGC mill by line 3 (a comment names a Haas); Haas UMC-750 is assumed because the \
         program moves B and C"
    );
    // With A it is the usual machine.
    let fourth = FIVE_AXES.replace("B0. C0.", "A0.").replace("B90. C180.", "A90.");
    let loaded = text("part", fourth.into(), &Request::default()).expect("a program");
    assert_eq!(loaded.machine().name, "haas-vf2");
    // Arguments of a macro are no axes.
    let called = FIVE_AXES.replace("B90. C180.", "G65 P9000 B90. C180.").replace("B0. C0.", "A0.");
    let loaded = text("part", called.into(), &Request::default()).expect("a program");
    assert_eq!(loaded.machine().name, "haas-vf2");
}

#[test]
fn an_axis_that_no_built_in_machine_has_is_a_warning() {
    let program = "N1 O1 (FADAL\nN2 G20 G90 S900 M3\nN3 G0 X0 Y0 C0 E1\nN4 C90.\nN5 M2\n";
    let report = check(program, &Request::default());
    assert_eq!(ids(&report), ["CH309"]);
    let warning = &report.diagnostics[0];
    assert_eq!(warning.severity, Severity::Warning);
    assert_eq!(warning.message, "the assumed machine (Fadal VMC 4020) has no C axis");
    // Of a machine that somebody named it is an error.
    let named = check(program, &on("fadal-4020"));
    assert_eq!(named.diagnostics[0].severity, Severity::Error);
}

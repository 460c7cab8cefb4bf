//! A percent sign in the middle of a text: the end of the tape, or a character that means nothing.

use chordal::{Code, Job, Machine, Source, SourceMap};

/// The codes that a program is told, and how many rapids it makes.
fn run(machine: &str, program: &str) -> (Vec<Code>, u64) {
    let machine = Machine::from_builtin(machine).expect("a built-in machine");
    let mut sources = SourceMap::new();
    sources.add(Source::new("tape.nc", program.as_bytes()));
    let report = Job::new(sources, machine).expect("a machine of its own control").report();
    (report.diagnostics.iter().map(|found| found.code).collect(), report.summary.rapids)
}

#[test]
fn linuxcnc_takes_a_second_percent_sign_and_no_lone_one() {
    assert_eq!(run("linuxcnc-mill", "%\nG21 G0 X1\n%\nG0 X2\nM2\n"), (vec![], 1));
    let (codes, rapids) = run("linuxcnc-mill", "G21 G0 X1\n%\nG0 X2\nM2\n");
    assert_eq!(rapids, 1);
    assert!(codes.contains(&Code::UnexpectedCharacter), "{codes:?}");
}

#[test]
fn on_other_controls_it_ends_the_tape() {
    for machine in ["fanuc-30i", "haas-vf2", "mitsubishi-m700", "fadal-4020"] {
        let (codes, rapids) = run(machine, "O1\nG0 X1.\nM30\n%\nG0 X2.\n");
        assert_eq!((codes, rapids), (vec![], 1), "{machine}");
    }
}

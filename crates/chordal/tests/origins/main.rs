//! Where values come from: every variable, input and register that a program of a control can read, and the words
//! that it reaches. What neither the program nor the machine file says is not known, and a path that it reaches is
//! not verified from there on.

mod random;
mod rows;
mod sides;
mod table;

use chordal::{Job, Machine, Report, Source, SourceMap};

/// Blocks before those of a case.
const HEAD: &str = "G21 G17 G40 G80 G90\n";

/// The programs that a case can call, each with the word that calls it.
const CALLED: [(&str, &str); 2] =
    [("P2000", "O2000\nG0 Y#1\nM99\n"), ("P2001", "O2001\nG0 Y1.\nM99\n")];

/// A program that runs the blocks of a case after the head, and what line the case begins in.
fn program(machine: &str, body: &str) -> (String, usize) {
    match Machine::from_builtin(machine).expect(machine).control.as_str() {
        "linuxcnc" | "mach3" => (format!("{HEAD}{body}\nG0 Z0.\nM2\n"), 2),
        "fadal" => (format!("N1 {HEAD}{body}\nN900 G0 Z0.\nN901 M2\n"), 2),
        _ => {
            let called: String =
                CALLED.iter().filter(|(call, _)| body.contains(call)).map(|row| row.1).collect();
            (format!("O1\n{HEAD}{body}\nG0 Z0.\nM30\n{called}"), 3)
        }
    }
}

fn job(machine: &str, given: &[&str], text: &str) -> Job<'static> {
    let mut machine = Machine::from_builtin(machine).expect(machine);
    for assignment in given {
        machine.set(assignment).unwrap_or_else(|error| panic!("{assignment}: {error}"));
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    Job::new(sources, machine).expect("a job")
}

fn report(machine: &str, given: &[&str], text: &str) -> Report {
    job(machine, given, text).report()
}

/// The line of a case from which on it is not verified, the first of which is 1; and what is said of it.
fn lost_line(machine: &str, given: &[&str], body: &str) -> (Option<usize>, Vec<String>) {
    let (text, first) = program(machine, body);
    let report = report(machine, given, &text);
    let said = |each: &chordal::Diagnostic| format!("{}: {}", each.code.info().id, each.message);
    let line = report.not_verified_from.map(|span| {
        let before = &text.as_bytes()[..span.range.start as usize];
        2 + before.iter().filter(|byte| **byte == b'\n').count() - first
    });
    (line, report.diagnostics.iter().map(said).collect())
}

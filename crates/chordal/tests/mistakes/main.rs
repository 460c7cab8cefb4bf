//! Mistakes that machinists make, as rows: a control, a program, and the codes that a check must report. Each mistake
//! stands next to the right program, of which nothing may be said.

mod spindle;
mod turning;

use chordal::{Diagnostic, Job, Machine, RunOptions, Severity, Source, SourceMap};

/// The mills, each with what its programs begin with.
pub const MILLS: &[&str] =
    &["fadal-4020", "haas-vf2", "fanuc-0i", "mitsubishi-m700", "linuxcnc-mill", "mach3-mill"];

/// The lathes of which the codes are those of Fanuc.
pub const LATHES: &[&str] = &["fanuc-lathe", "haas-lathe", "mitsubishi-lathe"];

/// What a check reports, on a machine that somebody named.
pub fn check(machine: &str, settings: &[&str], program: &str) -> Vec<Diagnostic> {
    run(machine, settings, program, false)
}

/// The same where nobody named the machine.
pub fn check_assumed(machine: &str, program: &str) -> Vec<Diagnostic> {
    run(machine, &[], program, true)
}

fn run(machine: &str, settings: &[&str], program: &str, assumed_machine: bool) -> Vec<Diagnostic> {
    let mut machine = Machine::from_builtin(machine).expect("a built-in machine");
    for setting in settings {
        machine.set(setting).unwrap_or_else(|error| panic!("{setting}: {error}"));
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.as_bytes().to_vec()));
    let options = RunOptions { assumed_machine, ..RunOptions::default() };
    Job::new(sources, machine).expect("a job").options(options).check().diagnostics
}

/// What is reported of a spindle, a thread or a turret, as `CH613 4`: the code and the line.
pub fn mistakes(found: &[Diagnostic], program: &str) -> Vec<String> {
    const WATCHED: &[&str] = &[
        "CH407", "CH413", "CH606", "CH608", "CH613", "CH614", "CH615", "CH616", "CH617", "CH814",
        "CH818", "CH819",
    ];
    let line = |each: &Diagnostic| {
        let start = each.primary.span.range.start as usize;
        program.as_bytes()[..start].iter().filter(|byte| **byte == b'\n').count() + 1
    };
    let watched = found.iter().filter(|each| WATCHED.contains(&each.code.info().id));
    watched.map(|each| format!("{} {}", each.code.info().id, line(each))).collect()
}

/// A program must be reported with exactly these mistakes, on each of the machines.
#[track_caller]
pub fn expect(machines: &[&str], settings: &[&str], program: &str, expected: &[&str]) {
    for machine in machines {
        let found = check(machine, settings, program);
        let texts: Vec<&str> = found.iter().map(|each| each.message.as_str()).collect();
        assert_eq!(mistakes(&found, program), expected, "{machine}:\n{program}\n{texts:#?}");
    }
}

/// The only diagnostic of this code.
#[track_caller]
pub fn only(found: &[Diagnostic], id: &str) -> Diagnostic {
    let mut all = found.iter().filter(|each| each.code.info().id == id);
    let first = all.next().unwrap_or_else(|| panic!("no {id}: {found:#?}"));
    assert!(all.next().is_none(), "{id} more than once: {found:#?}");
    first.clone()
}

/// Its message has these words, and it has this severity.
#[track_caller]
pub fn says(found: &Diagnostic, severity: Severity, words: &[&str]) {
    assert_eq!(found.severity, severity, "{}", found.message);
    let label = found.primary.text.clone();
    for words in words {
        assert!(
            found.message.contains(words) || label.contains(words),
            "{}\n{label}",
            found.message
        );
    }
}

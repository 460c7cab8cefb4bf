//! What motion a control keeps: every motion code of every control, and a block behind it that names axes alone.
//!
//! A row says what the block after the code does: it repeats the code (`same`), moves as the motion before the code
//! did (`before`), moves straight at the feed (`line`), or is refused (`refused`). Sources: Fanuc B-63534EN and
//! B-63604EN list of G codes (groups 00, 01, 09); Haas operator's manual, group 00 and 01; Mitsubishi M700V manual,
//! list of G codes; RS274/NGC modal groups, each row run with rs274 2.9; GRBL 1.1 gcode.c; Fadal user manual, section
//! on G codes (G1 is cancelled by G0 alone); Mach3 manual, modal groups.

use chordal::{CommandKind, Job, Machine, Severity, Source, SourceMap};

/// The kinds of motion that blocks make.
#[derive(Debug, PartialEq, Clone, Copy)]
enum Made {
    Rapid,
    Line,
    Arc,
    Spline,
    Probe,
    Hole,
    Thread,
    Nothing,
    Refused,
}
use Made::*;

/// What the last two motion blocks of a program make.
fn made(machine: &str, program: &str) -> [Made; 2] {
    let machine = Machine::from_builtin(machine).expect("a built-in machine");
    let mut sources = SourceMap::new();
    sources.add(Source::new("modal.nc", program.as_bytes()));
    let job = Job::new(sources, machine).expect("a machine of its own control");
    let lines = program.lines().count() as u32;
    let mut found = [Nothing; 2];
    let report = job.report_of_commands(|command| {
        let Some(at) = [lines - 2, lines - 1].iter().position(|line| *line == command.origin.line)
        else {
            return;
        };
        let made = &mut found[at];
        match &command.kind {
            CommandKind::Probed { .. } => *made = Probe,
            CommandKind::Spline { .. } => *made = Spline,
            _ if command.origin.cycle => *made = Hole,
            CommandKind::Rapid { .. } if *made == Nothing => *made = Rapid,
            CommandKind::Line { feed, .. } if *made == Nothing => {
                *made = match feed.mode {
                    chordal::control::FeedMode::PerRevolution => Thread,
                    _ => Line,
                };
            }
            CommandKind::Arc { .. } | CommandKind::Spiral { .. } if *made == Nothing => *made = Arc,
            _ => {}
        }
    });
    for (at, line) in [lines - 2, lines - 1].into_iter().enumerate() {
        let is_refused = report.diagnostics.iter().any(|found| {
            let source = job.sources().get(found.primary.span.file).expect("a file of this job");
            found.severity == Severity::Error
                && source.line_of(found.primary.span.range.start) == line
        });
        if is_refused {
            found[at] = Refused;
        }
    }
    found
}

/// A row: the code with its words, the block behind it, what the two make.
type Row = (&'static str, &'static str, [Made; 2]);

fn check(machines: &[&str], head: &str, end: &str, rows: &[Row]) {
    let mut wrong = Vec::new();
    for machine in machines {
        for (code, next, expected) in rows {
            let program = format!("{head}\n{code}\n{next}\n{end}\n");
            let found = made(machine, &program);
            if found != *expected {
                wrong.push(format!("{machine}: {code} | {next}: {found:?}, not {expected:?}"));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of {} rows:\n{}",
        wrong.len(),
        machines.len() * rows.len(),
        wrong.join("\n")
    );
}

#[test]
fn fanuc() {
    check(
        &["fanuc-0i", "fanuc-30i"],
        "O1\nG21 G17 G90 G94 G98 S100 M3 F100\nG0 X0 Y0 Z10.",
        "M30",
        &[
            ("G0 X1.", "X2.", [Rapid, Rapid]),
            ("G1 X1.", "X2.", [Line, Line]),
            ("G1 X1.", "Y2. Z3.", [Line, Line]),
            ("G2 X2. Y0 R1.", "X4. R1.", [Arc, Arc]),
            ("G3 X2. I1.", "X4. I1.", [Arc, Arc]),
            // No. 3403#5 is 0: a straight line.
            ("G3 X2. I1.", "X4.", [Arc, Line]),
            // Not followed, and said.
            ("G33 Z-5. F1.", "Z-9.", [Refused, Rapid]),
            // Group 00: the motion before it stays.
            ("G31 X1.", "X2.", [Probe, Rapid]),
            ("G28 X0", "X2.", [Rapid, Rapid]),
            ("G30 X0", "X2.", [Rapid, Rapid]),
            ("G53 X0", "X2.", [Rapid, Rapid]),
            ("G4 P100", "X2.", [Nothing, Rapid]),
            ("G92 X0", "X2.", [Nothing, Rapid]),
            ("G52 X0", "X2.", [Nothing, Rapid]),
            ("G10 L2 P1 X-500.", "X2.", [Nothing, Rapid]),
            ("G1 G53 X0", "X2.", [Rapid, Line]),
            ("G1 G28 X0", "X2.", [Rapid, Line]),
            // Group 09: a hole at every place, until G80 or a code of group 01.
            ("G81 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G73 Z-5. R2. Q1.", "X2.", [Hole, Hole]),
            ("G74 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G76 Z-5. R2. Q.1", "X2.", [Hole, Hole]),
            ("G82 Z-5. R2. P100", "X2.", [Hole, Hole]),
            ("G83 Z-5. R2. Q1.", "X2.", [Hole, Hole]),
            ("G84 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G85 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G86 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G87 Z-5. R-20. Q.1", "X2.", [Hole, Hole]),
            ("G88 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G89 Z-5. R2. P100", "X2.", [Hole, Hole]),
            ("G81 Z-5. R2.\nG80", "X2.", [Nothing, Rapid]),
            ("G1 X1.\nG81 Z-5. R2.\nG80", "X2.", [Nothing, Line]),
            ("G81 Z-5. R2.\nG1 X1.", "X2.", [Line, Line]),
            ("G81 Z-5. R2.\nG0 X1.", "X2.", [Rapid, Rapid]),
            // A block without axes makes no hole, and the cycle stays.
            ("G81 Z-5. R2.\nG4 P10", "X2.", [Nothing, Hole]),
        ],
    );
}

#[test]
fn mitsubishi() {
    check(
        &["mitsubishi-m700"],
        "O1\nG21 G17 G90 G94 G98 S100 M3 F100\nG0 X0 Y0 Z10.",
        "M30",
        &[
            ("G1 X1.", "X2.", [Line, Line]),
            ("G2 X2. Y0 R1.", "X4. R1.", [Arc, Arc]),
            ("G3 X2. I1.", "X4. I1.", [Arc, Arc]),
            // Type 1 spirals are of group 01.
            ("G2.1 X3. Y0 I1. P1", "X6. I1. P1", [Arc, Arc]),
            // Not followed, and said.
            ("G33 Z-5. F1.", "Z-9.", [Refused, Rapid]),
            ("G31 X1.", "X2.", [Probe, Rapid]),
            ("G28 X0", "X2.", [Rapid, Rapid]),
            ("G53 X0", "X2.", [Rapid, Rapid]),
            ("G92 X0", "X2.", [Nothing, Rapid]),
            ("G52 X0", "X2.", [Nothing, Rapid]),
            ("G81 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G73 Z-5. R2. Q1.", "X2.", [Hole, Hole]),
            ("G83 Z-5. R2. Q1.", "X2.", [Hole, Hole]),
            ("G84 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G1 X1.\nG81 Z-5. R2.\nG80", "X2.", [Nothing, Line]),
            ("G81 Z-5. R2.\nG1 X1.", "X2.", [Line, Line]),
        ],
    );
}

#[test]
fn haas() {
    check(
        &["haas-vf2"],
        "%\nO1\nG21 G17 G90 G94 G98 S100 M3 F100.\nG0 X0 Y0 Z10.",
        "M30",
        &[
            ("G0 X1.", "X2.", [Rapid, Rapid]),
            ("G1 X1.", "X2.", [Line, Line]),
            ("G2 X2. Y0 R1.", "X4. R1.", [Arc, Arc]),
            ("G3 X2. I1.", "X4. I1.", [Arc, Arc]),
            ("G31 X1.", "X2.", [Probe, Rapid]),
            ("G28 X0", "X2.", [Rapid, Rapid]),
            ("G53 X0", "X2.", [Rapid, Rapid]),
            ("G4 P100", "X2.", [Nothing, Rapid]),
            ("G92 X0", "X2.", [Nothing, Rapid]),
            ("G52 X0", "X2.", [Nothing, Rapid]),
            ("G1 X1.\nG53 G0 Z0", "X2.", [Rapid, Rapid]),
            ("G81 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G73 Z-5. R2. Q1.", "X2.", [Hole, Hole]),
            ("G82 Z-5. R2. P.1", "X2.", [Hole, Hole]),
            ("G83 Z-5. R2. Q1.", "X2.", [Hole, Hole]),
            ("G84 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G85 Z-5. R2.", "X2.", [Hole, Hole]),
            ("G89 Z-5. R2. P.1", "X2.", [Hole, Hole]),
            ("G1 X1.\nG81 Z-5. R2.\nG80", "X2.", [Nothing, Line]),
            ("G81 Z-5. R2.\nG1 X1.", "X2.", [Line, Line]),
        ],
    );
}

#[test]
fn fadal() {
    check(
        &["fadal-4020"],
        "%\nO1\nG20 G17 G90 G94 G98 S100 M3 F10.\nG0 X0 Y0 Z1.",
        "M2",
        &[
            ("G0 X1.", "X2.", [Rapid, Rapid]),
            ("G1 X1.", "X2.", [Line, Line]),
            // A direction stays armed: a centre makes an arc of it, and no centre a straight line.
            ("G1 X0\nG2 X2. I1.", "X4. I1.", [Arc, Arc]),
            ("G1 X0\nG2 X2. I1.", "X4.", [Arc, Line]),
            ("G1 X0\nG3 X2. I1.\nG1 X3.", "X5. I1.", [Line, Arc]),
            ("G81 X1. Z-.5 R0.1", "X2.", [Hole, Hole]),
            ("G1 X1.\nG81 Z-.5 R0.1\nG80", "X2.", [Nothing, Line]),
        ],
    );
}

#[test]
fn linuxcnc() {
    check(
        &["linuxcnc-mill"],
        "G21 G17 G90 G94 G98 S100 M3 F100\nG0 X0 Y0 Z10",
        "M2",
        &[
            ("G0 X1", "X2", [Rapid, Rapid]),
            ("G1 X1", "X2", [Line, Line]),
            ("G2 X2 R1", "X4 R1", [Arc, Arc]),
            ("G3 X2 I1", "X4 I1", [Arc, Arc]),
            ("G3 X2 I1", "X4", [Arc, Refused]),
            ("G33 Z-5 K1", "Z-9 K1", [Thread, Thread]),
            ("G33 Z-5 K1", "Z-9", [Thread, Refused]),
            // Probe moves are of group 1.
            ("G38.2 X1", "X2", [Probe, Probe]),
            ("G38.3 X1", "X2", [Probe, Probe]),
            ("G38.4 X1", "X2", [Probe, Probe]),
            ("G38.5 X1", "Y2 Z3", [Probe, Probe]),
            ("G38.2 X1\nG1 Y1", "X2", [Line, Line]),
            ("G38.3 X1\nG80", "X2", [Nothing, Refused]),
            ("G5 X1 Y1 I1 J0 P-1 Q0", "X2 Y2 P-1 Q0", [Spline, Refused]),
            ("G28 X0", "X2", [Rapid, Rapid]),
            ("G53 X0", "X2", [Rapid, Rapid]),
            ("G4 P.1", "X2", [Nothing, Rapid]),
            ("G92 X0", "X2", [Nothing, Rapid]),
            ("G52 X0", "X2", [Nothing, Rapid]),
            ("G10 L2 P1 X0", "X2", [Nothing, Rapid]),
            ("G81 Z-5 R2", "X2", [Hole, Hole]),
            ("G73 Z-5 R2 Q1", "X2", [Hole, Hole]),
            ("G82 Z-5 R2 P.1", "X2", [Hole, Hole]),
            ("G83 Z-5 R2 Q1", "X2", [Hole, Hole]),
            ("G85 Z-5 R2", "X2", [Hole, Hole]),
            ("G86 Z-5 R2 P.1", "X2", [Hole, Hole]),
            ("G89 Z-5 R2 P.1", "X2", [Hole, Hole]),
            // Nothing is in force behind G80.
            ("G80", "X2", [Nothing, Refused]),
            ("G1 X1\nG81 Z-5 R2\nG80", "X2", [Nothing, Refused]),
            ("G81 Z-5 R2\nG1 X1", "X2", [Line, Line]),
        ],
    );
}

#[test]
fn grbl_and_its_family() {
    let rows: &[Row] = &[
        ("G0 X1", "X2", [Rapid, Rapid]),
        ("G1 X1", "X2", [Line, Line]),
        ("G2 X2 Y0 R1", "X4 R1", [Arc, Arc]),
        ("G3 X2 Y0 I1", "X4 I1", [Arc, Arc]),
        ("G38.2 X1", "X2", [Probe, Probe]),
        ("G38.3 X1", "Y2", [Probe, Probe]),
        ("G38.4 X1", "X2", [Probe, Probe]),
        ("G38.5 X1", "X2 Z1", [Probe, Probe]),
        ("G38.3 X1\nG0 Y1", "X2", [Rapid, Rapid]),
        ("G28 X0", "X2", [Rapid, Rapid]),
        ("G53 X0", "X2", [Rapid, Rapid]),
        ("G4 P.1", "X2", [Nothing, Rapid]),
        ("G92 X0", "X2", [Nothing, Rapid]),
        ("G80", "X2", [Nothing, Refused]),
        ("G3 X2 Y0 I1", "X4", [Arc, Refused]),
    ];
    let head = "G21 G17 G90 G94\nS100 M3 F100\nG0 X0 Y0 Z10";
    check(&["grbl", "grblhal", "fluidnc"], head, "M2", rows);
    check(
        &["grblhal"],
        head,
        "M2",
        &[
            ("G81 Z-5 R2", "X2", [Hole, Hole]),
            ("G83 Z-5 R2 Q1", "X2", [Hole, Hole]),
            ("G81 Z-5 R2\nG80", "X2", [Nothing, Refused]),
        ],
    );
}

#[test]
fn mach3() {
    check(
        &["mach3-mill"],
        "G21 G17 G90 G94 G98 S100 M3 F100\nG0 X0 Y0 Z10",
        "M30",
        &[
            ("G0 X1", "X2", [Rapid, Rapid]),
            ("G1 X1", "X2", [Line, Line]),
            ("G2 X2 R1", "X4 R1", [Arc, Arc]),
            ("G3 X2 I1", "X4 I1", [Arc, Arc]),
            ("G28 X0", "X2", [Rapid, Rapid]),
            ("G53 X0", "X2", [Rapid, Rapid]),
            ("G92 X0", "X2", [Nothing, Rapid]),
            ("G81 Z-5 R2", "X2", [Hole, Hole]),
            ("G83 Z-5 R2 Q1", "X2", [Hole, Hole]),
        ],
    );
}

/// Lathes: threads and passes repeat, cycles of several passes do not (groups 01 and 00).
#[test]
fn lathes() {
    let head = "O1\nG21 G99 G97 S500 M3\nT0101\nG0 X50. Z5. F.2";
    check(
        &["fanuc-lathe", "haas-lathe"],
        head,
        "M30",
        &[
            ("G0 X40.", "X41.", [Rapid, Rapid]),
            ("G1 X40.", "X41.", [Thread, Thread]),
            ("G32 Z-5. F1.", "Z-9.", [Thread, Thread]),
            ("G1 X40.\nG4 P100", "X41.", [Nothing, Thread]),
            ("G1 X40.\nG28 U0", "X41.", [Rapid, Thread]),
        ],
    );
    check(
        &["linuxcnc-lathe"],
        "G21 G18 G90 G97 S500 M3\nG95 F.2\nG0 X50 Z5",
        "M2",
        &[
            ("G0 X40", "X41", [Rapid, Rapid]),
            ("G1 X40", "X41", [Thread, Thread]),
            ("G33 Z-5 K1", "Z-9 K1", [Thread, Thread]),
            // A thread cycle stays in force, and needs its words again.
            ("G76 P1 Z-10 I-1 J.3 K.9", "Z-12", [Hole, Refused]),
            ("G76 P1 Z-10 I-1 J.3 K.9", "G0 X60", [Hole, Rapid]),
        ],
    );
}

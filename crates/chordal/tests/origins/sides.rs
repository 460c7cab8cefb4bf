//! Conditions that nobody knows: what is wrong on either side is found, and where.

use chordal::motion::MotionOptions;
use chordal::time::{RepeatPlanning, TimeQuestion};

use super::{program, report};

/// A fault of a program: its code and the line of the case, the first of which is 1.
type Fault = (&'static str, usize);

/// A control, blocks with conditions, the faults in them, and the lines of the conditions of which both sides ran.
type Case = (&'static str, &'static str, &'static [Fault], &'static [usize]);

const CASES: &[Case] = &[
    // The circle with two radii is CH401, a missing label is CH218.
    (
        "fanuc-0i",
        "S100 M3 F100.\nIF[#500EQ1]GOTO9\nG1 X10. Y0.\nGOTO10\nN9 G1 X0 Y0\nG2 X10. Y0 I4. J0\nN10",
        &[("CH401", 6)],
        &[2],
    ),
    ("haas-vf2", "S100 M3 F100.\nIF [#1000EQ1] THEN G0 X9999.\nG0 X1.", &[("CH601", 2)], &[2]),
    (
        "mitsubishi-m700",
        "S100 M3 F100.\n#1=0\nWHILE[#1LT#500]DO1\nG1 X0 Y0\nG2 X10. Y0 I4. J0\n#1=#1+1\nEND1",
        &[("CH401", 5)],
        &[3],
    ),
    // The second condition is met only where the first is fulfilled.
    (
        "fanuc-0i",
        "S100 M3 F100.\nIF[#500EQ0]GOTO9\nG1 X0 Y0\nIF[#501EQ0]GOTO9\nG2 X10. Y0 I4. J0\nN9",
        &[("CH401", 5)],
        &[2, 4],
    ),
    (
        "fanuc-0i",
        "S100 M3 F100.\nIF[#500NE0]GOTO5\nGOTO9\nN5 G1 X0 Y0\nIF[#501NE0]GOTO7\nGOTO9\nN7 G2 X10. Y0 I4. J0\nN9",
        &[("CH401", 7)],
        &[2, 5],
    ),
    // A wait for an input ends.
    ("fanuc-0i", "N5 G4 P100\nIF[#1000EQ0]GOTO5\nG0 X1.", &[], &[2]),
    (
        "linuxcnc-mill",
        "S100 M3 F100\no1 if [#31 GT 2]\nG1 X0 Y0\nG2 X10 Y0 I4 J0\no1 endif",
        &[("CH401", 4)],
        &[2],
    ),
    (
        "linuxcnc-mill",
        "S100 M3 F100\nM66 P0 L0\no1 while [#5399 GT 0]\nG1 X0 Y0\nG2 X10 Y0 I4 J0\no1 endwhile",
        &[("CH401", 5)],
        &[3],
    ),
    (
        "fadal-4020",
        "N10 S100 M3 F100.\n#IF V1 GT 2 THEN GOTO :9\nN11 G1 X0 Y0\nN12 G2 X10. Y0 I4. J0\n#:9",
        &[("CH401", 4)],
        &[2],
    ),
    // A program that stops itself where a value is missing is right.
    ("fanuc-0i", "IF[#500EQ#0]THEN #3000=1(NO VALUE)\nG0 X1.", &[], &[1]),
    // Block delete that decides about a mode is run both ways, another one is not.
    ("fanuc-0i", "S100 M3 F100.\nG1 X0 Y0\n/G91\nG1 X10. Y0\nG90\nG2 X20. Y0 I5. J0", &[], &[]),
    (
        "fanuc-0i",
        "S100 M3 F100.\nG1 X5. Y0\n/G91\nX10. Y0\nG90\nG2 X25. Y0 I5. J0",
        &[("CH401", 6)],
        &[],
    ),
    ("haas-vf2", "S100 M3 F100.\nG1 X5. Y0\n/X10. Y0\nG2 X20. Y0 I5. J0", &[], &[]),
    // Known conditions have one side.
    ("fanuc-0i", "#500=1\nIF[#500EQ1]GOTO9\nG2 X10. Y0 I4. J0\nN9", &[], &[]),
];

#[test]
fn faults_on_both_sides_are_found() {
    let mut wrong = Vec::new();
    for (machine, body, faults, conditions) in CASES {
        let (text, first) = program(machine, body);
        let report = report(machine, &["work_offsets.G54.X=-300 mm"], &text);
        let line = |span: chordal::Span| {
            let before = &text.as_bytes()[..span.range.start as usize];
            2 + before.iter().filter(|byte| **byte == b'\n').count() - first
        };
        let errors: Vec<(&str, usize)> = report
            .diagnostics
            .iter()
            .filter(|each| each.severity == chordal::Severity::Error)
            .map(|each| (each.code.info().id, line(each.primary.span)))
            .collect();
        let run: Vec<usize> = report.other_sides.run.iter().map(|span| line(*span)).collect();
        if errors != *faults || run != *conditions {
            wrong.push(format!(
                "{machine}:\n{body}\n  {errors:?} {run:?}: {:#?}",
                report.diagnostics
            ));
        }
    }
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), CASES.len(), wrong.join("\n"));
}

#[test]
fn too_many_conditions_are_said() {
    let body: String = (0..40).map(|at| format!("IF[#{}EQ1]GOTO9\n", 500 + at)).collect();
    let (text, _) = program("fanuc-0i", &format!("{body}N9"));
    let sides = report("fanuc-0i", &[], &text).other_sides;
    assert_eq!((sides.run.len(), sides.left_out.len()), (16, 24));
}

/// A cube of 40 mm, a mill of 10 mm, and everything else that stock needs.
const SETUP: &[&str] = &[
    "work_offsets.G54.X=-300 mm",
    "work_offsets.G54.Y=-200 mm",
    "work_offsets.G54.Z=-400 mm",
    "tools.1.shape=flat",
    "tools.1.diameter=10 mm",
    "tools.1.length=80 mm",
    "stock.shape=box",
    "stock.from.X=0 mm",
    "stock.from.Y=0 mm",
    "stock.from.Z=-20 mm",
    "stock.to.X=40 mm",
    "stock.to.Y=40 mm",
    "stock.to.Z=0 mm",
];

/// A rapid through the part on the side that is not taken, and one on none.
#[test]
fn stock_is_cut_on_both_sides() {
    let of = |condition: &str, height: &str| {
        let body = format!(
            "T1 M6\nG0 X-20. Y20. S1000 M3\nG43 H1 Z5.\n{condition}GOTO9\nG0 X60.\nGOTO10\nN9 Z{height}\nX60.\nN10 G0 Z50."
        );
        let (text, _) = program("fanuc-0i", &body);
        let job = super::job("fanuc-0i", SETUP, &text);
        let files = |_: &str| Err(String::new());
        let found = job.stock(&chordal::stock::StockOptions::default(), &files).expect("stock");
        (found.verdict, found.report.other_sides.run.len())
    };
    use chordal::stock::StockVerdict::{Clean, NotProved, Problems};
    assert_eq!(of("IF[1EQ0]", "-5."), (Clean, 0));
    assert_eq!(of("IF[1EQ1]", "-5."), (Problems, 0));
    assert_eq!(of("IF[#500EQ1]", "-5."), (Problems, 1));
    assert_eq!(of("IF[#500EQ1]", "1."), (NotProved, 1));
}

/// The way to Y60 takes a second more than the way to Y0: 60 mm at 60 mm/s.
#[test]
fn time_has_a_range() {
    let body = "S100 M3\nG1 X0 Y0 F3600.\nIF[#500EQ1]GOTO9\nX60.\nN9";
    let (text, _) = program("fanuc-0i", body);
    let job = super::job("fanuc-0i", &[], &text);
    let question = TimeQuestion {
        options: MotionOptions::default(),
        repeat_planning: RepeatPlanning::Never,
        computes_least: false,
    };
    let (report, study) = job.time_study(&question);
    let study = study.expect("limits").expect("a time");
    let [least, most] = study.range_s.expect("a range");
    assert_eq!(report.other_sides.run.len(), 1);
    assert!((most - study.timed.time.total_s()).abs() < 1e-9);
    assert!((1.0..1.2).contains(&(most - least)), "{least} to {most}");
}

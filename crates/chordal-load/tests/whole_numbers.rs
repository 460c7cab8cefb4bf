//! Whole numbers without a decimal point on controls that count least increments: a setting of the control says what they
//! are, and a program whose numbers are never written with a trailing point leaves it open.

use chordal::{Code, Report};
use chordal_load::{Loaded, Request, RequestedMachine, text};

fn load(program: &str, set: &[&str], machine: Option<&str>) -> Loaded {
    let request = Request {
        set: set.iter().map(ToString::to_string).collect(),
        machine: machine.map(|name| RequestedMachine::Name(name.into())),
        ..Request::default()
    };
    text("part", program.into(), &request).expect("a program")
}

fn check(loaded: &Loaded) -> Report {
    loaded.job().expect("a job").report()
}

/// How often a code is reported.
fn count(report: &Report, code: Code) -> usize {
    report.diagnostics.iter().filter(|found| found.code == code).count()
}

/// The lowest and the highest X of the cuts, mm.
fn cut_x(report: &Report) -> (f64, f64) {
    let axis = report.summary.axes.iter().find(|axis| axis.letter == 'X').expect("X moves");
    axis.cut_range.expect("cuts along X")
}

/// A program whose header names its control; the cuts go from X10 to X40.
fn program(header: &str) -> String {
    format!(
        "%\nO01001 ({header})\nG21 G17 G40 G80 G90 G54\nT1 M6\nS3000 M3\nG0 X10 Y5.5\n\
         G43 H01 Z25\nZ2.5\nG1 Z-3 F300\nX40 Y20.5\nG0 Z25\nM30\n%\n"
    )
}

#[test]
fn mixed_numbers_are_a_question_where_the_control_is_certain() {
    for header in ["HAAS VF-2", "CONTROL: FANUC", "CONTROL: MITSUBISHI"] {
        let program = program(header);
        let loaded = load(&program, &[], None);
        let report = check(&loaded);
        assert_eq!(count(&report, Code::ReadingNotKnown), 1, "{header}");
        assert!(!report.verified(), "{header}");
        let choices = loaded.choices().expect("readings");
        let sizes: Vec<_> = choices.readings.iter().map(|each| each.size_mm).collect();
        assert_eq!(sizes.len(), 2, "{header}");
        let [least, full] = [0, 1].map(|index| sizes[index].expect("cuts")[0].expect("along X"));
        assert!((least - 0.03).abs() < 1e-9 && (full - 30.0).abs() < 1e-9, "{sizes:?}");
        // Each answer is a reading of its own, and nothing is left to ask.
        for (reading, expected) in choices.readings.iter().zip([(0.01, 0.04), (10.0, 40.0)]) {
            let set: Vec<&str> =
                reading.settings.iter().map(|setting| setting.assignment).collect();
            for machine in [None, Some(reading.machine)] {
                let report = check(&load(&program, &set, machine));
                assert!(report.verified(), "{header}, {set:?}");
                assert_eq!(count(&report, Code::ReadingNotKnown), 0);
                let (low, high) = cut_x(&report);
                let near = (low - expected.0).abs() < 1e-9 && (high - expected.1).abs() < 1e-9;
                assert!(near, "{header}, {set:?}: {low} to {high}");
            }
        }
    }
}

#[test]
fn a_program_that_writes_points_means_its_increments() {
    let program = program("HAAS VF-2").replace("Z25\n", "Z25.\n").replace("X40 ", "X40. ");
    let report = check(&load(&program, &[], None));
    assert_eq!(count(&report, Code::ReadingNotKnown), 0);
    assert!(count(&report, Code::MissingDecimalPoint) > 0);
}

#[test]
fn numbers_in_thousandths_are_no_question() {
    let program = "%\nO01001 (HAAS VF-2)\nG21 G17 G40 G80 G90 G54\nT1 M6\nS3000 M3\nG0 X10000 Y5500\n\
         G43 H01 Z25000\nZ2500\nG1 Z-300 F300\nX40000 Y20500\nG0 Z25000\nM30\n%\n";
    let loaded = load(program, &[], None);
    assert!(loaded.choices().is_none());
    let report = check(&loaded);
    assert!(report.verified());
    assert_eq!(cut_x(&report), (10.0, 40.0));
}

#[test]
fn a_program_without_such_numbers_is_no_question() {
    let program = program("HAAS VF-2");
    let with_points = program.replace("X10 ", "X10.1 ").replace("Z25\n", "Z25.5\n");
    let with_points = with_points.replace("Z-3 ", "Z-3.5 ").replace("X40 ", "X40.5 ");
    let loaded = load(&with_points, &[], None);
    assert!(loaded.choices().is_none());
    assert!(check(&loaded).verified());
    assert!(load(&program, &[], Some("haas-vf2")).choices().is_none(), "the machine is named");
}

/// The post of SolidCAM for a Haas writes whole numbers: the reading in full units comes first, as other controls take them.
#[test]
fn a_likely_control_is_assumed_to_take_them_as_the_others_do() {
    let program = "\nO4902 (LINK)\n(* TOOL LIST *)\n(T02 ID=002  DIA-10.0000  FLAT END MILL)\n\
         N1 G90 G17 G80 G40 G94 G54\nG21\nM6 T02\nG90 G0 X3.4 Y38 S8000 M3\nG43 H002 G0 Z25\nZ2\n\
         G1 Z-1.15 F150\nX40.9\nG0 Z25\nM9\nM5\nG91 G28 Z0\nM30\n%\n";
    let loaded = load(program, &[], None);
    assert_eq!(loaded.control(), "haas");
    let choices = loaded.choices().expect("readings");
    assert!(choices.readings[0].controls.contains(&"linuxcnc"), "{choices:?}");
    assert_eq!(choices.readings[1].controls, ["haas"]);
    let report = check(&loaded);
    assert!(!report.verified());
    assert_eq!((cut_x(&report), report.counts.errors), ((3.4, 40.9), 0));
}

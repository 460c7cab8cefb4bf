//! TRANSMIT and TRACYL on a lathe with a C axis, and its live tools. Numbers are worked out beside each program.

use chordal::control::{CommandKind, SurfaceRun};
use chordal::diagnostics::{Code, FileId, Severity};
use chordal::{Diagnostic, Job, Machine, Source, SourceMap};

const HEAD: &str = "G18 G90 G94 G54 DIAMOF\nT1 D1\n";

fn job(text: &str, machine: &str) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.mpf", text.as_bytes().to_vec()));
    let machine = Machine::from_builtin(machine).expect("a built-in machine");
    Job::new(sources, machine).expect("a machine of this control")
}

/// The problems of a program with a line each; what is only a note is left out.
fn problems(text: &str, machine: &str) -> Vec<(u32, Code, Severity)> {
    let job = job(text, machine);
    let line_of = |found: &Diagnostic| {
        job.sources().get(FileId(0)).expect("the text").line_of(found.primary.span.range.start)
    };
    let found = job.check().diagnostics;
    let told = found.iter().filter(|found| found.severity != Severity::Note);
    told.map(|found| (line_of(found), found.code, found.severity)).collect()
}

/// X (a radius), Z (mm) and C (degrees) of the axes where each move ends.
fn ends(text: &str) -> Vec<[f64; 3]> {
    let (mut ends, mut surface) = (Vec::new(), None::<SurfaceRun>);
    job(text, "sinumerik-lathe-c").report_of_commands(|command| {
        if let CommandKind::Surface { surface: chosen, .. } = &command.kind {
            surface = chosen.map(SurfaceRun::new);
        }
        let Some(motion) = command.kind.motion() else { return };
        let axes = match &mut surface {
            Some(surface) => {
                surface.follow(motion, command.kind.shape());
                surface.on_axes(&motion.to)
            }
            None => motion.to,
        };
        ends.push([axes[0], axes[2], axes[5].to_degrees()]);
    });
    ends
}

fn assert_near(found: &[[f64; 3]], expected: &[[f64; 3]]) {
    let pairs = found.iter().flatten().zip(expected.iter().flatten());
    let near = pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-6);
    assert!(found.len() == expected.len() && near, "{found:?}");
}

#[test]
fn a_line_and_an_arc_on_the_face_turn_the_rotary_axis() {
    let text = format!(
        "{HEAD}SETMS(2)\nS3000 M3\nG0 X40 Z5 C0\nTRANSMIT\nG17\nG1 X30 Y0 F500\nZ-3\nX20 Y20\n\
         G3 X-20 Y20 I-20 J-20\nTRAFOOF\nG0 Z5\nM30\n"
    );
    assert_eq!(problems(&text, "sinumerik-lathe-c"), []);
    let found = ends(&text);
    // (20, 20) lies at 45 degrees, (-20, 20) at 135.
    let angles: Vec<f64> = found.iter().map(|end| end[2]).collect();
    let expected = [0.0, 0.0, 0.0, 45.0, 135.0, 135.0];
    let near = angles.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(angles.len() == expected.len() && near, "{angles:?}");
    // The tool is at the radius of (-20, 20) after the end of the transformation.
    let last = found.last().expect("a move");
    assert!((last[0] - 800_f64.sqrt()).abs() < 1e-9, "{last:?}");
}

#[test]
fn the_length_around_a_cylinder_is_its_angle() {
    // A quarter of the way around a cylinder of diameter 40 is 10π long.
    let quarter = 10.0 * std::f64::consts::PI;
    let text = format!(
        "{HEAD}SETMS(2)\nS3000 M3\nG0 X25 Z5 C0\nTRACYL(40)\nG19\nG1 X18 Z-5 Y0 F300\n\
         Y={quarter}\nZ-20 Y0\nTRAFOOF\nG0 X25\nM30\n"
    );
    assert_eq!(problems(&text, "sinumerik-lathe-c"), []);
    let expected = [
        [25.0, 5.0, 0.0],
        [18.0, -5.0, 0.0],
        [18.0, -5.0, 90.0],
        [18.0, -20.0, 0.0],
        [25.0, -20.0, 0.0],
    ];
    assert_near(&ends(&text), &expected);
}

#[test]
fn a_call_with_the_number_of_the_transformation_is_the_same() {
    let text = format!(
        "{HEAD}S2=3000 M2=3\nG0 X40 Z5 C0\nTRANSMIT(1)\nG17\nG1 X20 Y20 F500\nTRAFOOF\nM30\n"
    );
    assert_eq!(problems(&text, "sinumerik-lathe-c"), []);
    let last = ends(&text).pop().expect("a move");
    assert!((last[2] - 45.0).abs() < 1e-9, "{last:?}");
}

#[test]
fn the_transformation_must_exist_and_compensation_be_off() {
    let no_axis = format!("{HEAD}S1000 M3\nG0 X40 Z5\nTRANSMIT\nG1 X30 Y0 F500\nM30\n");
    let lathe = problems(&no_axis, "sinumerik-lathe");
    assert_eq!(lathe.first().map(|found| (found.0, found.2)), Some((5, Severity::Error)));
    let tilted = "G17 G54\nT1 M6\nS1000 M3\nTRAORI\nG1 X30 Y0 F500\nM30\n";
    let mill = problems(tilted, "sinumerik-mill");
    assert!(mill.iter().any(|found| (found.0, found.2) == (4, Severity::Error)), "{mill:?}");
    let compensated = format!(
        "{HEAD}S1000 M3\nG0 X40 Z5 C0\nG1 G41 X30 Z0 F500\nZ-10\nTRANSMIT\nG1 X30 Y0\nM30\n"
    );
    let found = problems(&compensated, "sinumerik-lathe-c");
    assert!(found.iter().any(|found| (found.0, found.2) == (7, Severity::Error)), "{found:?}");
}

#[test]
fn the_face_starts_at_another_angle() {
    // At C30 the tool at X40 is at (34.641, 20) of the face; Y0 is at C0, (40, 40) at C45.
    let text = format!(
        "{HEAD}S2=3000 M2=3\nG0 X40 Z5 C30\nTRANSMIT\nG17\nG1 X40 Y0 F500\nY40\nTRAFOOF\nM30\n"
    );
    assert_eq!(problems(&text, "sinumerik-lathe-c"), []);
    let angles: Vec<f64> = ends(&text).iter().map(|end| end[2]).collect();
    let near = angles.iter().zip([30.0, 0.0, 45.0]).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(angles.len() == 3 && near, "{angles:?}");
}

#[test]
fn a_live_tool_cuts_while_the_main_spindle_stands() {
    // S2, M2=3 start the second spindle; with SETMS(2) S and M3 are its own.
    for start in ["S2=3000 M2=3", "SETMS(2)\nS3000 M3"] {
        let text = format!("{HEAD}{start}\nG0 X40 Z5 C0\nG1 Z-5 F300\nG0 Z5\nM30\n");
        assert_eq!(problems(&text, "sinumerik-lathe-c"), [], "{start}");
    }
    // After M2=5 nothing turns.
    let stopped = format!("{HEAD}S2=3000 M2=3\nM2=5\nG0 X40 Z5\nG1 Z-5 F300\nM30\n");
    let found = problems(&stopped, "sinumerik-lathe-c");
    assert!(found.iter().any(|found| found.1 == Code::SpindleStopped || found.0 == 6), "{found:?}");
    // G95 counts its revolutions: 50 mm at 0.1 mm of 3000 rev/min take 10 s.
    let turns = format!("{HEAD}SETMS(2)\nG95 S3000 M3\nG0 X40 Z5\nG1 Z-45 F0.1\nM30\n");
    let report = job(&turns, "sinumerik-lathe-c").report_of_commands(|_| {});
    let time = report.summary.feed_time_s;
    assert!((time - 10.0).abs() < 1e-9, "{time}");
}

#[test]
fn text_of_the_iso_mode_is_not_read_as_sinumerik() {
    let text = "G17 G54 G90\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG291\nG00 G43 H1 Z10.\n\
                G81 X1. R2. Z-5. F100\nG65 P9010 A1.\n#100=5\nG290\nG1 X10 Y0 Z5 F500\nM30\n";
    let found = problems(text, "sinumerik-mill");
    // One error where it begins, and nothing about what follows.
    let errors: Vec<u32> =
        found.iter().filter(|found| found.2 == Severity::Error).map(|found| found.0).collect();
    assert_eq!(errors, [5]);
}

#[test]
fn setms_alone_gives_s_and_m3_back_to_the_main_spindle() {
    let text = format!(
        "{HEAD}SETMS(2)\nS3000 M3\nG0 X40 Z5 C0\nG1 Z-5 F300\nM5\nSETMS\nG95 S600 M3\nG1 Z-35 F0.1\nM30\n"
    );
    assert_eq!(problems(&text, "sinumerik-lathe-c"), []);
    // 10 mm at 300 mm/min take 2 s, 30 mm at 0.1 mm of 600 rev/min 30 s.
    let report = job(&text, "sinumerik-lathe-c").report_of_commands(|_| {});
    let time = report.summary.feed_time_s;
    assert!((time - 32.0).abs() < 1e-9, "{time}");
}

//! Contours of LinuxCNC's G70 to G72: U and W are increments, A rounds and C chamfers the end of a move, whichever axes the
//! machine has. Expected are the moves that LinuxCNC's own interpreter (rs274 2.9) prints for the same blocks.

use chordal::control::{Origin, Sink};
use chordal::{Command, CommandKind, Diagnostic, Job, Machine, Severity, Source, SourceMap};

/// Ends of moves, X as a radius and Z; of arcs the centre, too. Without those that stand.
type Move = ([f64; 2], Option<[f64; 2]>);

fn job(text: &str) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.ngc", text.as_bytes().to_vec()));
    Job::new(sources, Machine::from_builtin("linuxcnc-lathe").unwrap()).unwrap()
}

fn moves(text: &str) -> (Vec<Move>, Vec<Diagnostic>) {
    let job = job(text);
    let mut moves = Vec::new();
    let report = job.report_of_commands(|command: &Command| {
        let Some(motion) = command.kind.motion() else { return };
        let center = command.kind.shape().map(|shape| [shape.center[1], shape.center[0]]);
        let stands = (0..3).all(|axis| (motion.from[axis] - motion.to[axis]).abs() < 1e-9);
        if !stands || matches!(command.kind, CommandKind::Arc { .. }) {
            moves.push(([motion.to[0], motion.to[2]], center));
        }
    });
    (moves, report.diagnostics)
}

/// A finishing cycle about a contour, from X 40 Z 2.
fn program(contour: &str, mode: &str) -> String {
    format!(
        "G21 G18 G90 G40 {mode} F100\nM3 S500\nG0 X40 Z2\nO100 SUB\n{contour}\nO100 ENDSUB\nG70 Q100\nM2\n"
    )
}

#[track_caller]
fn goes(contour: &str, mode: &str, expected: &[Move]) {
    let (moves, problems) = moves(&program(contour, mode));
    let errors: Vec<_> = problems.iter().filter(|one| one.severity == Severity::Error).collect();
    assert!(errors.is_empty(), "{contour}: {errors:?}");
    let contour_moves = &moves[1..];
    assert_eq!(contour_moves.len(), expected.len(), "{contour} {mode}\n{moves:?}");
    for (found, wanted) in contour_moves.iter().zip(expected) {
        let near =
            |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() < 6e-5 && (a[1] - b[1]).abs() < 6e-5;
        let centers = match (found.1, wanted.1) {
            (Some(a), Some(b)) => near(a, b),
            (a, b) => a == b,
        };
        assert!(
            near(found.0, wanted.0) && centers,
            "{contour} {mode}\n{found:?} {wanted:?}\n{moves:?}"
        );
    }
}

const fn line(x: f64, z: f64) -> Move {
    ([x, z], None)
}

const fn arc(x: f64, z: f64, center: [f64; 2]) -> Move {
    ([x, z], Some(center))
}

#[test]
fn increments_are_those_of_their_axes() {
    let contour = "G0 X10\nG1 Z-5\nU5 W-4\nU3\nW-2";
    goes(
        contour,
        "G8",
        &[line(10.0, 2.0), line(10.0, -5.0), line(15.0, -9.0), line(18.0, -9.0), line(18.0, -11.0)],
    );
    // Of diameters U is half as much.
    goes(
        contour,
        "G7",
        &[line(5.0, 2.0), line(5.0, -5.0), line(7.5, -9.0), line(9.0, -9.0), line(9.0, -11.0)],
    );
}

#[test]
fn a_rounds_and_c_chamfers_the_end_of_a_move() {
    let end = [line(14.0, -20.0)];
    // Corners of 90° and of 45°: the chamfer joins the points where a rounding would touch.
    goes(
        "G0 X10\nG1 Z-5\nX20 A1\n Z-20",
        "G8",
        &[
            line(10.0, 2.0),
            line(10.0, -5.0),
            line(19.0, -5.0),
            arc(20.0, -6.0, [19.0, -6.0]),
            line(20.0, -20.0),
        ],
    );
    goes(
        "G0 X10\nG1 Z-5\nX20 A1\n Z-20",
        "G7",
        &[
            line(5.0, 2.0),
            line(5.0, -5.0),
            line(9.0, -5.0),
            arc(10.0, -6.0, [9.0, -6.0]),
            line(10.0, -20.0),
        ],
    );
    goes(
        "G0 X10\nG1 Z-5\nX14 Z-9 C1\nZ-20",
        "G8",
        &[
            &[line(10.0, 2.0), line(10.0, -5.0), line(13.7071, -8.7071), line(14.0, -9.4142)],
            &end[..],
        ]
        .concat(),
    );
    goes(
        "G0 X10\nG1 Z-5 C1\nX14 Z-6 C.5\nZ-20",
        "G8",
        &[
            &[line(10.0, 2.0), line(10.0, -4.2192), line(10.7575, -5.1894)][..],
            &[line(13.6213, -5.9053), line(14.0, -6.3904)][..],
            &end[..],
        ]
        .concat(),
    );
    // Beside arcs, with a sign, at the end of all, after a rapid, and alone.
    goes(
        "G0 X10\nG1 Z-5 A1\nG3 X14 Z-9 R4\nG1 Z-20",
        "G8",
        &[
            &[line(10.0, 2.0), line(10.0, -4.1010), arc(10.8, -5.0808, [11.0, -4.1010])][..],
            &[arc(14.0, -9.0, [10.0, -9.0])][..],
            &end[..],
        ]
        .concat(),
    );
    goes(
        "G0 X10\nG1 Z-5\nG3 X14 Z-9 R4 C1\nG1 X20\n Z-20",
        "G8",
        &[
            line(10.0, 2.0),
            line(10.0, -5.0),
            arc(13.9192, -8.2, [10.0, -9.0]),
            line(14.8990, -9.0),
            line(20.0, -9.0),
            line(20.0, -20.0),
        ],
    );
    goes(
        "G0 X10 A-1\nG1 Z-5\nA3\nX20\n Z-20 A2",
        "G8",
        &[
            line(11.0, 2.0),
            arc(10.0, 1.0, [11.0, 1.0]),
            line(10.0, -5.0),
            line(20.0, -5.0),
            line(20.0, -20.0),
        ],
    );
}

#[test]
fn a_corner_shorter_than_a_thousandth_is_none() {
    // A turn by 0.1°: a rounding of 0.55 mm would be 0.00096 mm long, one of 0.6 mm is 0.00105 mm.
    let [x, z] = [10.017_453, -14.999_985];
    for (radius, corners) in [("0.55", 0), ("0.6", 1), ("3", 1)] {
        for letter in ["A", "C"] {
            let contour = format!("G0 X10\nG1 Z-5 {letter}{radius}\nX{x} Z{z}\nX40");
            let (moves, _) = moves(&program(&contour, "G8"));
            assert_eq!(moves.len(), 5 + corners, "{contour} {moves:?}");
        }
    }
    // An arc that goes on from a line.
    let contour = "G0 X10\nG1 Z-5\nX14 A.5\nG3 X17 Z-8 R3\nG1 Z-20";
    let end = [line(14.0, -5.0), arc(17.0, -8.0, [14.0, -8.0]), line(17.0, -20.0)];
    goes(contour, "G8", &[&[line(10.0, 2.0), line(10.0, -5.0)][..], &end[..]].concat());
}

#[test]
fn what_the_control_refuses_is_said_in_its_words() {
    for (contour, alarm) in [
        ("G0 X10\nG1 Z-5\nX14 U1\nZ-20", "Cannot use U and X in the same block"),
        ("G0 X10\nG1 Z-5\nZ-8 W-1\nZ-20", "Cannot use W and Z in the same block"),
        ("G0 X10\nG1 Z-5 C1\nX20 A.5 C.3\n Z-20", "Both A and C parameters on a corner"),
    ] {
        let (_, problems) = moves(&program(contour, "G8"));
        let said =
            problems.iter().any(|one| one.alarm.as_ref().is_some_and(|text| text.ends_with(alarm)));
        assert!(said, "{contour}: {problems:?}");
    }
}

#[test]
fn outside_of_contours_the_letters_are_what_they_were() {
    let (_, problems) = moves("G21 G18 G90 G8 F100\nM3 S500\nG0 X40 Z2\nG1 X30 A1\nG1 U3\nM2\n");
    let codes: Vec<&str> = problems.iter().map(|one| one.code.id()).collect();
    assert!(codes.contains(&"CH309") && codes.contains(&"CH304"), "{codes:?}");
}

/// Ends of the moves of a mill.
#[derive(Default)]
struct Ends(Vec<[f64; 3]>);

impl Sink for Ends {
    fn command(&mut self, command: &Command) {
        if let Some(motion) = command.kind.motion() {
            self.0.push([motion.to[0], motion.to[1], motion.to[2]]);
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl chordal::RunSink for Ends {
    fn block_done(&mut self, _: &Origin, _: &chordal::control::AfterBlock) {}
}

#[test]
fn one_name_for_a_subroutine_and_for_a_loop_outside_of_it() {
    let sub = "O101 SUB\nG1 Y5\nO101 ENDSUB\n";
    let cases: [(String, &[[f64; 3]]); 5] = [
        // A loop of the main program, which calls the subroutine of its name.
        (
            format!("{sub}O101 REPEAT [2]\nO101 CALL\nG91 G1 X1\nG90\nO101 ENDREPEAT\n"),
            &[[0., 5., 0.], [1., 5., 0.], [1., 5., 0.], [2., 5., 0.]],
        ),
        (
            format!("{sub}O101 IF [1 GT 0]\nG1 X3\nO101 ENDIF\nO101 CALL\n"),
            &[[3., 0., 0.], [3., 5., 0.]],
        ),
        (
            format!(
                "{sub}#1=0\nO101 WHILE [#1 LT 2]\n#1=[#1+1]\nG1 Z[#1]\nO101 ENDWHILE\nO101 CALL\n"
            ),
            &[[0., 0., 1.], [0., 0., 2.], [0., 5., 2.]],
        ),
        // A loop of another subroutine, before and after.
        (
            format!(
                "O102 SUB\nO101 REPEAT [2]\nG91 G1 X1\nG90\nO101 ENDREPEAT\nO102 ENDSUB\n{sub}O102 CALL\nO101 CALL\n"
            ),
            &[[1., 0., 0.], [2., 0., 0.], [2., 5., 0.]],
        ),
        // A loop of its own name in the subroutine itself.
        (
            "O101 SUB\nO101 REPEAT [2]\nG91 G1 X1\nG90\nO101 ENDREPEAT\nO101 ENDSUB\nO101 CALL\n"
                .into(),
            &[[1., 0., 0.], [2., 0., 0.]],
        ),
    ];
    for (body, expected) in cases {
        let text = format!("G21 G90 F100 S900 M3\n{body}M2\n");
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.ngc", text.as_bytes().to_vec()));
        let job = Job::new(sources, Machine::from_builtin("linuxcnc-mill").unwrap()).unwrap();
        let mut ends = Ends::default();
        job.run(&mut ends);
        assert_eq!(ends.0, expected, "{text}");
        let errors =
            job.check().diagnostics.into_iter().filter(|one| one.severity == Severity::Error);
        assert_eq!(errors.count(), 0, "{text}");
    }
    // Two structures of one level with one name are an error there, too.
    let twice = "G21 G90 F100 S900 M3\nO5 IF [1 GT 0]\nG1 X3\nO5 ENDIF\nO5 REPEAT [2]\nG1 X2\nO5 ENDREPEAT\nM2\n";
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.ngc", twice.as_bytes().to_vec()));
    let job = Job::new(sources, Machine::from_builtin("linuxcnc-mill").unwrap()).unwrap();
    assert!(job.check().diagnostics.iter().any(|one| one.code.id() == "CH712"));
}

//! PLANE and M128 on the machine with the tables B and C. Where the tip is on the part follows from the positions of the
//! axes by two rotations that are written out here.

use chordal::diagnostics::Severity;
use chordal::motion::{MotionOptions, MotionStep, StepSource};
use chordal::{Job, Machine, Source, SourceMap};

/// C through X-300 Y-200 on B through X-300 Z-400; the preset at (-300, -200, -380), and above it a tool of 100 mm.
const MACHINE: &str = "inherits = 'heidenhain-bc-trunnion'
[rotary.B]
point = { X = '-300 mm', Z = '-400 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
[work_offsets.G54]
X = '-300 mm'
Y = '-200 mm'
Z = '-380 mm'
[tools.1]
length = '100 mm'
diameter = '10 mm'
";

const PRESET: [f64; 3] = [-300.0, -200.0, -380.0];
const LENGTH_MM: f64 = 100.0;

/// A move of the axes: its line, and where it ends: mm of the gauge point and degrees, machine coordinates.
struct AxesEnd {
    line: u32,
    place: [f64; 6],
}

fn run(blocks: &str, settings: &str) -> Vec<AxesEnd> {
    let machine = format!("{MACHINE}[settings]\n{settings}\n");
    let machine = Machine::from_toml("five.toml", &machine, &|name| Err(format!("no {name}")));
    let mut sources = SourceMap::new();
    let text = format!("BEGIN PGM A MM\nTOOL CALL 1 Z S5000\n{blocks}\nM30\nEND PGM A MM\n");
    sources.add(Source::new("a.h", text.into_bytes()));
    let job = Job::new(sources, machine.expect("a machine")).expect("a job");
    let report = job.check();
    let found: Vec<_> =
        report.diagnostics.iter().filter(|found| found.severity == Severity::Error).collect();
    assert!(found.is_empty(), "{blocks}\n{found:#?}");
    let mut ends = Vec::new();
    let taken = job.motion(&MotionOptions::default(), |step: &MotionStep, source: &StepSource| {
        if let MotionStep::Move(motion) = step {
            let to = motion.to();
            let gauge_point = [PRESET[0], PRESET[1], PRESET[2] + LENGTH_MM];
            let place = std::array::from_fn(|axis| match axis {
                0..3 => to[axis] + gauge_point[axis],
                _ => to[axis].to_degrees(),
            });
            ends.push(AxesEnd { line: source.origin.line, place });
        }
        Ok(())
    });
    assert!(taken.is_ok());
    drop(taken);
    ends
}

/// The tip on the part as it lies with the tables at zero, from the preset: the tables are turned back.
fn tip([x, y, z, _, b, c]: [f64; 6]) -> [f64; 3] {
    let tip = [x, y, z - LENGTH_MM];
    let (sin, cos) = b.to_radians().sin_cos();
    let [u, w] = [tip[0] + 300.0, tip[2] + 400.0];
    let about_b = [u * cos + w * sin - 300.0, tip[1], w * cos - u * sin - 400.0];
    let (sin, cos) = c.to_radians().sin_cos();
    let [u, v] = [about_b[0] + 300.0, about_b[1] + 200.0];
    let about_c = [u * cos - v * sin - 300.0, u * sin + v * cos - 200.0, about_b[2]];
    std::array::from_fn(|axis| about_c[axis] - PRESET[axis])
}

/// The direction of the tool on the part.
fn direction([.., b, c]: [f64; 6]) -> [f64; 3] {
    let [b, c] = [b, c].map(f64::to_radians);
    [b.sin() * c.cos(), b.sin() * c.sin(), b.cos()]
}

/// A vector turned about X, then Y, then Z by these degrees.
fn spatial([x, y, z]: [f64; 3], degrees: [f64; 3]) -> [f64; 3] {
    let [a, b, c] = degrees.map(f64::to_radians);
    let (y, z) = (y * a.cos() - z * a.sin(), y * a.sin() + z * a.cos());
    let (x, z) = (x * b.cos() + z * b.sin(), z * b.cos() - x * b.sin());
    [x * c.cos() - y * c.sin(), x * c.sin() + y * c.cos(), z]
}

fn distance(one: [f64; 3], other: [f64; 3]) -> f64 {
    (0..3).map(|axis| (one[axis] - other[axis]).powi(2)).sum::<f64>().sqrt()
}

#[track_caller]
fn near(found: [f64; 3], expected: [f64; 3]) {
    assert!(distance(found, expected) < 1e-4, "{found:?} is not {expected:?}");
}

fn last(ends: &[AxesEnd], line: u32) -> [f64; 6] {
    ends.iter().rfind(|end| end.line == line).expect("a move of this line").place
}

#[test]
fn the_tip_stays_on_its_line_while_both_tables_turn() {
    let ends = run(
        "L X+10 Y+0 Z+20 B+0 C+0 R0 FMAX M3
M128
L X+40 Y+10 Z+5 B+30 C+45 F500
L X-20 Y-30 Z+15 B-20 C+100
M129
L Z+60 FMAX",
        "",
    );
    let points = [[10.0, 0.0, 20.0], [40.0, 10.0, 5.0], [-20.0, -30.0, 15.0]];
    for (line, ends_of_line) in [(5, [points[0], points[1]]), (6, [points[1], points[2]])] {
        let own: Vec<[f64; 6]> =
            ends.iter().filter(|end| end.line == line).map(|end| end.place).collect();
        assert!(own.len() > 5, "line {line} is {} moves", own.len());
        let [from, to] = ends_of_line;
        let length = distance(from, to);
        for place in &own {
            let at = tip(*place);
            let along: f64 =
                (0..3).map(|axis| (at[axis] - from[axis]) * (to[axis] - from[axis])).sum();
            let share = along / (length * length);
            let on_line = [0, 1, 2].map(|axis| from[axis] + (to[axis] - from[axis]) * share);
            assert!(distance(at, on_line) < 0.002, "{at:?} is off the line");
        }
        near(tip(*own.last().expect("a move")), to);
    }
}

#[test]
fn every_form_of_a_plane_stands_upright_and_its_points_are_rotated() {
    let angles = [20.0, 30.0, 40.0];
    let [x, z] = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| spatial(axis, angles));
    let vector = format!(
        "VECTOR BX{:+.9} BY{:+.9} BZ{:+.9} NX{:+.9} NY{:+.9} NZ{:+.9}",
        x[0], x[1], x[2], z[0], z[1], z[2]
    );
    for form in ["SPATIAL SPA+20 SPB+30 SPC+40", &vector] {
        for positioning in ["TURN FMAX", "MOVE DIST50 F1000", "TURN FMAX SEQ+", "TURN FMAX SEQ-"] {
            let ends = run(
                &format!(
                    "L X+0 Y+0 Z+50 B+0 C+0 R0 FMAX M3
PLANE {form} {positioning}
L X+10 Y+5 Z+2 F500
L X-12
PLANE RESET TURN FMAX
L Z+60 FMAX"
                ),
                "",
            );
            let [first, second] = [5, 6].map(|line| last(&ends, line));
            near(direction(first), z);
            near(tip(first), spatial([10.0, 5.0, 2.0], angles));
            near(tip(second), spatial([-12.0, 5.0, 2.0], angles));
            let [.., b, _] = first;
            match positioning {
                "TURN FMAX SEQ+" => assert!(b > 0.0),
                "TURN FMAX SEQ-" => assert!(b < 0.0),
                _ => {}
            }
            let [.., b, c] = last(&ends, 7);
            assert!(b.abs() < 1e-9 && c.abs() < 1e-9);
        }
    }
}

#[test]
fn seq_with_stay_chooses_the_angles_of_the_parameters() {
    for (sequence, is_right) in [("+", 1.0), ("-", -1.0)] {
        let ends = run(
            &format!(
                "L X+0 Y+0 Z+50 B+0 C+0 R0 FMAX M3
PLANE SPATIAL SPA+0 SPB+30 SPC+20 STAY SEQ{sequence}
L B+Q121 C+Q122 FMAX
L X+10 Y+5 Z+2 F500"
            ),
            "",
        );
        let first = last(&ends, 6);
        near(direction(first), spatial([0.0, 0.0, 1.0], [0.0, 30.0, 20.0]));
        near(tip(first), spatial([10.0, 5.0, 2.0], [0.0, 30.0, 20.0]));
        assert!(first[4] * is_right > 0.0, "{first:?}");
    }
}

#[test]
fn axial_planes_lie_as_the_tables_turn() {
    // Axes of the machine on the part: about Y by B, then about Z by C.
    let of = |point: [f64; 3], b: f64, c: f64| spatial(point, [0.0, b, c]);
    let program = |words: &str, rest: &str| {
        run(
            &format!(
                "L X+0 Y+0 Z+50 B+0 C+10 R0 FMAX M3\n{rest}PLANE AXIAL {words}\nL X+10 Y+5 Z+2 F500"
            ),
            "",
        )
    };
    let first = last(&program("B-25 C+70 TURN FMAX", ""), 5);
    assert!((first[4] + 25.0).abs() < 1e-9 && (first[5] - 70.0).abs() < 1e-9, "{first:?}");
    near(tip(first), of([10.0, 5.0, 2.0], -25.0, 70.0));
    // An axis without a word stays, an incremental one goes on from where it is.
    let first = last(&program("B+40 TURN FMAX", ""), 5);
    near(tip(first), of([10.0, 5.0, 2.0], 40.0, 10.0));
    let first = last(&program("B+40 IC+20 MOVE DIST50 F500", ""), 5);
    near(tip(first), of([10.0, 5.0, 2.0], 40.0, 30.0));
    // A datum shift and a rotation before: the datum turns the point of the plane, and not its axes.
    let shift = "CYCL DEF 7.0\nCYCL DEF 7.1 X+20\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+33\n";
    let first = last(&program("B+40 C+10 TURN FMAX", shift), 9);
    let [x, y, z] = of([10.0, 5.0, 2.0], 40.0, 10.0);
    near(tip(first), [x + 20.0, y, z]);
    let stay = run(
        "L X+0 Y+0 Z+50 B+0 C+0 R0 FMAX M3\nPLANE AXIAL B+30 C+45 STAY\nL B+Q121 C+Q122 FMAX\nL X+10 Y+5 Z+2 F500",
        "",
    );
    near(tip(last(&stay, 6)), of([10.0, 5.0, 2.0], 30.0, 45.0));
}

#[test]
fn projected_planes_rise_by_their_angles() {
    let program = |words: &str, settings: &str| {
        let ends = run(
            &format!(
                "L X+0 Y+0 Z+50 B+0 C+0 R0 FMAX M3\nPLANE PROJECTED {words} TURN FMAX\nL X+10 Y+5 Z+2 F500"
            ),
            settings,
        );
        last(&ends, 5)
    };
    // Along Y alone it is a rotation about X, along X alone one about Y.
    let minor = program("PROPR+0 PROMIN+35 ROT+0", "");
    near(tip(minor), spatial([10.0, 5.0, 2.0], [35.0, 0.0, 0.0]));
    let main = program("PROPR+25 PROMIN+0 ROT+0", "");
    near(tip(main), spatial([10.0, 5.0, 2.0], [0.0, -25.0, 0.0]));
    let falling = program("PROPR+25 PROMIN+0 ROT+0", "projected_angle = \"falling\"");
    near(tip(falling), spatial([10.0, 5.0, 2.0], [0.0, 25.0, 0.0]));
    // Turned by 90 degrees in the plane, X goes along Y.
    let turned = program("PROPR+0 PROMIN+35 ROT+90", "");
    near(tip(turned), spatial([-5.0, 10.0, 2.0], [35.0, 0.0, 0.0]));
}

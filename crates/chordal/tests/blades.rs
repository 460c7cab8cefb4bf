//! Blades and flanks on three kinematics: the same program, given by the tip and the direction of the tool, is run on a
//! trunnion, on a head with a table and on a nutating head. What the axes do is turned back to the part by the formulas
//! of the machines, written here apart from those of the crates.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use chordal::diagnostics::{Code, Severity};
use chordal::motion::{MotionOptions, PlannerLevel, SamplingRequest};
use chordal::time::ReferenceQuality;
use chordal::{Job, Machine, Source, SourceMap};

type Vector = [f64; 3];

const WORK_OFFSET: Vector = [-300.0, -250.0, -380.0];
const TOOL_LENGTH_MM: f64 = 100.0;

/// A rotary axis: its index among X Y Z A B C, the direction it turns about, and a point on it: of a table in machine
/// coordinates, of a head from the gauge point.
struct Rotation {
    axis: usize,
    direction: Vector,
    point: Vector,
}

struct MachineFormulas {
    name: &'static str,
    machine: &'static str,
    /// Where the rotary axes stand before the first vector: on the side of the pole on which they stay.
    start: &'static str,
    /// From the tool to the machine frame.
    heads: Vec<Rotation>,
    /// From the machine frame to the part.
    tables: Vec<Rotation>,
}

fn rotation(axis: usize, direction: Vector, point: Vector) -> Rotation {
    Rotation { axis, direction, point }
}

fn all_kinematics() -> [MachineFormulas; 3] {
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let halfway = [0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2];
    [
        MachineFormulas {
            name: "trunnion",
            machine: "inherits = 'fanuc-ac-trunnion'
[rotary.A]
point = { Y = '-200 mm', Z = '-400 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
",
            start: "A20. C135.",
            heads: vec![],
            tables: vec![
                rotation(3, x, [0.0, -200.0, -400.0]),
                rotation(5, z, [-300.0, -200.0, 0.0]),
            ],
        },
        MachineFormulas {
            name: "head and table",
            machine: "inherits = 'fanuc-head-table'
[rotary.B]
point = { X = '0 mm', Z = '150 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
",
            start: "B20. C0",
            heads: vec![rotation(4, y, [0.0, 0.0, 150.0])],
            tables: vec![rotation(5, z, [-300.0, -200.0, 0.0])],
        },
        MachineFormulas {
            name: "nutating head",
            machine: "inherits = 'fanuc-nutating-head'
",
            start: "B20. C0",
            heads: vec![rotation(4, halfway, [0.0, 0.0, 150.0]), rotation(5, z, [0.0, 0.0, 0.0])],
            tables: vec![],
        },
    ]
}

fn add(a: Vector, b: Vector, factor: f64) -> Vector {
    std::array::from_fn(|axis| a[axis] + factor * b[axis])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// Rodrigues' formula.
fn turn(v: Vector, about: Vector, angle: f64) -> Vector {
    let cross = [
        about[1] * v[2] - about[2] * v[1],
        about[2] * v[0] - about[0] * v[2],
        about[0] * v[1] - about[1] * v[0],
    ];
    let (sin, cos) = angle.sin_cos();
    let along = dot(about, v) * (1.0 - cos);
    std::array::from_fn(|axis| v[axis] * cos + cross[axis] * sin + about[axis] * along)
}

impl MachineFormulas {
    /// The tip in coordinates of the part and the direction from the tip to the spindle, from a setpoint.
    fn tip(&self, setpoint: &[f64; 6]) -> (Vector, Vector) {
        let mut tip = [0.0, 0.0, -TOOL_LENGTH_MM];
        let mut direction = [0.0, 0.0, 1.0];
        for Rotation { axis, direction: about, point } in &self.heads {
            tip = add(*point, turn(add(tip, *point, -1.0), *about, setpoint[*axis]), 1.0);
            direction = turn(direction, *about, setpoint[*axis]);
        }
        // A setpoint is in coordinates of the program that leave the rotary axes out: the work offset and the length
        // bring it to the gauge point.
        let gauge_point = [
            setpoint[0] + WORK_OFFSET[0],
            setpoint[1] + WORK_OFFSET[1],
            setpoint[2] + WORK_OFFSET[2] + TOOL_LENGTH_MM,
        ];
        tip = add(tip, gauge_point, 1.0);
        for Rotation { axis, direction: about, point } in &self.tables {
            tip = add(*point, turn(add(tip, *point, -1.0), *about, setpoint[*axis]), 1.0);
            direction = turn(direction, *about, setpoint[*axis]);
        }
        (add(tip, WORK_OFFSET, -1.0), direction)
    }

    fn job(&self, text: &str) -> Job<'static> {
        let common = format!(
            "{}[work_offsets.G54]\nX = '{} mm'\nY = '{} mm'\nZ = '{} mm'\n[tools.1]\nlength = '{TOOL_LENGTH_MM} mm'\n\
             diameter = '6 mm'\n",
            self.machine, WORK_OFFSET[0], WORK_OFFSET[1], WORK_OFFSET[2]
        );
        let machine = Machine::from_toml("five.toml", &common, &|name| Err(format!("no {name}")))
            .expect("a machine");
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
        Job::new(sources, machine).expect("good settings")
    }
}

/// A point of the program: the tip and the direction of the tool.
type Point = (Vector, Vector);

/// The tool leans by `lean` (degrees) from Z towards `azimuth` (degrees).
fn leaning(lean: f64, azimuth: f64) -> Vector {
    let (sin, cos) = lean.to_radians().sin_cos();
    let (sin_azimuth, cos_azimuth) = azimuth.to_radians().sin_cos();
    [sin * cos_azimuth, sin * sin_azimuth, cos]
}

/// One side of a blade in rows from the shroud to the hub: each row winds about Z and downwards, while the tool leans
/// outwards more and more.
fn blade() -> Vec<Point> {
    let mut points = Vec::new();
    for row in 0..4 {
        let depth = f64::from(row) * 4.0;
        let mut line: Vec<Point> = (0..=60)
            .map(|step| {
                let share = f64::from(step) / 60.0;
                let azimuth = 20.0 + 70.0 * share * share;
                let radius = 20.0 + 40.0 * share - depth;
                let (sin, cos) = azimuth.to_radians().sin_cos();
                let tip = [radius * cos, radius * sin, 30.0 - 25.0 * share.powf(1.5)];
                (tip, leaning(15.0 + 40.0 * share, azimuth + 25.0 - depth))
            })
            .collect();
        if row % 2 == 1 {
            line.reverse();
        }
        points.extend(line);
    }
    points
}

/// The wall of a pocket with rounded corners, cut by the flank: it leans outwards by 8 to 14 degrees.
fn flank() -> Vec<Point> {
    let steps = 240;
    (0..=steps)
        .map(|step| {
            let azimuth = 360.0 * f64::from(step) / f64::from(steps);
            let (sin, cos) = azimuth.to_radians().sin_cos();
            // A rounded square as a superellipse.
            let radius = 40.0 / (cos.powi(4) + sin.powi(4)).powf(0.25);
            let lean = 11.0 + 3.0 * (3.0 * azimuth.to_radians()).sin();
            ([radius * cos, radius * sin, 2.0], leaning(lean, azimuth))
        })
        .collect()
}

/// The direction goes past the Z axis: at first at a tenth of a degree from it, then through it.
fn past_the_pole() -> Vec<Point> {
    (0..=80)
        .map(|step| {
            let share = f64::from(step) / 40.0 - 1.0;
            let aside = 0.1 * PI / 180.0;
            let lean = 20.0f64.to_radians() * share;
            let vector = [lean.sin(), aside, lean.cos()];
            let length = norm(vector);
            ([40.0 * share, 5.0, 10.0], vector.map(|value| value / length))
        })
        .collect()
}

fn program(kinematics: &MachineFormulas, points: &[Point], feed: f64) -> String {
    let [x, y, z] = points[0].0;
    let mut text = format!(
        "G21 G90 G17 G94\nG5.1 Q1\nT1 M6\nS9000 M3\nG54 G0 X{x:.4} Y{y:.4} {}\nG43.5 H1 Z{:.4}\n",
        kinematics.start,
        z + 40.0
    );
    for (index, ([x, y, z], [i, j, k])) in points.iter().enumerate() {
        let word = if index == 0 { "G0" } else { "G1" };
        let feed = if index == 1 { format!(" F{feed:.0}.") } else { String::new() };
        text += &format!("{word} X{x:.4} Y{y:.4} Z{z:.4} I{i:.7} J{j:.7} K{k:.7}{feed}\n");
    }
    text + "G49\nM30\n"
}

fn distance_to_line(point: Vector, from: Vector, to: Vector) -> f64 {
    let along = add(to, from, -1.0);
    let square = dot(along, along);
    let share = if square > 0.0 {
        (dot(add(point, from, -1.0), along) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    norm(add(point, add(from, along, share), -1.0))
}

struct SampledRun {
    tip_off_mm: f64,
    direction_off_deg: f64,
    velocity: f64,
    acceleration: f64,
    jerk: f64,
}

/// Samples the run each half millisecond; the shares of the limits are of the cut.
fn measure(kinematics: &MachineFormulas, points: &[Point], text: &str) -> SampledRun {
    let job = kinematics.job(text);
    let found = job.check().diagnostics;
    let problems: Vec<(Code, String)> = found
        .iter()
        // Next to the pole the table cannot keep up with F; the time of the block is that of the table.
        .filter(|found| found.severity != Severity::Note && found.code != Code::TipFeedTooFast)
        .map(|found| (found.code, found.message.clone()))
        .collect();
    assert_eq!(problems, [], "{}", kinematics.name);

    const PERIOD_S: f64 = 5e-4;
    let request =
        SamplingRequest { period_s: PERIOD_S, level: PlannerLevel::Fast, max_samples: 10_000_000 };
    let mut measured = SampledRun {
        tip_off_mm: 0.0,
        direction_off_deg: 0.0,
        velocity: 0.0,
        acceleration: 0.0,
        jerk: 0.0,
    };
    let first_line = 7;
    let mut before: Option<[f64; 6]> = None;
    let mut count = 0;
    job.setpoints(&request, |sample, line| {
        // The blocks of the points but the first, which is a rapid.
        if line <= first_line || line > first_line + points.len() as u32 - 1 {
            before = None;
            return;
        }
        count += 1;
        let at = (line - first_line) as usize;
        let (tip, direction) = kinematics.tip(&sample.position);
        // A corner may be rounded off, so that the tip is beside the lines on both sides.
        let near = at.saturating_sub(2)..(at + 2).min(points.len() - 1);
        let off = near
            .clone()
            .map(|index| distance_to_line(tip, points[index].0, points[index + 1].0))
            .fold(f64::INFINITY, f64::min);
        measured.tip_off_mm = measured.tip_off_mm.max(off);
        let off = near
            .map(|index| distance_to_line(direction, points[index].1, points[index + 1].1))
            .fold(f64::INFINITY, f64::min);
        measured.direction_off_deg = measured.direction_off_deg.max(off.to_degrees());
        for axis in 0..6 {
            let [velocity, acceleration, jerk] = match axis {
                0..3 => [800.0, 5000.0, 100_000.0],
                _ => [180.0, 900.0, 18_000.0].map(f64::to_radians),
            };
            measured.velocity = measured.velocity.max(sample.velocity[axis].abs() / velocity);
            measured.acceleration =
                measured.acceleration.max(sample.acceleration[axis].abs() / acceleration);
            if let Some(before) = before {
                let change = (sample.acceleration[axis] - before[axis]).abs() / PERIOD_S;
                measured.jerk = measured.jerk.max(change / jerk);
            }
        }
        before = Some(sample.acceleration);
    })
    .expect("setpoints");
    assert!(count > 500, "{count}");
    measured
}

/// What the control may leave of the path: by its corners, by the chords of the axes, and by the tolerance of the rotary
/// axes at the longest arm of the three machines.
const CORNER_MM: f64 = 0.01;
const CHORD_MM: f64 = 0.001;
const ROTARY_DEG: f64 = 0.01;
const ARM_MM: f64 = 320.0;

/// Runs the program on all three machines. `above_bound` is how much longer than the bound without jerk the moves may
/// take, and `direction_deg` how far the tool may leave the plane of the directions at both ends of a block.
fn run(points: &[Point], feed: f64, above_bound: f64, direction_deg: f64) {
    for kinematics in all_kinematics() {
        let text = program(&kinematics, points, feed);
        let measured = measure(&kinematics, points, &text);
        let job = kinematics.job(&text);
        let options = MotionOptions::default();
        let bound_alone = ReferenceQuality { most_nodes: 0, ..ReferenceQuality::default() };
        let least = job.least(&options, bound_alone).expect("limits").whole;
        let (_, timed) = job.report_timed(&options, u64::MAX, &mut ());
        let timed_s = timed.expect("limits").expect("few moves").time.total_s();
        let summary = format!(
            "{}: tip {:.5} mm, direction {:.4} deg, velocity {:.4}, acceleration {:.4}, jerk {:.4}; time {:.3} s, bound {:.3} s",
            kinematics.name,
            measured.tip_off_mm,
            measured.direction_off_deg,
            measured.velocity,
            measured.acceleration,
            measured.jerk,
            least.time_s,
            least.bound_s,
        );
        println!("{summary}");
        let tolerance_mm = CORNER_MM + CHORD_MM + ROTARY_DEG.to_radians() * ARM_MM;
        assert!(measured.tip_off_mm < tolerance_mm, "{summary}");
        assert!(measured.direction_off_deg < direction_deg + ROTARY_DEG, "{summary}");
        // What is sampled at half a millisecond may exceed a limit by rounding alone.
        let of_limits = [measured.velocity, measured.acceleration, measured.jerk];
        assert!(of_limits.into_iter().all(|share| share < 1.001), "{summary}");
        assert!(least.time_s < (1.0 + above_bound) * least.bound_s, "{summary}");
        assert!(least.time_s >= least.bound_s, "{summary}");
        assert!((timed_s - least.time_s).abs() < 1e-6 * timed_s, "{timed_s}, not {summary}");
    }
}

#[test]
fn a_blade_of_an_impeller() {
    run(&blade(), 2000.0, 0.05, 0.05);
}

#[test]
fn a_flank() {
    run(&flank(), 3000.0, 0.05, 0.05);
}

#[test]
fn past_the_pole_of_the_rotary_axes() {
    // Within a block the axes turn evenly, and the tool goes round the pole at 0.1 degrees.
    run(&past_the_pole(), 1500.0, 0.1, 0.15);
}

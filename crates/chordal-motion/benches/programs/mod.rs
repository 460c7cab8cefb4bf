//! Programs that go on for ever, and a stream that setpoints are pulled from.

use std::hint::black_box;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use chordal_geometry::{Arc, Curve, EvenPart, ParamCurve, Plane, Spiral, Spline, Vec3};
use chordal_motion::{
    CornerMode, MoveRequest, PushOutcome, StreamFeeder, StreamOptions, StreamServo, stream,
};

use super::support;

/// A move of a program that goes on for ever.
pub type Program = fn(u64) -> MoveRequest;

fn motion(curve: Curve, corner: CornerMode, tag: u64) -> MoveRequest {
    MoveRequest { tag, ..support::cut(curve, 100.0, corner) }
}

fn line(from: [f64; 2], to: [f64; 2], corner: CornerMode, tag: u64) -> MoveRequest {
    let at = |[x, y]: [f64; 2]| [x, y, 0.0];
    motion(support::line(at(from), at(to)), corner, tag)
}

/// To and fro.
fn lines(index: u64) -> MoveRequest {
    let (from, to) = if index.is_multiple_of(2) { (0.0, 500.0) } else { (500.0, 0.0) };
    line([from, 0.0], [to, 0.0], CornerMode::Stop, index)
}

/// Circles of radius 20, with a stop after twenty.
fn arcs(index: u64) -> MoveRequest {
    let turn = std::f64::consts::TAU;
    let corner = if index % 20 == 19 { CornerMode::Stop } else { CornerMode::Exact };
    motion(Arc::new(Plane::Xy.frame(), 20.0, turn, 0.0).into(), corner, index)
}

/// Out and in on a spiral of ten turns, with a stop at each end.
fn spirals(index: u64) -> MoveRequest {
    let out = Spiral::new(Plane::Xy.frame(), (5.0, 25.0), 10.0 * std::f64::consts::TAU, 0.0);
    let spiral = if index.is_multiple_of(2) { out } else { out.reversed() };
    motion(spiral.into(), CornerMode::Stop, index)
}

/// Chords of a star, which the planner makes a curve, with a stop after each lap.
fn dense(index: u64) -> MoveRequest {
    static LAP: LazyLock<Vec<MoveRequest>> =
        LazyLock::new(|| support::dense::moves(&support::dense::star(0.1), 1000.0, 0.01));
    let chord = index as usize % LAP.len();
    let corner = if chord + 1 == LAP.len() { CornerMode::Stop } else { LAP[chord].corner };
    MoveRequest { corner, tag: index, ..LAP[chord] }
}

/// A polygon of 500 lines around radius 20, eased within a hundredth of a millimetre.
fn eased(index: u64) -> MoveRequest {
    let circle = Arc::new(Plane::Xy.frame(), 20.0, std::f64::consts::TAU, 0.0);
    let at = |index: u64| {
        let p = circle.point_at(circle.length() * (index % 500) as f64 / 500.0);
        [p.x, p.y]
    };
    let corner = CornerMode::Joined { linear_mm: 0.01, rotary_rad: 0.0 };
    line(at(index), at(index + 1), corner, index)
}

/// Lines of a micrometre along a circle.
fn short(index: u64) -> MoveRequest {
    let circle = Arc::new(Plane::Xy.frame(), 20.0, std::f64::consts::TAU, 0.0);
    let at = |index: u64| {
        let p = circle.point_at((index % 125_663) as f64 * 0.001);
        [p.x, p.y]
    };
    let corner = CornerMode::Joined { linear_mm: 0.01, rotary_rad: 0.0 };
    line(at(index), at(index + 1), corner, index)
}

/// Laps of a closed spline in its even parts, with a stop after each.
fn splines(index: u64) -> MoveRequest {
    static LAP: LazyLock<Vec<Curve>> = LazyLock::new(|| {
        let at = |index: i32| {
            let (sin, cos) = (f64::from(index) * std::f64::consts::TAU / 24.0).sin_cos();
            Vec3::new(60.0 * cos, 30.0 * sin, 5.0 * sin * cos)
        };
        let points: Vec<Vec3> = (0..=24).map(at).collect();
        let weights = vec![1.0; points.len()];
        let spline = Spline::uniform(4, points, weights).expect("a spline");
        let mut lap = Vec::new();
        for span in spline.pieces().expect("spans") {
            span.even_parts(1e-6, &mut |part| {
                lap.push(match part {
                    EvenPart::Line(line) => line.into(),
                    EvenPart::Bent(bent) => bent.into(),
                });
            });
        }
        lap
    });
    let part = index as usize % LAP.len();
    let corner = if part + 1 == LAP.len() { CornerMode::Stop } else { CornerMode::Exact };
    motion(LAP[part], corner, index)
}

/// The programs by their names.
pub const PROGRAMS: [(&str, Program); 7] = [
    ("lines", lines),
    ("arcs", arcs),
    ("spirals", spirals),
    ("splines", splines),
    ("eased", eased),
    ("short", short),
    ("dense", dense),
];

/// A stream of a program.
pub struct Source {
    feeder: StreamFeeder,
    servo: StreamServo,
    program: Program,
    next: u64,
}

impl Source {
    /// A stream that has gone for two seconds.
    pub fn new(program: Program) -> Source {
        let limits = support::limits(200.0, 2000.0, 1e5);
        let (feeder, servo) = stream(limits, StreamOptions::default(), program(0).from());
        let mut source = Source { feeder, servo, program, next: 0 };
        source.fill();
        for _ in 0..2000 {
            source.servo.next();
            source.fill();
        }
        source
    }

    fn fill(&mut self) {
        while self.feeder.push(&(self.program)(self.next)) == Ok(PushOutcome::Taken) {
            self.next += 1;
        }
    }

    /// Time that setpoints take, without the push side.
    pub fn pull(&mut self, count: u64, steer: impl Fn(u64, &mut StreamServo)) -> Duration {
        let mut spent = Duration::ZERO;
        let mut left = count;
        while left > 0 {
            self.fill();
            let batch = left.min(100);
            let start = Instant::now();
            for index in 0..batch {
                steer(index, &mut self.servo);
                black_box(self.servo.next());
            }
            spent += start.elapsed();
            left -= batch;
        }
        spent
    }
}

//! Movements to take setpoints from, one for each kind of path.

use chordal_geometry::{AXES, Arc, Curve, EvenPart, Plane, Spiral, Spline, Vec3};
use chordal_motion::{PlannedTrajectory, PlannerLevel};

use super::support::law::{LAW, piece, straight};
use super::support::{dense, limits, plan};

/// The kinds of path by their names.
pub const KINDS: [&str; 9] =
    ["lines", "short", "bends", "arc", "helix", "spiral", "spline", "star", "harmonics"];

/// The movements of a kind of path, and how often they are repeated: in the same memory, as a planner does.
pub fn trajectories(kind: &str) -> Option<(Vec<PlannedTrajectory>, usize)> {
    // 100 m, about the length of an arc of radius 10.
    let turns = 1e5 / 10.0;
    let xy = Plane::Xy.frame();
    Some(match kind {
        "lines" => (vec![lines(10)], 1),
        "short" => (vec![lines(100_000)], 1),
        "bends" => (vec![bends()], 1),
        "arc" => curve(Arc::new(xy, 10.0, turns, 0.0).into()),
        "helix" => curve(Arc::new(xy, 10.0, turns, 100.0).into()),
        "spiral" => curve(Spiral::new(xy, (10.0, 20.0), turns / 1.5, 0.0).into()),
        "spline" => spline(),
        "star" => dense_run(&dense::star(0.1)),
        "harmonics" => dense_run(&dense::harmonics(0.1, 4, 1)),
        _ => return None,
    })
}

/// Laps of a closed path.
const LAPS: usize = 100;

/// 100 m along X and Y in pieces of one length.
fn lines(pieces: usize) -> PlannedTrajectory {
    let length = 1e5 / pieces as f64;
    let direction = [0.6, 0.8, 0.0, 0.0, 0.0, 0.0];
    let piece = |n: usize| {
        let at = length * n as f64;
        straight([0.6 * at, 0.8 * at, 5.0, 0.0, 0.0, 0.0], direction, length, n as u64)
    };
    LAW.trajectory((0..pieces).map(piece).collect())
}

/// The same length with bends: cubic in every linear axis.
fn bends() -> PlannedTrajectory {
    let piece = |n: usize| {
        let mut piece = straight([0.0; AXES], [0.6, 0.8, 0.0, 0.0, 0.0, 0.0], 1e3, n as u64);
        piece.start[2] = [1e-3, -1e-3, 1e-4, 0.0, 0.0, 0.0];
        piece.start[3] = [-1e-6, 1e-6, -1e-7, 0.0, 0.0, 0.0];
        piece
    };
    LAW.trajectory((0..100).map(piece).collect())
}

fn curve(curve: Curve) -> (Vec<PlannedTrajectory>, usize) {
    (vec![LAW.trajectory(vec![piece(curve, 1)])], 1)
}

/// Laps of a spline of order 4 in its even parts.
fn spline() -> (Vec<PlannedTrajectory>, usize) {
    let points: Vec<Vec3> = (0..=24)
        .map(|index| {
            let (sin, cos) = (f64::from(index) * std::f64::consts::TAU / 24.0).sin_cos();
            Vec3::new(60.0 * cos, 30.0 * sin, 5.0 * sin * cos)
        })
        .collect();
    let weights = vec![1.0; points.len()];
    let spline = Spline::uniform(4, points, weights).expect("a spline");
    let mut pieces = Vec::new();
    for span in spline.pieces().expect("spans") {
        span.even_parts(1e-6, &mut |part| match part {
            EvenPart::Line(line) => pieces.push(piece(Curve::Line(line), 1)),
            EvenPart::Bent(bent) => pieces.push(piece(Curve::Spline(bent), 1)),
        });
    }
    (vec![LAW.trajectory(pieces)], LAPS)
}

/// A dense run as the planner makes it: a curve with its velocity profile, again and again.
fn dense_run(places: &dense::Places) -> (Vec<PlannedTrajectory>, usize) {
    let moves = dense::moves(places, 1000.0, 0.01);
    (plan(&moves, limits(500.0, 5000.0, 1e5), PlannerLevel::Fast), LAPS)
}

//! Rows of moves to measure the planner with.

#[path = "../../tests/support/mod.rs"]
mod support;

use chordal_geometry::{Arc, Curve, Frame, Line, ParamCurve, Vec3};
use chordal_motion::{
    CornerMode, MotionPlanner, MoveRequest, PlannerLevel, PlannerOptions, PlannerStep,
};

/// A feed that no axis reaches, mm/s.
const FAST: f64 = 1000.0;

fn motion(curve: Curve, corner: CornerMode) -> MoveRequest {
    support::cut(curve, 50.0, corner)
}

/// A raster over a wavy surface in lines of 0.1 mm.
pub fn surface(count: usize) -> Vec<MoveRequest> {
    let within = CornerMode::Joined { linear_mm: 0.01, rotary_rad: 1e-4 };
    let row = 1000;
    let point = |i: usize| {
        let (y, step) = (i / row, i % row);
        let x = 0.1 * if y % 2 == 0 { step as f64 } else { (row - 1 - step) as f64 };
        let z = (0.6 * x).sin() + 0.3 * (0.11 * x + 0.5 * y as f64).cos();
        Vec3::new(x, 0.5 * y as f64, z)
    };
    (0..count).map(|i| motion(Line { start: point(i), end: point(i + 1) }.into(), within)).collect()
}

/// Lines of 0.1 mm at random angles of a few degrees.
pub fn wiggle(count: usize) -> Vec<MoveRequest> {
    let within = CornerMode::Joined { linear_mm: 0.01, rotary_rad: 1e-4 };
    let mut at = Vec3::ZERO;
    let (mut angle, mut state) = (0.0_f64, 1u64);
    (0..count)
        .map(|_| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            angle += ((state >> 40) as f64 / f64::from(1 << 24) - 0.5) * 0.1;
            let end = at + Vec3::new(angle.cos(), angle.sin(), 0.0) * 0.1;
            let line = Line { start: at, end };
            at = end;
            motion(line.into(), within)
        })
        .collect()
}

/// Tangent quarter circles.
pub fn arcs(count: usize) -> Vec<MoveRequest> {
    let within = CornerMode::Joined { linear_mm: 0.01, rotary_rad: 1e-4 };
    let mut at = Vec3::ZERO;
    let mut heading = Vec3::X;
    (0..count)
        .map(|i| {
            let side = if i % 2 == 0 { 1.0 } else { -1.0 };
            let out = heading.cross(Vec3::Z) * side;
            let frame = Frame::from_normal(at - out * 5.0, Vec3::Z * side, out).expect("a frame");
            let arc = Arc::new(frame, 5.0, 1.5, 0.0);
            at = arc.end();
            heading = arc.tangent_at(arc.length());
            motion(arc.into(), within)
        })
        .collect()
}

/// A spiral in lines of 0.1 mm, its turns 0.5 mm apart.
pub fn spiral(count: usize) -> Vec<MoveRequest> {
    let within = CornerMode::Joined { linear_mm: 0.01, rotary_rad: 1e-4 };
    let mut angle = 10.0_f64;
    let mut point = || {
        let radius = 0.5 * angle / std::f64::consts::TAU;
        let point = Vec3::new(radius * angle.cos(), radius * angle.sin(), 0.0);
        angle += 0.1 / radius;
        point
    };
    let mut at = point();
    (0..count)
        .map(|_| {
            let end = point();
            let line = Line { start: at, end };
            at = end;
            motion(line.into(), within)
        })
        .collect()
}

/// A lap of an ellipse at a feed that is never reached.
pub fn ellipse(count: usize) -> Vec<MoveRequest> {
    support::dense::moves(&support::dense::ellipse(count as u32, None), FAST, 0.01)
}

/// Harmonics in space in chords of 0.1 mm, from the start on, at a feed that is never reached.
pub fn harmonics(count: usize) -> Vec<MoveRequest> {
    let places = support::dense::harmonics(0.1, 4, 1);
    let places = places[..places.len().min(count + 1)].to_vec();
    support::dense::moves(&places, FAST, 0.01)
}

/// Plans them, where it is quicker as curves if they may be joined; the time they take, s.
pub fn plan(moves: &[MoveRequest], joins: bool) -> f64 {
    let options = PlannerOptions { joins, ..PlannerOptions::new(PlannerLevel::Fast) };
    let mut planner = MotionPlanner::new(support::limits(500.0, 5000.0, 1e5), options);
    let mut time = 0.0;
    let mut take = |step: PlannerStep<'_>| {
        if let PlannerStep::Trajectory(trajectory) = step {
            time += trajectory.duration_s() - trajectory.overlap_s;
        }
    };
    for motion in moves {
        planner.push(motion, &mut take).expect("the moves are good");
    }
    planner.finish(&mut take);
    time
}

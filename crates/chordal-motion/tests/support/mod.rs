//! What tests and benchmarks of this crate share: limits and moves by hand, the profile of the level best (`best`), dense paths (`dense`), trajectories by hand
//! (`law`), figures with worked times (`figures`), random paths (`random`), and what can be
//! measured on a plan or on setpoints (`watch`).
#![allow(dead_code, reason = "each test uses its part")]

pub mod best;
pub mod dense;
pub mod figures;
pub mod law;
pub mod random;
pub mod watch;

use chordal_geometry::{AXES, Curve, Line, ParamCurve, Vec3};
use chordal_motion::{
    AxisJet, AxisLimit, AxisValues, CornerMode, KinematicLimits, MotionPlanner, MotionSample,
    MoveKind, MoveRequest, PlannedTrajectory, PlannerLevel, PlannerOptions, PlannerStep,
    SetpointSampler,
};

/// Every axis with the same limits, in mm or in rad.
pub fn limits(velocity: f64, acceleration: f64, jerk: f64) -> KinematicLimits {
    KinematicLimits::new([Some(AxisLimit { velocity, acceleration, jerk }); AXES])
        .expect("positive limits")
}

/// A straight line from place to place.
pub fn line(from: [f64; 3], to: [f64; 3]) -> Curve {
    let at = |p: [f64; 3]| Vec3::new(p[0], p[1], p[2]);
    Line::new(at(from), at(to)).into()
}

/// A cut along a curve in which no rotary axis moves, with tag 0.
pub fn cut(curve: Curve, speed: f64, corner: CornerMode) -> MoveRequest {
    MoveRequest {
        curve,
        rotary_from: [0.0; 3],
        rotary_to: [0.0; 3],
        path_length: None,
        speed,
        corner,
        kind: MoveKind::Cut,
        tag: 0,
    }
}

/// The plan of some moves.
pub fn plan(
    moves: &[MoveRequest],
    limits: KinematicLimits,
    level: PlannerLevel,
) -> Vec<PlannedTrajectory> {
    let mut planner = MotionPlanner::new(limits, PlannerOptions::new(level));
    let mut trajectories = Vec::new();
    let mut take = |step: PlannerStep<'_>| {
        if let PlannerStep::Trajectory(trajectory) = step {
            trajectories.push(trajectory.clone());
        }
    };
    for motion in moves {
        planner.push(motion, &mut take).unwrap();
    }
    planner.finish(&mut take);
    trajectories
}

/// How long a plan takes, s.
pub fn time_of(trajectories: &[PlannedTrajectory]) -> f64 {
    trajectories.iter().map(|trajectory| trajectory.duration_s() - trajectory.overlap_s).sum()
}

/// Setpoints of a plan.
pub fn samples(trajectories: &[PlannedTrajectory], period_s: f64) -> Vec<MotionSample> {
    let mut sampler = SetpointSampler::new(period_s);
    let mut samples = Vec::new();
    for trajectory in trajectories {
        sampler.push(PlannerStep::Trajectory(trajectory), |sample| samples.push(*sample));
    }
    sampler.finish(|sample| samples.push(*sample));
    samples
}

/// Largest difference of two jets' first rows.
pub fn jump(a: &AxisJet, b: &AxisJet, order: usize) -> f64 {
    (0..AXES).map(|axis| (a[order][axis] - b[order][axis]).abs()).fold(0.0, f64::max)
}

/// Distance of a point from the moves near a guess, and the index of the nearest.
pub fn distance(moves: &[MoveRequest], near: usize, window: usize, position: &AxisValues) -> f64 {
    let p = Vec3::new(position[0], position[1], position[2]);
    let (low, high) = (near.saturating_sub(window), (near + window + 1).min(moves.len()));
    moves[low..high].iter().map(|m| m.curve.nearest(p).distance).fold(f64::INFINITY, f64::min)
}

//! Dense moves for which a velocity profile is not found everywhere: they have a sound plan all the same.
//!
//! About one window in 1,500 of these paths has none. `CHORDAL_ROUNDS=n` takes n paths, else the test ends with the
//! first that has such a window.

#![allow(clippy::disallowed_methods, reason = "a test reads how many rounds it is to run")]

mod support;

use chordal_motion::{
    CornerMode, KinematicLimits, LimitUse, MotionPlanner, MoveRequest, PlannedTrajectory,
    PlannerLevel, PlannerOptions, PlannerStep, SolverWork, largest_use,
};
use support::random::{Dice, Mix, random_limits, random_path};
use support::time_of;

/// What rounding may add to a limit.
const ABOVE: f64 = 1.0 + 1e-6;

fn rounds() -> Option<u64> {
    std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok())
}

fn plan(
    moves: &[MoveRequest],
    limits: KinematicLimits,
    joins: bool,
) -> (Vec<PlannedTrajectory>, SolverWork) {
    let options = PlannerOptions { joins, ..PlannerOptions::new(PlannerLevel::Fast) };
    let mut planner = MotionPlanner::new(limits, options);
    let mut trajectories = Vec::new();
    let mut take = |step: PlannerStep<'_>| {
        if let PlannerStep::Trajectory(trajectory) = step {
            trajectories.push(trajectory.clone());
        }
    };
    moves.iter().for_each(|motion| planner.push(motion, &mut take).expect("a good move"));
    planner.finish(&mut take);
    let work = planner.work();
    (trajectories, work)
}

/// Every trajectory begins where the last ended and goes from rest to rest, over all of its path.
fn check_chain(name: &str, moves: &[MoveRequest], trajectories: &[PlannedTrajectory]) {
    let mut at = moves[0].from();
    for trajectory in trajectories {
        let near = |a: &[f64; 6], b: &[f64; 6]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(near(&at, &trajectory.from()), "{name}: {at:?} {:?}", trajectory.from());
        at = trajectory.to();
        let (first, last) = (trajectory.phases[0], trajectory.phases[trajectory.phases.len() - 1]);
        let end = last.at(last.duration_s);
        let length = trajectory.length();
        assert_eq!(first.speed, 0.0, "{name}");
        assert!(end.speed.abs() < 1e-6 && end.acceleration.abs() < 1e-3, "{name}: {end:?}");
        assert!((end.sigma - length).abs() < 1e-9 * length.max(1.0), "{name}: {end:?} of {length}");
    }
    let target = moves[moves.len() - 1].to();
    assert!(at.iter().zip(&target).all(|(a, b)| (a - b).abs() < 1e-9), "{name}: {at:?} {target:?}");
}

#[test]
fn moves_without_a_law_have_a_sound_plan() {
    let mix =
        Mix { moves: 120, curves: false, rotary: true, shortest: 1e-3, longest: 2.0, turn: 0.7 };
    let (mut windows, mut failed, mut paths) = (0, 0, 0);
    for seed in 0..rounds().unwrap_or(150) {
        let mut dice = Dice(seed * 7919 + 5);
        let limits = random_limits(&mut dice);
        let mut moves = random_path(&mut dice, &Mix { curves: seed % 3 == 0, ..mix });
        let linear_mm = dice.decades(1e-3, 0.3);
        for motion in &mut moves {
            // Speeds that differ from move to move take windows to their limits.
            motion.speed = dice.decades(5.0, 1000.0);
            motion.corner = CornerMode::Joined { linear_mm, rotary_rad: 1e-3 };
        }
        let (trajectories, work) = plan(&moves, limits, true);
        windows += work.windows;
        failed += work.failed;
        if work.failed == 0 {
            continue;
        }
        paths += 1;
        let name = format!("seed {seed}");
        let used = trajectories
            .iter()
            .map(|s| largest_use(s, &limits, 5))
            .fold(LimitUse::default(), LimitUse::or);
        let most = used.velocity.max(used.acceleration).max(used.jerk);
        assert!(most <= ABOVE, "{name}: {used:?}");
        check_chain(&name, &moves, &trajectories);
        // Corners by themselves are the last resort.
        let by_corners = time_of(&plan(&moves, limits, false).0);
        let ours = time_of(&trajectories);
        assert!(ours <= by_corners * (1.0 + 1e-9), "{name}: {ours} s, by corners {by_corners} s");
        if rounds().is_none() {
            break;
        }
    }
    println!("{failed} of {windows} windows without a law, on {paths} paths");
    assert!(failed > 0, "no window without a law in {windows}: the test shows nothing");
}

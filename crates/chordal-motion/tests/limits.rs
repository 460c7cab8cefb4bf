//! What every plan keeps, on random paths: the limits of every axis, the path, its ends.

mod support;

use chordal_geometry::AXES;
use chordal_motion::{
    CornerMode, KinematicLimits, LimitUse, MoveRequest, PlannedTrajectory, PlannerLevel,
    largest_use,
};
use support::random::{Dice, Mix, random_limits, random_path};
use support::{distance, jump, plan, samples, time_of};

/// What rounding may add to a limit.
const ABOVE: f64 = 1.0 + 1e-6;

/// No step between two pieces of a trajectory, by the order of the derivative, and none of the place between two
/// trajectories is more than rounding, as shares of one and the size: setpoints at 4 kHz show a step of 1e-13 mm as
/// a jerk of 0.006 mm/s³. Directions and bends have more of it within narrow corrections, which are passed slowly.
const STEPS: [f64; 3] = [STEP, 1e-10, 1e-6];
const STEP: f64 = 1e-13;

fn mixes() -> Vec<(&'static str, Mix)> {
    let plain =
        Mix { moves: 60, curves: false, rotary: false, shortest: 0.5, longest: 80.0, turn: 4.0 };
    vec![
        ("lines", plain),
        ("short lines", Mix { moves: 400, shortest: 0.001, longest: 0.5, turn: 0.3, ..plain }),
        (
            "dense smooth lines",
            Mix { moves: 1500, shortest: 0.02, longest: 0.2, turn: 0.02, ..plain },
        ),
        ("zigzag of short lines", Mix { moves: 200, shortest: 0.001, longest: 2.0, ..plain }),
        ("curves", Mix { curves: true, turn: 1e-12, ..plain }),
        ("curves with kinks", Mix { curves: true, shortest: 0.001, turn: 0.5, ..plain }),
        (
            "five axes",
            Mix { rotary: true, moves: 200, shortest: 0.01, longest: 5.0, turn: 0.2, ..plain },
        ),
        ("five axes with curves", Mix { rotary: true, curves: true, turn: 4.0, ..plain }),
    ]
}

fn check(
    name: &str,
    seed: u64,
    moves: &[MoveRequest],
    limits: &KinematicLimits,
    trajectories: &[PlannedTrajectory],
) {
    let place = format!("{name}, seed {seed}");
    let used = trajectories
        .iter()
        .map(|s| largest_use(s, limits, 3))
        .fold(LimitUse::default(), LimitUse::or);
    let worst = used.velocity.max(used.acceleration).max(used.jerk);
    assert!(worst <= ABOVE, "{place}: {used:?}");
    for trajectory in trajectories {
        for phase in &trajectory.phases {
            let end = phase.at(phase.duration_s);
            assert!(phase.duration_s >= 0.0 && phase.speed >= 0.0, "{place}: {phase:?}");
            assert!(end.speed >= -1e-9, "{place}: {phase:?}");
        }
        for pair in trajectory.pieces.windows(2) {
            let (end, start) = (pair[0].at(pair[0].length), pair[1].at(0.0));
            for (order, most) in STEPS.into_iter().enumerate() {
                let scale = 1.0 + start[order].iter().fold(0.0_f64, |all, v| all.max(v.abs()));
                let jump = jump(&end, &start, order);
                assert!(
                    jump <= most * scale,
                    "{place}: order {order} jumps by {jump} at {:?}",
                    pair[1]
                );
            }
        }
    }
    for pair in trajectories.windows(2) {
        for (end, start) in pair[0].to().iter().zip(pair[1].from()) {
            let most = STEP * (1.0 + start.abs());
            assert!((end - start).abs() <= most, "{place}: from {end} to {start}");
        }
    }
    let (first, last) = (trajectories.first().unwrap(), trajectories.last().unwrap());
    let ends = [(first.from(), moves[0].from()), (last.to(), moves.last().unwrap().to())];
    for (planned, programmed) in ends {
        for axis in 0..AXES {
            assert!((planned[axis] - programmed[axis]).abs() < 1e-9, "{place}");
        }
    }
}

fn check_samples(
    name: &str,
    seed: u64,
    moves: &[MoveRequest],
    limits: &KinematicLimits,
    trajectories: &[PlannedTrajectory],
) {
    let tolerance = moves.iter().fold(1e-6_f64, |most, motion| match motion.corner {
        CornerMode::Joined { linear_mm, .. } => most.max(linear_mm),
        _ => most,
    });
    for period in [1e-3, 2.5e-4] {
        let place = format!("{name}, seed {seed}, period {period}");
        let samples = samples(trajectories, period);
        // A thousand places of a path are enough to find it in the wrong one.
        for sample in samples.iter().step_by(1 + samples.len() / 1000) {
            let d = distance(moves, sample.tag as usize, 40, &sample.position);
            assert!(
                d <= tolerance * ABOVE + 1e-9,
                "{place}: {d} mm off the path at {}",
                sample.time_s
            );
        }
        let [velocity, acceleration, jerk] =
            [limits.velocity(), limits.acceleration(), limits.jerk()];
        for axis in 0..AXES {
            let x: Vec<f64> = samples.iter().map(|sample| sample.position[axis]).collect();
            let rate = |values: &[f64]| -> Vec<f64> {
                values.windows(2).map(|pair| (pair[1] - pair[0]) / period).collect()
            };
            let v = rate(&x);
            let a = rate(&v);
            let j = rate(&a);
            let most =
                |values: &[f64]| values.iter().fold(0.0_f64, |all, value| all.max(value.abs()));
            // Positions are rounded to 1e-13 mm, and times to a share of 1e-16 of themselves.
            let late = samples.last().map_or(0.0, |sample| sample.time_s) * f64::EPSILON;
            let rounding = 4.0 * (1e-13 + most(&v) * late) / period.powi(3);
            assert!(most(&v) <= velocity[axis] * ABOVE, "{place} axis {axis}: {}", most(&v));
            assert!(most(&a) <= acceleration[axis] * ABOVE, "{place} axis {axis}: {}", most(&a));
            assert!(
                most(&j) <= jerk[axis] * ABOVE + rounding,
                "{place} axis {axis}: {} above {}",
                most(&j),
                jerk[axis]
            );
        }
    }
}

fn rounds() -> u64 {
    // A longer run: `CHORDAL_ROUNDS=2000 cargo test --release -p chordal-motion --test limits`.
    option_env!("CHORDAL_ROUNDS").and_then(|rounds| rounds.parse().ok()).unwrap_or(12)
}

#[test]
fn every_limit_holds() {
    let mut count = 0;
    for (name, mix) in mixes() {
        for seed in 0..rounds() {
            let mut dice = Dice(seed * 1000 + mix.moves as u64);
            let limits = random_limits(&mut dice);
            let moves = random_path(&mut dice, &mix);
            let trajectories = plan(&moves, limits, PlannerLevel::Fast);
            check(name, seed, &moves, &limits, &trajectories);
            check_samples(name, seed, &moves, &limits, &trajectories);
            count += moves.len();
        }
    }
    println!("{count} moves");
}

#[test]
fn stops_are_not_slower_than_stopping_everywhere() {
    for (name, mix) in mixes() {
        for seed in 0..rounds() {
            let mut dice = Dice(seed + 77);
            let limits = random_limits(&mut dice);
            let moves = random_path(&mut dice, &mix);
            let stopping: Vec<MoveRequest> = moves
                .iter()
                .map(|motion| MoveRequest { corner: CornerMode::Stop, ..*motion })
                .collect();
            let (ours, stops) = (
                plan(&moves, limits, PlannerLevel::Fast),
                plan(&stopping, limits, PlannerLevel::Fast),
            );
            let (ours, stops) = (time_of(&ours), time_of(&stops));
            assert!(
                ours <= stops * (1.0 + 1e-9),
                "{name}, seed {seed}: {ours} s, stopping {stops} s"
            );
        }
    }
}

//! Times of dense chords: as planned, and the least with and without jerk.
//!
//! ```text
//! cargo run --release -p chordal-motion --example dense [NAME [TOLERANCE]]
//! cargo run --release -p chordal-motion --example dense random=1000
//! cargo run --release -p chordal-motion --example dense properties=1000 [from=1] [places=1000]
//! ```
//!
//! `random=` counts random paths that curves are quicker on. `properties=` changes one thing of a random path
//! at a time and tells how much slower that makes it at most; of paths from a number on, cut to so many places.

#![allow(clippy::disallowed_methods, reason = "an example is a shell")]

#[path = "../tests/support/mod.rs"]
mod support;

use std::time::Instant;

use chordal_motion::{
    CornerMode, KinematicLimits, LimitUse, MotionPlanner, MoveRequest, PathRun, PlannedTrajectory,
    PlannerLevel, PlannerOptions, PlannerStep, SolverWork, largest_use, time_bound,
};
use support::dense::{self, Places};

fn main() {
    let filter = std::env::args().nth(1).unwrap_or_default();
    let tolerance: f64 = std::env::args().nth(2).and_then(|word| word.parse().ok()).unwrap_or(0.01);
    let paths: Vec<(&str, Places)> = vec![
        ("ellipse 334", dense::ellipse(334, None)),
        ("ellipse 1336", dense::ellipse(1336, None)),
        ("ellipse 1336 3 decimals", dense::ellipse(1336, Some(3))),
        ("ellipse 5000", dense::ellipse(5000, None)),
        ("ellipse 5000 3 decimals", dense::ellipse(5000, Some(3))),
        ("circle R20", dense::circle(20.0, 1.0, 0.1, None)),
        ("circle R5 two turns", dense::circle(5.0, 2.0, 0.1, None)),
        ("spiral", dense::spiral(0.1)),
        ("star", dense::star(0.1)),
        ("trident", dense::trident(0.1)),
        ("butterfly", dense::butterfly(0.1)),
        ("raster", dense::raster(20, 60.0, 0.5, 0.2)),
        ("raster turned by 30", dense::turned(dense::raster(20, 60.0, 0.5, 0.2), 30.0)),
        ("harmonics 4 decimals", dense::harmonics(0.1, 4, 1)),
        ("harmonics 3 decimals", dense::harmonics(0.05, 3, 1)),
    ];
    let limits = support::limits(500.0, 5000.0, 1e5);
    if let Some(count) = filter.strip_prefix("random=").and_then(|word| word.parse().ok()) {
        return random(count, limits);
    }
    if let Some(count) = number("properties") {
        return properties(count, number("from").unwrap_or(1), number("places").unwrap_or(1000));
    }
    println!(
        "path                      moves  corners       ms |  curves       ms  no jerk  acceleration    jerk  pieces  runs"
    );
    for (name, places) in paths.iter().filter(|(name, _)| name.contains(filter.as_str())) {
        let moves = dense::moves(places, 1000.0, tolerance);
        let (before, before_ms, _) = timed(&moves, limits, false);
        let (now, now_ms, _) = timed(&moves, limits, true);
        let used =
            now.iter().map(|s| largest_use(s, &limits, 5)).fold(LimitUse::default(), LimitUse::or);
        let mut least = 0.0;
        for trajectory in &now {
            let speeds = vec![1000.0; trajectory.pieces.len()];
            if let Ok(run) = PathRun::new(&trajectory.pieces, &speeds, 0.0, &limits) {
                least += time_bound(&run).time_s;
            }
        }
        println!(
            "{name:24} {:6} {:8.4} {before_ms:8.1} | {:7.4} {now_ms:8.1} {least:8.4} {:13.5} {:7.5} {:7} {:5}",
            moves.len(),
            support::time_of(&before),
            support::time_of(&now),
            used.acceleration,
            used.jerk,
            now.iter().map(|s| s.pieces.len()).sum::<usize>(),
            now.len(),
        );
    }
}

/// The number that an argument gives: `name=number`.
fn number(name: &str) -> Option<u64> {
    let value = |word: String| word.strip_prefix(name)?.strip_prefix('=')?.parse().ok();
    std::env::args().skip(1).find_map(value)
}

/// Random sums of harmonics: how many are planned as curves, and how far from the least time without
/// jerk on the same path.
fn random(count: u64, limits: KinematicLimits) {
    let (mut curves, mut ratio, mut worst) = (0, 0.0, LimitUse::default());
    for seed in 1..=count {
        let chord = [0.05, 0.1, 0.3, 1.0][seed as usize % 4];
        let places = dense::harmonics(chord, 3 + seed as i32 % 2, seed);
        let tolerance = [0.002, 0.01, 0.05][seed as usize % 3];
        let moves = dense::moves(&places, [20.0, 100.0, 1000.0][seed as usize / 3 % 3], tolerance);
        let (before, ..) = timed(&moves, limits, false);
        let (now, ..) = timed(&moves, limits, true);
        let [before, time] = [before, now.clone()].map(|all| support::time_of(&all));
        if time < before {
            curves += 1;
        } else {
            let feed_s = moves.iter().map(|m| m.length() / m.speed).sum::<f64>();
            println!(
                "corners: seed {seed}, chords of {chord} mm within {tolerance} mm, {time} s, at feed {feed_s} s"
            );
        }
        ratio += time / before;
        worst = now.iter().map(|s| largest_use(s, &limits, 5)).fold(worst, LimitUse::or);
    }
    println!(
        "{curves} of {count} as curves, mean time {:.3} of corners, {worst:?}",
        ratio / count as f64
    );
}

/// How much slower one change makes random paths: the worst, and how many are above 0.02 % and 1 %.
fn properties(count: u64, from: u64, most: u64) {
    const NAMES: [&str; 9] = [
        "feed × 1.26",
        "acceleration × 1.26",
        "jerk × 1.26",
        "tolerance × 1.41",
        "chords of half the length",
        "one decimal less",
        "one decimal less, and as long",
        "backwards",
        "than stops",
    ];
    let mut worst = [(0.0_f64, 0); 9];
    let mut above = [[0_u64; 2]; 9];
    let (mut windows, mut failed) = (0, 0);
    let mut used = LimitUse::default();
    for seed in from..from + count {
        let chord = [0.05, 0.1, 0.2, 0.4][seed as usize % 4];
        let tolerance = [0.002, 0.005, 0.01, 0.02, 0.05][seed as usize % 5];
        let feed = [30.0, 100.0, 250.0, 1000.0][seed as usize / 4 % 4];
        let limits = |a: f64, j: f64| support::limits(500.0, 5000.0 * a, 1e5 * j);
        let short = |places: &[[f64; 3]]| places[..places.len().min(most as usize)].to_vec();
        let places = short(&dense::harmonics(chord, 4, seed));
        let time_with =
            |places: &[[f64; 3]], feed: f64, tolerance: f64, limits: KinematicLimits| {
                support::time_of(&timed(&dense::moves(places, feed, tolerance), limits, true).0)
            };
        let moves = dense::moves(&places, feed, tolerance);
        let (trajectories, _, work) = timed(&moves, limits(1.0, 1.0), true);
        (windows, failed) = (windows + work.windows, failed + work.failed);
        used = trajectories
            .iter()
            .map(|s| largest_use(s, &limits(1.0, 1.0), 5))
            .fold(used, LimitUse::or);
        let time = support::time_of(&trajectories);
        let halved: Places = places
            .windows(2)
            .flat_map(|ends| {
                let middle = std::array::from_fn(|axis| 0.5 * (ends[0][axis] + ends[1][axis]));
                [ends[0], middle]
            })
            .chain(places.last().copied())
            .collect();
        let rounded: Places = places
            .iter()
            .map(|place| place.map(|value| (value * 1000.0).round() / 1000.0))
            .collect();
        let mut back = places.clone();
        back.reverse();
        let stops: Vec<MoveRequest> = moves
            .iter()
            .map(|motion| MoveRequest { corner: CornerMode::Stop, ..*motion })
            .collect();
        let stops = support::time_of(&timed(&stops, limits(1.0, 1.0), true).0);
        let rounded_s = time_with(&rounded, feed, tolerance, limits(1.0, 1.0));
        let length = |places: &[[f64; 3]]| {
            dense::moves(places, feed, tolerance).iter().map(MoveRequest::length).sum::<f64>()
        };
        let ratios = [
            time_with(&places, 1.26 * feed, tolerance, limits(1.0, 1.0)) / time,
            time_with(&places, feed, tolerance, limits(1.26, 1.0)) / time,
            time_with(&places, feed, tolerance, limits(1.0, 1.26)) / time,
            time_with(&places, feed, 1.41 * tolerance, limits(1.0, 1.0)) / time,
            time_with(&halved, feed, tolerance, limits(1.0, 1.0)) / time,
            rounded_s / time,
            rounded_s / time * length(&places) / length(&rounded),
            time_with(&back, feed, tolerance, limits(1.0, 1.0)) / time,
            time / stops,
        ];
        for (index, ratio) in ratios.into_iter().enumerate() {
            if ratio - 1.0 > worst[index].0 {
                worst[index] = (ratio - 1.0, seed);
            }
            above[index][0] += u64::from(ratio > 1.0002);
            above[index][1] += u64::from(ratio > 1.01);
        }
    }
    println!("{count} paths, use {used:?}; {failed} of {windows} windows without a law");
    for (name, ((worst, seed), [little, much])) in NAMES.iter().zip(worst.iter().zip(&above)) {
        println!(
            "{name:30} at most {:8.4} % slower (seed {seed}); above 0.02 % {little}, above 1 % {much}",
            100.0 * worst
        );
    }
}

fn timed(
    moves: &[MoveRequest],
    limits: KinematicLimits,
    joins: bool,
) -> (Vec<PlannedTrajectory>, f64, SolverWork) {
    let options = PlannerOptions { joins, ..PlannerOptions::new(PlannerLevel::Fast) };
    let mut planner = MotionPlanner::new(limits, options);
    let mut trajectories: Vec<PlannedTrajectory> = Vec::new();
    let mut take = |step: PlannerStep<'_>| {
        if let PlannerStep::Trajectory(trajectory) = step {
            trajectories.push(trajectory.clone());
        }
    };
    let begin = Instant::now();
    for motion in moves {
        planner.push(motion, &mut take).expect("a line");
    }
    planner.finish(&mut take);
    let ms = begin.elapsed().as_secs_f64() * 1e3;
    (trajectories, ms, planner.work())
}

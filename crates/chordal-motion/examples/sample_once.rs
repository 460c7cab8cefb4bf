//! Takes setpoints from one kind of path, for a profiler that counts instructions, or by the clock:
//!
//! ```text
//! cargo build --release -p chordal-motion --example sample_once
//! valgrind --tool=callgrind target/release/examples/sample_once arc
//! target/release/examples/sample_once arc 40
//! ```
//!
//! With a number it takes them so many times and tells the quickest round; with 0 it only makes the
//! path: what that takes is to be taken off.

#![allow(clippy::disallowed_methods, reason = "an example is a shell")]

#[path = "../benches/paths/mod.rs"]
mod paths;
#[path = "../tests/support/mod.rs"]
mod support;

use std::hint::black_box;
use std::time::Instant;

use chordal_motion::{PlannedTrajectory, PlannerStep, SetpointSampler};

const PERIOD_S: f64 = 0.001;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let kinds = match words.first().map(String::as_str) {
        Some("all") => paths::KINDS.to_vec(),
        Some(kind) => vec![kind],
        None => Vec::new(),
    };
    if kinds.is_empty() {
        println!("say all, or one of {}", paths::KINDS.join(", "));
    }
    let rounds: usize = words.get(1).and_then(|word| word.parse().ok()).unwrap_or(1);
    for kind in kinds {
        let Some((trajectories, laps)) = paths::trajectories(kind) else {
            println!("{kind} is none of {}", paths::KINDS.join(", "));
            continue;
        };
        let (mut quickest_s, mut count) = (f64::INFINITY, 0);
        for _ in 0..rounds {
            let start = Instant::now();
            count = take(&trajectories, laps);
            quickest_s = quickest_s.min(start.elapsed().as_secs_f64());
        }
        let millions = count as f64 / quickest_s / 1e6;
        let pieces: usize = trajectories.iter().map(|trajectory| trajectory.pieces.len()).sum();
        println!("{kind}: {count} setpoints on {pieces} pieces, {millions:.1} M/s");
    }
}

/// Takes all setpoints; how many.
fn take(trajectories: &[PlannedTrajectory], laps: usize) -> u64 {
    let (mut count, mut sum) = (0, 0.0);
    let mut sampler = SetpointSampler::new(PERIOD_S);
    for trajectory in (0..laps).flat_map(|_| trajectories) {
        sampler.push(PlannerStep::Trajectory(trajectory), |sample| {
            count += 1;
            sum += sample.position[0];
        });
    }
    sampler.finish(|sample| {
        black_box(sample);
        count += 1;
        sum += sample.position[0];
    });
    black_box(sum);
    count
}

//! Setpoints a second, by the kind of path. `cargo bench -p chordal-motion --bench sample`.

mod paths;
#[path = "../tests/support/mod.rs"]
mod support;

use std::hint::black_box;

use chordal_motion::{PlannedTrajectory, PlannerStep, SetpointSampler};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const PERIOD_S: f64 = 0.001;

fn sample(c: &mut Criterion) {
    let mut group = c.benchmark_group("sample");
    for name in paths::KINDS {
        let (trajectories, laps) = paths::trajectories(name).expect("a kind of path");
        let lap_s: f64 = trajectories.iter().map(PlannedTrajectory::duration_s).sum();
        let seconds = lap_s * laps as f64;
        group.throughput(Throughput::Elements((seconds / PERIOD_S).ceil() as u64 + 1));
        group.sample_size(10);
        group.bench_function(name, |b| {
            b.iter(|| {
                let mut sum = 0.0;
                let mut sampler = SetpointSampler::new(PERIOD_S);
                for trajectory in (0..laps).flat_map(|_| &trajectories) {
                    sampler.push(PlannerStep::Trajectory(trajectory), |sample| {
                        sum += sample.position[0]
                    });
                }
                sampler.finish(|sample| {
                    black_box(sample);
                    sum += sample.position[0];
                });
                black_box(sum)
            });
        });
    }
    group.finish();
}

criterion_group!(benches, sample);
criterion_main!(benches);

//! Setpoints a second, by the kind of path. `cargo bench -p chordal-motion --bench sample`.

mod paths;
#[path = "../tests/support/mod.rs"]
mod support;

use std::hint::black_box;

use chordal_motion::{Sampler, Step, Stretch};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const PERIOD_S: f64 = 0.001;

fn sample(c: &mut Criterion) {
    let mut group = c.benchmark_group("sample");
    for name in paths::KINDS {
        let (stretches, laps) = paths::stretches(name).expect("a kind of path");
        let lap_s: f64 = stretches.iter().map(Stretch::duration_s).sum();
        let seconds = lap_s * laps as f64;
        group.throughput(Throughput::Elements((seconds / PERIOD_S).ceil() as u64 + 1));
        group.sample_size(10);
        group.bench_function(name, |b| {
            b.iter(|| {
                let mut sum = 0.0;
                let mut sampler = Sampler::new(PERIOD_S);
                for stretch in (0..laps).flat_map(|_| &stretches) {
                    sampler.push(Step::Stretch(stretch), |sample| sum += sample.position[0]);
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

//! Setpoints a second, by the kind of path. `cargo bench -p chordal-motion --bench sample`.

#[path = "../tests/support/mod.rs"]
mod support;

use std::hint::black_box;

use chordal_geometry::{AXES, Arc, Curve, Plane, Spiral};
use chordal_motion::{Sampler, Step, Stretch};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use support::law::{LAW, piece, straight};

const PERIOD_S: f64 = 0.001;

/// 100 m along X and Y in pieces of one length.
fn lines(pieces: usize) -> Stretch {
    let length = 1e5 / pieces as f64;
    let direction = [0.6, 0.8, 0.0, 0.0, 0.0, 0.0];
    let piece = |n: usize| {
        let at = length * n as f64;
        straight([0.6 * at, 0.8 * at, 5.0, 0.0, 0.0, 0.0], direction, length, n as u64)
    };
    LAW.stretch((0..pieces).map(piece).collect())
}

/// The same length with bends: cubic in every linear axis.
fn bends() -> Stretch {
    let piece = |n: usize| {
        let mut piece = straight([0.0; AXES], [0.6, 0.8, 0.0, 0.0, 0.0, 0.0], 1e3, n as u64);
        piece.start[2] = [1e-3, -1e-3, 1e-4, 0.0, 0.0, 0.0];
        piece.start[3] = [-1e-6, 1e-6, -1e-7, 0.0, 0.0, 0.0];
        piece
    };
    LAW.stretch((0..100).map(piece).collect())
}

fn curves(curve: Curve) -> Stretch {
    LAW.stretch(vec![piece(curve, 1)])
}

fn sample(c: &mut Criterion) {
    let turns = 1e5 / 10.0;
    let arc = Arc::new(Plane::Xy.frame(), 10.0, turns, 0.0);
    let helix = Arc::new(Plane::Xy.frame(), 10.0, turns, 100.0);
    let spiral = Spiral::new(Plane::Xy.frame(), (10.0, 20.0), turns / 1.5, 0.0);
    let cases = [
        ("lines", lines(10)),
        ("short lines", lines(100_000)),
        ("bends", bends()),
        ("arc", curves(arc.into())),
        ("helix", curves(helix.into())),
        ("spiral", curves(spiral.into())),
    ];
    let mut group = c.benchmark_group("sample");
    for (name, stretch) in &cases {
        let count = (stretch.duration_s() / PERIOD_S).ceil() as u64 + 1;
        group.throughput(Throughput::Elements(count));
        group.sample_size(10);
        group.bench_function(*name, |b| {
            b.iter(|| {
                let mut sum = 0.0;
                let mut sampler = Sampler::new(PERIOD_S);
                sampler.push(Step::Stretch(stretch), |sample| sum += sample.position[0]);
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

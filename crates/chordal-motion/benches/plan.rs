//! How many moves a second the fast level plans, next to a bare copy of the same moves.

mod rows;

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use rows::{arcs, ellipse, harmonics, plan, spiral, surface, wiggle};

fn bench(c: &mut Criterion) {
    let mut group = c.benchmark_group("plan");
    group.sample_size(10);
    for (name, moves, joins) in [
        ("surface", surface(100_000), true),
        ("spiral", spiral(100_000), true),
        ("wiggle", wiggle(100_000), true),
        ("ellipse", ellipse(5000), true),
        ("harmonics", harmonics(1500), true),
        ("surface by corners", surface(100_000), false),
        ("arcs", arcs(20_000), true),
    ] {
        group.throughput(Throughput::Elements(moves.len() as u64));
        group.bench_function(name, |b| b.iter(|| plan(black_box(&moves), joins)));
    }
    let moves = surface(100_000);
    group.throughput(Throughput::Elements(moves.len() as u64));
    group
        .bench_function("surface copied", |b| b.iter_with_large_drop(|| black_box(&moves).clone()));
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);

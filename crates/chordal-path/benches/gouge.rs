//! The whole-contour check on 10⁵ and 10⁶ blocks: clean, badly gouging, and with jitter.

#[path = "../tests/support/mod.rs"]
mod support;

use std::f64::consts::TAU;

use chordal_geometry::Vec2;
use chordal_path::gouge::{
    CenterMove, Contour, GougeCurve, GougeOptions, OutsideCornerRule, ToolSide, check, range,
};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use support::{Dice, contour, offset_path};

/// A closed ring of short lines, 100 mm about, with waves of so many mm, and jitter across it.
fn ring(count: usize, radius: f64, waves: f64, height: f64, jitter: f64) -> Vec<GougeCurve> {
    let mut dice = Dice::new(7);
    let points: Vec<Vec2> = (0..count)
        .map(|k| {
            let angle = TAU * k as f64 / count as f64;
            let r = radius + height * (waves * angle).sin() + dice.between(-jitter, jitter);
            Vec2::new(r * angle.cos(), r * angle.sin())
        })
        .collect();
    (0..count).map(|k| GougeCurve::line(points[k], points[(k + 1) % count])).collect()
}

fn job(curves: &[GougeCurve], radius: f64) -> (Contour, Vec<CenterMove>) {
    let path = offset_path(curves, ToolSide::Left, radius).expect("lines have an offset");
    (contour(curves, ToolSide::Left, radius), path)
}

fn gouge(c: &mut Criterion) {
    let mut group = c.benchmark_group("gouge");
    group.sample_size(10);
    for count in [100_000, 1_000_000] {
        let scale = count as f64 * 1e-6;
        let jobs = [
            // 6 µm segments of a ring of 1 m at most, radius 5.
            ("clean", job(&ring(count, 955.0 * scale, 5.0, 20.0 * scale, 0.0), 5.0 * scale)),
            // Waves of 0.6 mm beside a tool of 60 mm: ten thousand segments of it.
            ("gouging", job(&ring(count, 955.0 * scale, 9000.0 * scale, 0.1, 0.0), 60.0 * scale)),
            ("jitter", job(&ring(count, 955.0 * scale, 5.0, 20.0 * scale, 1e-4), 5.0 * scale)),
        ];
        for (name, (contour, path)) in &jobs {
            let report = check(contour, path, &GougeOptions::default());
            println!(
                "{name} {count}: {} gouges, more {}, complete {}, deepest {:?}",
                report.gouges.len(),
                report.more,
                report.complete,
                report.gouges.first().map(|g| g.depth)
            );
            group.bench_function(BenchmarkId::new(*name, count), |b| {
                b.iter(|| check(contour, path, &GougeOptions::default()))
            });
        }
        group.bench_function(BenchmarkId::new("range", count), |b| {
            b.iter(|| range(&jobs[0].1.0, OutsideCornerRule::Circular, &GougeOptions::default()))
        });
    }
    group.finish();
}

criterion_group!(benches, gouge);
criterion_main!(benches);

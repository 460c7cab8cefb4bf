//! What comparing, converting, splitting and fitting a program of 250,000 lines takes in addition to running it. Ratios
//! within one run are what counts.

#![allow(missing_docs, reason = "a benchmark")]

use std::hint::black_box;

use chordal::{Job, Machine, Source, SourceMap};
use chordal_compare::compare;
use chordal_rewrite::convert::{self, convert};
use chordal_rewrite::{SplitBy, TransformStep, split, transform};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const LINES: u32 = 250_000;

/// Points of a row.
const ROW: u32 = 500;

/// Rows over a wavy surface, each from above and back.
fn surfacing() -> String {
    let mut text = String::from("O100\nT1 M6\nG21 G90 G17 G54\nS9000 M3\nG0 X0. Y0. Z5.\n");
    for row in 0..LINES / ROW {
        text += &format!("G0 Z5.\nX0. Y{:.1}\nG1 Z.3 F3000.\n", f64::from(row) * 0.2);
        for point in 3..ROW {
            let x = f64::from(point) * 0.1;
            let z = 0.6 * (0.3 * x).sin() + 0.3 * (0.11 * x + 0.05 * f64::from(row)).cos();
            text += &format!("X{x:.1} Z{z:.4}\n");
        }
    }
    text + "G0 Z5.\nM30\n"
}

fn machine(name: &str) -> Machine {
    Machine::from_builtin(name).expect("a built-in machine")
}

fn benches(criterion: &mut Criterion) {
    let mut sources = SourceMap::new();
    sources.add(Source::new("surfacing.nc", surfacing().into_bytes()));
    let job = Job::new(sources, machine("haas-vf2")).expect("good settings");
    let mut group = criterion.benchmark_group("250,000 lines");
    group.sample_size(10).throughput(Throughput::Elements(LINES.into()));
    group.bench_function("check", |bench| bench.iter(|| black_box(job.check())));
    group.bench_function("compare with itself", |bench| {
        bench.iter(|| black_box(compare(&job, &job, &Default::default())));
    });
    for to in ["haas-vf2", "fanuc-30i", "fadal-4020"] {
        let target = machine(to);
        group.bench_function(format!("convert to {to}"), |bench| {
            bench.iter(|| {
                let done = convert(&job, &target, &convert::ConversionOptions::default());
                assert!(done.holds());
                done
            });
        });
    }
    group.bench_function("part", |bench| {
        bench.iter(|| {
            let done = split(&job, SplitBy::Bytes(500_000)).expect("places to part it");
            assert!(done.certificate.holds());
            done
        });
    });
    group.bench_function("fit within 0.01 mm", |bench| {
        bench.iter(|| {
            black_box(
                transform(&job, &[TransformStep::Fit { tolerance: 0.01, feed_tolerance: 0.01 }])
                    .expect("rows"),
            )
        });
    });
    group.finish();
}

criterion_group!(large, benches);
criterion_main!(large);

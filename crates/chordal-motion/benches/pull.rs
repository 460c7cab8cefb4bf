//! The cost of a setpoint on the pull side: on lines, arcs, spirals, eased corners, short segments and dense
//! curves, with and without a change of the rate under way.

#![allow(missing_docs, clippy::disallowed_methods, reason = "a benchmark is a shell")]

mod programs;
#[path = "../tests/support/mod.rs"]
mod support;

use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use programs::{PROGRAMS, Source};

fn pull(c: &mut Criterion) {
    let mut group = c.benchmark_group("setpoint");
    for (name, program) in PROGRAMS {
        group.bench_function(name, |bencher| {
            let mut source = Source::new(program);
            bencher.iter_custom(|count| source.pull(count, |_, _| {}));
        });
    }
    for (name, program) in PROGRAMS {
        group.bench_function(format!("{name}, override changing"), |bencher| {
            let mut source = Source::new(program);
            bencher.iter_custom(|count| {
                source.pull(count, |index, servo| {
                    if index % 50 == 0 {
                        servo.set_override(if index == 0 { 0.7 } else { 1.0 });
                    }
                })
            });
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = pull
}
criterion_main!(benches);

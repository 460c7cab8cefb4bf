//! How fast programs under tool centre point control run: interpreted alone, with the path of the axes, and planned; next to
//! the same path of the tip without rotary axes. Ratios within one run are what counts.

#![allow(missing_docs, reason = "a benchmark")]

use std::hint::black_box;

use chordal::motion::{MotionOptions, MotionStep};
use chordal::{Command, Diagnostic, Job, Machine, RunSink, Sink, Source, SourceMap};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const BLOCKS: u64 = 100_000;

const TRUNNION: &str = "inherits = 'fanuc-ac-trunnion'
[rotary.A]
point = { Y = '-200 mm', Z = '-400 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
[work_offsets.G54]
X = '-300 mm'
Y = '-250 mm'
Z = '-380 mm'
[tools.1]
length = '100 mm'
diameter = '6 mm'
";

/// How the direction of the tool is given.
#[derive(Clone, Copy)]
enum DirectionWords {
    /// Not at all: three axes.
    Absent,
    /// A and C (G43.4).
    Angles,
    /// I, J and K (G43.5).
    Vector,
}

/// Passes over a wavy surface in steps of half a millimetre, the tool leaning by some degrees around its normal.
fn surface(words: DirectionWords) -> String {
    let length_code = match words {
        DirectionWords::Absent => "G43",
        DirectionWords::Angles => "G43.4",
        DirectionWords::Vector => "G43.5",
    };
    let mut text = format!(
        "G21 G90 G17 G94\nG5.1 Q1\nT1 M6\nS9000 M3\nG54 G0 X0 Y0 A10. C135.\n{length_code} H1 Z40.\nG1 X0 Y0 Z10. F3000.\n"
    );
    for index in 0..BLOCKS {
        let (row, column) = (index / 160, index % 160);
        let column = if row % 2 == 0 { column } else { 159 - column };
        let (x, y) = (column as f64 * 0.5 - 40.0, row as f64 * 0.1 - 30.0);
        let z = 4.0 * (x / 20.0).sin() + 3.0 * (y / 25.0).cos();
        let (lean, azimuth) = (14.0 + 6.0 * (x / 30.0).sin(), 40.0 + 25.0 * (y / 40.0).sin());
        let (sin, cos) = f64::to_radians(lean).sin_cos();
        let (sin_azimuth, cos_azimuth) = f64::to_radians(azimuth).sin_cos();
        text += &format!("X{x:.3} Y{y:.3} Z{z:.3}");
        match words {
            DirectionWords::Absent => {}
            DirectionWords::Angles => text += &format!(" A{lean:.3} C{:.3}", azimuth + 90.0),
            DirectionWords::Vector => {
                let [i, j] = [sin * cos_azimuth, sin * sin_azimuth];
                text += &format!(" I{i:.6} J{j:.6} K{cos:.6}");
            }
        }
        text.push('\n');
    }
    text + "G49\nM30\n"
}

#[derive(Default)]
struct CommandSum(f64);

impl Sink for CommandSum {
    fn command(&mut self, command: &Command) {
        self.0 += command.kind.motion().map_or(0.0, |motion| motion.to[0] + motion.to[5]);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        assert!(
            diagnostic.severity != chordal::diagnostics::Severity::Error,
            "{}",
            diagnostic.message
        );
    }
}

impl RunSink for CommandSum {}

fn benches(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("100k lines of the tip");
    group.throughput(Throughput::Elements(BLOCKS)).sample_size(10);
    let kinds = [
        ("three axes", DirectionWords::Absent),
        ("angles", DirectionWords::Angles),
        ("vectors", DirectionWords::Vector),
    ];
    for (name, words) in kinds {
        let machine = Machine::from_toml("five.toml", TRUNNION, &|name| Err(format!("no {name}")))
            .expect("a machine");
        let mut sources = SourceMap::new();
        sources.add(Source::new("bench.nc", surface(words).into_bytes()));
        let job = Job::new(sources, machine).expect("a good machine");
        group.bench_function(format!("{name}, interpreted"), |bench| {
            bench.iter(|| {
                let mut sum = CommandSum::default();
                job.run(&mut sum);
                black_box(sum.0)
            });
        });
        group.bench_function(format!("{name}, moves of the axes"), |bench| {
            bench.iter(|| {
                let mut sum = 0.0;
                let take = |step: &MotionStep, _: &_| {
                    if let MotionStep::Move(motion) = step {
                        sum += motion.to()[0];
                    }
                    Ok(())
                };
                drop(job.motion(&MotionOptions::default(), take).expect("limits"));
                black_box(sum)
            });
        });
        group.bench_function(format!("{name}, planned"), |bench| {
            bench.iter(|| {
                black_box(job.time(&MotionOptions::default()).expect("limits").time.total_s())
            });
        });
    }
    group.finish();
}

criterion_group!(all, benches);
criterion_main!(all);

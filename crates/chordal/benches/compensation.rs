//! How fast a compensated contour runs: interpreted alone, with the path of the tool centre, and
//! with the whole contour compared with that path. Ratios within one run are what counts.

#![allow(missing_docs, reason = "a benchmark")]

use chordal::RunSink;
use std::hint::black_box;

use chordal::path::{ContourPiece, PathCommand, PathSink};
use chordal::{Command, Diagnostic, Job, Machine, Sink, Source, SourceMap};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const BLOCKS: u64 = 100_000;

/// A stair of lines and tangent arcs with a sharp outside and inside corner now and then, on
/// which the tool fits everywhere.
fn contour() -> String {
    let mut text =
        String::from("G21 G17 G40 G91\nT1 M6\nS1000 M3\nG0 X0 Y5.\nG1 G41 D1 Y-5. F1000.\n");
    for index in 0..BLOCKS / 4 {
        text += match index % 8 {
            7 => "G1 X.7 Y-.1\nX.5\nX.3 Y.2\nX.5\n",
            _ => "G1 X.1\nG3 X.2 Y.2 J.2\nG1 Y.1\nG2 X.2 Y.2 I.2\n",
        };
    }
    text + "G40 G1 Y5.\nM30\n"
}

#[derive(Default)]
struct Sum(f64);

impl Sink for Sum {
    fn command(&mut self, command: &Command) {
        self.0 += command.kind.motion().map_or(0.0, |motion| motion.to[0]);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        panic!("{}", diagnostic.message);
    }
}

impl RunSink for Sum {}

impl PathSink for Sum {
    fn command(&mut self, path: PathCommand<'_>) {
        Sink::command(self, path.command);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &chordal::control::Origin) {
        Sink::diagnostic(self, diagnostic);
    }

    fn contour(&mut self, piece: &ContourPiece) {
        self.0 += piece.radius_mm;
    }
}

fn benches(criterion: &mut Criterion) {
    let text = contour();
    let mut machine = Machine::from_builtin("fanuc-30i").expect("a built-in machine");
    let given = [
        "tools.1.diameter=0.2 mm",
        "tools.1.length=100 mm",
        "axes.X.travel=[\"-1000 mm\", \"50000 mm\"]",
        "axes.Y.travel=[\"-1000 mm\", \"50000 mm\"]",
    ];
    for assignment in given {
        machine.set(assignment).expect("a good assignment");
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("bench.nc", text.as_bytes()));
    let job = Job::new(sources, machine).expect("a good machine");
    let mut group = criterion.benchmark_group("100k blocks of G41");
    group.throughput(Throughput::Elements(BLOCKS)).sample_size(20);
    group.bench_function("interpreted", |bench| {
        bench.iter(|| {
            let mut sum = Sum::default();
            job.run(&mut sum);
            black_box(sum.0)
        });
    });
    group.bench_function("compensated", |bench| {
        bench.iter(|| {
            let mut sum = Sum::default();
            job.compensated(None, &mut sum);
            black_box(sum.0)
        });
    });
    group.bench_function("checked whole", |bench| {
        bench.iter(|| {
            let report = job.check();
            assert_eq!(report.counts.errors, 0);
            black_box(report.counts)
        });
    });
    group.finish();
}

criterion_group!(all, benches);
criterion_main!(all);

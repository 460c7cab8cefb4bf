//! How fast programs are interpreted, beside a loop that only reads the numbers: ratios
//! within one run are what counts, since machines differ and drift.

#![allow(missing_docs, clippy::disallowed_methods, reason = "a benchmark is a shell")]

use chordal_command::{Command, CommandKind, Sink};
use chordal_dialect::Control;
use chordal_gcode::{Library, run};
use chordal_kernel::{RunOptions, RunSink};
use std::hint::black_box;

use chordal_diagnostics::{Diagnostic, Source, SourceMap};
use chordal_machine::Machine;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

/// Counts commands and adds up their ends, so that nothing can be left out.
#[derive(Default)]
struct Counting {
    motions: u64,
    sum: f64,
    problems: u64,
}

impl Sink for Counting {
    fn command(&mut self, command: &Command) {
        if let Some(motion) = command.kind.motion() {
            self.motions += 1;
            self.sum += motion.to[0];
        }
        if let CommandKind::Arc { shape, .. } = &command.kind {
            self.sum += shape.sweep;
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {
        self.problems += 1;
    }
}

impl RunSink for Counting {}

fn interpret(text: &[u8], machine: &Machine, expected: u64) {
    let mut sources = SourceMap::new();
    sources.add(Source::new("bench", text));
    let (control, _) = Control::of(machine).expect("a word-address control");
    let library = Library::new(&sources, &control.table.lexicon);
    let mut sink = Counting::default();
    run(&library, 0, machine, &control, &RunOptions::default(), &mut sink);
    assert_eq!((sink.motions, sink.problems), (expected, 0));
    black_box(sink.sum);
}

/// A xorshift, so that every run reads the same text.
struct Random(u64);

impl Random {
    fn next(&mut self, below: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % below
    }
}

fn lines(count: usize) -> String {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut text = String::from("G21 G90 S1000 M3\nG1 F1000.\n");
    for _ in 0..count {
        let mut word = |letter: char| {
            let sign = if random.next(2) == 0 { "-" } else { "" };
            format!("{letter}{sign}{}.{:03}", random.next(200), random.next(1000))
        };
        let (x, y, z) = (word('X'), word('Y'), word('Z'));
        text += &format!("{x} {y} {z}\n");
    }
    text + "M30\n"
}

/// Quarter arcs around a circle, with exact centres.
fn arcs(count: usize) -> String {
    let mut text = String::from("G21 G90 S1000 M3\nG1 X0. Y10. F1000.\n");
    for index in 0..count {
        let corner = match index % 4 {
            0 => "G2 X10.000 Y20.000 I10.000 J0.000\n",
            1 => "G2 X20.000 Y10.000 I0.000 J-10.000\n",
            2 => "G2 X10.000 Y0.000 I-10.000 J0.000\n",
            _ => "G2 X0.000 Y10.000 I0.000 J10.000\n",
        };
        text += corner;
    }
    text + "M30\n"
}

/// What any reader must do at least: find the numbers and add them up.
fn numbers_only(text: &[u8]) -> f64 {
    let (mut sum, mut value, mut scale, mut sign) = (0.0, 0i64, 0i64, 1i64);
    for byte in text {
        match byte {
            b'0'..=b'9' => {
                value = value * 10 + i64::from(byte - b'0');
                scale *= 10;
            }
            b'-' => sign = -1,
            b'.' => scale = 1,
            _ => {
                if value != 0 {
                    sum += (sign * value) as f64 / if scale > 0 { scale as f64 } else { 1.0 };
                }
                (value, scale, sign) = (0, 0, 1);
            }
        }
    }
    sum
}

fn benchmarks(criterion: &mut Criterion) {
    let machine = Machine::from_builtin("fanuc-30i").expect("a built-in machine");
    let (million, arcs) = (lines(1_000_000), arcs(200_000));
    let mut group = criterion.benchmark_group("interpret");
    group.sample_size(10);
    group.throughput(Throughput::Elements(1_000_000));
    group.bench_function("numbers only, 1 M lines", |b| {
        b.iter(|| black_box(numbers_only(million.as_bytes())));
    });
    group.bench_function("1 M lines", |b| {
        b.iter(|| interpret(million.as_bytes(), &machine, 1_000_000));
    });
    group.throughput(Throughput::Elements(200_000));
    group.bench_function("200 k arcs", |b| {
        b.iter(|| interpret(arcs.as_bytes(), &machine, 200_001));
    });
    group.finish();
}

criterion_group!(all, benchmarks);
criterion_main!(all);

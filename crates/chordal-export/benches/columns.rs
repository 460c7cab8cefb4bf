//! What columns cost: commands of a long program into Arrow, next to the same run to a sink that
//! counts and a copy of as many bytes. Ratios within one run are what counts.
//!
//!     CHORDAL_LINES=1000000 cargo bench -p chordal-export --bench columns

#![allow(missing_docs, clippy::disallowed_methods, reason = "a benchmark is a shell")]

use std::fmt::Write;
use std::hint::black_box;
use std::io;
use std::time::Duration;

use arrow_array::RecordBatch;
use chordal::{Command, Job, Machine, Source, SourceMap};
use chordal_export::OutputFormat;
use chordal_export::columns::{ColumnFile, CommandColumns, RowBatcher};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

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

/// A surface of so many short moves.
fn program(lines: usize) -> String {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut text = String::from("%\nO1\nG21 G17 G90 G94\nS9000 M3\nG0 X0 Y0 Z1.\nG1 F3000.\n");
    for index in 0..lines {
        let (x, z) = (index % 2000, random.next(1000));
        let _ = writeln!(
            text,
            "X{}.{:03} Y{}.{:03} Z-0.{z:03}",
            x / 10,
            x % 10,
            index / 100_000,
            index % 997
        );
    }
    text + "G0 Z1. M5\nM30\n%\n"
}

fn job(text: &[u8]) -> Job<'_> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("bench.nc", text));
    let machine = Machine::from_builtin("haas-vf2").expect("a built-in machine");
    Job::new(sources, machine).expect("its settings are known")
}

fn counted(job: &Job) -> u64 {
    let mut count = 0;
    job.report_of_commands(|command: &Command| {
        count += 1;
        black_box(command);
    });
    count
}

/// All rows in one batch, as the Python package has them.
fn batch(job: &Job) -> RecordBatch {
    let mut columns = CommandColumns::new(job);
    job.report_of_commands(|command| columns.command(command));
    columns.take().expect("a batch")
}

fn file(job: &Job, format: OutputFormat) {
    let mut file =
        ColumnFile::new(io::sink(), format, CommandColumns::new(job)).expect("a sink takes all");
    job.report_of_commands(|command| file.put(|rows| rows.command(command)).expect("it does"));
    file.finish().expect("it does");
}

fn columns(criterion: &mut Criterion) {
    let lines = std::env::var("CHORDAL_LINES").ok().and_then(|text| text.parse().ok());
    let lines: usize = lines.unwrap_or(100_000);
    let text = program(lines);
    let job = job(text.as_bytes());
    let rows = counted(&job);
    let whole = batch(&job);
    assert_eq!(whole.num_rows() as u64, rows);
    let bytes = whole.get_array_memory_size();
    println!("{lines} lines, {rows} rows, {bytes} bytes of columns");
    drop(whole);
    let block = vec![1u64; bytes / 8];

    let mut group = criterion.benchmark_group("commands");
    group.sample_size(10).measurement_time(Duration::from_secs(5));
    group.throughput(Throughput::Elements(rows));
    group.bench_function("to a counting sink", |bench| bench.iter(|| counted(&job)));
    group
        .bench_function("a copy of as many bytes", |bench| bench.iter(|| black_box(block.clone())));
    group.bench_function("to one batch", |bench| bench.iter(|| batch(&job)));
    group.bench_function("to an Arrow file", |bench| {
        bench.iter(|| file(&job, OutputFormat::Arrow));
    });
    group.bench_function("to a Parquet file", |bench| {
        bench.iter(|| file(&job, OutputFormat::Parquet));
    });
    group.finish();
}

criterion_group!(benches, columns);
criterion_main!(benches);

//! Columns: the page that documents them, and batches of any size.

#![allow(clippy::disallowed_methods, reason = "reads the page that it checks")]

use std::io::{self, Write};

use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array, RecordBatch};
use chordal::geometry::Placement;
use chordal::{Command, Job, Machine, Source, SourceMap};
use chordal_export::OutputFormat;
use chordal_export::columns::{ChordColumns, ColumnFile, CommandColumns, PathColumns, RowBatcher};

const PART: &str = "G21 G90 G17 S900 M3\nG0 X0 Y0 Z5.\nT2 M6\nG1 Z-1. F100.\nX10.\n\
                    G3 X20. Y10. I0 J10. F50.\nG4 P2.\n#1=3.\nDPRNT[X#1[32]]\nM30\n";

fn job() -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", PART.as_bytes()));
    let machine = Machine::from_builtin("haas-vf2").expect("a built-in machine");
    Job::new(sources, machine).expect("its settings are known")
}

fn numbers(batch: &RecordBatch, name: &str) -> Vec<Option<f64>> {
    let column = batch.column_by_name(name).expect(name);
    column.as_primitive::<Float64Type>().iter().collect()
}

#[test]
fn the_page_is_that_of_the_code() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/columns.md");
    let page = std::fs::read_to_string(path).expect("docs/columns.md");
    assert!(
        page == chordal_export::column_reference(),
        "run `cargo run -p chordal-export --example columns > docs/columns.md`"
    );
}

/// Rows of commands in batches of a size.
fn batches(size: usize) -> Vec<RecordBatch> {
    let job = job();
    let mut columns = CommandColumns::new(&job);
    let mut batches = Vec::new();
    job.report_of_commands(|command: &Command| {
        columns.command(command);
        if columns.rows() == size {
            batches.push(columns.take().expect("a batch"));
        }
    });
    batches.push(columns.take().expect("a batch"));
    batches
}

#[test]
fn rows_are_the_same_in_batches_of_any_size() {
    let whole = batches(usize::MAX);
    assert_eq!(whole.len(), 1);
    let rows = whole[0].num_rows();
    for size in [1, 2, 3, 7] {
        let mut from = 0;
        for batch in batches(size) {
            assert_eq!(batch.schema(), whole[0].schema());
            let part = whole[0].slice(from, batch.num_rows());
            for (column, expected) in batch.columns().iter().zip(part.columns()) {
                assert_eq!(column.as_ref(), expected.as_ref());
            }
            from += batch.num_rows();
        }
        assert_eq!(from, rows);
    }
}

/// An output that is full after so many bytes.
struct Full(usize);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.0 < bytes.len() {
            return Err(io::Error::new(io::ErrorKind::StorageFull, "no room"));
        }
        self.0 -= bytes.len();
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Rows until the output is full, if it ever is.
fn fill(room: usize, format: OutputFormat) -> io::Result<usize> {
    let job = job();
    let mut file = ColumnFile::new(Full(room), format, PathColumns::new(&job))?;
    let mut done = Ok(());
    for _ in 0..20_000 {
        job.path(|segment| {
            if done.is_ok() {
                done = file.put(|rows| rows.segment(segment));
            }
        });
        if done.is_err() {
            break;
        }
    }
    done?;
    file.finish().map(|out| room - out.0)
}

#[test]
fn a_full_output_is_told_as_such() {
    for format in [OutputFormat::Parquet, OutputFormat::Arrow] {
        let bytes = fill(usize::MAX, format).expect("room for all");
        for room in [0, 3, bytes / 2, bytes - 1] {
            let error = fill(room, format).expect_err("no room");
            assert_eq!(error.kind(), io::ErrorKind::StorageFull, "{format:?} {room}: {error}");
        }
        assert_eq!(fill(bytes, format).expect("just room"), bytes);
    }
}

#[test]
fn a_gap_is_null_and_not_a_number() {
    let whole = &batches(usize::MAX)[0];
    let seconds = numbers(whole, "seconds");
    assert_eq!(seconds.iter().flatten().collect::<Vec<_>>(), [&2.0]);
    let column = whole.column_by_name("seconds").expect("a column");
    let column = column.as_primitive::<Float64Type>();
    assert_eq!(column.null_count() + 1, column.len());
    assert!(
        column.iter().zip(column.values()).all(|(cell, value)| cell.is_some() != value.is_nan())
    );
    let sweeps: Vec<f64> = numbers(whole, "sweep_deg").into_iter().flatten().collect();
    assert_eq!(sweeps, [90.0]);
}

#[test]
fn the_path_and_its_chords_join() {
    let job = job();
    let (mut path, mut chords) =
        (PathColumns::new(&job), ChordColumns::new(&job, 0.01, Placement::Inscribed));
    job.path(|segment| {
        path.segment(segment);
        chords.segment(segment).expect("a curve of this size has chords");
    });
    let (path, chords) = (path.take().expect("a batch"), chords.take().expect("a batch"));
    for batch in [&path, &chords] {
        for axis in ["x", "y", "z"] {
            let from = numbers(batch, &format!("{axis}_from_mm"));
            let to = numbers(batch, &format!("{axis}_to_mm"));
            assert_eq!(from[1..], to[..to.len() - 1]);
        }
    }
    // The way to the first place is not known, and no chord has its length.
    let known = path.column_by_name("known").expect("a column").as_boolean();
    let lengths = numbers(&path, "length_mm").into_iter().zip(known.iter());
    let length: f64 =
        lengths.filter(|(_, known)| *known == Some(true)).filter_map(|(mm, _)| mm).sum();
    assert_eq!(known.iter().filter(|known| *known == Some(false)).count(), 1);
    assert_eq!(numbers(&chords, "length_mm").iter().filter(|mm| mm.is_none()).count(), 1);
    let of_chords: f64 = numbers(&chords, "length_mm").into_iter().flatten().sum();
    assert!(of_chords < length && of_chords > length - 0.1);
    assert_eq!(
        chords.schema().metadata()["chordal.tolerance_mm"],
        "0.01",
        "a tolerance is told with its chords"
    );
}

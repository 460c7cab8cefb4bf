//! Setpoints in every format, read back.

use std::io::{self, Cursor, Write};

use arrow_array::{Array, Float64Array, RecordBatch, UInt32Array};
use bytes::Bytes;
use chordal::machine::AXES;
use chordal::motion::MotionSample;
use chordal::{Job, Machine, Source, SourceMap};
use chordal_export::columns::SampleColumns;
use chordal_export::{OutputFormat, SampleHead, SampleWriter};
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use serde_json::Value;

const PERIOD_S: f64 = 0.001;

fn head(rotary: [bool; 3]) -> SampleHead {
    SampleHead {
        rotary,
        period_s: PERIOD_S,
        program: "O\"1.nc".into(),
        program_sha256: "ab".repeat(32),
        machine: "haas-vf2".into(),
        control: "haas".into(),
    }
}

fn sample(index: usize) -> MotionSample {
    let t = index as f64 * PERIOD_S;
    MotionSample {
        time_s: t,
        position: [50.0 * t * t, -1.5, 0.1 + 0.2, std::f64::consts::PI * t, 0.0, 0.0],
        velocity: [100.0 * t, 0.0, -3.0, std::f64::consts::PI, 0.0, 0.0],
        acceleration: [100.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        jerk: [0.0; AXES],
        tag: 0,
    }
}

fn written(format: OutputFormat, rotary: [bool; 3], rows: usize) -> Vec<u8> {
    let mut writer =
        SampleWriter::new(Vec::new(), format, SampleColumns::new(&head(rotary))).unwrap();
    for index in 0..rows {
        writer.sample(&sample(index), 10 + (index / 1000) as u32).unwrap();
    }
    writer.finish().unwrap()
}

#[test]
fn a_table_by_hand() {
    let text = String::from_utf8(written(OutputFormat::Csv, [false; 3], 3)).unwrap();
    assert_eq!(
        text,
        "time_s,x_mm,x_vel_mm_per_s,x_acc_mm_per_s2,y_mm,y_vel_mm_per_s,y_acc_mm_per_s2,\
         z_mm,z_vel_mm_per_s,z_acc_mm_per_s2,speed_mm_per_s,line\n\
         0,0,0,100,-1.5,0,0,0.3,-3,0,3,10\n\
         0.001,0.00005,0.1,100,-1.5,0,0,0.3,-3,0,3.001666204,10\n\
         0.002,0.0002,0.2,100,-1.5,0,0,0.3,-3,0,3.006659276,10\n"
    );
}

#[test]
fn rotary_axes_are_degrees() {
    let text = String::from_utf8(written(OutputFormat::Csv, [true, false, false], 3)).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(
        rows[0][10..],
        ["a_deg", "a_vel_deg_per_s", "a_acc_deg_per_s2", "speed_mm_per_s", "line"]
    );
    assert_eq!(rows[3][10..], ["0.36", "180", "0", "3.006659276", "10"]);
}

#[test]
fn json_lines_have_a_header_and_the_names_of_the_columns() {
    let text = String::from_utf8(written(OutputFormat::Jsonl, [false, false, true], 2)).unwrap();
    let lines: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines.len(), 3);
    assert_eq!(lines[0]["schema"], "chordal.samples/1");
    assert_eq!(lines[0]["program"], "O\"1.nc");
    assert_eq!(lines[0]["period_s"], 0.001);
    let names: Vec<&str> = lines[2].as_object().unwrap().keys().map(String::as_str).collect();
    assert_eq!(names[..3], ["time_s", "x_mm", "x_vel_mm_per_s"]);
    assert_eq!(
        names[10..],
        ["c_deg", "c_vel_deg_per_s", "c_acc_deg_per_s2", "speed_mm_per_s", "line"]
    );
    assert_eq!((&lines[2]["x_mm"], &lines[2]["line"]), (&Value::from(5e-5), &Value::from(10)));
}

/// The doubles themselves, not their text.
fn rows_agree(batches: &[RecordBatch], rows: usize) {
    assert_eq!(batches.iter().map(RecordBatch::num_rows).sum::<usize>(), rows);
    let mut index = 0;
    for batch in batches {
        let column = |name: &str| {
            let column = batch.column_by_name(name).unwrap();
            column.as_any().downcast_ref::<Float64Array>().unwrap().clone()
        };
        let (time, x, a) = (column("time_s"), column("x_mm"), column("a_vel_deg_per_s"));
        let line = batch.column_by_name("line").unwrap();
        let line = line.as_any().downcast_ref::<UInt32Array>().unwrap();
        for row in 0..batch.num_rows() {
            let sample = sample(index);
            assert_eq!((time.value(row), x.value(row)), (sample.time_s, sample.position[0]));
            assert_eq!(a.value(row), 180.0);
            assert_eq!(line.value(row), 10 + (index / 1000) as u32);
            index += 1;
        }
    }
}

#[test]
fn a_parquet_file_reads_back() {
    let rows = 200_000;
    let bytes = Bytes::from(written(OutputFormat::Parquet, [true, false, false], rows));
    let builder = ParquetRecordBatchReaderBuilder::try_new(bytes).unwrap();
    assert_eq!(builder.metadata().num_row_groups(), 2);
    let about = builder.metadata().file_metadata().key_value_metadata().unwrap();
    let value = |key: &str| {
        about.iter().find(|pair| pair.key == key).and_then(|pair| pair.value.clone()).unwrap()
    };
    assert_eq!(value("chordal.schema"), "chordal.samples/1");
    assert_eq!(value("chordal.program_sha256"), "ab".repeat(32));
    let unit =
        builder.schema().field_with_name("x_acc_mm_per_s2").unwrap().metadata()["unit"].clone();
    assert_eq!(unit, "mm/s^2");
    let batches: Vec<RecordBatch> = builder.build().unwrap().map(Result::unwrap).collect();
    rows_agree(&batches, rows);
}

#[test]
fn an_arrow_file_reads_back() {
    for rows in [0, 1, 8192, 20_000] {
        let bytes = written(OutputFormat::Arrow, [true, false, false], rows);
        let reader = arrow_ipc::reader::FileReader::try_new(Cursor::new(bytes), None).unwrap();
        assert_eq!(reader.schema().metadata()["chordal.period_s"], "0.001");
        assert_eq!(reader.schema().field(1).metadata()["unit"], "mm");
        let batches: Vec<RecordBatch> = reader.map(Result::unwrap).collect();
        rows_agree(&batches, rows);
    }
}

#[test]
fn the_same_samples_are_the_same_bytes() {
    for format in
        [OutputFormat::Csv, OutputFormat::Jsonl, OutputFormat::Parquet, OutputFormat::Arrow]
    {
        assert_eq!(written(format, [true; 3], 10_000), written(format, [true; 3], 10_000));
    }
}

#[test]
fn the_head_is_that_of_the_job() {
    let head = |text: &'static [u8]| {
        let mut sources = SourceMap::new();
        sources.add(Source::new("abc.nc", text));
        let job = Job::new(sources, Machine::from_builtin("haas-vf2").unwrap()).unwrap();
        SampleHead::of(&job, &job.report(), 0.5)
    };
    let first = head(b"abc");
    assert_eq!((first.program.as_str(), first.machine.as_str()), ("abc.nc", "haas-vf2"));
    assert!(first.program_sha256.starts_with("ba7816bf"));
    // The machine has an A axis; a column is for a program that moves it.
    assert_eq!((first.rotary, first.period_s), ([false; 3], 0.5));
    assert_eq!(head(b"G0 X1. A90.\nM30\n").rotary, [true, false, false]);
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

#[test]
fn a_full_output_is_told_as_such() {
    for format in
        [OutputFormat::Csv, OutputFormat::Jsonl, OutputFormat::Parquet, OutputFormat::Arrow]
    {
        let mut writer =
            SampleWriter::new(Full(5_000), format, SampleColumns::new(&head([true; 3]))).unwrap();
        let mut done = Ok(());
        for index in 0..400_000 {
            done = writer.sample(&sample(index), 1);
            if done.is_err() {
                break;
            }
        }
        let error = done.unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::StorageFull, "{format:?}: {error}");
    }
}

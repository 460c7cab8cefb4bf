//! Setpoints as Parquet and as an Arrow file.

use std::collections::HashMap;
use std::io::{self, Write};
use std::sync::Arc;

use arrow_array::{ArrayRef, Float64Array, RecordBatch, UInt32Array};
use arrow_ipc::writer::FileWriter;
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};
use chordal::motion::Sample;
use parquet::arrow::ArrowWriter;
use parquet::basic::Compression;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;

use super::{Column, SAMPLE_SCHEMA, SampleHead};

/// Rows that are gathered before they are handed on.
const BATCH: usize = 1 << 13;
/// Rows of a group of a Parquet file: what a reader reads at once, about 10 MB.
const ROWS_OF_A_GROUP: usize = 1 << 17;

/// Gathers setpoints, one row each, and gives them as a batch when it is asked.
#[derive(Debug)]
pub struct SampleColumns {
    schema: Arc<Schema>,
    columns: Vec<Column>,
    values: Vec<Vec<f64>>,
    lines: Vec<u32>,
}

/// What the file says about itself, in a fixed order.
fn metadata(head: &SampleHead) -> Vec<(String, String)> {
    [
        ("schema", SAMPLE_SCHEMA.to_string()),
        ("period_s", head.period_s.to_string()),
        ("machine", head.machine.clone()),
        ("program", head.program.clone()),
        ("program_sha256", head.program_sha256.clone()),
    ]
    .map(|(key, value)| (format!("chordal.{key}"), value))
    .into()
}

impl SampleColumns {
    /// Columns for setpoints.
    pub fn new(head: &SampleHead) -> SampleColumns {
        let columns = head.columns();
        let field = |column: &Column| {
            let unit = HashMap::from([("unit".to_string(), column.unit.to_string())]);
            Field::new(&column.name, DataType::Float64, false).with_metadata(unit)
        };
        let mut fields: Vec<Field> = columns.iter().map(field).collect();
        fields.push(Field::new("line", DataType::UInt32, false));
        let about = metadata(head).into_iter().collect();
        SampleColumns {
            schema: Arc::new(Schema::new_with_metadata(fields, about)),
            values: vec![Vec::with_capacity(BATCH); columns.len()],
            columns,
            lines: Vec::with_capacity(BATCH),
        }
    }

    /// Takes a setpoint of a block on this line.
    pub fn sample(&mut self, sample: &Sample, line: u32) {
        for (values, column) in self.values.iter_mut().zip(&self.columns) {
            values.push(column.of(sample));
        }
        self.lines.push(line);
    }

    /// Rows gathered since the last batch.
    pub fn rows(&self) -> usize {
        self.lines.len()
    }

    /// The columns, with their units and what they come from.
    pub fn schema(&self) -> &SchemaRef {
        &self.schema
    }

    /// True when a file should be given what there is.
    fn is_full(&self) -> bool {
        self.rows() >= BATCH
    }

    /// The rows gathered so far; the next begin anew.
    ///
    /// # Errors
    /// None that the rows themselves could cause.
    pub fn take(&mut self) -> Result<RecordBatch, ArrowError> {
        let fresh = || Vec::with_capacity(BATCH);
        let mut arrays: Vec<ArrayRef> = Vec::with_capacity(self.values.len() + 1);
        for values in &mut self.values {
            arrays.push(Arc::new(Float64Array::from(std::mem::replace(values, fresh()))));
        }
        let lines = std::mem::replace(&mut self.lines, Vec::with_capacity(BATCH));
        arrays.push(Arc::new(UInt32Array::from(lines)));
        RecordBatch::try_new(self.schema.clone(), arrays)
    }
}

/// A Parquet file: groups of rows, each column compressed.
pub(super) struct ParquetFile<W: Write + Send> {
    rows: SampleColumns,
    out: ArrowWriter<W>,
}

impl<W: Write + Send> ParquetFile<W> {
    pub fn new(out: W, head: &SampleHead) -> io::Result<ParquetFile<W>> {
        let rows = SampleColumns::new(head);
        let about = metadata(head).into_iter().map(|(key, value)| KeyValue::new(key, value));
        let properties = WriterProperties::builder()
            .set_created_by(concat!("chordal ", env!("CARGO_PKG_VERSION")).to_string())
            .set_compression(Compression::SNAPPY)
            // Hardly two doubles of a movement are the same; lines repeat.
            .set_dictionary_enabled(false)
            .set_column_dictionary_enabled("line".into(), true)
            .set_max_row_group_row_count(Some(ROWS_OF_A_GROUP))
            .set_key_value_metadata(Some(about.collect()))
            .build();
        let out = ArrowWriter::try_new(out, rows.schema.clone(), Some(properties));
        Ok(ParquetFile { rows, out: out.map_err(of_parquet)? })
    }

    pub fn sample(&mut self, sample: &Sample, line: u32) -> io::Result<()> {
        self.rows.sample(sample, line);
        if self.rows.is_full() { self.hand_on() } else { Ok(()) }
    }

    pub fn finish(mut self) -> io::Result<W> {
        self.hand_on()?;
        self.out.into_inner().map_err(of_parquet)
    }

    fn hand_on(&mut self) -> io::Result<()> {
        let batch = self.rows.take().map_err(of_arrow)?;
        self.out.write(&batch).map_err(of_parquet)
    }
}

/// An Arrow IPC file: the columns as they lie in memory.
pub(super) struct ArrowFile<W: Write> {
    rows: SampleColumns,
    out: FileWriter<W>,
}

impl<W: Write> ArrowFile<W> {
    pub fn new(out: W, head: &SampleHead) -> io::Result<ArrowFile<W>> {
        let rows = SampleColumns::new(head);
        let out = FileWriter::try_new(out, &rows.schema).map_err(of_arrow)?;
        Ok(ArrowFile { rows, out })
    }

    pub fn sample(&mut self, sample: &Sample, line: u32) -> io::Result<()> {
        self.rows.sample(sample, line);
        if self.rows.is_full() { self.hand_on() } else { Ok(()) }
    }

    pub fn finish(mut self) -> io::Result<W> {
        if !self.rows.lines.is_empty() {
            self.hand_on()?;
        }
        self.out.finish().map_err(of_arrow)?;
        self.out.into_inner().map_err(of_arrow)
    }

    fn hand_on(&mut self) -> io::Result<()> {
        let batch = self.rows.take().map_err(of_arrow)?;
        self.out.write(&batch).map_err(of_arrow)
    }
}

impl<W: Write + Send> std::fmt::Debug for ParquetFile<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ParquetFile").field("rows", &self.rows.lines.len()).finish_non_exhaustive()
    }
}

impl<W: Write> std::fmt::Debug for ArrowFile<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ArrowFile").field("rows", &self.rows.lines.len()).finish_non_exhaustive()
    }
}

/// The output's own error where it is one.
fn of_arrow(error: ArrowError) -> io::Error {
    match error {
        ArrowError::IoError(_, error) => error,
        other => io::Error::other(other),
    }
}

fn of_parquet(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(inner) => match inner.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(inner) => io::Error::other(inner),
        },
        other => io::Error::other(other),
    }
}

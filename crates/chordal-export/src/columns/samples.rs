//! Setpoints as columns.

use std::io::{self, Write};
use std::sync::Arc;

use arrow_array::{ArrayRef, Float64Array, RecordBatch, UInt32Array};
use arrow_schema::{ArrowError, SchemaRef};
use chordal::motion::MotionSample;

use super::field::{CellType, Column, schema_of};
use super::file::ColumnFile;
use super::rows::{BATCH, RowBatcher};
use crate::json::JsonObject;
use crate::setpoints::{SAMPLE_SCHEMA, SampleHead, SetpointColumn, sample_columns};

/// Gathers setpoints, one row each, and gives them as a batch when it is asked.
#[derive(Debug)]
pub struct SampleColumns {
    schema: SchemaRef,
    columns: Vec<SetpointColumn>,
    values: Vec<Vec<f64>>,
    lines: Vec<u32>,
    head: SampleHead,
}

impl SampleColumns {
    /// Columns for setpoints.
    pub fn new(head: &SampleHead) -> SampleColumns {
        let mut columns: Vec<Column> = sample_columns(head.axes())
            .map(|(name, unit, meaning)| Column { name, cell: CellType::Number, unit, meaning })
            .collect();
        columns.push(Column::new("line", CellType::Integer, "", "line of the block, from 1"));
        let more = [("period_s", head.period_s.to_string())];
        let about = [
            ("program", head.program.clone()),
            ("program_sha256", head.program_sha256.clone()),
            ("machine", head.machine.clone()),
            ("control", head.control.clone()),
        ];
        let of = head.columns();
        SampleColumns {
            schema: schema_of(SAMPLE_SCHEMA, about, &columns, &more),
            values: vec![Vec::with_capacity(BATCH); of.len()],
            columns: of,
            lines: Vec::with_capacity(BATCH),
            head: head.clone(),
        }
    }

    /// Takes a setpoint of a block on this line.
    pub fn sample(&mut self, sample: &MotionSample, line: u32) {
        for (values, column) in self.values.iter_mut().zip(&self.columns) {
            values.push(column.of(sample));
        }
        self.lines.push(line);
    }
}

impl RowBatcher for SampleColumns {
    fn rows(&self) -> usize {
        self.lines.len()
    }

    fn schema(&self) -> &SchemaRef {
        &self.schema
    }

    fn json_header(&self) -> Option<Vec<u8>> {
        let mut line = Vec::new();
        let mut header = JsonObject::open(&mut line);
        header.word("schema", SAMPLE_SCHEMA);
        for (name, unit) in [("length_unit", "mm"), ("angle_unit", "deg"), ("time_unit", "s")] {
            header.word(name, unit);
        }
        header.number("period_s", self.head.period_s);
        header.text("machine", &self.head.machine);
        header.text("control", &self.head.control);
        header.text("program", &self.head.program);
        header.word("program_sha256", &self.head.program_sha256);
        header.close();
        line.push(b'\n');
        Some(line)
    }

    fn take(&mut self) -> Result<RecordBatch, ArrowError> {
        let mut arrays: Vec<ArrayRef> = Vec::with_capacity(self.values.len() + 1);
        for values in &mut self.values {
            let fresh = Vec::with_capacity(BATCH);
            arrays.push(Arc::new(Float64Array::from(std::mem::replace(values, fresh))));
        }
        let lines = std::mem::replace(&mut self.lines, Vec::with_capacity(BATCH));
        arrays.push(Arc::new(UInt32Array::from(lines)));
        RecordBatch::try_new(self.schema.clone(), arrays)
    }
}

/// Writes setpoints one after the other.
pub type SampleWriter<W> = ColumnFile<W, SampleColumns>;

impl<W: Write + Send + 'static> SampleWriter<W> {
    /// Writes a setpoint of a block on this line.
    ///
    /// # Errors
    /// Those of the output.
    pub fn sample(&mut self, sample: &MotionSample, line: u32) -> io::Result<()> {
        self.put(|rows| rows.sample(sample, line))
    }
}

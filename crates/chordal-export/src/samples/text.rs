//! Setpoints as CSV and as JSON lines.

use std::io::{self, Write};

use chordal::motion::MotionSample;

use crate::json::JsonObject;
use crate::number::{push_finite, push_integer, push_number};
use crate::setpoints::{SAMPLE_SCHEMA, SampleHead, SetpointColumn};

/// Bytes that are gathered before they are written.
const BLOCK: usize = 1 << 16;

#[derive(Debug)]
pub(super) struct TextRows<W> {
    out: W,
    rows: Vec<u8>,
    columns: Vec<SetpointColumn>,
    /// What stands before the value of each column in a JSON object; empty for CSV.
    names: Vec<Vec<u8>>,
}

impl<W: Write> TextRows<W> {
    pub fn csv(out: W, head: &SampleHead) -> io::Result<TextRows<W>> {
        let columns = head.columns();
        let mut rows = Vec::with_capacity(2 * BLOCK);
        for column in &columns {
            rows.extend_from_slice(column.name.as_bytes());
            rows.push(b',');
        }
        rows.extend_from_slice(b"line\n");
        Ok(TextRows { out, rows, columns, names: Vec::new() })
    }

    pub fn jsonl(out: W, head: &SampleHead) -> io::Result<TextRows<W>> {
        let columns = head.columns();
        let mut rows = Vec::with_capacity(2 * BLOCK);
        let mut header = JsonObject::open(&mut rows);
        header.word("schema", SAMPLE_SCHEMA);
        for (name, unit) in [("length_unit", "mm"), ("angle_unit", "deg"), ("time_unit", "s")] {
            header.word(name, unit);
        }
        header.number("period_s", head.period_s);
        header.text("machine", &head.machine);
        header.text("control", &head.control);
        header.text("program", &head.program);
        header.word("program_sha256", &head.program_sha256);
        header.close();
        rows.push(b'\n');
        let name = |(index, column): (usize, &SetpointColumn)| {
            format!("{}\"{}\":", if index == 0 { '{' } else { ',' }, column.name).into_bytes()
        };
        let names = columns.iter().enumerate().map(name).collect();
        Ok(TextRows { out, rows, columns, names })
    }

    pub fn sample(&mut self, sample: &MotionSample, line: u32) -> io::Result<()> {
        if self.names.is_empty() {
            for column in &self.columns {
                push_finite(&mut self.rows, column.of(sample));
                self.rows.push(b',');
            }
            push_integer(&mut self.rows, line.into());
        } else {
            for (column, name) in self.columns.iter().zip(&self.names) {
                self.rows.extend_from_slice(name);
                push_number(&mut self.rows, column.of(sample));
            }
            self.rows.extend_from_slice(b",\"line\":");
            push_integer(&mut self.rows, line.into());
            self.rows.push(b'}');
        }
        self.rows.push(b'\n');
        if self.rows.len() < BLOCK { Ok(()) } else { self.write() }
    }

    pub fn finish(mut self) -> io::Result<W> {
        self.write()?;
        Ok(self.out)
    }

    fn write(&mut self) -> io::Result<()> {
        self.out.write_all(&self.rows)?;
        self.rows.clear();
        Ok(())
    }
}

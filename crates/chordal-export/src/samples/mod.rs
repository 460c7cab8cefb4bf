//! Setpoints, written: time, place, velocity and acceleration of the axes at a fixed period.
//!
//! | format | is | here |
//! |---|---|---|
//! | CSV, JSON lines | text, nine decimals | `text.rs` |
//! | Parquet, Arrow | columns of doubles, for analysis | [`crate::columns`] |
//!
//! All formats have the same columns, those of [`crate::setpoints`].

mod text;

use std::io::{self, Write};

use chordal::motion::Sample;

use crate::columns::{ColumnFile, ColumnFormat, SampleColumns};
use crate::setpoints::SampleHead;
use text::TextRows;

/// How setpoints are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SampleFormat {
    /// Comma-separated, a row each.
    Csv,
    /// JSON lines: a header, then an object each.
    Jsonl,
    /// Apache Parquet.
    Parquet,
    /// The Arrow IPC file, also called Feather.
    Arrow,
}

/// Writes setpoints one after the other, and holds no more of them than a group of rows.
#[derive(Debug)]
pub struct SampleWriter<W: Write + Send + 'static>(Kind<W>);

#[derive(Debug)]
enum Kind<W: Write + Send + 'static> {
    Text(TextRows<W>),
    Columns(Box<ColumnFile<W, SampleColumns>>),
}

impl<W: Write + Send + 'static> SampleWriter<W> {
    /// Writes what stands before the setpoints.
    ///
    /// # Errors
    /// Those of the output.
    pub fn new(out: W, format: SampleFormat, head: &SampleHead) -> io::Result<SampleWriter<W>> {
        let columns = match format {
            SampleFormat::Csv => return Ok(SampleWriter(Kind::Text(TextRows::csv(out, head)?))),
            SampleFormat::Jsonl => {
                return Ok(SampleWriter(Kind::Text(TextRows::jsonl(out, head)?)));
            }
            SampleFormat::Parquet => ColumnFormat::Parquet,
            SampleFormat::Arrow => ColumnFormat::Arrow,
        };
        let file = ColumnFile::new(out, columns, SampleColumns::new(head))?;
        Ok(SampleWriter(Kind::Columns(Box::new(file))))
    }

    /// Writes a setpoint of a block on this line.
    ///
    /// # Errors
    /// Those of the output.
    pub fn sample(&mut self, sample: &Sample, line: u32) -> io::Result<()> {
        match &mut self.0 {
            Kind::Text(out) => out.sample(sample, line),
            Kind::Columns(out) => out.put(|rows| rows.sample(sample, line)),
        }
    }

    /// Writes what is left and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(self) -> io::Result<W> {
        let mut out = match self.0 {
            Kind::Text(out) => out.finish(),
            Kind::Columns(out) => out.finish(),
        }?;
        out.flush()?;
        Ok(out)
    }
}

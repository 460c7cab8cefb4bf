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

use chordal::motion::MotionSample;

#[cfg(feature = "files")]
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
    #[cfg(feature = "files")]
    Parquet,
    /// The Arrow IPC file, also called Feather.
    #[cfg(feature = "files")]
    Arrow,
}

/// Writes setpoints one after the other, and holds no more of them than a group of rows.
#[derive(Debug)]
pub struct SampleWriter<W: Write + Send + 'static>(SampleFileFormat<W>);

#[derive(Debug)]
enum SampleFileFormat<W: Write + Send + 'static> {
    Text(TextRows<W>),
    #[cfg(feature = "files")]
    Columns(Box<ColumnFile<W, SampleColumns>>),
}

#[cfg(feature = "files")]
impl<W: Write + Send + 'static> SampleFileFormat<W> {
    fn columns(out: W, format: ColumnFormat, head: &SampleHead) -> io::Result<SampleFileFormat<W>> {
        let file = ColumnFile::new(out, format, SampleColumns::new(head))?;
        Ok(SampleFileFormat::Columns(Box::new(file)))
    }
}

impl<W: Write + Send + 'static> SampleWriter<W> {
    /// Writes what stands before the setpoints.
    ///
    /// # Errors
    /// Those of the output.
    pub fn new(out: W, format: SampleFormat, head: &SampleHead) -> io::Result<SampleWriter<W>> {
        Ok(SampleWriter(match format {
            SampleFormat::Csv => SampleFileFormat::Text(TextRows::csv(out, head)?),
            SampleFormat::Jsonl => SampleFileFormat::Text(TextRows::jsonl(out, head)?),
            #[cfg(feature = "files")]
            SampleFormat::Parquet => SampleFileFormat::columns(out, ColumnFormat::Parquet, head)?,
            #[cfg(feature = "files")]
            SampleFormat::Arrow => SampleFileFormat::columns(out, ColumnFormat::Arrow, head)?,
        }))
    }

    /// Writes a setpoint of a block on this line.
    ///
    /// # Errors
    /// Those of the output.
    pub fn sample(&mut self, sample: &MotionSample, line: u32) -> io::Result<()> {
        match &mut self.0 {
            SampleFileFormat::Text(out) => out.sample(sample, line),
            #[cfg(feature = "files")]
            SampleFileFormat::Columns(out) => out.put(|rows| rows.sample(sample, line)),
        }
    }

    /// Writes what is left and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(self) -> io::Result<W> {
        let mut out = match self.0 {
            SampleFileFormat::Text(out) => out.finish(),
            #[cfg(feature = "files")]
            SampleFileFormat::Columns(out) => out.finish(),
        }?;
        out.flush()?;
        Ok(out)
    }
}

//! Chords: the path as straight pieces within a tolerance.

use std::io::{self, Write};

use chordal::geometry::{Placement, Vec3};
use chordal::{Job, Segment};

use crate::columns::{ChordColumns, ColumnFile, chords_of, kind_word};
use crate::format::OutputFormat;
use crate::json::JsonObject;

/// Writes the path as chords, one row each. Lines and rapids are one chord without error. A coordinate that is not known
/// is blank or null.
#[derive(Debug)]
pub enum ChordWriter<'a, W> {
    /// JSON lines.
    Jsonl(ChordJsonLines<W>),
    /// Tables, of text or of columns.
    Table(Box<ColumnFile<W, ChordColumns<'a>>>),
}

impl<'a, W: Write + Send + 'static> ChordWriter<'a, W> {
    /// For chords within a tolerance.
    ///
    /// # Errors
    /// Those of the output, a tolerance that is not above zero, and a format that has no chords.
    pub fn new(
        out: W,
        format: OutputFormat,
        job: &'a Job<'a>,
        (tolerance_mm, placement): (f64, Placement),
    ) -> io::Result<Self> {
        if !(tolerance_mm > 0.0 && tolerance_mm.is_finite()) {
            let text = format!("a chord tolerance of {tolerance_mm} mm is not above zero");
            return Err(io::Error::new(io::ErrorKind::InvalidInput, text));
        }
        if format == OutputFormat::Jsonl {
            return ChordJsonLines::new(out, tolerance_mm, placement).map(Self::Jsonl);
        }
        let rows = ChordColumns::new(job, tolerance_mm, placement);
        Ok(Self::Table(Box::new(ColumnFile::new(out, format, rows)?)))
    }

    /// Writes the chords of a segment.
    ///
    /// # Errors
    /// Those of the output, and [`io::ErrorKind::InvalidData`] for a curve that cannot be cut
    /// into chords.
    pub fn segment(&mut self, segment: &Segment) -> io::Result<()> {
        match self {
            ChordWriter::Jsonl(out) => out.segment(segment),
            ChordWriter::Table(out) => out.segment(segment),
        }
    }

    /// Writes what is left and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(self) -> io::Result<W> {
        match self {
            ChordWriter::Jsonl(mut out) => out.out.flush().map(|()| out.out),
            ChordWriter::Table(out) => out.finish(),
        }
    }
}

/// Chords as JSON lines, schema `chordal.chords/1`, after a header.
#[derive(Debug)]
pub struct ChordJsonLines<W> {
    out: W,
    row: Vec<u8>,
    tolerance_mm: f64,
    placement: Placement,
}

impl<W: Write> ChordJsonLines<W> {
    fn new(out: W, tolerance_mm: f64, placement: Placement) -> io::Result<Self> {
        let mut writer = Self { out, row: Vec::with_capacity(256), tolerance_mm, placement };
        let mut header = JsonObject::open(&mut writer.row);
        header.word("schema", "chordal.chords/1");
        header.word("length_unit", "mm");
        header.number("tolerance_mm", tolerance_mm);
        header.word("placement", placement.as_str());
        header.close();
        writer.end_row()?;
        Ok(writer)
    }

    fn segment(&mut self, segment: &Segment) -> io::Result<()> {
        let (chords, error_mm) = chords_of(segment, self.tolerance_mm, self.placement)
            .map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))?;
        for [from, to] in chords {
            let mut object = JsonObject::open(&mut self.row);
            object.integer("line", segment.origin.line.into());
            object.word("kind", kind_word(segment.kind));
            object.object("from", |inner| write_point(inner, from));
            object.object("to", |inner| write_point(inner, to));
            object.number("length_mm", (to - from).length());
            object.number("error_mm", error_mm);
            object.close();
            self.end_row()?;
        }
        Ok(())
    }

    fn end_row(&mut self) -> io::Result<()> {
        self.row.push(b'\n');
        self.out.write_all(&self.row)?;
        self.row.clear();
        Ok(())
    }
}

fn write_point(object: &mut JsonObject, point: Vec3) {
    object.number("X", point.x);
    object.number("Y", point.y);
    object.number("Z", point.z);
}

//! Chords as columns.

use std::io::{self, Write};

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};
use chordal::control::AxisMask;
use chordal::geometry::{ChordError, Chords, ParamCurve, Placement, Vec3};
use chordal::{Job, Segment, SegmentKind};

use super::cells::{FileColumn, IntegerColumn, NumberColumn, WordColumn};
use super::field::{CellType, Column, places, schema};
use super::file::ColumnFile;
use super::path::{KINDS, kind_key};
use super::rows::RowBatcher;

/// Name and version of the columns of chords.
pub const CHORD_COLUMNS: &str = "chordal.chord-columns/1";

/// Gathers the chords of a path, one row each. Lines and rapids are one chord without error.
#[derive(Debug)]
pub struct ChordColumns<'a> {
    schema: SchemaRef,
    tolerance_mm: f64,
    placement: Placement,
    rows: usize,
    line: IntegerColumn,
    file: FileColumn<'a>,
    kind: WordColumn,
    tool: IntegerColumn,
    numbers: [NumberColumn; 8],
}

pub(super) fn columns() -> Vec<Column> {
    let mut columns = vec![
        Column::new("line", CellType::Integer, "", "line of the block, from 1"),
        Column::new("file", CellType::File, "", "the text that the block is in"),
        Column::new("kind", CellType::Word, "", "kind of move of the chord"),
        Column::new("tool", CellType::Integer, "", "the tool in the spindle"),
    ];
    let places = |end, meaning| places(AxisMask::LINEAR, end, CellType::NumberOrGap, meaning);
    columns.extend(places("from", "start of the chord, frame of the run, where known"));
    columns.extend(places("to", "end of the chord, frame of the run, where known"));
    columns.push(Column::new(
        "length_mm",
        CellType::NumberOrGap,
        "mm",
        "length of the chord, where known",
    ));
    let error = "largest distance of the curve from the chord";
    columns.push(Column::new("error_mm", CellType::Number, "mm", error));
    columns
}

impl<'a> ChordColumns<'a> {
    /// Columns for chords within a tolerance, mm.
    pub fn new(job: &'a Job<'a>, tolerance_mm: f64, placement: Placement) -> ChordColumns<'a> {
        let word = placement.as_str().to_string();
        let more = [("tolerance_mm", tolerance_mm.to_string()), ("placement", word)];
        ChordColumns {
            schema: schema(job, CHORD_COLUMNS, &columns(), &more),
            tolerance_mm,
            placement,
            rows: 0,
            line: IntegerColumn::new(),
            file: FileColumn::of(job),
            kind: WordColumn::new(KINDS),
            tool: IntegerColumn::new(),
            numbers: std::array::from_fn(|_| NumberColumn::new()),
        }
    }

    /// Takes the chords of a segment.
    ///
    /// # Errors
    /// A tolerance that is not above zero, and a curve that cannot be cut into chords.
    pub fn segment(&mut self, segment: &Segment) -> Result<(), ChordError> {
        let (chords, error_mm) = chords_of(segment, self.tolerance_mm, self.placement)?;
        for ends in chords {
            self.chord(segment, ends, error_mm);
        }
        Ok(())
    }

    fn chord(&mut self, segment: &Segment, [from, to]: [Vec3; 2], error_mm: f64) {
        let [a, b] = [from, to].map(|point| point.to_array());
        let length = (to - from).length();
        let values = [a[0], a[1], a[2], b[0], b[1], b[2], length, error_mm];
        for (column, value) in self.numbers.iter_mut().zip(values) {
            column.put(self.rows, value);
        }
        self.line.put(self.rows, segment.origin.line);
        self.file.push(segment.origin.span.file);
        self.kind.put(self.rows, kind_key(segment.kind));
        self.tool.put(self.rows, segment.tool);
        self.rows += 1;
    }
}

impl RowBatcher for ChordColumns<'_> {
    fn rows(&self) -> usize {
        self.rows
    }

    fn schema(&self) -> &SchemaRef {
        &self.schema
    }

    fn text_columns(&self) -> Vec<String> {
        let all = columns().into_iter().map(|column| column.name);
        all.filter(|name| !["file", "tool"].contains(&name.as_str())).collect()
    }

    fn take(&mut self) -> Result<RecordBatch, ArrowError> {
        let rows = std::mem::take(&mut self.rows);
        let mut arrays = vec![
            self.line.take(rows),
            self.file.take()?,
            self.kind.take(rows)?,
            self.tool.take(rows),
        ];
        arrays.extend(self.numbers.iter_mut().map(|column| column.take(rows)));
        RecordBatch::try_new(self.schema.clone(), arrays)
    }
}

impl<W: Write + Send + 'static> ColumnFile<W, ChordColumns<'_>> {
    /// Writes the chords of a segment; they are emitted as they come, since one arc may have
    /// a million.
    ///
    /// # Errors
    /// Those of the output, and [`io::ErrorKind::InvalidData`] for a curve that cannot be cut
    /// into chords.
    pub fn segment(&mut self, segment: &Segment) -> io::Result<()> {
        let rows = self.gathered();
        let chords = chords_of(segment, rows.tolerance_mm, rows.placement);
        let (mut chords, error_mm) =
            chords.map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))?;
        chords.try_for_each(|ends| self.put(|rows| rows.chord(segment, ends, error_mm)))
    }
}

/// The ends of the chords of a segment, and how far these are from it, mm.
pub(crate) fn chords_of(
    segment: &Segment,
    tolerance_mm: f64,
    placement: Placement,
) -> Result<(impl Iterator<Item = [Vec3; 2]> + use<>, f64), ChordError> {
    let chords = segment.curve.chords(tolerance_mm, placement)?;
    let straight = matches!(segment.kind, SegmentKind::Rapid | SegmentKind::Line);
    let error_mm = if straight { 0.0 } else { error_mm(&chords, placement, tolerance_mm) };
    Ok((known_chords(segment, chords), error_mm))
}

/// The ends of the chords of a segment. A coordinate that is not known is NaN; an axis that the program does not name is
/// at zero.
fn known_chords(segment: &Segment, corners: Chords) -> impl Iterator<Item = [Vec3; 2]> + use<> {
    let [start, end] = segment.places().map(|axes| axes.or(segment.not_named.all()));
    let mut corners = corners.peekable();
    let mut from = corners.next().map_or(Vec3::ZERO, |corner| only(corner, start));
    std::iter::from_fn(move || {
        let corner = corners.next()?;
        let is_last = corners.peek().is_none();
        let to = only(corner, if is_last { end } else { start.and(end) });
        Some([std::mem::replace(&mut from, to), to])
    })
}

/// A point with the coordinates of these axes alone.
fn only(point: Vec3, known: AxisMask) -> Vec3 {
    if known.covers(AxisMask::LINEAR) {
        return point;
    }
    let place = point.to_array();
    let of = |axis: usize| if known.has(axis) { place[axis] } else { f64::NAN };
    Vec3::new(of(0), of(1), of(2))
}

/// How far chords are from their curve: by no more than the tolerance, or what a control makes of it.
fn error_mm(chords: &Chords, placement: Placement, tolerance_mm: f64) -> f64 {
    match placement {
        Placement::Inscribed | Placement::Balanced => tolerance_mm,
        Placement::RoundedDown => chords.sagitta().unwrap_or(tolerance_mm),
    }
}

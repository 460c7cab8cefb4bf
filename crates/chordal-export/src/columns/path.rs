//! The exact path as columns: enough to make every curve again.

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};
use chordal::control::AxisMask;
use chordal::geometry::{Curve, ParamCurve, Vec3};
use chordal::{Job, Segment, SegmentKind};

use super::cells::{FileColumn, FlagColumn, IntegerColumn, NumberColumn, WordColumn};
use super::field::{CellType, Column, axes_of, of_axis, places, schema};
use super::rows::RowBatcher;

/// Name and version of the columns of the exact path.
pub const PATH_COLUMNS: &str = "chordal.path-columns/1";

pub(super) const KINDS: &[&str] = &["rapid", "line", "arc", "spiral", "spline"];

/// The word of a piece of path.
pub(crate) fn kind_word(kind: SegmentKind) -> &'static str {
    KINDS[kind_key(kind)]
}

/// Its place among them.
pub(super) fn kind_key(kind: SegmentKind) -> usize {
    match kind {
        SegmentKind::Rapid => 0,
        SegmentKind::Line => 1,
        SegmentKind::Arc => 2,
        SegmentKind::Spiral => 3,
        SegmentKind::Spline => 4,
    }
}

/// Gathers the pieces of the exact path, one row each.
#[derive(Debug)]
pub struct PathColumns<'a> {
    schema: SchemaRef,
    axes: Vec<usize>,
    rows: usize,
    line: IntegerColumn,
    file: FileColumn<'a>,
    kind: WordColumn,
    tool: IntegerColumn,
    known: FlagColumn,
    from: Vec<NumberColumn>,
    to: Vec<NumberColumn>,
    center: [NumberColumn; 3],
    normal: [NumberColumn; 3],
    radii: [NumberColumn; 2],
    sweep: NumberColumn,
    rise: NumberColumn,
    length: NumberColumn,
    seconds: NumberColumn,
}

pub(super) fn columns(axes: AxisMask) -> Vec<Column> {
    use CellType::{File, Flag, Integer, Number, NumberOrGap, Word};
    let column = Column::new;
    let mut columns = vec![
        column("line", Integer, "", "line of the block, from 1"),
        column("file", File, "", "the text that the block is in"),
        column("kind", Word, "", "kind of the piece"),
        column("tool", Integer, "", "the tool in the spindle"),
        column("known", Flag, "", "both ends have a known place in the frame of the run"),
    ];
    columns.extend(places(axes, "from", Number, "start of the piece, frame of the run"));
    columns.extend(places(axes, "to", Number, "end of the piece, frame of the run"));
    for letter in ["x", "y", "z"] {
        let name = format!("{letter}_center_mm");
        columns.push(column(&name, NumberOrGap, "mm", "centre at the height of the start"));
    }
    for letter in ["x", "y", "z"] {
        let name = format!("{letter}_axis");
        columns.push(column(&name, NumberOrGap, "", "unit vector of the axis of rotation"));
    }
    columns.extend([
        column("radius_from_mm", NumberOrGap, "mm", "radius at the start"),
        column("radius_to_mm", NumberOrGap, "mm", "radius at the end"),
        column("sweep_deg", NumberOrGap, "deg", "angle about the axis, positive counter-clockwise"),
        column("rise_mm", NumberOrGap, "mm", "movement along the axis"),
        column("length_mm", Number, "mm", "length of the curve"),
        column("seconds", NumberOrGap, "s", "time without acceleration, if the feed is known"),
    ]);
    columns
}

/// What a curve that turns has in addition to its ends.
struct TurnFields {
    center: Vec3,
    normal: Vec3,
    radii: [f64; 2],
    sweep: f64,
    rise: f64,
}

fn turn_of(curve: &Curve) -> Option<TurnFields> {
    match curve {
        Curve::Line(_) | Curve::Spline(_) => None,
        Curve::Arc(arc) => Some(TurnFields {
            center: arc.center,
            normal: arc.w,
            radii: [arc.radius; 2],
            sweep: arc.sweep,
            rise: arc.rise,
        }),
        Curve::Spiral(spiral) => Some(TurnFields {
            center: spiral.center,
            normal: spiral.w,
            radii: [spiral.radius_start, spiral.radius_end],
            sweep: spiral.sweep,
            rise: spiral.rise,
        }),
    }
}

impl<'a> PathColumns<'a> {
    /// Columns for the path of a job.
    pub fn new(job: &'a Job<'a>) -> PathColumns<'a> {
        let axes = axes_of(job);
        let listed: Vec<usize> = axes.iter().map(|axis| axis as usize).collect();
        let numbers = || listed.iter().map(|_| NumberColumn::new()).collect::<Vec<_>>();
        let three = || std::array::from_fn(|_| NumberColumn::new());
        PathColumns {
            schema: schema(job, PATH_COLUMNS, &columns(axes), &[]),
            rows: 0,
            line: IntegerColumn::new(),
            file: FileColumn::of(job),
            kind: WordColumn::new(KINDS),
            tool: IntegerColumn::new(),
            known: FlagColumn::new(),
            from: numbers(),
            to: numbers(),
            center: three(),
            normal: three(),
            radii: [NumberColumn::new(), NumberColumn::new()],
            sweep: NumberColumn::new(),
            rise: NumberColumn::new(),
            length: NumberColumn::new(),
            seconds: NumberColumn::new(),
            axes: listed,
        }
    }

    /// Takes a piece of path; one with a coordinate that is no number is left out.
    pub fn segment(&mut self, segment: &Segment) {
        let row = self.rows;
        let (start, end) = (segment.curve.start().to_array(), segment.curve.end().to_array());
        if !(start.iter().chain(&end).all(|v| v.is_finite()) && segment.length_mm.is_finite()) {
            return;
        }
        let put = |columns: &mut [NumberColumn], linear: [f64; 3], rotary: [f64; 3]| {
            for (column, axis) in columns.iter_mut().zip(&self.axes) {
                let value = if *axis < 3 { linear[*axis] } else { rotary[*axis - 3] };
                column.put(row, of_axis(*axis, value));
            }
        };
        put(&mut self.from, start, segment.rotary_from);
        put(&mut self.to, end, segment.rotary_to);
        if let Some(turn) = turn_of(&segment.curve) {
            for (column, value) in self.center.iter_mut().zip(turn.center.to_array()) {
                column.put(row, value);
            }
            for (column, value) in self.normal.iter_mut().zip(turn.normal.to_array()) {
                column.put(row, value);
            }
            for (column, value) in self.radii.iter_mut().zip(turn.radii) {
                column.put(row, value);
            }
            self.sweep.put(row, turn.sweep.to_degrees());
            self.rise.put(row, turn.rise);
        }
        self.length.put(row, segment.length_mm);
        if segment.duration_s > 0.0 {
            self.seconds.put(row, segment.duration_s);
        }
        self.line.put(row, segment.origin.line);
        self.file.push(segment.origin.span.file);
        self.kind.put(row, kind_key(segment.kind));
        self.tool.put(row, segment.tool);
        self.known.put(row, segment.known && segment.unrelated_zero.is_none());
        self.rows += 1;
    }
}

impl RowBatcher for PathColumns<'_> {
    fn rows(&self) -> usize {
        self.rows
    }

    fn schema(&self) -> &SchemaRef {
        &self.schema
    }

    fn take(&mut self) -> Result<RecordBatch, ArrowError> {
        let rows = std::mem::take(&mut self.rows);
        let mut arrays = vec![
            self.line.take(rows),
            self.file.take()?,
            self.kind.take(rows)?,
            self.tool.take(rows),
            self.known.take(rows),
        ];
        let groups = [
            &mut self.from[..],
            &mut self.to[..],
            &mut self.center[..],
            &mut self.normal[..],
            &mut self.radii[..],
        ];
        for column in groups.into_iter().flatten() {
            arrays.push(column.take(rows));
        }
        for column in [&mut self.sweep, &mut self.rise, &mut self.length, &mut self.seconds] {
            arrays.push(column.take(rows));
        }
        RecordBatch::try_new(self.schema.clone(), arrays)
    }
}

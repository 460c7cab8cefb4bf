//! Chords: the path as straight pieces within a tolerance.

use std::io::{self, Write};

use chordal::control::AxisMask;
use chordal::geometry::{Chords, ParamCurve, Placement, Vec3};
use chordal::{Segment, SegmentKind};

use crate::json::JsonObject;
use crate::number::{push_finite, push_integer};

/// Writes the path as chords, one row each, as CSV or as JSON lines (schema
/// `chordal.chords/1`). Lines and rapids are one chord without error. A coordinate that is not known is blank or null.
#[derive(Debug)]
pub struct ChordWriter<W> {
    out: W,
    row: Vec<u8>,
    json: bool,
    tolerance_mm: f64,
    placement: Placement,
}

impl<W: Write> ChordWriter<W> {
    /// Chords as CSV.
    ///
    /// # Errors
    /// Those of the output, and a tolerance that is not above zero.
    pub fn csv(out: W, tolerance_mm: f64, placement: Placement) -> io::Result<Self> {
        let mut writer = Self::open(out, tolerance_mm, placement, false)?;
        writer.row.extend_from_slice(
            b"line,kind,x_from_mm,y_from_mm,z_from_mm,x_to_mm,y_to_mm,z_to_mm,length_mm,error_mm",
        );
        writer.end_row()?;
        Ok(writer)
    }

    /// Chords as JSON lines, after a header.
    ///
    /// # Errors
    /// Those of the output, and a tolerance that is not above zero.
    pub fn jsonl(out: W, tolerance_mm: f64, placement: Placement) -> io::Result<Self> {
        let mut writer = Self::open(out, tolerance_mm, placement, true)?;
        let mut header = JsonObject::open(&mut writer.row);
        header.word("schema", "chordal.chords/1");
        header.word("length_unit", "mm");
        header.number("tolerance_mm", tolerance_mm);
        header.word("placement", placement.as_str());
        header.close();
        writer.end_row()?;
        Ok(writer)
    }

    /// Writes the chords of a segment.
    ///
    /// # Errors
    /// Those of the output, and [`io::ErrorKind::InvalidData`] for a curve that cannot be cut
    /// into chords.
    pub fn segment(&mut self, segment: &Segment) -> io::Result<()> {
        let curve = &segment.curve;
        let chords = curve
            .chords(self.tolerance_mm, self.placement)
            .map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))?;
        let straight = matches!(segment.kind, SegmentKind::Rapid | SegmentKind::Line);
        let error_mm =
            if straight { 0.0 } else { error_mm(&chords, self.placement, self.tolerance_mm) };
        for [from, to] in known_chords(segment, chords) {
            self.chord(segment, from, to, error_mm)?;
        }
        Ok(())
    }

    /// Writes what is left and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }

    fn open(out: W, tolerance_mm: f64, placement: Placement, json: bool) -> io::Result<Self> {
        if !(tolerance_mm > 0.0 && tolerance_mm.is_finite()) {
            let text = format!("a chord tolerance of {tolerance_mm} mm is not above zero");
            return Err(io::Error::new(io::ErrorKind::InvalidInput, text));
        }
        Ok(Self { out, row: Vec::with_capacity(256), json, tolerance_mm, placement })
    }

    fn chord(&mut self, segment: &Segment, from: Vec3, to: Vec3, error_mm: f64) -> io::Result<()> {
        let line = segment.origin.line;
        let kind = kind_word(segment.kind);
        let length = (to - from).length();
        if self.json {
            let mut object = JsonObject::open(&mut self.row);
            object.integer("line", line.into());
            object.word("kind", kind);
            object.object("from", |inner| write_point(inner, from));
            object.object("to", |inner| write_point(inner, to));
            object.number("length_mm", length);
            object.number("error_mm", error_mm);
            object.close();
        } else {
            push_integer(&mut self.row, line.into());
            self.row.push(b',');
            self.row.extend_from_slice(kind.as_bytes());
            for value in [from.x, from.y, from.z, to.x, to.y, to.z, length, error_mm] {
                self.row.push(b',');
                push_finite(&mut self.row, value);
            }
        }
        self.end_row()
    }

    fn end_row(&mut self) -> io::Result<()> {
        self.row.push(b'\n');
        self.out.write_all(&self.row)?;
        self.row.clear();
        Ok(())
    }
}

/// The ends of the chords of a segment. A coordinate that is not known is NaN; an axis that the program does not name is
/// at zero.
pub(crate) fn known_chords(
    segment: &Segment,
    corners: Chords,
) -> impl Iterator<Item = [Vec3; 2]> + use<> {
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
pub(crate) fn error_mm(chords: &Chords, placement: Placement, tolerance_mm: f64) -> f64 {
    match placement {
        Placement::Inscribed | Placement::Balanced => tolerance_mm,
        Placement::RoundedDown => chords.sagitta().unwrap_or(tolerance_mm),
    }
}

fn write_point(object: &mut JsonObject, point: Vec3) {
    object.number("X", point.x);
    object.number("Y", point.y);
    object.number("Z", point.z);
}

/// The word of a piece of path.
pub(crate) const fn kind_word(kind: SegmentKind) -> &'static str {
    match kind {
        SegmentKind::Rapid => "rapid",
        SegmentKind::Line => "line",
        SegmentKind::Arc => "arc",
        SegmentKind::Spiral => "spiral",
        SegmentKind::Spline => "spline",
    }
}

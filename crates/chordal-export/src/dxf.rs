//! The path as DXF, Release 12: what every CAD system reads.

use std::io::{self, Write};

use chordal::control::WorkNaming;
use chordal::geometry::{Arc, Chords, Curve, Line, ParamCurve, Placement, Vec3};
use chordal::path::{NotNamed, UnrelatedZero};
use chordal::{Job, Segment, SegmentKind};

use crate::number::push_finite;
use crate::omissions::{left_out_texts, not_named_texts};

/// How far the polylines of helices, spirals and splines leave the curve, mm.
const TOLERANCE_MM: f64 = 0.001;
/// Corners of one polyline at most: a curve that would need more is drawn less exactly, and a comment says how.
const MAX_CORNERS: u64 = 100_000;
/// What counts as flat, as no length and as a whole turn, mm and rad.
const NEGLIGIBLE: f64 = 1e-9;
/// AutoCAD's colours of tools: blue, red, green, magenta, cyan, orange, olive.
const COLORS: [u32; 7] = [5, 1, 3, 6, 4, 30, 54];
const GREY: u32 = 8;

const HEAD: &str = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n4\n\
    9\n$MEASUREMENT\n70\n1\n0\nENDSEC\n\
    0\nSECTION\n2\nTABLES\n\
    0\nTABLE\n2\nLTYPE\n70\n2\n\
    0\nLTYPE\n2\nCONTINUOUS\n70\n0\n3\nSolid line\n72\n65\n73\n0\n40\n0\n\
    0\nLTYPE\n2\nDASHED\n70\n0\n3\n__ __ __\n72\n65\n73\n2\n40\n3\n49\n2\n49\n-1\n\
    0\nENDTAB\n\
    0\nTABLE\n2\nLAYER\n70\n2\n\
    0\nLAYER\n2\n0\n70\n0\n62\n7\n6\nCONTINUOUS\n\
    0\nLAYER\n2\nRAPID\n70\n0\n62\n8\n6\nDASHED\n\
    0\nENDTAB\n0\nENDSEC\n\
    0\nSECTION\n2\nENTITIES\n";
const FOOT: &str = "0\nENDSEC\n0\nEOF\n";

/// Writes the path as DXF Release 12 in mm: true lines, arcs and circles, in any of the three
/// planes; helices, spirals and splines as polylines within 0.001 mm.
///
/// Rapids are on the layer `RAPID`, cuts on `TOOL_1` and so on. Layers of tools are not
/// declared ahead, because the file is written while the program runs; each entity carries
/// its colour. What is not known relative to the part is left out, and so are moves in a work offset of
/// which nobody knows how it lies to the first; an axis that the program never names is at zero. A comment
/// says each of it.
#[derive(Debug)]
pub struct DxfWriter<W> {
    out: W,
    text: Vec<u8>,
    not_named: NotNamed,
    unrelated_zeros: Vec<UnrelatedZero>,
    naming: WorkNaming,
    /// How far the polylines leave their curves at most, mm.
    tolerance_mm: f64,
}

impl<W: Write> DxfWriter<W> {
    /// Writes the header, for the path of a job.
    ///
    /// # Errors
    /// Those of the output.
    pub fn new(mut out: W, job: &Job) -> io::Result<Self> {
        out.write_all(HEAD.as_bytes())?;
        Ok(Self {
            out,
            text: Vec::with_capacity(1024),
            not_named: NotNamed::NONE,
            unrelated_zeros: Vec::new(),
            naming: job.profile().work_names,
            tolerance_mm: TOLERANCE_MM,
        })
    }

    /// Writes a segment.
    ///
    /// # Errors
    /// Those of the output, and [`io::ErrorKind::InvalidData`] for a curve that cannot be cut
    /// into chords.
    pub fn segment(&mut self, segment: &Segment) -> io::Result<()> {
        let bounds = segment.curve.bounds();
        if let Some(zero) = segment.unrelated_zero
            && !self.unrelated_zeros.contains(&zero)
        {
            self.unrelated_zeros.push(zero);
        }
        if !segment.is_drawn() || !bounds.min.is_finite() || !bounds.max.is_finite() {
            return Ok(());
        }
        self.not_named = self.not_named.or(segment.not_named);
        match &segment.curve {
            Curve::Line(line) => self.line(segment, line),
            Curve::Arc(arc) if arc.rise.abs() < NEGLIGIBLE => self.arc(segment, arc),
            curve => self.polyline(segment, curve)?,
        }
        self.flush_text()
    }

    /// Writes the end and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(mut self) -> io::Result<W> {
        let left_out = left_out_texts(&self.unrelated_zeros, self.naming);
        for stated in not_named_texts(self.not_named).into_iter().chain(left_out) {
            // A comment.
            self.group(999, &stated);
        }
        if self.tolerance_mm > TOLERANCE_MM {
            let within = self.tolerance_mm;
            self.group(
                999,
                &format!("curves of more than {MAX_CORNERS} corners are within {within:.3} mm"),
            );
        }
        self.flush_text()?;
        self.out.write_all(FOOT.as_bytes())?;
        self.out.flush()?;
        Ok(self.out)
    }

    fn flush_text(&mut self) -> io::Result<()> {
        self.out.write_all(&self.text)?;
        self.text.clear();
        Ok(())
    }

    fn line(&mut self, segment: &Segment, line: &Line) {
        if line.length() < NEGLIGIBLE {
            return;
        }
        self.entity("LINE", segment);
        self.point(0, line.start);
        self.point(1, line.end);
    }

    fn arc(&mut self, segment: &Segment, arc: &Arc) {
        if arc.radius < NEGLIGIBLE || arc.length() < NEGLIGIBLE {
            return;
        }
        let whole = arc.sweep.abs() > std::f64::consts::TAU - NEGLIGIBLE;
        self.entity(if whole { "CIRCLE" } else { "ARC" }, segment);
        let (first, second) = arbitrary_axes(arc.w);
        let center =
            Vec3::new(arc.center.dot(first), arc.center.dot(second), arc.center.dot(arc.w));
        self.point(0, center);
        self.number(40, arc.radius);
        if !whole {
            let start = arc.u.dot(second).atan2(arc.u.dot(first));
            let end = start + arc.sweep;
            // Entities turn counter-clockwise.
            let (from, to) = if arc.sweep < 0.0 { (end, start) } else { (start, end) };
            self.number(50, from.to_degrees().rem_euclid(360.0));
            self.number(51, to.to_degrees().rem_euclid(360.0));
        }
        if arc.w != Vec3::Z {
            self.number(210, arc.w.x);
            self.number(220, arc.w.y);
            self.number(230, arc.w.z);
        }
    }

    fn polyline(&mut self, segment: &Segment, curve: &Curve) -> io::Result<()> {
        let chords = self.chords_of(curve)?;
        self.entity("POLYLINE", segment);
        self.group(66, "1");
        self.point(0, Vec3::ZERO);
        self.group(70, "8");
        for corner in chords {
            self.entity("VERTEX", segment);
            self.point(0, corner);
            self.group(70, "32");
            self.flush_text()?;
        }
        self.entity("SEQEND", segment);
        Ok(())
    }

    /// The chords of a curve, no more than a polyline may have.
    fn chords_of(&mut self, curve: &Curve) -> io::Result<Chords> {
        let mut tolerance_mm = TOLERANCE_MM;
        loop {
            let chords = curve
                .chords(tolerance_mm, Placement::Inscribed)
                .map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))?;
            let more = chords.chord_count() as f64 / MAX_CORNERS as f64;
            if more <= 1.0 {
                self.tolerance_mm = self.tolerance_mm.max(tolerance_mm);
                return Ok(chords);
            }
            // A chord leaves its curve by the square of its length.
            tolerance_mm *= 1.1 * more * more;
        }
    }

    /// The head of an entity: its layer, colour and line type.
    fn entity(&mut self, name: &str, segment: &Segment) {
        self.group(0, name);
        if segment.kind == SegmentKind::Rapid {
            self.group(8, "RAPID");
            self.group(6, "DASHED");
            self.group(62, &GREY.to_string());
        } else {
            self.group(8, &format!("TOOL_{}", segment.tool));
            let color = COLORS[segment.tool.saturating_sub(1) as usize % COLORS.len()];
            self.group(62, &color.to_string());
        }
    }

    fn group(&mut self, code: u32, value: &str) {
        self.text.extend_from_slice(format!("{code}\n{value}\n").as_bytes());
    }

    fn number(&mut self, code: u32, value: f64) {
        self.text.extend_from_slice(format!("{code}\n").as_bytes());
        push_finite(&mut self.text, value);
        self.text.push(b'\n');
    }

    fn point(&mut self, index: u32, point: Vec3) {
        self.number(10 + index, point.x);
        self.number(20 + index, point.y);
        self.number(30 + index, point.z);
    }
}

/// The two axes of an entity's plane, which DXF derives from its normal.
fn arbitrary_axes(normal: Vec3) -> (Vec3, Vec3) {
    const TURN_TOLERANCE: f64 = 1.0 / 64.0;
    let near_z = normal.x.abs() < TURN_TOLERANCE && normal.y.abs() < TURN_TOLERANCE;
    let aside = if near_z { Vec3::Y } else { Vec3::Z };
    let first = aside.cross(normal).normalized().unwrap_or(Vec3::X);
    (first, normal.cross(first))
}

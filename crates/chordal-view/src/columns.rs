//! A path as columns.
//!
//! One row a piece of path, its two ends as single-precision offsets from a double-precision
//! origin: that is what a graphics card takes, as it is. Arcs, helices, spirals and cones have
//! their exact record as well, so that the page can draw them as fine as its zoom needs without
//! another request; it needs no rule of any control for that. Spans of splines have points along them,
//! at even distances.

use chordal::geometry::{Curve, ParamCurve, SplinePiece, Transform, Vec3};
use chordal::{Job, Segment, SegmentKind};
use serde_json::{Value, json};

use crate::frame::ColumnFrame;
use crate::part_path::{AngleRange, PartKinematics};

/// The tool moves at rapid speed.
const RAPID_KIND: u8 = 0;
/// Both ends have a place in the frame of the run, along every axis that the program names; others cannot be drawn.
const KNOWN_FLAG: u8 = 0x10;
/// Compensation made it.
const INSERTED_FLAG: u8 = 0x20;
/// A canned cycle made it.
const CYCLE_FLAG: u8 = 0x40;

/// The bits of X, Y and Z that are known at the end, above those that are at the start.
const END_AXES_SHIFT: u8 = 3;

/// Numbers of an arc's record: centre, towards the start, axis, both radii, sweep (rad), rise (mm).
const ARC_NUMBERS: usize = 13;

/// How far the straight pieces between the points of a spline are from it at most, mm: below what a screen
/// shows of a part.
const SPLINE_TOLERANCE_MM: f64 = 0.001;
/// Most pieces of a span of a spline.
const MAX_SPLINE_PIECES: f64 = 4096.0;

/// Rows that are gathered.
#[derive(Debug, Default)]
pub struct PathRows {
    /// Taken off all places, mm: that of the first known place.
    origin: Option<Vec3>,
    /// What the rotary axes do, where that is known.
    kinematics: Option<PartKinematics>,
    /// Both ends of each row, on the part.
    points: Vec<f32>,
    /// The same as it is programmed; sent where the part turns.
    programmed: Vec<f32>,
    kind: Vec<u8>,
    /// Which of X, Y and Z have a known place at both ends of each row.
    known: Vec<u8>,
    tool: Vec<u32>,
    file: Vec<u8>,
    line: Vec<u32>,
    feed: Vec<f32>,
    /// S of each row, where it may be the power of a laser.
    power: Vec<f32>,
    has_power: bool,
    arc_rows: Vec<u32>,
    arcs: Vec<f32>,
    /// Rows that are splines, or that a turning part bends.
    curve_rows: Vec<u32>,
    /// How many points each of them has.
    curve_counts: Vec<u32>,
    curve_points: Vec<f32>,
    /// A, B and C at both ends of each row, rad; sent where one of them is not zero.
    turns: Vec<f32>,
}

impl PathRows {
    /// Rows of a job, with S of each row where it may be the power of a laser.
    pub fn of(job: &Job) -> PathRows {
        let has_power = job.control().parameters.rules.spindle_by_hand;
        PathRows { has_power, ..PathRows::without_power(job) }
    }

    /// Rows of a job, without S.
    pub fn without_power(job: &Job) -> PathRows {
        let kinematics = PartKinematics::of(&job.machine().rotary);
        PathRows { kinematics, ..PathRows::default() }
    }

    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.kind.len()
    }

    pub fn push(&mut self, segment: &Segment, inserted: bool) {
        let (start, end) = (segment.curve.start(), segment.curve.end());
        let origin = match self.origin {
            Some(origin) => origin,
            None if segment.is_drawn() => *self.origin.insert(end),
            None => Vec3::ZERO,
        };
        let near = |point: Vec3| {
            let d = point - origin;
            [d.x as f32, d.y as f32, d.z as f32]
        };
        let angles = AngleRange::of(segment);
        let kinematics = self.kinematics.filter(|_| !angles.is_zero());
        let [at_start, at_end] =
            [0.0, 1.0].map(|share| kinematics.map(|own| own.along(angles, share)));
        self.points.extend(near(placed(at_start.as_ref(), start)));
        self.points.extend(near(placed(at_end.as_ref(), end)));
        if self.kinematics.is_some() {
            self.programmed.extend(near(start));
            self.programmed.extend(near(end));
        }
        self.kind.push(kind_of(segment, inserted));
        let [from, to] = segment.places();
        self.known.push(from.0 | to.0 << END_AXES_SHIFT);
        self.tool.push(segment.tool);
        self.file.push(u8::try_from(segment.origin.span.file.0).unwrap_or(u8::MAX));
        self.line.push(segment.origin.line);
        self.feed.push(feed_of(segment));
        if self.has_power {
            self.power.push(segment.rpm as f32);
        }
        let turns = segment.rotary_from.into_iter().chain(segment.rotary_to);
        self.turns.extend(turns.map(|angle| angle as f32));
        let row = self.kind.len() as u32 - 1;
        let before = self.curve_points.len();
        let mut push = |point: Vec3| self.curve_points.extend(near(point));
        if let Some(own) = kinematics {
            own.curve(&segment.curve, angles, &mut push);
        }
        if let Curve::Spline(piece) = &segment.curve {
            spline_points(piece, |point, share| {
                let to_part = kinematics.map(|own| own.along(angles, share));
                push(placed(to_part.as_ref(), point));
            });
        }
        let count = (self.curve_points.len() - before) / 3;
        if count > 0 {
            self.curve_rows.push(row);
            self.curve_counts.push(count as u32);
        }
        // An arc that the part bends is drawn as a curve; its record stays as it is programmed.
        let to_part = at_start.filter(|_| count == 0);
        if let Some(record) = arc_record(&segment.curve, to_part.as_ref(), near) {
            self.arc_rows.push(row);
            self.arcs.extend(record);
        }
    }

    /// The rows as a frame, and none are left.
    pub fn take(&mut self, header: &Value) -> Vec<u8> {
        let next = PathRows {
            origin: self.origin,
            kinematics: self.kinematics,
            has_power: self.has_power,
            ..PathRows::default()
        };
        let rows = std::mem::replace(self, next);
        let mut frame = ColumnFrame::default();
        frame.column("points", &rows.points);
        frame.column("line", &rows.line);
        frame.column("tool", &rows.tool);
        frame.column("feed", &rows.feed);
        if rows.has_power {
            frame.column("power", &rows.power);
        }
        frame.column("arc_rows", &rows.arc_rows);
        frame.column("arcs", &rows.arcs);
        if !rows.curve_rows.is_empty() {
            frame.column("curve_rows", &rows.curve_rows);
            frame.column("curve_counts", &rows.curve_counts);
            frame.column("curve_points", &rows.curve_points);
        }
        if rows.turns.iter().any(|angle| *angle != 0.0) {
            frame.column("turns", &rows.turns);
            if rows.kinematics.is_some() {
                frame.column("programmed", &rows.programmed);
            }
        }
        frame.column("kind", &rows.kind);
        frame.column("known", &rows.known);
        frame.column("file", &rows.file);
        let mut header = header.clone();
        let origin = rows.origin.unwrap_or(Vec3::ZERO);
        header["origin"] = json!([origin.x, origin.y, origin.z]);
        header["rows"] = json!(rows.kind.len());
        frame.finish(header)
    }
}

fn kind_of(segment: &Segment, inserted: bool) -> u8 {
    let kind = match segment.kind {
        SegmentKind::Rapid => RAPID_KIND,
        SegmentKind::Line => 1,
        SegmentKind::Arc => 2,
        SegmentKind::Spiral => 3,
        SegmentKind::Spline => 4,
    };
    let flag = |is, flag| if is { flag } else { 0 };
    kind | flag(segment.is_drawn(), KNOWN_FLAG)
        | flag(inserted, INSERTED_FLAG)
        | flag(segment.origin.cycle, CYCLE_FLAG)
}

/// Along the path, mm/min; 0 where there is none.
fn feed_of(segment: &Segment) -> f32 {
    let known = segment.duration_s > 0.0 && segment.length_mm > 0.0;
    if known { (segment.length_mm / segment.duration_s * 60.0) as f32 } else { 0.0 }
}

/// Points of a span at even distances, each with its share of the length. A piece of the length d leaves the curve by d²/8 of its largest
/// curvature at most.
fn spline_points(piece: &SplinePiece, mut push: impl FnMut(Vec3, f64)) {
    let length = piece.length();
    let pieces = length * (piece.max_curvature() / (8.0 * SPLINE_TOLERANCE_MM)).sqrt();
    // A NaN is one piece, too.
    let pieces = if pieces > 1.0 { pieces.ceil().min(MAX_SPLINE_PIECES) } else { 1.0 };
    for index in 0..=pieces as u32 {
        push(piece.point_at(length * f64::from(index) / pieces), f64::from(index) / pieces);
    }
}

/// A point on the part; where nothing is turned it stays as it is, to the bit.
fn placed(to_part: Option<&Transform>, point: Vec3) -> Vec3 {
    to_part.map_or(point, |to_part| to_part.apply_point(point))
}

/// The record of an arc; `to_part` is how the part lies, without motion.
fn arc_record(
    curve: &Curve,
    to_part: Option<&Transform>,
    near: impl Fn(Vec3) -> [f32; 3],
) -> Option<[f32; ARC_NUMBERS]> {
    let (center, u, w, radii, sweep, rise) = match curve {
        Curve::Line(_) | Curve::Spline(_) => return None,
        Curve::Arc(arc) => {
            (arc.center, arc.u, arc.w, (arc.radius, arc.radius), arc.sweep, arc.rise)
        }
        Curve::Spiral(spiral) => (
            spiral.center,
            spiral.u,
            spiral.w,
            (spiral.radius_start, spiral.radius_end),
            spiral.sweep,
            spiral.rise,
        ),
    };
    let [cx, cy, cz] = near(placed(to_part, center));
    let [u, w] = [u, w]
        .map(|direction| to_part.map_or(direction, |to_part| to_part.apply_vector(direction)));
    let rest = [u.x, u.y, u.z, w.x, w.y, w.z, radii.0, radii.1, sweep, rise].map(|v| v as f32);
    let mut record = [0.0; ARC_NUMBERS];
    record[..3].copy_from_slice(&[cx, cy, cz]);
    record[3..].copy_from_slice(&rest);
    Some(record)
}

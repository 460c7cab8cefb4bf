//! Reads half sections from drawings: the lines, arcs and polylines of a DXF file, joined to closed loops.
//!
//! X of the drawing is z, Y is r. An outline that begins and ends on the axis is closed along it; lines on the axis
//! itself are not needed.

use core::f64::consts::TAU;

use chordal_geometry::Vec2;

use super::region::RegionError;
use super::segment::OutlineSegment;

/// Most segments of a drawing.
const MAX_SEGMENTS: usize = 10_000;
/// Ends within this distance are one point, mm.
const JOIN_GAP_MM: f64 = 1e-4;

/// Why a drawing cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DxfError {
    /// It is not text; binary DXF is not supported.
    #[error("it is not a DXF file in text form")]
    NotText,
    /// A group code or a value is not a number.
    #[error("line {line} is not what a DXF file has there: `{found}`")]
    Broken {
        /// The line, from 1.
        line: usize,
        /// The text in that line.
        found: String,
    },
    /// It has no lines, arcs or polylines.
    #[error("it has no lines, arcs or polylines")]
    Empty,
    /// It has more segments than a half section can have.
    #[error("it has more than {MAX_SEGMENTS} lines and arcs")]
    TooMany,
    /// A curve that is neither a line nor an arc.
    #[error("it has a curve of the kind {kind}: a half section consists of lines and arcs")]
    Curve {
        /// Its kind.
        kind: String,
    },
    /// An open chain of segments ends away from the axis.
    #[error("its outline is open at z {z} mm, radius {r} mm")]
    Open {
        /// The z of that end, mm.
        z: f64,
        /// The radius of that end, mm.
        r: f64,
    },
    /// The loops do not give a region.
    #[error(transparent)]
    Region(#[from] RegionError),
}

/// The closed loops of a drawing whose unit is `unit_mm` mm.
pub fn read_dxf(bytes: &[u8], unit_mm: f64) -> Result<Vec<Vec<OutlineSegment>>, DxfError> {
    let text = core::str::from_utf8(bytes).map_err(|_| DxfError::NotText)?;
    if text.starts_with("AutoCAD Binary") {
        return Err(DxfError::NotText);
    }
    let mut segments = Vec::new();
    let mut entity = DxfEntity::default();
    let mut section = String::new();
    let mut lines = text.lines().enumerate();
    while let (Some((at, code)), Some((_, value))) = (lines.next(), lines.next()) {
        let broken = |line: usize, found: &str| DxfError::Broken { line, found: found.to_string() };
        let code: i32 = code.trim().parse().map_err(|_| broken(at + 1, code))?;
        let value = value.trim();
        match code {
            0 => {
                let is_drawn = section == "ENTITIES";
                let next = if is_drawn { value } else { "" };
                entity.finish(next, unit_mm, &mut segments)?;
                if segments.len() > MAX_SEGMENTS {
                    return Err(DxfError::TooMany);
                }
                entity.begin(next);
                if value == "ENDSEC" {
                    section.clear();
                }
                if value == "EOF" {
                    break;
                }
            }
            2 if section.is_empty() => section = value.to_string(),
            10..=59 | 70 if section == "ENTITIES" => {
                let number: f64 = value.parse().map_err(|_| broken(at + 2, value))?;
                entity.take(code, number);
            }
            _ => {}
        }
    }
    entity.finish("", unit_mm, &mut segments)?;
    loops(segments)
}

/// The entity that is being read.
#[derive(Default)]
struct DxfEntity {
    kind: String,
    /// Corners of a polyline: x, y, and the bulge of the side after it.
    corners: Vec<[f64; 3]>,
    ends: [f64; 4],
    radius: f64,
    angles: [f64; 2],
    closed: bool,
    /// Inside a POLYLINE (the old form), whose vertices follow as entities.
    in_polyline: bool,
}

impl DxfEntity {
    fn begin(&mut self, kind: &str) {
        if self.in_polyline && kind == "VERTEX" {
            self.corners.push([0.0; 3]);
            return;
        }
        let in_polyline = kind == "POLYLINE";
        *self = DxfEntity { kind: kind.to_string(), in_polyline, ..DxfEntity::default() };
    }

    fn take(&mut self, code: i32, number: f64) {
        let is_polyline = self.kind == "LWPOLYLINE" || self.in_polyline;
        match code {
            10 if self.kind == "LWPOLYLINE" => self.corners.push([number, 0.0, 0.0]),
            10 | 20 | 42 if is_polyline => {
                let place = [10, 20, 42].iter().position(|known| *known == code).unwrap_or(0);
                if let Some(corner) = self.corners.last_mut() {
                    corner[place] = number;
                }
            }
            10 => self.ends[0] = number,
            20 => self.ends[1] = number,
            11 => self.ends[2] = number,
            21 => self.ends[3] = number,
            40 => self.radius = number,
            50 => self.angles[0] = number,
            51 => self.angles[1] = number,
            70 if is_polyline && self.corners.is_empty() => {
                self.closed = (number as i64) & 1 == 1;
            }
            70 if self.kind == "LWPOLYLINE" => self.closed = (number as i64) & 1 == 1,
            _ => {}
        }
    }

    fn finish(
        &mut self,
        next: &str,
        unit: f64,
        segments: &mut Vec<OutlineSegment>,
    ) -> Result<(), DxfError> {
        if self.in_polyline && next == "VERTEX" {
            return Ok(());
        }
        let [x, y, to_x, to_y] = self.ends.map(|value| value * unit);
        match self.kind.as_str() {
            "LINE" => segments.push(OutlineSegment::line(Vec2::new(x, y), Vec2::new(to_x, to_y))),
            "ARC" => {
                let (center, radius) = (Vec2::new(x, y), self.radius * unit);
                let [from, to] = self.angles.map(|angle| on_circle(center, radius, angle));
                segments.push(OutlineSegment::arc(from, to, center, true));
            }
            "CIRCLE" => {
                let right = Vec2::new(x + self.radius * unit, y);
                segments.push(OutlineSegment::arc(right, right, Vec2::new(x, y), true));
            }
            "LWPOLYLINE" | "POLYLINE" => self.polyline(unit, segments),
            "SPLINE" | "ELLIPSE" => {
                return Err(DxfError::Curve { kind: self.kind.to_ascii_lowercase() });
            }
            _ => {}
        }
        Ok(())
    }

    fn polyline(&mut self, unit: f64, segments: &mut Vec<OutlineSegment>) {
        let count = self.corners.len();
        let sides = if self.closed { count } else { count.saturating_sub(1) };
        for at in 0..sides {
            let [from, to] = [self.corners[at], self.corners[(at + 1) % count]];
            let [start, end] = [from, to].map(|corner| Vec2::new(corner[0], corner[1]) * unit);
            segments.push(bulged(start, end, from[2]));
        }
    }
}

/// A side of a polyline. Its bulge is the tangent of a quarter of the included angle.
fn bulged(start: Vec2, end: Vec2, bulge: f64) -> OutlineSegment {
    if bulge == 0.0 || start == end {
        return OutlineSegment::line(start, end);
    }
    let chord = end - start;
    // The centre is to the left of the chord's middle by half the chord times (1 − b²)/2b.
    let off = (1.0 - bulge * bulge) / (4.0 * bulge);
    let center = (start + end) * 0.5 + chord.turned_left() * off;
    OutlineSegment::arc(start, end, center, bulge > 0.0)
}

fn on_circle(center: Vec2, radius: f64, degrees: f64) -> Vec2 {
    let (sine, cosine) = libm::sincos((degrees / 360.0).rem_euclid(1.0) * TAU);
    center + Vec2::new(cosine, sine) * radius
}

fn reversed(segment: &OutlineSegment) -> OutlineSegment {
    match segment.bend {
        None => OutlineSegment::line(segment.end, segment.start),
        Some(bend) => {
            OutlineSegment::arc(segment.end, segment.start, bend.center, !bend.counterclockwise)
        }
    }
}

/// Joins segments end to end.
fn loops(mut open: Vec<OutlineSegment>) -> Result<Vec<Vec<OutlineSegment>>, DxfError> {
    let on_axis = |p: Vec2| p.b.abs() <= JOIN_GAP_MM;
    let lies_on_axis = |segment: &OutlineSegment| {
        segment.bend.is_none() && on_axis(segment.start) && on_axis(segment.end)
    };
    open.retain(|segment| {
        let is_point = segment.bend.is_none() && segment.start.distance(segment.end) <= JOIN_GAP_MM;
        !is_point && !lies_on_axis(segment)
    });
    let mut loops = Vec::new();
    while let Some(first) = open.pop() {
        let mut chain = vec![first];
        grow(&mut chain, &mut open);
        let ends = |chain: &[OutlineSegment]| (chain[0].start, chain[chain.len() - 1].end);
        let (start, end) = ends(&chain);
        if start.distance(end) > JOIN_GAP_MM {
            // The chain is extended at its other end.
            chain = chain.iter().rev().map(reversed).collect();
            grow(&mut chain, &mut open);
            let (start, end) = ends(&chain);
            if start.distance(end) > JOIN_GAP_MM {
                let loose = if on_axis(start) { end } else { start };
                if !on_axis(loose) {
                    return Err(DxfError::Open { z: loose.a, r: loose.b });
                }
                chain.push(OutlineSegment::line(end, start));
            }
        }
        loops.push(chain);
    }
    if loops.is_empty() { Err(DxfError::Empty) } else { Ok(loops) }
}

/// Appends segments that join on to the end of the chain, until it is closed or none fits.
fn grow(chain: &mut Vec<OutlineSegment>, open: &mut Vec<OutlineSegment>) {
    loop {
        let (start, end) = (chain[0].start, chain[chain.len() - 1].end);
        let is_closed =
            start.distance(end) <= JOIN_GAP_MM && (chain.len() > 1 || chain[0].bend.is_some());
        if is_closed {
            return;
        }
        let fits = |segment: &OutlineSegment| {
            segment.start.distance(end) <= JOIN_GAP_MM || segment.end.distance(end) <= JOIN_GAP_MM
        };
        let Some(at) = open.iter().position(fits) else { return };
        let next = open.swap_remove(at);
        chain.push(if next.start.distance(end) <= JOIN_GAP_MM { next } else { reversed(&next) });
    }
}

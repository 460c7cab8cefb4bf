//! Collects the blocks of a compensated contour that are checked together.

use chordal_command::Origin;
use chordal_geometry::{Plane, Vec2};

use crate::compensation::{BlockRole, CompensationCurve, ContourPiece};
use crate::gouge::{self, CenterMove, Contour, ContourBlock, ToolSide};

/// An arc whose end radii differ by more than this is a spiral, mm.
const ROUNDED_RADIUS_MM: f64 = 0.02;

/// A spiral is checked along chords that deviate from it by at most this, mm.
const SPIRAL_CHORD_MM: f64 = 0.0005;

/// The largest number of chords of one spiral.
const MAX_CHORDS: f64 = 20_000.0;

/// Blocks of a contour at one height, with the tool on one side and with one offset.
#[derive(Debug, Default)]
pub struct ContourLevel {
    /// The plane of compensation.
    pub plane: Plane,
    sign: f64,
    radius: f64,
    height: f64,
    /// The largest difference between the end radii of an arc that comes from rounding, mm.
    pub rounding: f64,
    blocks: Vec<ContourBlock>,
    /// The path of the tool centre.
    pub moves: Vec<CenterMove>,
    /// The position of each block in the program; a tag is an index into this list.
    pub origins: Vec<Origin>,
}

impl ContourLevel {
    /// A level that begins with this piece; the piece itself is not added.
    pub fn of(piece: &ContourPiece) -> ContourLevel {
        ContourLevel {
            plane: piece.plane,
            sign: piece.sign,
            radius: piece.radius_mm,
            ..ContourLevel::default()
        }
    }

    /// The level that follows this one and begins with this piece; the piece itself is not added. Each of the two levels
    /// gets the neighbouring block of the other, which shows whether its first or last block is a lead.
    pub fn next(&mut self, piece: &ContourPiece) -> ContourLevel {
        let mut next = ContourLevel::of(piece);
        let Some(last) = self.blocks.last() else { return next };
        next.blocks.push(passing(last.curve));
        if let Some(programmed) = &piece.programmed {
            let mut first = true;
            plain(programmed, |curve| {
                if std::mem::take(&mut first) {
                    self.blocks.push(passing(curve));
                }
            });
        }
        next
    }

    /// Whether a piece belongs to this level. Another side, another offset, or a step of the third axis between two
    /// blocks begins another level: walls at another height are not cut by this one.
    pub fn continues_with(&self, piece: &ContourPiece) -> bool {
        self.sign == piece.sign
            && self.radius == piece.radius_mm
            && (self.blocks.is_empty() || self.height == piece.height.0)
    }

    /// Adds a block and its path of the tool centre.
    pub fn take(&mut self, piece: &ContourPiece) {
        let tag = self.origins.len() as u32;
        self.origins.push(piece.origin);
        self.height = piece.height.1;
        let role = match piece.role {
            BlockRole::StartUp => gouge::GougeRole::LeadIn,
            BlockRole::Contour if piece.rapid => gouge::GougeRole::Passing,
            BlockRole::Contour if crosses(piece) => gouge::GougeRole::LeadIn,
            BlockRole::Contour => gouge::GougeRole::Offset,
            BlockRole::Cancel => gouge::GougeRole::LeadOut,
        };
        if let Some(programmed) = &piece.programmed {
            self.rounding = self.rounding.max(radius_difference(programmed));
            plain(programmed, |curve| self.blocks.push(ContourBlock { curve, tag, role }));
        }
        for centre in &piece.centre {
            plain(centre, |curve| self.moves.push(CenterMove { curve, tag }));
        }
    }

    /// Takes the programmed contour out; `None` if there are no blocks or no offset.
    pub fn contour(&mut self) -> Option<Contour> {
        if self.radius <= 0.0 || self.blocks.is_empty() {
            return None;
        }
        let side = if self.sign > 0.0 { ToolSide::Left } else { ToolSide::Right };
        Some(Contour { blocks: std::mem::take(&mut self.blocks), side, radius: self.radius })
    }
}

/// Whether the tool goes over from the other side of the contour on a straight block, which is then no wall.
fn crosses(piece: &ContourPiece) -> bool {
    let (Some(line @ CompensationCurve::Line { .. }), Some(centre)) =
        (&piece.programmed, piece.centre.first())
    else {
        return false;
    };
    let across = (line.to() - line.from()).cross(centre.from() - line.from());
    across * piece.sign < 0.0
}

/// A block that is no wall at this height.
fn passing(curve: gouge::GougeCurve) -> ContourBlock {
    ContourBlock { curve, tag: u32::MAX, role: gouge::GougeRole::Passing }
}

/// The difference between the end radii of an arc, mm; 0 for a spiral.
fn radius_difference(curve: &CompensationCurve) -> f64 {
    match *curve {
        CompensationCurve::Arc { radius_from, radius_to, .. } => {
            let difference = (radius_to - radius_from).abs();
            if difference <= ROUNDED_RADIUS_MM { difference } else { 0.0 }
        }
        CompensationCurve::Line { .. } => 0.0,
    }
}

/// Splits a curve into lines and arcs of one radius: a spiral becomes short chords.
fn plain(curve: &CompensationCurve, mut push: impl FnMut(gouge::GougeCurve)) {
    match *curve {
        CompensationCurve::Line { from, to } => push(gouge::GougeCurve::line(from, to)),
        CompensationCurve::Arc { from, center, sweep, radius_from, radius_to, .. } => {
            let arm = from - center;
            let start = libm::atan2(arm.b, arm.a);
            if (radius_to - radius_from).abs() <= ROUNDED_RADIUS_MM {
                let radius = 0.5 * (radius_from + radius_to);
                return push(gouge::GougeCurve::Arc { center, radius, start, sweep });
            }
            let at = |part: f64| {
                let (sin, cos) = libm::sincos(start + part * sweep);
                center + Vec2::new(cos, sin) * (radius_from + part * (radius_to - radius_from))
            };
            let largest = radius_from.max(radius_to);
            let step = (8.0 * SPIRAL_CHORD_MM / largest).sqrt();
            let steps = (sweep.abs() / step).ceil().clamp(1.0, MAX_CHORDS);
            for index in 0..steps as u32 {
                let part = |index: u32| f64::from(index) / steps;
                push(gouge::GougeCurve::line(at(part(index)), at(part(index + 1))));
            }
        }
    }
}

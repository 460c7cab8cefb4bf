//! Blocks of a compensated contour, gathered for what looks at it whole.

use chordal_command::Origin;
use chordal_geometry::{Plane, Vec2};

use crate::compensation::{BlockRole, CompensationCurve, ContourPiece};
use crate::gouge::{self, CenterMove, Contour, ContourBlock, ToolSide};

/// A difference of the radii of an arc's ends above this makes it a spiral, mm.
const ROUNDED_RADIUS_MM: f64 = 0.02;

/// A spiral is checked along chords that stay this near to it, mm.
const SPIRAL_CHORD_MM: f64 = 0.0005;

/// Most chords of one spiral.
const MAX_CHORDS: f64 = 20_000.0;

/// Blocks of a contour at one height, on one side, with one offset.
#[derive(Debug, Default)]
pub struct ContourLevel {
    /// The plane of compensation.
    pub plane: Plane,
    sign: f64,
    radius: f64,
    height: f64,
    /// Largest difference of an arc's radii that comes from rounding, mm.
    pub rounding: f64,
    blocks: Vec<ContourBlock>,
    /// The path of the tool centre.
    pub moves: Vec<CenterMove>,
    /// The block of each tag.
    pub origins: Vec<Origin>,
}

impl ContourLevel {
    /// A level that begins with this piece, which is still to be taken.
    pub fn of(piece: &ContourPiece) -> ContourLevel {
        ContourLevel {
            plane: piece.plane,
            sign: piece.sign,
            radius: piece.radius_mm,
            ..ContourLevel::default()
        }
    }

    /// The level that follows this one and begins with this piece, which is still to be taken. What each
    /// level runs into at the other's height shows whether its first and last block are leads.
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

    /// Another side, another offset, or a step of the third axis between two blocks begin a
    /// level of their own: what lies at another height is not cut by this one.
    pub fn goes_on_with(&self, piece: &ContourPiece) -> bool {
        self.sign == piece.sign
            && self.radius == piece.radius_mm
            && (self.blocks.is_empty() || self.height == piece.height.0)
    }

    /// Takes a block and what the tool centre does for it.
    pub fn take(&mut self, piece: &ContourPiece) {
        let tag = self.origins.len() as u32;
        self.origins.push(piece.origin);
        self.height = piece.height.1;
        let role = match piece.role {
            BlockRole::StartUp => gouge::GougeRole::LeadIn,
            BlockRole::Contour if piece.rapid => gouge::GougeRole::Passing,
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

    /// The programmed contour, if there is one and the tool is offset from it.
    pub fn contour(&mut self) -> Option<Contour> {
        if self.radius <= 0.0 || self.blocks.is_empty() {
            return None;
        }
        let side = if self.sign > 0.0 { ToolSide::Left } else { ToolSide::Right };
        Some(Contour { blocks: std::mem::take(&mut self.blocks), side, radius: self.radius })
    }
}

/// A block that bounds nothing at this height.
fn passing(curve: gouge::GougeCurve) -> ContourBlock {
    ContourBlock { curve, tag: u32::MAX, role: gouge::GougeRole::Passing }
}

/// How much the radii of an arc differ by rounding, mm; nothing for a spiral.
fn radius_difference(curve: &CompensationCurve) -> f64 {
    match *curve {
        CompensationCurve::Arc { radius_from, radius_to, .. } => {
            let difference = (radius_to - radius_from).abs();
            if difference <= ROUNDED_RADIUS_MM { difference } else { 0.0 }
        }
        CompensationCurve::Line { .. } => 0.0,
    }
}

/// The curve as lines and arcs of one radius: a spiral in short chords.
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

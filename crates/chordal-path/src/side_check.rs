//! Compares the side from which the tool comes to a compensated contour and to which it leaves with the side of G41 or
//! G42. This does not need the tool diameter.

use core::f64::consts::PI;

use chordal_command::Origin;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::Vec2;

use crate::compensation::{BlockRole, CompensationCurve, ContourPiece};

/// A lead that is on the far side of a wall by less is in line with it, mm.
const ACROSS_MM: f64 = 0.01;

/// Turns smaller than this are tangent joints, rad.
const TANGENT_RAD: f64 = 0.02;

/// Checks the leads of contour after contour.
#[derive(Debug, Default)]
pub struct SideCheck {
    /// The start of the lead-in, mm, and its block, until the first wall is known.
    begun: Option<(Vec2, Origin)>,
    /// The lead-in, if it came from the far side.
    across: Option<Origin>,
    /// The last block.
    last: Option<CompensationCurve>,
    /// The block before the last, which is the last wall if the last block is a lead-out arc.
    before: Option<CompensationCurve>,
}

impl SideCheck {
    /// Follows the next block of a contour. A problem is reported at its lead-out.
    pub fn piece(&mut self, piece: &ContourPiece, report: &mut dyn FnMut(Diagnostic, &Origin)) {
        let Some(programmed) = &piece.programmed else { return };
        match piece.role {
            BlockRole::StartUp => {
                let begun = Some((programmed.from(), piece.origin));
                *self = SideCheck { begun, ..SideCheck::default() };
            }
            BlockRole::Contour => self.contour_block(programmed, piece.sign),
            BlockRole::Cancel => {
                self.first_wall(piece.sign, None);
                let ended = std::mem::take(self);
                if let (Some(origin), Some(wall)) = (ended.across, ended.last_wall(piece.sign))
                    && let Some((_, tangent)) = wall.tangents()
                    && across(tangent, programmed.to() - wall.to(), piece.sign)
                {
                    report(wrong_side(piece, &origin), &origin);
                }
            }
        }
    }

    fn contour_block(&mut self, block: &CompensationCurve, sign: f64) {
        self.first_wall(sign, Some(block));
        self.before = self.last.replace(*block);
    }

    /// Records if the tool came from the far side of the first wall: the first block, or the one after a lead-in arc.
    fn first_wall(&mut self, sign: f64, next: Option<&CompensationCurve>) {
        let (Some((begun, origin)), Some(first)) = (self.begun, self.last) else { return };
        let wall = match next {
            Some(next) if leads(&first, sign) && are_tangent(&first, next) => *next,
            _ => first,
        };
        self.begun = None;
        if let Some((tangent, _)) = wall.tangents()
            && across(tangent, begun - wall.from(), sign)
        {
            self.across = Some(origin);
        }
    }

    /// The last wall: the last block, or the one before a lead-out arc.
    fn last_wall(&self, sign: f64) -> Option<CompensationCurve> {
        let last = self.last?;
        match self.before {
            Some(before) if leads(&last, sign) && are_tangent(&before, &last) => Some(before),
            _ => Some(last),
        }
    }
}

/// Whether a curve is an arc of at most half a turn with the tool inside it.
fn leads(curve: &CompensationCurve, sign: f64) -> bool {
    match *curve {
        CompensationCurve::Arc { sweep, .. } => sweep * sign > 0.0 && sweep.abs() <= PI + 1e-6,
        CompensationCurve::Line { .. } => false,
    }
}

fn are_tangent(before: &CompensationCurve, after: &CompensationCurve) -> bool {
    match (before.tangents(), after.tangents()) {
        (Some((_, end)), Some((start, _))) => {
            end.dot(start) > 0.0 && end.cross(start).abs() <= TANGENT_RAD
        }
        _ => false,
    }
}

/// Whether a lead is on the side of the wall opposite to the tool.
fn across(tangent: Vec2, lead: Vec2, sign: f64) -> bool {
    tangent.turned_left().dot(lead) * sign < -ACROSS_MM
}

/// The diagnostic for a tool that comes from the far side of the contour and leaves to it: it would have to cross the
/// contour twice, so probably the other side was meant.
fn wrong_side(lead_out: &ContourPiece, lead_in: &Origin) -> Diagnostic {
    let (code, other, side, far) = match lead_out.sign > 0.0 {
        true => ("G41", "G42", "left", "right"),
        false => ("G42", "G41", "right", "left"),
    };
    let message = format!(
        "the tool comes from the {far} of the contour, runs {side} of it, and leaves to the {far}"
    );
    Diagnostic::new(Code::CompensationSideDoubtful, lead_in.span, message)
        .label(format!("{code} puts the tool on the opposite side of the contour from the lead-in"))
        .also(lead_out.origin.span, format!("the lead-out goes back to the {far}"))
        .help(format!("write {other}, or a negative offset, if the tool belongs on the {far}"))
}

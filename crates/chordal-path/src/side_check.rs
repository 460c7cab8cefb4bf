//! From where the tool comes to a compensated contour, and where it goes: the side that G41 or G42 puts
//! it on. It needs no diameter.

use chordal_command::Origin;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::Vec2;

use crate::compensation::{ContourPiece, Role};

/// A lead that lies on the far side of a wall by less is in line with it, mm.
const ACROSS_MM: f64 = 0.01;

/// Follows the leads of one contour after the other.
#[derive(Debug, Default)]
pub struct SideCheck {
    /// From the start of the contour back along the lead-in, until the first block is known.
    back: Option<(Vec2, Origin)>,
    /// The lead-in, where it came from the far side.
    across: Option<Origin>,
    /// Direction at the end of the last block.
    last: Option<Vec2>,
}

impl SideCheck {
    /// Takes the next block of a contour; what is found is reported with its lead-out.
    pub fn piece(&mut self, piece: &ContourPiece, report: &mut dyn FnMut(Diagnostic, &Origin)) {
        let Some(programmed) = &piece.programmed else { return };
        let Some((first, last)) = programmed.tangents() else { return };
        match piece.role {
            Role::StartUp => {
                let back = programmed.from() - programmed.to();
                *self = SideCheck { back: Some((back, piece.origin)), ..SideCheck::default() };
            }
            Role::Contour => {
                if let Some((back, origin)) = self.back.take()
                    && across(first, back, piece.sign)
                {
                    self.across = Some(origin);
                }
                self.last = Some(last);
            }
            Role::Cancel => {
                let ended = std::mem::take(self);
                let off = programmed.to() - programmed.from();
                if let (Some(origin), Some(last)) = (ended.across, ended.last)
                    && across(last, off, piece.sign)
                {
                    report(wrong_side(piece, &origin), &origin);
                }
            }
        }
    }
}

/// A lead that lies on the other side of the wall than the tool.
fn across(tangent: Vec2, lead: Vec2, sign: f64) -> bool {
    tangent.turned_left().dot(lead) * sign < -ACROSS_MM
}

/// A tool that comes from the far side of the contour and goes off to it has to cross it twice: the
/// other side was meant.
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

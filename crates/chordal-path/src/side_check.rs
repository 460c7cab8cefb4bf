//! From where the tool comes to a compensated contour, and where it goes: the side that G41 or G42 puts
//! it on, and a contour that is left open. It needs no diameter.

use chordal_control::Origin;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::{Plane, Vec2};

use crate::compensation::{ContourPiece, PlaneCurve, Role};

/// A lead that lies on the far side of a wall by less is in line with it, mm.
const ACROSS_MM: f64 = 0.01;

/// A lead-out in the direction of the last block, but for this angle, runs on along its wall, rad.
const RUNS_ON_RAD: f64 = 0.01;

/// Less turning than this, all of it to the tool's side, makes no pocket, rad.
const POCKET_RAD: f64 = 0.5;

/// Ends that are nearer than this are one point, mm.
const CLOSED_MM: f64 = 0.01;

/// Follows the leads of one contour after the other.
#[derive(Debug, Default)]
pub struct SideCheck {
    /// From the start of the contour back along the lead-in, until the first block is known.
    back: Option<(Vec2, Origin)>,
    /// The lead-in, where it came from the far side.
    across: Option<Origin>,
    /// Where the first block begins.
    start: Option<Vec2>,
    /// End and direction at the end of the last block.
    last: Option<(Vec2, Vec2)>,
    /// Turning to the tool's side, and away from it, rad.
    turned: (f64, f64),
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
                if let Some((back, origin)) = self.back.take() {
                    self.start = Some(programmed.from());
                    if across(first, back, piece.sign) {
                        self.across = Some(origin);
                    }
                }
                if let Some((_, before)) = self.last {
                    self.turn(angle(before, first) * piece.sign);
                }
                if let PlaneCurve::Arc { sweep, .. } = programmed {
                    self.turn(sweep * piece.sign);
                }
                self.last = Some((programmed.to(), last));
            }
            Role::Cancel => {
                let ended = std::mem::take(self);
                let Some((end, last)) = ended.last else { return };
                let off = programmed.to() - programmed.from();
                if let Some(origin) = ended.across
                    && across(last, off, piece.sign)
                {
                    report(wrong_side(piece, &origin), &origin);
                }
                if let Some(start) = ended.start
                    && ended.is_pocket()
                    && start.distance(end) > CLOSED_MM
                    && angle(last, first).abs() < RUNS_ON_RAD
                {
                    report(left_open(piece, start, end), &piece.origin);
                }
            }
        }
    }

    fn turn(&mut self, angle: f64) {
        if angle > 0.0 {
            self.turned.0 += angle;
        } else {
            self.turned.1 -= angle;
        }
    }

    /// The contour turns round the tool, as the wall of a pocket does.
    fn is_pocket(&self) -> bool {
        self.turned.0 > POCKET_RAD && self.turned.1 < RUNS_ON_RAD
    }
}

/// A lead that lies on the other side of the wall than the tool.
fn across(tangent: Vec2, lead: Vec2, sign: f64) -> bool {
    tangent.turned_left().dot(lead) * sign < -ACROSS_MM
}

/// From one direction to the other, positive to the left, rad.
fn angle(from: Vec2, to: Vec2) -> f64 {
    libm::atan2(from.cross(to), from.dot(to))
}

/// A tool that comes from the far side of the contour and goes off to it has to cross it twice: the
/// other side was meant.
fn wrong_side(lead_out: &ContourPiece, lead_in: &Origin) -> Diagnostic {
    let (code, other, side, far) = match lead_out.sign > 0.0 {
        true => ("G41", "G42", "left", "right"),
        false => ("G42", "G41", "right", "left"),
    };
    let message = format!(
        "the tool comes from the {far} of the contour and leaves to the {far}, and runs {side} of it"
    );
    Diagnostic::new(Code::CompensationSideDoubtful, lead_in.span, message)
        .label(format!("{code} puts the tool on the other side of the contour than the lead-in"))
        .also(lead_out.origin.span, format!("the lead-out goes to the {far} again"))
        .help(format!("write {other}, or a negative offset, if the tool belongs on the {far}"))
}

/// The wall of a pocket that ends somewhere else than it began, with a lead-out straight on.
fn left_open(lead_out: &ContourPiece, start: Vec2, end: Vec2) -> Diagnostic {
    let place = |at: Vec2| {
        let (a, b) = match lead_out.plane {
            Plane::Xy => ("X", "Y"),
            Plane::Zx => ("Z", "X"),
            Plane::Yz => ("Y", "Z"),
        };
        let text = |mm: f64| lead_out.units.length_text(mm);
        format!("{a} {}, {b} {}", text(at.a), text(at.b))
    };
    Diagnostic::new(
        Code::PocketLeftOpen,
        lead_out.origin.span,
        format!(
            "the wall of this pocket begins at {} and ends at {}: it is not closed",
            place(start),
            place(end)
        ),
    )
    .label("the lead-out runs straight on along the wall, and over it by the offset")
    .help("look for blocks that are missing before this one")
}

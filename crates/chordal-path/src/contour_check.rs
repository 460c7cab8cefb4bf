//! Checks every compensated contour, from G41 or G42 to G40, against the whole path of its tool centre, and reports
//! where the tool would cut into the contour.
//!
//! The checks of a control compare a few blocks; this one compares the whole contour. It finds the real gouges, which
//! the alarms of the control may miss, and the alarms where nothing would be cut.

use chordal_command::{Origin, Units};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_geometry::Plane;

use crate::compensation::{BlockRole, ContourPiece};
use crate::contour_level::ContourLevel;
use crate::gouge::{self, Gouge, GougeKind, GougeOptions};
use crate::side_check::SideCheck;

/// The largest number of gouges reported for one contour; that there are more is one further report.
const MAX_REPORTED_PER_CONTOUR: usize = 8;

/// The largest number of blocks stored for one contour. The blocks after them are not checked, which is reported.
const KEPT_BLOCKS: usize = 4_000_000;

/// The largest number of steps of the search per contour: a few seconds.
const SEARCH_BUDGET: u64 = 200_000_000;

/// A depth up to this comes from rounding of the programmed points and is not a gouge, mm.
const MIN_DEPTH_MM: f64 = 0.002;

/// Checks the compensated contours of a run one after the other.
#[derive(Debug)]
pub struct ContourCheck {
    units: Units,
    contour_number: u32,
    level: ContourLevel,
    sides: SideCheck,
    /// Blocks of this contour at which the control found interference.
    alarms: Vec<Span>,
    /// The first block that was not stored.
    beyond: Option<Origin>,
}

impl Default for ContourCheck {
    /// A check for one run.
    fn default() -> ContourCheck {
        ContourCheck {
            units: Units::Millimetre,
            contour_number: 0,
            level: ContourLevel::default(),
            sides: SideCheck::default(),
            alarms: Vec::new(),
            beyond: None,
        }
    }
}

impl ContourCheck {
    /// Takes the next block of a compensated contour. The findings of a contour are reported when it ends.
    pub fn piece(&mut self, piece: &ContourPiece, report: &mut dyn FnMut(Diagnostic, &Origin)) {
        if piece.contour_number != self.contour_number {
            self.finish(report);
            self.contour_number = piece.contour_number;
        }
        self.units = piece.units;
        if piece.negative {
            // The program gives the tool centre, with a negative wear: the programmed path is not the wall.
            return;
        }
        if !self.level.continues_with(piece) {
            let next = self.level.next(piece);
            self.end_level(report);
            self.level = next;
        }
        if self.level.origins.len() >= KEPT_BLOCKS {
            self.beyond.get_or_insert(piece.origin);
            return;
        }
        self.level.take(piece);
        self.sides.piece(piece, report);
        if piece.role == BlockRole::Cancel {
            self.finish(report);
        }
    }

    /// Whether no contour is open, so that all findings are reported.
    pub fn is_settled(&self) -> bool {
        self.level.origins.is_empty() && self.alarms.is_empty() && self.beyond.is_none()
    }

    /// Records an alarm of the control. If it is an interference alarm and nothing would be cut, this is reported at
    /// the end of the contour. Diagnostics that do not stop the control, such as the note of an inside arc as large as
    /// the offset, are ignored.
    pub fn alarm(&mut self, diagnostic: &Diagnostic) {
        let interference = diagnostic.severity == Severity::Error
            && matches!(
                diagnostic.code,
                Code::InsideArcTooSmall
                    | Code::CompensationInterference
                    | Code::NoOffsetIntersection
            );
        if interference && self.alarms.len() < MAX_REPORTED_PER_CONTOUR {
            self.alarms.push(diagnostic.primary.span);
        }
    }

    /// Ends the open contour and reports its findings.
    pub fn finish(&mut self, report: &mut dyn FnMut(Diagnostic, &Origin)) {
        self.end_level(report);
        self.alarms.clear();
        self.sides = SideCheck::default();
        if let Some(origin) = self.beyond.take() {
            let message = format!(
                "this contour has more than {KEPT_BLOCKS} blocks; it is checked up to here"
            );
            report(
                Diagnostic::new(Code::ContourNotChecked, origin.span, message)
                    .help("end the contour with G40 earlier to have all of it checked"),
                &origin,
            );
        }
    }

    fn end_level(&mut self, report: &mut dyn FnMut(Diagnostic, &Origin)) {
        let mut level = std::mem::take(&mut self.level);
        let Some(contour) = level.contour() else { return };
        let least_increment = match self.units {
            Units::Inch => 0.00254,
            Units::Millimetre => 0.001,
        };
        let options = GougeOptions {
            epsilon: MIN_DEPTH_MM.max(level.rounding).max(2.0 * least_increment),
            most: MAX_REPORTED_PER_CONTOUR,
            budget: SEARCH_BUDGET,
            ..GougeOptions::default()
        };
        let found = gouge::check(&contour, &level.moves, &options);
        let origins = &level.origins;
        for gouge in &found.gouges {
            let diagnostic = self.gouge_diagnostic(gouge, level.plane, contour.radius, origins);
            report(diagnostic, &origins[gouge.cutting as usize]);
        }
        let alarms = std::mem::take(&mut self.alarms);
        if found.complete && found.gouges.iter().all(|gouge| gouge.kind == GougeKind::AtLead) {
            for origin in origins.iter().filter(|origin| alarms.contains(&origin.span)) {
                report(false_alarm(origin), origin);
            }
        }
        let last = *origins.last().unwrap_or(&Origin::default());
        if found.more {
            let message = format!("more than {MAX_REPORTED_PER_CONTOUR} gouges in this contour");
            let diagnostic = Diagnostic::new(Code::CutterGouges, last.span, message);
            report(diagnostic.label("the contour ends here; the deepest ones are reported"), &last);
        }
        if let Some((first, second)) = found.ambiguous.first() {
            let [first, second] = [first, second].map(|tag| origins[*tag as usize]);
            let message = "the contour runs along this line in both directions: neither side is known to be the part";
            let diagnostic = Diagnostic::new(Code::SideAmbiguous, second.span, message)
                .also(first.span, "first direction");
            report(diagnostic, &second);
        }
        if !found.complete {
            let message = "the contour is too dense to be checked completely";
            report(Diagnostic::new(Code::GougeSearchLimit, last.span, message), &last);
        }
    }

    fn gouge_diagnostic(
        &self,
        gouge: &Gouge,
        plane: Plane,
        radius: f64,
        origins: &[Origin],
    ) -> Diagnostic {
        let [cutting, cut] = [gouge.cutting, gouge.cut].map(|tag| origins[tag as usize]);
        let depth = self.length(gouge.depth);
        let radius = self.length(radius);
        let (code, how) = match gouge.kind {
            GougeKind::Contour => (Code::CutterGouges, "cuts"),
            GougeKind::AtLead => (Code::CutterGougesAtLead, "on its lead-in or lead-out cuts"),
        };
        let itself = cutting.span == cut.span;
        let message = match itself {
            true => format!("the tool of radius {radius} {how} {depth} into this wall"),
            false => format!(
                "the tool of radius {radius} {how} {depth} into the contour of line {}",
                cut.line
            ),
        };
        let (first, second, _) = plane.axes();
        let along = |axis: usize, mm: f64| format!("{} {}", ["X", "Y", "Z"][axis], self.length(mm));
        let place = format!("{}, {}", along(first, gouge.center.a), along(second, gouge.center.b));
        let diagnostic = Diagnostic::new(code, cutting.span, message)
            .label("the tool cuts here")
            .note(format!("deepest where the tool centre is at {place}"));
        if itself { diagnostic } else { diagnostic.also(cut.span, "this wall is cut") }
    }

    /// A length in the program's units.
    fn length(&self, mm: f64) -> String {
        self.units.length_text(mm)
    }
}

fn false_alarm(origin: &Origin) -> Diagnostic {
    let message = "the control alarms here, but the tool would not cut into a wall";
    Diagnostic::new(Code::FalseInterferenceAlarm, origin.span, message)
        .label("a false alarm of the control's look-ahead")
        .help("the control does not run this block: use a smaller tool, or change the contour here")
}

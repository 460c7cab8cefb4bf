//! Diagnostics of a compensated contour.

use chordal_command::Origin;
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_kernel::rules::{SideChange, SpiralCompensation};

use super::interference::InterferenceKind;
use super::queue::QueuedBlock;
use super::{Compensator, PathSink};

impl Compensator {
    /// Reports a problem with the alarm that the control shows. `{n}` stays in the text: the caller replaces it with the
    /// block number.
    fn report(&self, diagnostic: Diagnostic, origin: &Origin, out: &mut dyn PathSink) {
        self.report_with(diagnostic, false, origin, out);
    }

    fn report_with(
        &self,
        mut diagnostic: Diagnostic,
        arc: bool,
        origin: &Origin,
        out: &mut dyn PathSink,
    ) {
        if diagnostic.severity == Severity::Error
            && let Some(text) = self.alarms.text(diagnostic.code)
        {
            let moved = if arc { "Arc move" } else { "Straight feed" };
            // A text with ` / ` has one version for an arc and one for a line.
            let text = match text.split_once(" / ") {
                Some((of_arc, of_line)) => {
                    if arc {
                        of_arc
                    } else {
                        of_line
                    }
                }
                None => text,
            };
            let text = text.replace("{move}", moved);
            diagnostic.alarm = Some(format!("{}: {text}", self.alarms.title));
        }
        out.diagnostic(diagnostic, origin);
    }

    /// A length in the program's units.
    fn length(&self, mm: f64) -> String {
        self.units.length_text(mm)
    }

    pub(super) fn report_inside_arc(
        &self,
        block: &QueuedBlock,
        radius: f64,
        offset: f64,
        out: &mut dyn PathSink,
    ) {
        let origin = &block.command.origin;
        let (radius, offset) = (self.length(radius), self.length(offset));
        let how = if radius == offset { "not larger" } else { "smaller" };
        let diagnostic = Diagnostic::new(
            Code::InsideArcTooSmall,
            origin.span,
            format!("inside radius {radius} is {how} than the offset {offset}"),
        )
        .label("the tool runs inside this arc")
        .help(format!("use a tool with a radius below {radius}, or check the offset"));
        self.report_with(diagnostic, true, origin, out);
    }

    /// Reports an inside arc whose radius equals the offset, on a control that accepts it.
    pub(super) fn inside_arc_vanishes(
        &self,
        block: &QueuedBlock,
        offset: f64,
        out: &mut dyn PathSink,
    ) {
        let origin = &block.command.origin;
        let offset = self.length(offset);
        let diagnostic = Diagnostic::new(
            Code::InsideArcTooSmall,
            origin.span,
            format!("this inside arc is as large as the offset {offset}: the tool centre does not move on it"),
        )
        .severity(Severity::Note)
        .label("the arc shrinks to a point")
        .help("a larger offset does not fit; a smaller tool cuts the arc without stopping in it");
        self.report_with(diagnostic, true, origin, out);
    }

    pub(super) fn report_interference(
        &self,
        block: &QueuedBlock,
        found: &InterferenceKind,
        out: &mut dyn PathSink,
    ) {
        let origin = &block.command.origin;
        let offset = self.length(block.radii.1);
        let what = match found {
            InterferenceKind::Reversed { length, lost } => format!(
                "this move of {} loses {} at its corners with the offset {offset}",
                self.length(*length),
                self.length(*lost),
            ),
            InterferenceKind::Turned { programmed, becomes } => format!(
                "this arc of {:.3} degrees becomes {:.3} degrees with the offset {offset}",
                programmed.to_degrees().abs(),
                becomes.to_degrees() * programmed.signum(),
            ),
            InterferenceKind::Crossing => {
                format!("the vectors of the offset {offset} cross between the ends of this block")
            }
        };
        let diagnostic = Diagnostic::new(Code::CompensationInterference, origin.span, what)
            .label("does not fit between its neighbours")
            .help("use a smaller tool, or change the contour here");
        self.report_with(diagnostic, block.curve.is_arc(), origin, out);
    }

    pub(super) fn avoided(&self, block: &QueuedBlock, out: &mut dyn PathSink) {
        let origin = &block.command.origin;
        let offset = self.length(block.radii.1);
        let diagnostic = Diagnostic::new(
            Code::InterferenceAvoided,
            origin.span,
            format!("with the offset {offset} the control skips this block"),
        )
        .help("use a smaller tool, or change the contour here");
        self.report(diagnostic, origin, out);
    }

    pub(super) fn no_intersection(
        &self,
        before: &QueuedBlock,
        new: &QueuedBlock,
        out: &mut dyn PathSink,
    ) {
        let origin = &new.command.origin;
        let offset = self.length(new.radii.0);
        let diagnostic = Diagnostic::new(
            Code::NoOffsetIntersection,
            origin.span,
            format!("at the start of this block the offset paths of {offset} do not meet"),
        )
        .also(before.command.origin.span, "the block before")
        .help("use a smaller tool, or change the corner");
        self.report_with(diagnostic, new.curve.is_arc(), origin, out);
    }

    pub(super) fn lead_too_short(&self, origin: &Origin, length: f64, out: &mut dyn PathSink) {
        let (is, offset) = (self.length(length), self.length(self.radius));
        let diagnostic = Diagnostic::new(
            Code::LeadInTooShort,
            origin.span,
            format!("the lead-in of {is} is too short for the offset {offset}"),
        )
        .help(format!("start more than {offset} away"));
        self.report(diagnostic, origin, out);
    }

    /// Reports G40 in a block that does not move in the plane.
    pub(super) fn no_lead_out(&self, origin: &Origin, out: &mut dyn PathSink) {
        let diagnostic = Diagnostic::new(
            Code::LeadInTooShort,
            origin.span,
            "G40 is in a block that does not move in the plane: compensation is cancelled on the next move",
        )
        .severity(Severity::Warning)
        .label("no lead-out")
        .help("put G40 on a straight move away from the contour");
        self.report(diagnostic, origin, out);
    }

    pub(super) fn starts_on_arc(&self, origin: &Origin, out: &mut dyn PathSink) {
        self.on_arc("starts", "put G41 or G42 on a straight move to the contour", origin, out);
    }

    pub(super) fn ends_on_arc(&self, origin: &Origin, out: &mut dyn PathSink) {
        self.on_arc("ends", "put G40 on a straight move away from the contour", origin, out);
    }

    /// Reports an arc on which compensation starts or ends. In the block of the code itself this was already reported
    /// when the block was interpreted.
    fn on_arc(&self, what: &str, help: &str, origin: &Origin, out: &mut dyn PathSink) {
        if self.code.span == origin.span {
            return;
        }
        let message = format!("cutter compensation {what} on an arc");
        let diagnostic = Diagnostic::new(Code::CompensationOnArc, origin.span, message)
            .label("this block is an arc")
            .also(self.code.span, "from here")
            .help(help);
        self.report(diagnostic, origin, out);
    }

    pub(super) fn report_side_change(&self, origin: &Origin, out: &mut dyn PathSink) {
        if self.rules.compensation.side_change == SideChange::Refused {
            self.side_change_refused(origin, out);
        }
    }

    pub(super) fn side_change_refused(&self, origin: &Origin, out: &mut dyn PathSink) {
        let message = "compensation changes to the other side here";
        let diagnostic = Diagnostic::new(Code::SideChangeRefused, origin.span, message)
            .help("cancel with G40 on a move away from the contour, then start compensation again");
        self.report(diagnostic, origin, out);
    }

    pub(super) fn new_offset_refused(&self, origin: &Origin, out: &mut dyn PathSink) {
        let message = "a new offset number while compensation is on";
        let diagnostic = Diagnostic::new(Code::NewOffsetRefused, origin.span, message)
            .help("cancel with G40 first");
        self.report(diagnostic, origin, out);
    }

    pub(super) fn twice(&self, origin: &Origin, out: &mut dyn PathSink) {
        let message = "compensation is already on";
        let diagnostic = Diagnostic::new(Code::CompensationTwice, origin.span, message)
            .help("remove this code, or cancel with G40 first");
        self.report(diagnostic, origin, out);
    }

    pub(super) fn plane_refused(&self, origin: &Origin, out: &mut dyn PathSink) {
        let message = "this control does not compensate in this plane";
        let diagnostic = Diagnostic::new(Code::CompensationPlane, origin.span, message)
            .label("shown as programmed")
            .help("compensate in G17");
        self.report(diagnostic, origin, out);
    }

    pub(super) fn look_ahead_lost(&self, before: &QueuedBlock, out: &mut dyn PathSink) {
        let origin = &before.command.origin;
        let limit = self.rules.compensation.idle_blocks.unwrap_or(0);
        let idle = before.idle;
        let blocks = if idle == 1 { "block" } else { "blocks" };
        let message = if idle >= 1000 {
            "a stop follows this move".to_string()
        } else {
            format!("{idle} {blocks} without motion follow this move; the control allows {limit}")
        };
        let diagnostic = Diagnostic::new(Code::LookAheadLost, origin.span, message)
            .label("the tool ends square to this move")
            .help("put the blocks without motion elsewhere");
        self.report(diagnostic, origin, out);
    }

    pub(super) fn too_many_idle(&self, origin: &Origin, out: &mut dyn PathSink) {
        let limit = super::queue::MAX_TRAILING;
        let message = format!("more than {limit} commands without motion while compensation is on");
        let diagnostic = Diagnostic::new(Code::TooManyIdleBlocks, origin.span, message)
            .help("cancel compensation with G40 first");
        self.report(diagnostic, origin, out);
    }

    pub(super) fn spiral(&self, origin: &Origin, out: &mut dyn PathSink) {
        let diagnostic = match self.rules.compensation.spirals {
            SpiralCompensation::Refused => {
                let message = "a spiral while compensation is on";
                Diagnostic::new(Code::SpiralInCompensation, origin.span, message)
                    .label("shown with the offset along the radius")
                    .help("program the tool-centre path for this spiral")
            }
            SpiralCompensation::ByCircles => {
                let message = "the control offsets this spiral along the radius, with circles through its ends";
                Diagnostic::new(Code::SpiralInCompensation, origin.span, message)
                    .severity(Severity::Note)
                    .label("the exact offset would be square to the spiral")
            }
        };
        self.report(diagnostic, origin, out);
    }

    pub(super) fn shift_refused(&self, origin: &Origin, out: &mut dyn PathSink) {
        let message = "the coordinates shift while compensation is on";
        let diagnostic = Diagnostic::new(Code::ShiftInCompensation, origin.span, message)
            .help("cancel compensation with G40 first");
        self.report(diagnostic, origin, out);
    }

    pub(super) fn turn_lost(&self, block: &QueuedBlock, out: &mut dyn PathSink) {
        let origin = &block.command.origin;
        let message = "with its offset this arc is longer than a full turn; the control runs only the part over one turn";
        let diagnostic = Diagnostic::new(Code::FullTurnLost, origin.span, message)
            .help("divide the circle, or lead out tangentially");
        self.report(diagnostic, origin, out);
    }
}

//! R0, RL and RR.

use chordal_command::{CommandKind, CompensationSide};
use chordal_diagnostics::{Code, Diagnostic};

use super::interpreter::KlartextInterpreter;
use crate::alarms::{COMPENSATION_UNDEFINED, TOOL_NOT_DEFINED, WRONGLY_ENDED, WRONGLY_STARTED};
use crate::syntax::{PathFunction, PathWords};

impl KlartextInterpreter<'_> {
    /// R0, RL and RR of a block.
    pub(super) fn set_compensation(&mut self, function: PathFunction, words: &PathWords) {
        let Some((side, range)) = words.side else { return };
        let before = self.programmed_side();
        if side == before {
            return;
        }
        let is_line = matches!(function, PathFunction::Line | PathFunction::PolarLine);
        if !is_line {
            let (alarm, what) = match side {
                CompensationSide::Off => (WRONGLY_ENDED, "ends"),
                _ => (WRONGLY_STARTED, "begins"),
            };
            let message = format!("tool radius compensation {what} on an arc");
            let diagnostic = Diagnostic::new(Code::CompensationOnArc, self.span(range), message);
            self.report_alarm(alarm, diagnostic.help("write it into a block with a straight line"));
        }
        if side != CompensationSide::Off && before != CompensationSide::Off {
            let message = "compensation changes from one side to the other";
            let diagnostic = Diagnostic::new(Code::SideChangeRefused, self.span(range), message);
            let help = "write a block with R0 between the two";
            self.report_alarm(COMPENSATION_UNDEFINED, diagnostic.help(help));
        }
        self.check_tool(side, range);
        self.switch_compensation(side);
    }

    /// M97 after the move of its block: the outside corner at its end is passed without an arc, which lets the tool into
    /// small steps. M98: the inside corner at its end is open, and is cut to the ends of both elements (TNC 620 81760x-02
    /// p. 370).
    pub(super) fn set_corner_mode(&mut self, words: &PathWords) {
        let has = |number: u32| words.functions.iter().any(|function| function.number == number);
        let (meets, opens) = (has(97), has(98));
        // A corner is made when the move after it is known, so that the mode stays for one move more.
        if (meets, opens) != (self.modes.meets_corner, self.modes.opens_corner) {
            (self.modes.meets_corner, self.modes.opens_corner) = (meets, opens);
            self.kernel.emit(CommandKind::CornerMode { meets, opens });
        }
        if opens && self.is_first_report("M98") {
            let message = "after M98 the manuals do not give the path from the end of this element to the next: it is assumed";
            let diagnostic = Diagnostic::new(Code::CyclePathAssumed, self.span(self.here), message);
            let help =
                "both elements are cut to their ends; the tool goes straight from one to the other";
            self.kernel.report(diagnostic.help(help));
        }
    }

    /// The side as programmed: a mirrored contour has the tool on its other side.
    pub(super) fn programmed_side(&self) -> CompensationSide {
        let plane = self.tool_plane();
        self.kernel.state.side.mirrored_if(self.modes.frame.in_plane(plane).is_mirrored())
    }

    pub(super) fn check_tool(
        &mut self,
        side: CompensationSide,
        range: chordal_diagnostics::TextRange,
    ) {
        let has_tool = self.modes.has_tool && self.kernel.state.tool != 0;
        if side != CompensationSide::Off && !has_tool {
            let message = "tool radius compensation begins, and no tool is in the spindle";
            self.alarm(TOOL_NOT_DEFINED, Code::CompensationWithoutOffset, range, message);
        }
    }

    /// Switches compensation of the next line.
    pub(super) fn switch_compensation(&mut self, side: CompensationSide) {
        let plane = self.tool_plane();
        let is_mirrored = self.modes.frame.in_plane(plane).is_mirrored();
        let side = side.mirrored_if(is_mirrored);
        self.kernel.state.side = side;
        let number = self.kernel.state.radius_offset.filter(|_| side != CompensationSide::Off);
        let span = self.span(self.here);
        self.kernel.emit_compensation(number, None, span);
    }

    /// The radius of the tool in programmed lengths, mm.
    pub(super) fn tool_radius_mm(&self) -> f64 {
        let number = self.kernel.state.radius_offset;
        let radius = number.and_then(|number| self.kernel.state.offsets.radius_mm(number));
        radius.unwrap_or(0.0) / self.modes.frame.factor(self.tool_plane())
    }
}

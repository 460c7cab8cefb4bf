//! Constant cutting speed (G96): spindle speeds near the centre, and holes in the centre.

use std::f64::consts::PI;

use chordal_command::{
    Command, CommandKind, Move, Origin, SpindleState, SurfaceSpeed, number_text,
};
use chordal_diagnostics::{Code, Diagnostic, Severity, TextShift};
use chordal_geometry::ParamCurve;
use chordal_geometry::tolerance::ROUNDING_SHARE;
use chordal_kernel::hole_at_surface_speed;

use super::RunChecks;
use crate::segment::curve_of;

/// A position with |X| up to this is in the centre, mm.
const CENTER_MM: f64 = 1e-6;

const X: usize = 0;
const Z: usize = 2;

/// What is remembered for the checks of a constant cutting speed.
#[derive(Clone, Debug, Default)]
pub(super) struct CuttingSpeedMemory {
    /// The spindle turns.
    turns: bool,
    /// The last motion was a rapid.
    after_rapid: bool,
    /// The tool for which a missing speed limit was reported last.
    reported_limit: Option<u32>,
    /// The tool for which a hole was reported last.
    reported_hole: Option<u32>,
    /// The first cut along Z in the centre after a rapid to it.
    in_center: Option<CenterCut>,
}

/// A cut along Z in the centre: a hole, if the tool moves back along Z after it.
#[derive(Clone, Copy, Debug)]
struct CenterCut {
    origin: Origin,
    /// The cut goes in the direction of Z plus.
    is_up: bool,
    surface: SurfaceSpeed,
}

impl CuttingSpeedMemory {
    /// Moves the positions in the text after an edit of other text; `None` if one of them was in the edited text.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        if let Some(cut) = &mut self.in_center {
            cut.origin = cut.origin.shifted(shift)?;
        }
        Some(())
    }
}

impl RunChecks<'_> {
    /// Follows the spindle and the motion of a command.
    pub(super) fn cutting_speed(&mut self, command: &Command, report: &mut impl FnMut(Diagnostic)) {
        if let CommandKind::Spindle { state, .. } = &command.kind {
            self.now.cutting_speed.turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
        }
        let Some(motion) = command.kind.motion() else { return };
        self.hole_in_center(command, motion, report);
        self.now.cutting_speed.after_rapid = command.kind.feed().is_none();
        let Some(surface) = command.kind.feed().and_then(|feed| feed.surface) else { return };
        if self.now.cutting_speed.turns && !surface.is_limited {
            self.speed_without_limit(command, motion, surface, report);
        }
    }

    /// Reports a cut so close to the centre that only the machine limits the spindle speed.
    #[cold]
    fn speed_without_limit(
        &mut self,
        command: &Command,
        motion: &Move,
        surface: SurfaceSpeed,
        report: &mut impl FnMut(Diagnostic),
    ) {
        let (tool, _) = self.now.tip.tool_and_offset();
        let is_known = motion.from_known.has(X) && motion.to_known.has(X);
        if !is_known || self.now.cutting_speed.reported_limit == Some(tool) {
            return;
        }
        let least = least_radius(command, motion);
        let free = SurfaceSpeed { most_rev_per_s: f64::INFINITY, ..surface }.rev_per_s(least);
        let most = surface.most_rev_per_s;
        let has_maximum = most.is_finite() && !self.assumed;
        let is_over = match has_maximum {
            true => free > most * (1.0 + ROUNDING_SHARE),
            // In the centre the speed exceeds any maximum.
            false => least <= CENTER_MM && surface.mm_per_s > 0.0,
        };
        if !is_over {
            return;
        }
        self.now.cutting_speed.reported_limit = Some(tool);
        let text = |mm: f64| self.now.units.length_text(mm);
        let to = match least <= CENTER_MM {
            true => "this cut goes to the centre".to_string(),
            false => format!("this cut goes to a diameter of {}", text(2.0 * least)),
        };
        let (message, label) = match has_maximum {
            true => {
                let diameter = text(surface.mm_per_s / (PI * most));
                let rpm = number_text(most * 60.0, 0);
                let message = format!(
                    "G96 without a limit of the speed: below a diameter of {diameter} the spindle turns at {rpm} rpm, the machine's maximum"
                );
                (message, to)
            }
            false => (
                format!(
                    "G96 without a limit of the speed: {to}, where the spindle turns at the machine's maximum"
                ),
                "nothing else limits it".to_string(),
            ),
        };
        let severity = if most.is_finite() { Severity::Warning } else { Severity::Note };
        let example = self.speed_limit_example;
        report(
            Diagnostic::new(Code::SpeedWithoutLimit, command.origin.span, message)
                .severity(severity)
                .label(label)
                .help(format!(
                    "write `{example}` before it, with the largest speed that chuck and part allow"
                )),
        );
    }

    /// Finds a cut along Z in the centre and back out again: a drill, a tap or a reamer.
    fn hole_in_center(
        &mut self,
        command: &Command,
        motion: &Move,
        report: &mut impl FnMut(Diagnostic),
    ) {
        let known = motion.from_known.and(motion.to_known);
        let centered =
            known.has(X) && motion.from[X].abs() <= CENTER_MM && motion.to[X].abs() <= CENTER_MM;
        let path = motion.to[Z] - motion.from[Z];
        if !centered || path == 0.0 {
            if !centered {
                self.now.cutting_speed.in_center = None;
            }
            return;
        }
        let memory = &mut self.now.cutting_speed;
        let surface = command.kind.feed().and_then(|feed| feed.surface);
        if let Some(cut) = memory.in_center {
            if (path > 0.0) != cut.is_up {
                memory.in_center = None;
                self.report_hole(cut, report);
            }
        } else if let Some(surface) = surface
            && memory.turns
            && memory.after_rapid
            // The drilling cycles report this themselves.
            && !command.origin.cycle
            && matches!(command.kind, CommandKind::Line { .. })
        {
            memory.in_center =
                Some(CenterCut { origin: command.origin, is_up: path > 0.0, surface });
        }
    }

    fn report_hole(&mut self, cut: CenterCut, report: &mut impl FnMut(Diagnostic)) {
        let (tool, _) = self.now.tip.tool_and_offset();
        if self.now.cutting_speed.reported_hole.replace(tool) == Some(tool) {
            return;
        }
        let most = cut.surface.most_rev_per_s * 60.0;
        let is_known = most.is_finite() && (cut.surface.is_limited || !self.assumed);
        let rpm = is_known.then_some(most);
        report(hole_at_surface_speed(cut.origin.span, "a hole in the centre", rpm));
    }
}

/// The smallest distance of a cut from the spindle axis, mm.
fn least_radius(command: &Command, motion: &Move) -> f64 {
    let Some(shape) = command.kind.shape() else { return motion.least_radius() };
    let bounds = curve_of(motion, Some(shape)).bounds();
    match bounds.min.x <= 0.0 && bounds.max.x >= 0.0 {
        true => 0.0,
        false => bounds.min.x.abs().min(bounds.max.x.abs()),
    }
}

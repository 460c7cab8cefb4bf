//! Finds the first move near the part for which the tip is not where the program assumes it to be.

use chordal_command::{Command, CommandKind};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_geometry::Vec3;
use chordal_machine::{Axis, Machine, Tool};

use super::RunChecks;
use crate::tip::{TipDoubt, TipPlace};

const Z: usize = Axis::Z as usize;

/// Radii that differ by less are equal, mm.
const EQUAL_RADIUS_MM: f64 = 1e-5;

impl RunChecks<'_> {
    /// Checks the position of the tip; each pair of tool and length offset is reported once.
    #[cold]
    pub(super) fn tip(&mut self, command: &Command, report: &mut impl FnMut(Diagnostic)) {
        let place = self.now.tip.place();
        let pair = self.now.tip.tool_and_offset();
        if !self.is_near_part(&command.kind, place) {
            return;
        }
        self.now.tip.set_reported();
        let span = command.origin.span;
        let (tool, number) = pair;
        let active = match number {
            Some(number) => format!("length offset {number} is in force"),
            None => "no length offset is in force".to_string(),
        };
        let diagnostic = match place {
            TipPlace::Shifted(by) => {
                let message =
                    format!("the tip of tool {tool} is {}: {active}", self.deviation_text(by));
                Diagnostic::new(Code::TipDisplaced, span, message)
                    .label(self.tip_label(&command.kind, by))
                    .help(self.lengths_help(tool, number))
            }
            TipPlace::Unknown(doubt) => {
                let why = match doubt {
                    TipDoubt::NoLength => active,
                    TipDoubt::LeftInForce => {
                        "the length that the program before this one left in force is active"
                            .to_string()
                    }
                    TipDoubt::OtherTool => format!("{active}, which is that of another tool"),
                    TipDoubt::OtherSign => {
                        format!("{active} with the other sign than lengths before (G43, G44)")
                    }
                };
                let message = format!("where the tip of tool {tool} is is not known: {why}");
                Diagnostic::new(Code::TipNotKnown, span, message)
                    .label("the first move near the part with it")
                    .help(format!(
                        "bring the length of tool {tool} into force before; where the work offset is set with each \
                         tool, set `tool_lengths` to `touched-off`"
                    ))
            }
            TipPlace::Assumed => {
                let message = format!(
                    "no length offset is in force for tool {tool}, and its length is not given"
                );
                Diagnostic::new(Code::TipNotKnown, span, message)
                    .severity(Severity::Note)
                    .label("right only if Z0 was set with this tool")
                    .help("bring its length into force before; where the work offset is set with each tool, set \
                           `tool_lengths` to `touched-off`")
            }
            TipPlace::AsProgrammed => return,
        };
        report(diagnostic);
    }

    /// Reports a radius offset that belongs to another tool.
    #[cold]
    pub(super) fn radius_of_other_tool(
        &mut self,
        command: &Command,
        offset: u32,
        radius_mm: Option<f64>,
        report: &mut impl FnMut(Diagnostic),
    ) {
        let (tool, _) = self.now.tip.tool_and_offset();
        // A number of no tool in the program may be another offset of this tool, for example for a roughing pass.
        let is_other = offset != tool && self.now.tip.has_used(offset);
        if tool == 0 || !is_other || self.machine.turns() {
            return;
        }
        let own_mm = self.machine.tools.get(&tool).and_then(Tool::radius_mm);
        let text = |mm: f64| self.now.units.length_text(mm);
        let (severity, why) = match (own_mm, radius_mm) {
            (Some(own), Some(other)) if (own - other).abs() < EQUAL_RADIUS_MM => return,
            (Some(own), Some(other)) => {
                let why = format!("its radius is {}, that of D{offset} {}", text(own), text(other));
                (Severity::Error, why)
            }
            _ => (Severity::Warning, "the machine file does not give both radii".to_string()),
        };
        let message = format!("tool {tool} cuts with D{offset}, the radius of another tool");
        let diagnostic = Diagnostic::new(Code::RadiusOfOtherTool, command.origin.span, message);
        report(
            diagnostic
                .severity(severity)
                .note(why)
                .help(format!("write D{tool}, where offsets have the numbers of their tools")),
        );
    }

    /// True for a cut, and for a rapid that is not a retract and ends with the tip below the clearance plane.
    fn is_near_part(&self, kind: &CommandKind, place: TipPlace) -> bool {
        let Some(motion) = kind.motion() else { return false };
        if kind.feed().is_some() {
            return !kind.only_turns();
        }
        let by = match place {
            TipPlace::Shifted(by) => by.z,
            _ => 0.0,
        };
        let is_retract = motion.from[..2] == motion.to[..2] && motion.to[Z] >= motion.from[Z];
        !is_retract && motion.to_known.has(Z) && motion.to[Z] + by < self.depth_mm()
    }

    /// The deviation of the tip as text: `200 mm below the programmed point`.
    fn deviation_text(&self, by: Vec3) -> String {
        let units = self.now.units;
        if by.z != 0.0 && !self.machine.turns() {
            let side = if by.z < 0.0 { "below" } else { "above" };
            return format!("{} {side} the programmed point", units.length_text(by.z.abs()));
        }
        let axes = [("X", by.x), ("Y", by.y), ("Z", by.z)];
        let moved = axes.into_iter().filter(|(_, by)| *by != 0.0);
        let moved: Vec<String> =
            moved.map(|(axis, by)| format!("{axis} {}", units.length_text(by))).collect();
        format!("{} from the programmed point", moved.join(", "))
    }

    fn tip_label(&self, kind: &CommandKind, by: Vec3) -> String {
        match kind.motion() {
            Some(motion) if !self.machine.turns() && motion.to_known.has(Z) => {
                let z = self.now.units.length_text(motion.to[Z] + by.z);
                format!("the tip goes to Z {z}")
            }
            _ => "the first move near the part with it".to_string(),
        }
    }

    /// A help text with the known lengths and what to change.
    fn lengths_help(&self, tool: u32, number: Option<u32>) -> String {
        let length =
            |number: u32| length_of(self.machine, number).map(|mm| self.now.units.length_text(mm));
        let own = match length(tool).filter(|_| !self.machine.turns()) {
            Some(own) => format!("tool {tool} is {own} long"),
            None => format!("the machine file gives the offset of tool {tool}"),
        };
        let other = number.filter(|number| *number != tool).and_then(|number| {
            let length = length(number).filter(|_| !self.machine.turns())?;
            Some(format!(", offset {number} is {length}"))
        });
        let other = other.unwrap_or_default();
        format!("{own}{other}; bring the offset of tool {tool} into force before this move")
    }
}

fn length_of(machine: &Machine, number: u32) -> Option<f64> {
    machine.tools.get(&number)?.offset_of(Z)
}

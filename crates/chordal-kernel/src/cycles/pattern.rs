//! Holes at computed places, and what ends a cycle.

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Diagnostic, Span};

use super::bore::plane_axes;
use super::hole::HoleWords;
use crate::frames::sin_cos_degrees;
use crate::kernel::Kernel;
use crate::state::ModalMotion;
use crate::statement::Statement;

impl Kernel<'_> {
    /// Holes at polar places (mm, degrees) about the place where the tool stands.
    pub fn holes_about_here(
        &mut self,
        at: &dyn Statement,
        count: u32,
        place: impl Fn(u32) -> (f64, f64),
    ) {
        let Some(hole) = self.resolve_hole(at) else { return };
        let center = self.state.position;
        let [a, b] = plane_axes(hole.axis);
        for index in 0..count {
            if index > 0 && !self.count_repeated() {
                return;
            }
            let (radius, degrees) = place(index);
            let (sin, cos) = sin_cos_degrees(degrees);
            let mut target = center;
            target[a] += radius * cos;
            target[b] += radius * sin;
            self.drill_at(at, &hole, target);
        }
    }

    /// One hole of the cycle in force at a place (program coordinates; the drilling axis is
    /// left out of account). False where the control refuses the hole.
    pub fn fire_hole_at(&mut self, at: &dyn Statement, place: Position) -> bool {
        let Some(hole) = self.resolve_hole(at) else { return false };
        self.drill_at(at, &hole, place);
        true
    }

    /// The same, for a hole that is resolved once and made at many places.
    pub fn drill_at(&mut self, at: &dyn Statement, hole: &HoleWords, place: Position) {
        let named = self.state.known.without(AxisMask(1 << hole.axis));
        self.drill(at, hole, place, named);
    }

    /// A code that drills, and no cycle is in force.
    pub fn report_no_cycle(&mut self, span: Span, message: &str) {
        self.report(
            Diagnostic::new(Code::NoCycle, span, message)
                .label("nothing is drilled")
                .help("define the cycle (G81 …) in a block before this one"),
        );
    }

    /// Something other than G80 that ends a cycle on this control.
    pub fn end_cycle_if(&mut self, ends: bool) {
        if ends {
            self.state.cycle = None;
        }
    }

    /// G80.
    pub fn cancel_cycle(&mut self) {
        self.state.cycle = None;
        if self.rules.cycles.one_group_with_motion {
            self.state.motion = ModalMotion::None;
        }
    }
}

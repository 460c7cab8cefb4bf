//! Bore milling of Fadal: L94NN counter-clockwise, L95NN clockwise, NN passes.

use chordal_command::AxisMask;
use chordal_geometry::{TurnDirection, Vec2};
use chordal_kernel::shapes::{Step, rings};
use chordal_syntax::{Block, Word};

use crate::interpreter::Interpreter;

impl Interpreter<'_> {
    /// From the centre to the wall by a half circle, `count` full circles, and back by a half circle. R0 is the feed; the
    /// word of the diameter is a setting, because no manual text was found.
    pub(super) fn bore_routine(
        &mut self,
        block: &Block,
        word: &Word,
        direction: TurnDirection,
        count: u32,
    ) {
        let register = self.control.parameters.bore_diameter_register;
        let Some(feed) = self.routine_start(block, word, &[0, register]) else { return };
        let Some(tool) = self.routine_tool(word) else { return };
        let Some(diameter) = self.register_length(block, register) else { return };
        if !self.fits(block, word, (register, diameter), tool) {
            return;
        }
        if count == 0 {
            return self.report_no_passes(word);
        }
        let radius = 0.5 * diameter - tool;
        if radius <= 0.0 {
            return;
        }
        let name = format!("L{}", self.routine_number(word));
        let choice = "half circles in and out, and the passes between them, are shown";
        let label = format!("R{register} is assumed to be the diameter");
        self.kernel.note_assumed_path(self.span(word.range), &name, choice, label);
        let center = Vec2::new(self.kernel.state.position[0], self.kernel.state.position[1]);
        let path = rings(&[radius], count, direction);
        let placed: Vec<Step> = path.iter().map(|step| step.shifted(center)).collect();
        self.kernel.follow(&placed, self.kernel.routine_feed(feed), AxisMask::NONE);
    }
}

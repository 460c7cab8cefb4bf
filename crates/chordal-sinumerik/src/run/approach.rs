//! KONT: where the approach and the departure are as with NORM, and where they are not.

use chordal_command::CompensationSide;
use chordal_diagnostics::TextRange;

use super::interpreter::Interpreter;
use super::run_state::OpenApproach;
use super::words::BlockWords;

impl Interpreter<'_> {
    /// Notes with which move compensation begins, and looks at the one with which it ends. With KONT the tool goes round
    /// the start of the contour if it comes from behind it; from its front it goes straight, as with NORM
    /// (Fundamentals 11/2006, 8.3).
    pub(super) fn note_approach(
        &mut self,
        side: CompensationSide,
        range: TextRange,
        words: &BlockWords,
    ) {
        if !self.modes.approaches_round {
            return;
        }
        let (a, b, _) = self.kernel.state.plane.axes();
        let place = self.kernel.state.position;
        let before = self.kernel.state.side.sign();
        if side != CompensationSide::Off {
            self.modes.open_approach =
                Some(OpenApproach { from: [place[a], place[b]], side: side.sign(), range });
            return;
        }
        let Some(along) = self.modes.last_direction else { return };
        let start = self.programmed_position();
        let incremental = self.kernel.state.incremental;
        let end = [a, b].map(|axis| {
            words.axes[axis].map_or(start[axis], |word| {
                word.coordinate(start[axis], self.unit_of_axis(axis, &word), incremental)
            })
        });
        let away = [end[0] - start[a], end[1] - start[b]];
        let is_on_side = before * (along[a] * away[1] - along[b] * away[0]) >= 0.0;
        let is_ahead = along[a] * away[0] + along[b] * away[1] >= 0.0;
        if !is_on_side || !is_ahead {
            self.report_round_approach(range);
        }
    }

    /// The direction in which the contour begins: decides whether the approach was from its front.
    pub(super) fn contour_begins(&mut self, start: [f64; 2], along: [f64; 2]) {
        let Some(open) = self.modes.open_approach.take() else { return };
        let from = [open.from[0] - start[0], open.from[1] - start[1]];
        // Whether the front ends at the tangent or at the normal of the contour is not sure: both must hold.
        let is_on_side = open.side * (along[0] * from[1] - along[1] * from[0]) >= 0.0;
        let is_before = along[0] * from[0] + along[1] * from[1] <= 0.0;
        if !is_on_side || !is_before {
            self.report_round_approach(open.range);
        }
    }

    fn report_round_approach(&mut self, range: TextRange) {
        let what = "KONT from behind the contour is not followed: the tool is drawn as with NORM";
        self.not_followed(range, what);
    }
}

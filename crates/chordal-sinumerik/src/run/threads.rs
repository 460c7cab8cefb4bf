//! Moves in step with the spindle: G33, G331, G332 and G63.

use chordal_command::FeedMode;
use chordal_diagnostics::{Code, TextRange};

use super::interpreter::Interpreter;
use super::motion::BlockTarget;
use super::words::{BlockStatementView, BlockWords};

impl Interpreter<'_> {
    /// A straight move whose feed follows from the lead (I, J or K, mm per revolution) and the speed of the spindle.
    pub(super) fn thread_move(
        &mut self,
        view: &BlockStatementView<'_>,
        range: TextRange,
        words: &BlockWords,
        target: &BlockTarget,
    ) {
        let lead = (0..3).find_map(|axis| Some((axis, words.centers[axis]?)));
        let lead = match lead {
            Some((axis, word)) => (axis, word.value.abs() * self.unit_mm()),
            None => match self.modes.lead {
                Some(lead) => lead,
                None => {
                    let message = "a thread needs its lead: I, J or K";
                    self.alarm(12110, Code::MissingWord, range, message);
                    return self.kernel.straight(view, target.end, target.named);
                }
            },
        };
        self.modes.lead = Some(lead);
        if self.kernel.state.rpm <= 0.0 && !self.kernel.state.unknown.speed {
            let message = "a thread, and the spindle has no speed";
            self.alarm(10900, Code::SpindleStopped, range, message);
        }
        let (axis, lead_mm) = lead;
        let start = self.kernel.state.position;
        let along = |axis: usize| (target.end[axis] - start[axis]).abs();
        let length = (0..3).map(|axis| along(axis) * along(axis)).sum::<f64>().sqrt();
        // The lead is that of its axis; the path is longer on a taper.
        let factor = if along(axis) > 0.0 { length / along(axis) } else { 1.0 };
        let speed = lead_mm * factor * self.kernel.state.rpm / 60.0;
        self.with_path_speed(speed, |own| own.kernel.straight(view, target.end, target.named));
    }

    /// Carries out moves at a path speed of their own, mm/s, whatever feed is in force.
    pub(super) fn with_path_speed(&mut self, mm_per_s: f64, moves: impl FnOnce(&mut Self)) {
        let state = &mut self.kernel.state;
        let (feed, mode) = (state.feed.replace(mm_per_s), state.feed_mode);
        state.feed_mode = FeedMode::PerTime;
        moves(self);
        (self.kernel.state.feed, self.kernel.state.feed_mode) = (feed, mode);
    }
}

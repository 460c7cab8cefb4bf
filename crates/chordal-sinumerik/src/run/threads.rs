//! Moves in step with the spindle: G33, G34, G35, G331, G332 and G63.

use chordal_command::FeedMode;
use chordal_diagnostics::{Code, Diagnostic, TextRange};

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
        let Some((axis, lead_mm)) = self.thread_lead(range, words) else {
            return self.kernel.straight(view, target.end, target.named);
        };
        let speed = lead_mm * self.path_per_axis(axis, target) * self.kernel.state.rpm / 60.0;
        self.with_path_speed(speed, |own| own.kernel.straight(view, target.end, target.named));
    }

    /// A thread whose lead changes by F in each revolution, mm: it grows with G34 and becomes less with G35.
    pub(super) fn changing_thread_move(
        &mut self,
        view: &BlockStatementView<'_>,
        range: TextRange,
        words: &BlockWords,
        target: &BlockTarget,
        grows: bool,
    ) {
        let Some((axis, first_mm)) = self.thread_lead(range, words) else {
            return self.kernel.straight(view, target.end, target.named);
        };
        // Whether F holds for the cuts after the thread is not known.
        let change = words.other("F").map_or(0.0, |word| word.value.abs() * self.unit_mm());
        self.kernel.set_unknown_feed();
        let change = if grows { change } else { -change };
        let along_mm = (target.end[axis] - self.kernel.state.position[axis]).abs();
        // The lead grows evenly with the revolutions, so its square grows evenly with the path.
        let last_squared = first_mm * first_mm + 2.0 * change * along_mm;
        if last_squared <= 0.0 {
            let span = self.span(range);
            let ends_mm = first_mm * first_mm / (2.0 * change.abs());
            let message = format!(
                "the lead of the thread becomes zero after {} of {}",
                self.kernel.length_text(ends_mm),
                self.kernel.length_text(along_mm)
            );
            let diagnostic = Diagnostic::new(Code::BadWordValue, span, message);
            self.kernel.report(diagnostic.help("give a smaller F, or a shorter thread"));
            return self.kernel.straight(view, target.end, target.named);
        }
        let mean_mm = 0.5 * (first_mm + last_squared.sqrt());
        let along_path = self.path_per_axis(axis, target);
        let leads_mm = [mean_mm, change].map(|mm| mm * along_path);
        self.kernel.changing_thread(target.end, target.named, leads_mm);
    }

    /// The lead of a thread and its axis: of this block, or the last one. `None`, and an alarm, without any.
    fn thread_lead(&mut self, range: TextRange, words: &BlockWords) -> Option<(usize, f64)> {
        let own = (0..3).find_map(|axis| Some((axis, words.centers[axis]?)));
        let own = own.map(|(axis, word)| (axis, word.value.abs() * self.unit_mm()));
        let Some(lead) = own.or(self.modes.lead) else {
            self.alarm(12110, Code::MissingWord, range, "a thread needs its lead: I, J or K");
            return None;
        };
        self.modes.lead = Some(lead);
        if self.kernel.state.rpm <= 0.0 && !self.kernel.state.unknown.speed {
            let message = "a thread, and the spindle has no speed";
            self.alarm(10900, Code::SpindleStopped, range, message);
        }
        Some(lead)
    }

    /// The length of the path for each unit of an axis: the lead is that of its axis, and the path is longer on a taper.
    fn path_per_axis(&self, axis: usize, target: &BlockTarget) -> f64 {
        let start = self.kernel.state.position;
        let along = |axis: usize| (target.end[axis] - start[axis]).abs();
        let length = (0..3).map(|axis| along(axis) * along(axis)).sum::<f64>().sqrt();
        if along(axis) > 0.0 { length / along(axis) } else { 1.0 }
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

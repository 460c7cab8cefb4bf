//! Cuts synchronized with the spindle: their feed is the lead, and no override acts.

use chordal_command::{AxisMask, CommandKind, Feed, FeedAlong, FeedMode, Position, SpindleState};

use crate::kernel::Kernel;
use crate::statement::Statement;

impl Kernel<'_> {
    /// Makes a straight cut that advances by `lead_mm` along its path per revolution of the spindle.
    pub fn thread(&mut self, target: Position, named: AxisMask, lead_mm: f64) {
        self.changing_thread(target, named, [lead_mm, 0.0]);
    }

    /// The same with a changing lead: its mean along the path, mm, and its change per revolution, mm.
    pub fn changing_thread(
        &mut self,
        target: Position,
        named: AxisMask,
        [lead_mm, change_mm]: [f64; 2],
    ) {
        self.check_thread_speed();
        self.set_in_tap(true);
        self.in_step(target, named, [lead_mm, change_mm], 1.0);
        self.set_in_tap(false);
    }

    /// Cuts a thread in and returns to its start with the spindle reversed, `out_factor` times as fast.
    pub fn rigid_tap(&mut self, target: Position, named: AxisMask, lead_mm: f64, out_factor: f64) {
        let start = self.state.position;
        let (inward, rpm) = (self.state.spindle, self.state.rpm);
        let outward =
            if inward == SpindleState::Ccw { SpindleState::Cw } else { SpindleState::Ccw };
        self.set_in_tap(true);
        self.in_step(target, named, [lead_mm, 0.0], 1.0);
        self.emit(CommandKind::Spindle { state: outward, rpm: rpm * out_factor });
        self.in_step(start, named, [lead_mm, 0.0], out_factor);
        self.emit(CommandKind::Spindle { state: inward, rpm });
        self.set_in_tap(false);
    }

    /// Reports a synchronized cut without a running spindle.
    pub(crate) fn require_spindle(&mut self, at: &dyn Statement) {
        let turns = matches!(self.state.spindle, SpindleState::Cw | SpindleState::Ccw);
        if !turns {
            self.report_spindle_stopped(at);
        }
    }

    fn in_step(
        &mut self,
        target: Position,
        named: AxisMask,
        [lead_mm, change_mm]: [f64; 2],
        factor: f64,
    ) {
        let motion = self.moved_to(target, named);
        let feed = Feed {
            value: lead_mm,
            mode: FeedMode::PerRevolution,
            along: FeedAlong::Path,
            spindle_rev_per_s: self.rev_per_s(motion.from[0]) * factor,
            lead_change: change_mm,
            surface: None,
        };
        self.check_feed_in_step(&motion, &feed);
        self.emit(CommandKind::Line { motion, feed });
    }
}

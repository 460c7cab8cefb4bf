//! Boring with a standing or oriented spindle: G86, G88, G76, G87 (Haas G77).

use chordal_command::{AxisMask, CommandKind, Position, SpindleState};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_machine::AXES;

use super::hole::HoleWords;
use crate::kernel::Kernel;
use crate::rules::{BackBore, ShiftWords};
use crate::statement::Statement;

impl Kernel<'_> {
    /// G86: the spindle stops at the bottom, rapid out.
    pub fn bore_and_stop(&mut self, at: &dyn Statement, hole: &HoleWords) {
        let rules = self.rules.cycles.bore;
        let spindle = self.state.spindle;
        let turns = matches!(spindle, SpindleState::Cw | SpindleState::Ccw);
        if rules.spindle_must_turn && !turns {
            let span = at.span();
            self.report(
                Diagnostic::new(
                    Code::CycleSpindle,
                    span,
                    "the spindle must turn before this cycle, which stops it at the bottom",
                )
                .help("write S and M3 before the cycle"),
            );
        }
        self.feed_to(at, hole, hole.z);
        if rules.dwell_before_stop {
            self.wait(hole.words.dwell_s);
        }
        self.turn_spindle(SpindleState::Off);
        self.level(hole, hole.clear);
        self.turn_spindle(spindle);
    }

    /// G88: the operator draws the tool out; shown as a rapid, which is where it ends.
    pub fn bore_by_hand(&mut self, at: &dyn Statement, hole: &HoleWords) {
        let spindle = self.state.spindle;
        self.feed_to(at, hole, hole.z);
        self.wait(hole.words.dwell_s);
        self.turn_spindle(SpindleState::Off);
        self.emit(CommandKind::Stop { optional: false });
        self.level(hole, hole.clear);
        self.turn_spindle(spindle);
    }

    /// G76: the tip steps off the wall before the way out.
    pub fn fine_bore(&mut self, at: &dyn Statement, hole: &HoleWords) {
        let spindle = self.state.spindle;
        let shift = self.shift(at, hole);
        let at_feed = self.rules.cycles.bore.shift_at_feed;
        self.feed_to(at, hole, hole.z);
        self.wait(hole.words.dwell_s);
        self.turn_spindle(SpindleState::Oriented);
        if at_feed {
            self.step_aside_at_feed(at, hole, shift);
        } else {
            self.step_aside(hole, shift);
        }
        self.level(hole, hole.clear);
        self.step_aside(hole, shift.map(|part| -part));
        self.turn_spindle(spindle);
    }

    /// G87: a bore that is cut upwards, from behind.
    pub fn back_bore(&mut self, at: &dyn Statement, hole: &HoleWords) {
        let shift = self.shift(at, hole);
        let back = shift.map(|part| -part);
        // The cut needs a turning spindle, whatever it did before.
        let turning = match self.state.spindle {
            SpindleState::Ccw => SpindleState::Ccw,
            _ => SpindleState::Cw,
        };
        match self.rules.cycles.bore.back {
            BackBore::ShiftAtInitial => {
                self.turn_spindle(SpindleState::Oriented);
                self.step_aside(hole, shift);
                self.level(hole, hole.r);
                self.step_aside(hole, back);
                self.turn_spindle(turning);
                self.feed_to(at, hole, hole.z);
                self.wait(hole.words.dwell_s);
                self.turn_spindle(SpindleState::Oriented);
                self.step_aside(hole, shift);
            }
            BackBore::ShiftAtR => {
                self.turn_spindle(SpindleState::Oriented);
                self.step_aside(hole, shift);
                self.turn_spindle(turning);
                self.feed_to(at, hole, hole.z);
                self.wait(hole.words.dwell_s);
                self.turn_spindle(SpindleState::Oriented);
                self.step_aside(hole, back);
                self.level(hole, hole.clear);
                return self.turn_spindle(turning);
            }
            BackBore::UpAndDown => {
                let top = self.top_of_bore(at, hole);
                self.step_aside(hole, shift);
                self.orient_from_stop();
                self.level(hole, hole.z);
                self.step_aside(hole, back);
                self.turn_spindle(turning);
                self.feed_to(at, hole, top);
                self.feed_to(at, hole, hole.z);
                self.orient_from_stop();
                self.step_aside(hole, shift);
            }
        }
        self.level(hole, hole.clear);
        self.step_aside(hole, back);
        self.turn_spindle(turning);
    }

    fn orient_from_stop(&mut self) {
        self.turn_spindle(SpindleState::Off);
        self.turn_spindle(SpindleState::Oriented);
    }

    /// The upper end of the bore: K, in G18 J and in G19 I; in G91 from the depth.
    fn top_of_bore(&mut self, at: &dyn Statement, hole: &HoleWords) -> f64 {
        match hole.words.vector[hole.axis] {
            Some(top) if self.state.incremental => hole.z + top,
            Some(top) => top,
            None => {
                let span = at.span();
                let letter = ["I", "J", "K"][hole.axis];
                let message = format!("back boring without {letter}");
                let help = format!("give the upper end of the bore with {letter}");
                self.missing_word(span, message, &help);
                hole.z
            }
        }
    }

    /// How far the tool steps aside along the two axes of the plane, mm.
    fn shift(&mut self, at: &dyn Statement, hole: &HoleWords) -> [f64; 2] {
        let rules = self.rules.cycles.bore;
        let [a, b] = plane_axes(hole.axis);
        let q = hole.words.q.map(f64::abs).filter(|_| rules.shift != ShiftWords::Vector);
        let vector = match (hole.words.vector[a], hole.words.vector[b]) {
            (None, None) => None,
            (a, b) => Some([a.unwrap_or(0.0), b.unwrap_or(0.0)]),
        };
        let by_q = q.map(|q| {
            let part = if rules.direction.minus { -q } else { q };
            if rules.direction.second { [0.0, part] } else { [part, 0.0] }
        });
        let found = match rules.shift {
            ShiftWords::Q => by_q,
            ShiftWords::Vector => vector,
            ShiftWords::QOrVector => by_q.or(vector),
        };
        found.unwrap_or_else(|| {
            let words = match rules.shift {
                ShiftWords::Q => "Q",
                ShiftWords::Vector => "I and J",
                ShiftWords::QOrVector => "Q, or I and J",
            };
            let span = at.span();
            self.report(
                Diagnostic::new(
                    Code::CycleWithoutShift,
                    span,
                    "boring with an oriented spindle, without a shift",
                )
                .label("the tip stays at the wall during the retract")
                .help(format!("give the shift with {words}")),
            );
            [0.0; 2]
        })
    }

    fn aside(&self, hole: &HoleWords, shift: [f64; 2]) -> (Position, AxisMask) {
        let mut target = self.state.position;
        let mut named = AxisMask::NONE;
        let axes = plane_axes(hole.axis);
        let mut path = [0.0; AXES];
        for (axis, part) in axes.into_iter().zip(shift) {
            path[axis] = part;
        }
        // The tip points where the spindle stands, whatever frame the program is in.
        if !self.state.frames.is_plain() {
            path = self.state.frames.inverse().vector(&path);
        }
        for axis in axes {
            target[axis] += path[axis];
            if path[axis] != 0.0 && self.state.known.has(axis) {
                named.insert(axis);
            }
        }
        (target, named)
    }

    fn step_aside(&mut self, hole: &HoleWords, shift: [f64; 2]) {
        let (target, named) = self.aside(hole, shift);
        self.rapid_to(target, named);
    }

    fn step_aside_at_feed(&mut self, at: &dyn Statement, hole: &HoleWords, shift: [f64; 2]) {
        let (target, named) = self.aside(hole, shift);
        if target != self.state.position {
            self.line(at, target, named);
        }
    }
}

/// The axes of the plane across a drilling axis, in the order of the plane.
pub(super) fn plane_axes(axis: usize) -> [usize; 2] {
    match axis {
        0 => [1, 2],
        1 => [2, 0],
        _ => [0, 1],
    }
}

//! The moves of a cycle.

use chordal_command::{AxisMask, CommandKind, FeedMode, SpindleState};
use chordal_geometry::TurnDirection;

use super::interpreter::KlartextInterpreter;
use crate::cycles::{CycleFeed, KlartextCycleStep};
use crate::geometry::ContourElement;

impl KlartextInterpreter<'_> {
    /// Carries out the steps of a cycle.
    pub(super) fn run_steps(&mut self, steps: &[KlartextCycleStep]) {
        let start = self.programmed();
        let (a, b, normal) = self.tool_plane().axes();
        let hole = [start[a], start[b]];
        let spindle = self.kernel.state.spindle;
        self.kernel.origin.cycle = true;
        for step in steps {
            let now = self.programmed();
            let mut place = [now[0], now[1], now[2]];
            match *step {
                KlartextCycleStep::Rapid(level) => {
                    place[normal] = level;
                    self.rapid_to(place, AxisMask::LINEAR);
                }
                KlartextCycleStep::Feed { to, feed } => {
                    place[normal] = to;
                    self.cycle_move(place, feed);
                }
                KlartextCycleStep::Across { offset, feed } => {
                    (place[a], place[b]) = (hole[0] + offset[0], hole[1] + offset[1]);
                    self.cycle_move(place, feed);
                }
                KlartextCycleStep::Arc { center, end, sweep_rad, feed } => {
                    (place[a], place[b]) = (hole[0] + end[0], hole[1] + end[1]);
                    let center = [hole[0] + center[0], hole[1] + center[1]];
                    self.cycle_arc(center, place, sweep_rad, feed);
                }
                KlartextCycleStep::Ramp { offset, to, feed } => {
                    (place[a], place[b]) = (hole[0] + offset[0], hole[1] + offset[1]);
                    place[normal] = to;
                    self.cycle_move(place, feed);
                }
                KlartextCycleStep::ArcRamp { center, end, sweep_rad, to, feed } => {
                    (place[a], place[b]) = (hole[0] + end[0], hole[1] + end[1]);
                    place[normal] = to;
                    let center = [hole[0] + center[0], hole[1] + center[1]];
                    self.cycle_arc(center, place, sweep_rad, feed);
                }
                KlartextCycleStep::Turn { state, rpm } => {
                    if let Some(rpm) = rpm {
                        self.kernel.set_speed(rpm);
                    }
                    self.kernel.set_spindle(state);
                }
                KlartextCycleStep::Coolant(function) => self.cycle_coolant(function),
                KlartextCycleStep::Helix { sweep_rad, to, feed } => {
                    self.cycle_helix(hole, sweep_rad, to, feed);
                }
                KlartextCycleStep::Dwell(seconds) => {
                    self.kernel.emit(CommandKind::Dwell { seconds, label: None });
                }
                KlartextCycleStep::Orient => self.kernel.set_spindle(SpindleState::Oriented),
                KlartextCycleStep::SpindleOn => self.kernel.set_spindle(spindle),
                KlartextCycleStep::Reverse => self.kernel.set_spindle(match spindle {
                    SpindleState::Cw => SpindleState::Ccw,
                    SpindleState::Ccw => SpindleState::Cw,
                    other => other,
                }),
            }
        }
        self.kernel.origin.cycle = false;
        self.modes.contour.direction = None;
    }

    /// Makes moves at a feed of the cycle, with that of the program restored after them.
    fn with_cycle_feed(&mut self, feed: CycleFeed, moves: impl FnOnce(&mut Self)) {
        let kept = (self.kernel.state.feed, self.kernel.state.feed_mode);
        if let CycleFeed::Speed(speed) = feed {
            self.kernel.state.feed = Some(speed);
            self.kernel.state.feed_mode = FeedMode::PerTime;
        }
        moves(self);
        (self.kernel.state.feed, self.kernel.state.feed_mode) = kept;
    }

    fn cycle_move(&mut self, place: [f64; 3], feed: CycleFeed) {
        if feed == CycleFeed::Rapid {
            return self.rapid_to(place, AxisMask::LINEAR);
        }
        self.with_cycle_feed(feed, |own| own.feed_to(place, AxisMask::LINEAR));
    }

    /// An arc in the plane.
    fn cycle_arc(&mut self, center: [f64; 2], place: [f64; 3], sweep_rad: f64, feed: CycleFeed) {
        let plane = self.tool_plane();
        let mut end = self.programmed();
        end[..3].copy_from_slice(&place);
        let element = ContourElement::Arc { plane, center, sweep_rad, end: place };
        self.with_cycle_feed(feed, |own| {
            own.move_along(None, &element, end, AxisMask::LINEAR, false);
        });
    }

    /// A helix about a hole, counter-clockwise.
    fn cycle_helix(&mut self, hole: [f64; 2], sweep_rad: f64, to: f64, feed: CycleFeed) {
        let plane = self.tool_plane();
        let (a, b, normal) = plane.axes();
        let mut end = self.programmed();
        let sweep_rad = TurnDirection::Ccw.sign() * sweep_rad;
        let turned = crate::geometry::turned_about([end[a], end[b]], hole, sweep_rad);
        let is_whole = (sweep_rad / std::f64::consts::TAU).fract().abs() < 1e-9;
        if !is_whole {
            (end[a], end[b]) = (turned[0], turned[1]);
        }
        end[normal] = to;
        let element =
            ContourElement::Arc { plane, center: hole, sweep_rad, end: [end[0], end[1], end[2]] };
        self.with_cycle_feed(feed, |own| {
            own.move_along(None, &element, end, AxisMask::LINEAR, false);
        });
    }

    /// The coolant by the number of an M function; one of the machine builder changes nothing that is known here.
    fn cycle_coolant(&mut self, function: u32) {
        match function {
            7 => self.kernel.set_coolant(|coolant| coolant.mist = true),
            8 => self.kernel.set_coolant(|coolant| coolant.flood = true),
            9 => self.kernel.set_coolant(|coolant| *coolant = Default::default()),
            _ => {}
        }
    }
}

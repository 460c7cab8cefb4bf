//! The way to a hole, the cut, and the way out.

use chordal_command::{AxisMask, CommandKind, Position, SpindleState};

use super::hole::HoleWords;
use crate::kernel::Kernel;
use crate::rules::{BackBore, CycleKind, HoleApproach};
use crate::state::LiveTool;
use crate::statement::Statement;

/// What the spindle is while a live tool works.
struct MainSpindle {
    turns: SpindleState,
    rpm: f64,
    surface_speed: Option<f64>,
}

impl Kernel<'_> {
    /// One hole: there, down, and out again.
    pub fn drill(
        &mut self,
        at: &dyn Statement,
        hole: &HoleWords,
        place: Position,
        named: AxisMask,
    ) {
        self.origin.cycle = true;
        self.check_hole_speeds(at, hole, &place);
        let main = self.live_tool_as_spindle();
        self.approach(hole, place, named);
        match hole.words.kind {
            CycleKind::Drill => self.feed_to(at, hole, hole.z),
            CycleKind::DrillDwell => {
                self.feed_to(at, hole, hole.z);
                self.wait(hole.words.dwell_s);
            }
            CycleKind::Peck => self.pecks(at, hole, true),
            CycleKind::ChipBreak => self.pecks(at, hole, false),
            CycleKind::BoreFeedOut | CycleKind::BoreInOut => {
                self.feed_to(at, hole, hole.z);
                self.feed_to(at, hole, hole.r);
            }
            CycleKind::BoreDwell => {
                let all_the_path = self.rules.cycles.bore.dwell_out_to_clear;
                self.feed_to(at, hole, hole.z);
                self.wait(hole.words.dwell_s);
                self.feed_to(at, hole, if all_the_path { hole.clear } else { hole.r });
            }
            CycleKind::BoreStop => self.bore_and_stop(at, hole),
            CycleKind::BoreManual => self.bore_by_hand(at, hole),
            CycleKind::FineBore => self.fine_bore(at, hole),
            CycleKind::BackBore => self.back_bore(at, hole),
            CycleKind::Tap | CycleKind::LeftTap => self.tap(at, hole),
            CycleKind::SelfReversingTap => self.tap_with_head(at, hole),
        }
        let is_out = |assumed: Position| assumed[hole.axis] == hole.clear;
        if !self.state.control_position.is_some_and(is_out) {
            self.level(hole, hole.clear);
        }
        self.clean_chips(hole);
        if let Some(main) = main {
            self.spindle_as_live_tool(main);
        }
        self.origin.cycle = false;
    }

    /// A cycle with a live tool: it is what the spindle is for any other one. Gives what the spindle was.
    fn live_tool_as_spindle(&mut self) -> Option<MainSpindle> {
        let live = self.state.live.take()?;
        let state = &mut self.state;
        let main = MainSpindle {
            turns: state.spindle,
            rpm: state.rpm,
            surface_speed: state.surface_speed.take(),
        };
        (state.spindle, state.rpm) = (live.turns, live.rpm);
        Some(main)
    }

    fn spindle_as_live_tool(&mut self, main: MainSpindle) {
        let state = &mut self.state;
        let live = LiveTool { turns: state.spindle, rpm: state.rpm };
        state.live = Some(live).filter(|live| live.turns != SpindleState::Off);
        (state.spindle, state.rpm) = (main.turns, main.rpm);
        state.surface_speed = main.surface_speed;
    }

    /// Above the hole: to its place, and to R.
    fn approach(&mut self, hole: &HoleWords, place: Position, named: AxisMask) {
        let rules = &self.rules.cycles;
        let (approach, back) = (rules.approach, rules.bore.back);
        match approach {
            HoleApproach::PlaceThenLevel => self.go_to_place(place, named, hole.axis),
            HoleApproach::FromAboveR => {
                if self.state.position[hole.axis] < hole.r {
                    self.level(hole, hole.r);
                }
                self.go_to_place(place, named, hole.axis);
            }
            HoleApproach::ByClearLevel => {
                let mut target = place;
                let now = self.state.control_position.unwrap_or(self.state.position)[hole.axis];
                if hole.words.initial < hole.r {
                    self.level(hole, hole.r);
                    target[hole.axis] = hole.r;
                } else {
                    target[hole.axis] = if now > hole.r { now } else { hole.clear };
                }
                self.rapid_to(target, named);
            }
        }
        // Back boring goes to R with the tool set aside.
        let later = hole.words.kind == CycleKind::BackBore && back == BackBore::ShiftAtInitial;
        if !later {
            self.level(hole, hole.r);
        }
    }

    /// Haas E: the spindle turns the other way for a moment, and throws the chips off.
    fn clean_chips(&mut self, hole: &HoleWords) {
        let throws_chips = hole.words.kind.facts().throws_chips;
        let Some(rpm) = hole.words.after_rpm.filter(|_| throws_chips) else { return };
        let before = self.state.spindle;
        let reversed =
            if before == SpindleState::Ccw { SpindleState::Cw } else { SpindleState::Ccw };
        self.emit(CommandKind::Spindle { state: reversed, rpm });
        self.state.spindle = reversed;
        self.turn_spindle(before);
    }

    /// A rapid in the plane, at the present level.
    pub fn go_to_place(&mut self, place: Position, named: AxisMask, axis: usize) {
        let mut target = place;
        target[axis] = self.state.position[axis];
        self.rapid_to(target, named);
    }

    /// A rapid along the drilling axis.
    pub fn level(&mut self, hole: &HoleWords, level: f64) {
        let mut target = self.state.control_position.unwrap_or(self.state.position);
        target[hole.axis] = level;
        self.rapid_to(target, AxisMask(1 << hole.axis));
    }

    /// A cut along the drilling axis at the feed in force.
    pub fn feed_to(&mut self, at: &dyn Statement, hole: &HoleWords, level: f64) {
        let mut target = self.state.position;
        target[hole.axis] = level;
        self.line(at, target, AxisMask(1 << hole.axis));
    }

    /// A dwell of a cycle, where it has one.
    pub fn wait(&mut self, seconds: Option<f64>) {
        if let Some(seconds) = seconds.filter(|seconds| *seconds > 0.0) {
            self.emit(CommandKind::Dwell { seconds, label: None });
        }
    }

    /// Turns the spindle as wanted, if it does not already.
    pub fn turn_spindle(&mut self, spindle: SpindleState) {
        if self.state.spindle != spindle {
            self.state.spindle = spindle;
            let turns = matches!(spindle, SpindleState::Cw | SpindleState::Ccw);
            let rpm = if turns { self.state.rpm } else { 0.0 };
            self.emit(CommandKind::Spindle { state: spindle, rpm });
        }
    }
}

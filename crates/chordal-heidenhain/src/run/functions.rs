//! M functions and the feed of a block.

use chordal_command::{FeedMode, SpindleState};
use chordal_diagnostics::{Code, Diagnostic};

use super::interpreter::KlartextInterpreter;
use crate::alarms::WRONG_RPM;
use crate::syntax::{FeedValue, FeedWord, MachineFunction, PathWords};

/// The M functions that move nothing that is drawn here, or only speed the tool up or slow it down.
const WITHOUT_PATH: [u32; 25] = [
    6, 10, 11, 90, 94, 101, 102, 103, 107, 108, 109, 110, 111, 112, 113, 116, 117, 120, 124, 126,
    127, 134, 135, 138, 141,
];

impl KlartextInterpreter<'_> {
    /// The M functions that act at the start of a block.
    pub(super) fn functions_at_start(&mut self, words: &PathWords) {
        let directions =
            words.functions.iter().filter(|own| matches!(own.number, 3 | 4 | 13 | 14)).count();
        if directions > 1 {
            let message = "the block turns the spindle in both directions";
            self.problem(Code::SameGroup, words.functions[0].range, message);
        }
        for function in &words.functions {
            self.function_at_start(function);
        }
    }

    fn function_at_start(&mut self, function: &MachineFunction) {
        match function.number {
            3 | 13 => self.turn_spindle(SpindleState::Cw, function),
            4 | 14 => self.turn_spindle(SpindleState::Ccw, function),
            19 => self.kernel.set_spindle(SpindleState::Oriented),
            7 => self.kernel.set_coolant(|coolant| coolant.mist = true),
            89 => self.modes.calls_each_block = true,
            136 => self.modes.per_revolution = true,
            137 => self.modes.per_revolution = false,
            _ => {}
        }
        if matches!(function.number, 8 | 13 | 14) {
            self.kernel.set_coolant(|coolant| coolant.flood = true);
        }
        let is_known = matches!(
            function.number,
            0..=5 | 7..=9 | 13 | 14 | 19 | 30 | 89 | 91 | 92 | 97..=99 | 136 | 137 | 140
        );
        if is_known || WITHOUT_PATH.contains(&function.number) {
            return;
        }
        let number = function.number;
        match number {
            98 => {}
            128 => self.tool_center_point(true, function.range, "M128"),
            129 | 115 | 145 => {}
            114 | 118 | 144 => {
                let what = format!("M{number} is not followed here");
                self.not_followed_once(&format!("M{number}"), function.range, &what);
            }
            _ => {
                if self.is_first_report(&format!("M{number}")) {
                    let what =
                        format!("M{number} is a function of the machine: it moves nothing here");
                    self.problem(Code::NotSimulated, function.range, what);
                }
            }
        }
    }

    fn turn_spindle(&mut self, state: SpindleState, function: &MachineFunction) {
        if self.kernel.state.rpm == 0.0 && !self.kernel.state.unknown.speed {
            let message = "the spindle starts, and no TOOL CALL has given its speed";
            self.alarm(WRONG_RPM, Code::BadWordValue, function.range, message);
        }
        self.kernel.set_spindle(state);
    }

    /// F of a block; true if the block is a rapid.
    pub(super) fn apply_feed(&mut self, feed: Option<FeedWord>) -> bool {
        let mode = match self.modes.per_revolution {
            true => FeedMode::PerRevolution,
            false => FeedMode::PerTime,
        };
        let Some(feed) = feed else {
            if self.kernel.state.feed_mode != mode {
                self.kernel.set_feed_mode(mode);
            }
            return false;
        };
        match feed.value {
            FeedValue::Rapid => return true,
            FeedValue::Value(value) => {
                let Some(value) = self.operand(value, feed.range) else { return false };
                self.set_feed(feed, value, mode);
            }
            FeedValue::OfTool => match self.modes.tool_feed {
                Some(value) => self.set_feed(feed, value, mode),
                None => {
                    let message = "F AUTO uses the feed of TOOL CALL, which has none";
                    let diagnostic =
                        Diagnostic::new(Code::MissingFeed, self.span(feed.range), message);
                    self.kernel.report(diagnostic.help("write F into the TOOL CALL before it"));
                    // One message is enough for the block.
                    self.kernel.set_unknown_feed();
                }
            },
            FeedValue::PerRevolution(value) => {
                let Some(value) = self.operand(value, feed.range) else { return false };
                self.set_feed(feed, value, FeedMode::PerRevolution);
            }
            FeedValue::PerTooth(value) => {
                let Some(value) = self.operand(value, feed.range) else { return false };
                let teeth = self.tools.get(&self.kernel.state.tool).and_then(|tool| tool.teeth);
                let Some(teeth) = teeth else {
                    let what = "FZ is a feed per tooth, and the number of teeth is not given";
                    self.kernel.set_unknown_feed();
                    self.assumed_once("FZ", feed.range, what);
                    return false;
                };
                self.set_feed(feed, value * f64::from(teeth), FeedMode::PerRevolution);
            }
            FeedValue::Time => {
                self.kernel.set_unknown_feed();
                self.assumed_once(
                    "FT",
                    feed.range,
                    "FT gives a time, whose feed is not known here",
                );
            }
        }
        false
    }

    /// Sets F: millimetres per minute, in inch programs tenths of an inch per minute; or millimetres or inches per
    /// revolution.
    fn set_feed(&mut self, word: FeedWord, value: f64, mode: FeedMode) {
        if value < 0.0 {
            let message = format!("the feed is {value}: a feed is above zero");
            self.problem(Code::BadWordValue, word.range, message);
            return;
        }
        if self.kernel.state.feed_mode != mode {
            self.kernel.set_feed_mode(mode);
        }
        let feed = self.feed_mm(value, mode);
        let angular = match mode {
            FeedMode::PerTime => (value / 60.0).to_radians(),
            FeedMode::PerRevolution | FeedMode::InverseTime => 0.0,
        };
        self.kernel.set_feed(self.span(word.range), feed, angular);
    }

    /// A feed as written: mm/s, or mm per revolution.
    pub(super) fn feed_mm(&self, value: f64, mode: FeedMode) -> f64 {
        match (mode, self.modes.is_inch) {
            (FeedMode::PerTime, true) => value * 2.54 / 60.0,
            (FeedMode::PerTime, false) => value / 60.0,
            (_, true) => value * 25.4,
            (_, false) => value,
        }
    }

    /// The functions that are active, as the control lists them.
    pub(super) fn active_functions(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        let mut add = |is_active: bool, name: &str| {
            if is_active {
                names.push(name.to_string());
            }
        };
        let side = match self.kernel.state.side {
            chordal_command::CompensationSide::Off => "R0",
            chordal_command::CompensationSide::Left => "RL",
            chordal_command::CompensationSide::Right => "RR",
        };
        add(true, side);
        add(self.modes.per_revolution, "M136");
        add(self.modes.calls_each_block, "M89");
        add(self.modes.is_inch, "INCH");
        names
    }
}

//! Carries out the drilling cycles and the patterns of holes.

use chordal_command::{AxisMask, CommandKind, FeedMode, SpindleState};
use chordal_diagnostics::{Code, Diagnostic, TextRange};

use super::interpreter::Interpreter;
use super::words::{BlockStatementView, BlockWords};
use crate::alarms::NO_ALARM;
use crate::cycles::{
    CycleArguments, CycleFault, HoleContext, HoleStep, PatternContext, cycle_signature,
    drilling_moves, is_milling_cycle, pattern_points,
};
use crate::syntax::ProgramUnitKind;
use crate::values::SinumerikValue;

/// The patterns of holes.
const PATTERNS: [&str; 4] = ["HOLES1", "HOLES2", "CYCLE801", "CYCLE802"];

impl Interpreter<'_> {
    /// Whether a name is that of a standard cycle.
    pub(super) fn is_cycle(&self, name: &str) -> bool {
        cycle_signature(name).is_some()
    }

    /// Carries out a standard cycle.
    pub(super) fn run_cycle(
        &mut self,
        name: &str,
        arguments: &[Option<SinumerikValue>],
        range: TextRange,
    ) {
        let Some(cycle) = cycle_signature(name) else { return };
        let numbers: Vec<Option<f64>> = arguments
            .iter()
            .map(|value| value.as_ref().and_then(|value| value.to_real().ok()))
            .collect();
        if name == "CYCLE800" {
            return self.swivel_plane(&numbers, range);
        }
        if name == "CYCLE832" {
            return;
        }
        if !cycle.is_carried_out {
            let what =
                format!("{name} ({}) is not followed: what it cuts is missing here", cycle.title);
            return self.not_followed(range, what);
        }
        let unknown = arguments.iter().flatten().find_map(SinumerikValue::unknown_cause);
        if let Some(cause) = unknown {
            return self.lose_path(range, name, &cause.clone());
        }
        let values = arguments;
        let arguments = CycleArguments::new(&numbers);
        if PATTERNS.contains(&name) {
            return self.run_pattern(name, &arguments, range);
        }
        if matches!(name, "CYCLE95" | "CYCLE97") {
            return self.run_turning(name, values, &arguments, range);
        }
        if name == "CYCLE72" {
            return self.mill_contour(values, &arguments, range);
        }
        if is_milling_cycle(name) {
            return self.run_milling(name, &arguments, range);
        }
        self.has_edge_for_cycle(name, range);
        // The feed of rigid tapping follows from the lead and the speed.
        let taps = matches!(name, "CYCLE84" | "CYCLE840");
        let has_feed = self.kernel.state.feed.is_some_and(|feed| feed > 0.0);
        if !taps && !has_feed && !self.kernel.state.unknown.feed {
            self.alarm(61003, Code::MissingFeed, range, format!("{name} needs a feed"));
        }
        let (_, _, normal) = self.kernel.state.plane.axes();
        let unit_mm = self.unit_mm();
        let context = HoleContext {
            current_level: self.programmed_position()[normal] / unit_mm,
            spindle_direction: spindle_code(self.kernel.state.spindle),
            unit_mm,
            ..HoleContext::default()
        };
        match drilling_moves(name, &arguments, &context) {
            Ok(steps) => self.drill(&steps, range),
            Err(fault) => self.report_cycle(fault, range),
        }
    }

    /// Whether a tool offset is active, which every cycle needs; without one the alarm is reported.
    pub(super) fn has_edge_for_cycle(&mut self, name: &str, range: TextRange) -> bool {
        let has_edge = self.modes.edge > 0 || self.modes.is_state_unknown;
        if !has_edge {
            let message = format!("{name} needs an active tool offset");
            self.alarm(61000, Code::OffsetNotSet, range, message);
        }
        has_edge
    }

    /// Carries out moves with a feed that a cycle gives, as F; without one, with that in force.
    pub(super) fn with_cycle_feed(&mut self, feed: Option<f64>, moves: impl FnOnce(&mut Self)) {
        let kept = self.kernel.state.feed;
        if let Some(feed) = feed {
            self.kernel.state.feed = Some(self.cycle_feed(feed));
        }
        moves(self);
        self.kernel.state.feed = kept;
    }

    /// A feed that a cycle is called with, mm/s or mm/rev: it is written as F is.
    pub(super) fn cycle_feed(&self, feed: f64) -> f64 {
        let unit = if self.modes.feed_in_units { self.unit_mm() } else { 1.0 };
        match self.kernel.state.feed_mode {
            FeedMode::PerRevolution => feed * unit,
            FeedMode::PerTime | FeedMode::InverseTime => feed * unit / 60.0,
        }
    }

    /// Reports why the control refuses a cycle, or that its form is not carried out.
    pub(super) fn report_cycle(&mut self, fault: CycleFault, range: TextRange) {
        if fault.alarm == NO_ALARM {
            // Not the program is at fault: the cycle has a form that is not carried out.
            return self.lose_cycle(range, fault.message);
        }
        let diagnostic = Diagnostic::new(Code::CycleLevels, self.span(range), fault.message);
        self.report_alarm(fault.alarm, diagnostic);
    }

    /// The holes of a pattern, at each of which the modal cycle runs.
    fn run_pattern(&mut self, name: &str, arguments: &CycleArguments, range: TextRange) {
        let main = self.stack.first().map(|main| main.program);
        let is_called =
            main.is_some_and(|main| self.programs.texts[main].unit.kind == ProgramUnitKind::Sub);
        if self.modal_call.is_none() && (is_called || self.modes.is_state_unknown) {
            return self.not_followed(
                range,
                format!("{name} works with the cycle of its caller, which is not known here"),
            );
        }
        if self.modal_call.is_none() {
            return self.alarm(
                62100,
                Code::NoCycle,
                range,
                format!("{name} needs a drilling cycle with MCALL before it"),
            );
        }
        let unit = self.unit_mm();
        let place = self.programmed_position();
        let (a, b, _) = self.kernel.state.plane.axes();
        let context = PatternContext {
            position: [place[a] / unit, place[b] / unit],
            ..PatternContext::default()
        };
        let points = match pattern_points(name, arguments, &context) {
            Ok(points) => points,
            Err(fault) => return self.report_cycle(fault, range),
        };
        for point in points {
            let mut place = self.programmed_position();
            (place[a], place[b]) = (point[0] * unit, point[1] * unit);
            self.rapid_to(place);
            if let Some(modal) = self.modal_call.clone()
                && self.is_cycle(&modal.name)
            {
                self.run_cycle(&modal.name, &modal.arguments, range);
            }
            if !self.kernel.count_repeated() {
                return;
            }
        }
    }

    /// A rapid to programmed coordinates.
    pub(super) fn rapid_to(&mut self, place: [f64; 3]) {
        let end = self.mapped(place);
        self.kernel.state.place(AxisMask::LINEAR);
        self.kernel.rapid_to(end, AxisMask::LINEAR);
    }

    /// A straight cut to programmed coordinates, at the active feed times a factor.
    pub(super) fn feed_to(&mut self, place: [f64; 3], range: TextRange, factor: f64) {
        let end = self.mapped(place);
        let words = BlockWords::default();
        let view = BlockStatementView { span: self.span(range), words: &words };
        let feed = self.kernel.state.feed;
        self.kernel.state.feed = feed.map(|feed| feed * factor);
        self.kernel.line(&view, end, AxisMask::LINEAR);
        self.kernel.state.feed = feed;
    }

    /// The spindle turns with the tap: clockwise into a right-hand thread.
    fn turn_with_tap(&mut self, is_ccw: bool, rpm: Option<f64>) {
        let state = if is_ccw { SpindleState::Ccw } else { SpindleState::Cw };
        let rpm = rpm.unwrap_or(self.kernel.state.rpm);
        if self.kernel.state.spindle != state {
            self.kernel.state.spindle = state;
            self.kernel.emit(CommandKind::Spindle { state, rpm });
        }
    }

    /// A straight cut at a feed of its own, mm/s.
    fn tap_to(&mut self, place: [f64; 3], range: TextRange, feed: f64) {
        self.with_path_speed(feed, |own| own.feed_to(place, range, 1.0));
    }

    fn drill(&mut self, steps: &[HoleStep], range: TextRange) {
        let (a, b, normal) = self.kernel.state.plane.axes();
        let (spindle, unit) = (self.kernel.state.spindle, self.unit_mm());
        self.kernel.origin.cycle = true;
        for step in steps {
            let mut place = self.programmed_position();
            match *step {
                HoleStep::Rapid(level) => {
                    place[normal] = level * unit;
                    self.rapid_to(place);
                }
                HoleStep::Feed { to, factor } => {
                    place[normal] = to * unit;
                    self.feed_to(place, range, factor);
                }
                HoleStep::FeedAt { to, feed } => {
                    place[normal] = to * unit;
                    let feed_unit = if self.modes.feed_in_units { unit } else { 1.0 };
                    let per_minute = self.kernel.state.feed_mode != FeedMode::PerRevolution;
                    let turns_per_s = self.kernel.state.rpm / 60.0;
                    let speed =
                        feed * feed_unit * if per_minute { 1.0 / 60.0 } else { turns_per_s };
                    self.tap_to(place, range, speed);
                }
                HoleStep::Dwell { seconds } => {
                    self.kernel.emit(CommandKind::Dwell { seconds, label: None });
                }
                HoleStep::DwellRevolutions { revolutions } => {
                    let rpm = self.kernel.state.rpm;
                    let seconds = if rpm > 0.0 { revolutions * 60.0 / rpm } else { 0.0 };
                    self.kernel.emit(CommandKind::Dwell { seconds, label: None });
                }
                HoleStep::SpindleStop => self.kernel.set_spindle(SpindleState::Off),
                HoleStep::SpindleReverse => self.kernel.set_spindle(match spindle {
                    SpindleState::Cw => SpindleState::Ccw,
                    _ => SpindleState::Cw,
                }),
                HoleStep::SpindleRestore(code) => self.kernel.set_spindle(match code {
                    3 => SpindleState::Cw,
                    4 => SpindleState::Ccw,
                    _ => SpindleState::Off,
                }),
                HoleStep::Orient { .. } => self.kernel.set_spindle(SpindleState::Oriented),
                HoleStep::Stop => self.kernel.emit(CommandKind::Stop { optional: false }),
                HoleStep::RapidInPlane { a: along, b: across, normal: up } => {
                    place[a] += along * unit;
                    place[b] += across * unit;
                    place[normal] += up * unit;
                    self.rapid_to(place);
                }
                HoleStep::TapIn { to, pitch_mm, spindle_rpm }
                | HoleStep::TapOut { to, pitch_mm, spindle_rpm } => {
                    place[normal] = to * unit;
                    let is_out = matches!(step, HoleStep::TapOut { .. });
                    self.turn_with_tap(is_out != (pitch_mm < 0.0), spindle_rpm);
                    let rpm = spindle_rpm.unwrap_or(self.kernel.state.rpm);
                    self.tap_to(place, range, pitch_mm.abs() * rpm / 60.0);
                }
            }
        }
        self.kernel.origin.cycle = false;
    }
}

/// The state of the spindle as cycles have it: 3 and 4 as after M3 and M4, 5 where it does not turn.
pub(super) const fn spindle_code(spindle: SpindleState) -> u8 {
    match spindle {
        SpindleState::Cw => 3,
        SpindleState::Ccw => 4,
        SpindleState::Off | SpindleState::Oriented => 5,
    }
}

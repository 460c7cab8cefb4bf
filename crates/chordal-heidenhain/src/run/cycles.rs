//! Cycles: their definition, their calls, and their moves.

use std::collections::BTreeMap;

use chordal_command::{AxisMask, CompensationSide, FeedMode, SpindleState};
use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};
use chordal_geometry::TurnDirection;
use chordal_kernel::EndReason;

use super::interpreter::KlartextInterpreter;
use super::program_texts::called_name;
use super::run_state::{CycleNumber, DataValue, KlartextFlow, StoredCycle};
use crate::alarms::{CYCLE_INCOMPLETE, TOOL_TOO_LARGE};
use crate::cycles::{
    CycleContext, CycleFeed, CycleValues, DefinedPattern, KlartextCycleFault, KlartextCycleRunner,
    KlartextCycleStep, OldCycle, OldCycleData, cycle_signature, old_cycle_lines, old_cycle_steps,
    old_pocket_steps, old_slot_steps, pattern_points, refused_range,
};
use crate::syntax::{
    CycleValue, CycleWord, KlartextStatement, ParameterBank, ParameterName, PathWords, PatternGroup,
};

/// The parameters that a pattern gives to the cycle before it.
const OF_PATTERN: [u32; 3] = [200, 203, 204];

impl KlartextInterpreter<'_> {
    /// CYCL DEF of a cycle with parameters: it is kept for calls, or acts at once.
    pub(super) fn define_cycle(
        &mut self,
        number: u32,
        words: &[(u32, CycleValue, TextRange)],
    ) -> KlartextFlow {
        let range = self.here;
        let mut values = BTreeMap::new();
        for (parameter, value, range) in words {
            let number = match value {
                CycleValue::Operand(operand) => self.operand(*operand, *range),
                _ => None,
            };
            if let Some(number) = number {
                self.parameters.set_shared(*parameter, number);
                if let Some(allowed) = refused_range(*parameter, number) {
                    let message = format!("Q{parameter} is {number}, and {allowed} is allowed");
                    self.problem(Code::BadWordValue, *range, message);
                }
            }
            if let Some(value) = CycleNumber::of(*value, number) {
                values.insert(*parameter, value);
            }
        }
        let Some(signature) = cycle_signature(number) else {
            if words.is_empty() {
                let message = format!("there is no cycle {number} without data");
                self.problem(Code::UnknownCode, range, message);
                return KlartextFlow::Next;
            }
            let what = format!("cycle {number} is not known here: what it does is missing");
            self.not_followed_once(&format!("cycle {number}"), range, &what);
            if number < 400 {
                self.modes.cycle = Some(StoredCycle::Parameters { number, values, range });
            }
            return KlartextFlow::Next;
        };
        if matches!(signature.runner, KlartextCycleRunner::Nothing) {
            let what = format!(
                "cycle {number} ({}) is not followed: what it cuts is missing here",
                signature.title
            );
            self.not_followed_once(&format!("cycle {number}"), range, &what);
        }
        let missing: Vec<String> = signature
            .required
            .iter()
            .filter(|parameter| !values.contains_key(parameter))
            .map(|parameter| format!("Q{parameter}"))
            .collect();
        if !missing.is_empty() {
            let message = format!("cycle {number} lacks {}", missing.join(", "));
            let diagnostic = Diagnostic::new(Code::CycleLevels, self.span(range), message);
            self.report_alarm(CYCLE_INCOMPLETE, diagnostic.help("write all data of the cycle"));
        }
        match number {
            247 => {
                let preset = match values.get(&339) {
                    Some(CycleNumber::Value(value)) => Some(*value),
                    _ => None,
                };
                self.activate_preset(preset);
                KlartextFlow::Next
            }
            220 | 221 => self.run_pattern(number, &values),
            20 => {
                self.modes.contour_data = values;
                KlartextFlow::Next
            }
            // It says how the contour train comes to the contour, which is assumed in any case.
            270 => KlartextFlow::Next,
            _ => {
                self.modes.cycle = Some(StoredCycle::Parameters { number, values, range });
                KlartextFlow::Next
            }
        }
    }

    /// A line of the data of an old cycle.
    pub(super) fn cycle_line(
        &mut self,
        number: u32,
        line: u32,
        words: &[CycleWord],
        rest: TextRange,
    ) {
        let range = self.here;
        match number {
            14 => self.contour_labels(line, rest),
            7..=11 | 13 | 19 | 26 | 32 => {
                if line > 0 {
                    self.immediate_cycle(number, line, words);
                }
            }
            12 => {
                if line > 0 {
                    let name = called_name(self.text(), rest);
                    self.modes.cycle = Some(StoredCycle::Program { name, range });
                }
            }
            _ if old_cycle_lines(number).is_some() => {
                self.add_data(number, line, words);
            }
            _ => {
                let what = format!("cycle {number} is not followed: what it cuts is missing here");
                self.not_followed_once(&format!("cycle {number}"), range, &what);
                let lines = BTreeMap::new();
                self.modes.cycle = Some(StoredCycle::Lines { number, lines, range });
            }
        }
    }

    fn add_data(&mut self, number: u32, line: u32, words: &[CycleWord]) {
        let is_begun = matches!(
            &self.modes.open_cycle,
            Some(StoredCycle::Lines { number: open, .. }) if *open == number && line > 0
        );
        if !is_begun {
            let lines = BTreeMap::new();
            self.modes.open_cycle = Some(StoredCycle::Lines { number, lines, range: self.here });
        }
        let mut data = Vec::new();
        for word in words {
            let value = word.value.and_then(|value| self.operand(value, word.range));
            data.push(DataValue { label: word.label.clone(), value, direction: word.direction });
        }
        if let Some(StoredCycle::Lines { lines, .. }) = &mut self.modes.open_cycle
            && line > 0
        {
            lines.insert(line, data);
        }
    }

    /// Ends the definition of an old cycle before a block that does not belong to it.
    pub(super) fn close_cycle(&mut self, next: &KlartextStatement) {
        let Some(StoredCycle::Lines { number: open, .. }) = &self.modes.open_cycle else { return };
        let goes_on = matches!(
            next,
            KlartextStatement::CycleLine { number, line, .. } if number == open && *line > 0
        );
        if goes_on {
            return;
        }
        let closed = self.modes.open_cycle.take();
        if let Some(StoredCycle::Lines { number, lines, range }) = &closed {
            let missing = self.old_cycle(*number, lines).missing_lines();
            if let Some(line) = missing.first() {
                let message = format!("line {number}.{line} of the cycle is missing");
                let diagnostic = Diagnostic::new(Code::CycleLevels, self.span(*range), message);
                let help = "write all lines of the cycle";
                self.report_alarm(CYCLE_INCOMPLETE, diagnostic.help(help));
            }
        }
        self.modes.cycle = closed;
    }

    /// The data of an old cycle in mm and mm/s.
    fn old_cycle(&self, number: u32, lines: &BTreeMap<u32, Vec<DataValue>>) -> OldCycle {
        let unit = self.unit_mm();
        let feed_unit = self.feed_mm(1.0, FeedMode::PerTime);
        let by_line = |line: u32, value: f64| match (number, line) {
            (1, 4) | (2, 3) => value,
            (1, 5) | (2, 4) => value * feed_unit,
            _ => value * unit,
        };
        // F stands with its letter on the lines of pockets.
        let convert = |line: u32, word: &DataValue, value: f64| match word.label.as_str() {
            "F" if matches!(number, 3..=5) => value * feed_unit,
            _ => by_line(line, value),
        };
        let values = |(line, data): (&u32, &Vec<DataValue>)| {
            let values = data.iter().filter_map(|word| Some((word, word.value?)));
            (*line, values.map(|(word, value)| convert(*line, word, value)).collect())
        };
        // The sides of slots and pockets may stand in either order of the axes.
        let (_, second, _) = self.tool_plane().axes();
        let side = lines.get(&4).and_then(|words| words.first());
        let second_axis_first = matches!(number, 3 | 4)
            && side.is_some_and(|word| word.label == ["X", "Y", "Z"][second]);
        let is_clockwise =
            lines.values().flatten().any(|word| word.direction == Some(TurnDirection::Cw));
        let lines = lines.iter().map(values).collect();
        OldCycle { number, data: OldCycleData { lines, second_axis_first, is_clockwise } }
    }

    /// CYCL CALL.
    pub(super) fn cycle_call_block(&mut self, words: &PathWords) -> KlartextFlow {
        self.functions_at_start(words);
        let called = self.call_cycle();
        let flow = self.functions_at_end(&words.functions);
        if matches!(called, KlartextFlow::End(_)) { called } else { flow }
    }

    /// CYCL CALL POS: a rapid or a move at F to a point, where the cycle runs. Z is added to the surface.
    pub(super) fn cycle_at_position(&mut self, words: &PathWords) -> KlartextFlow {
        self.functions_at_start(words);
        let is_rapid = self.apply_feed(words.feed);
        let Some(values) = self.values(words) else { return KlartextFlow::Next };
        let start = self.programmed();
        let (a, b, normal) = self.tool_plane().axes();
        let mut place = [start[0], start[1], start[2]];
        for axis in [a, b] {
            if let Some(coordinate) = values.axes[axis] {
                place[axis] = coordinate.from(place[axis]);
            }
        }
        let plane = AxisMask(1 << a | 1 << b);
        match is_rapid {
            true => self.rapid_to(place, plane),
            false => self.feed_to(place, plane),
        }
        let surface = values.axes[normal].map_or(0.0, |coordinate| coordinate.value);
        let called = self.call_cycle_at(surface);
        let flow = self.functions_at_end(&words.functions);
        if matches!(called, KlartextFlow::End(_)) { called } else { flow }
    }

    /// The points of a group of PATTERN DEF, mm, and its surface; `None` if that is reported.
    fn pattern_of_group(&mut self, group: &PatternGroup) -> Option<(Vec<[f64; 2]>, f64)> {
        let unit = self.unit_mm();
        let (a, b, normal) = self.tool_plane().axes();
        let mut first = [0.0; 3];
        let mut pattern = DefinedPattern::default();
        for (name, value) in &group.words {
            let Some(value) = self.operand(*value, group.range) else { continue };
            match ["X", "Y", "Z"].iter().position(|axis| axis == name) {
                Some(axis) => first[axis] = value * unit,
                None => {
                    let is_length = matches!(name.as_str(), "D" | "DX" | "DY");
                    let value = if is_length { value * unit } else { value };
                    pattern.words.push((name.clone(), value));
                }
            }
        }
        let own = match group.name.as_str() {
            "POS" => Ok(Some(vec![[0.0; 2]])),
            kind => pattern.points(kind),
        };
        match own {
            Ok(Some(points)) => {
                if matches!(group.name.as_str(), "PAT" | "FRAME") {
                    self.report_assumed_order(&group.name);
                }
                let at = |[x, y]: [f64; 2]| [first[a] + x, first[b] + y];
                Some((points.into_iter().map(at).collect(), first[normal]))
            }
            Ok(None) => {
                let what = format!("{} of PATTERN DEF is not followed", group.name);
                self.not_followed_once(&format!("pattern {}", group.name), group.range, &what);
                None
            }
            Err(fault) => {
                self.report_cycle(fault);
                None
            }
        }
    }

    /// Says once that the order of the points of a pattern is assumed.
    fn report_assumed_order(&mut self, pattern: &str) {
        self.report_assumption(
            &format!("order of {pattern}"),
            &format!(
                "no manual gives the order of the points of {pattern}: lines to and fro are assumed"
            ),
            "the holes are those of the control; the time may differ",
        );
    }

    /// CYCL CALL PAT: the cycle at each point of PATTERN DEF.
    pub(super) fn cycle_at_pattern(&mut self, words: &PathWords) -> KlartextFlow {
        self.functions_at_start(words);
        self.apply_feed(words.feed);
        let groups = self.modes.pattern.clone();
        if groups.is_empty() {
            let message = "CYCL CALL PAT needs PATTERN DEF before it";
            self.problem(Code::MissingWord, self.here, message);
        }
        let (a, b, _) = self.tool_plane().axes();
        for group in groups {
            let Some((points, surface)) = self.pattern_of_group(&group) else { continue };
            for point in points {
                let start = self.programmed();
                let mut place = [start[0], start[1], start[2]];
                (place[a], place[b]) = (point[0], point[1]);
                self.rapid_to(place, AxisMask(1 << a | 1 << b));
                let called = self.call_cycle_at(surface);
                if matches!(called, KlartextFlow::End(_)) {
                    return called;
                }
                if !self.kernel.count_repeated() {
                    return KlartextFlow::End(EndReason::Budget);
                }
            }
        }
        self.functions_at_end(&words.functions)
    }

    /// Runs the defined cycle where the tool is.
    pub(super) fn call_cycle(&mut self) -> KlartextFlow {
        self.call_cycle_at(0.0)
    }

    /// The same with the surface raised by a distance, mm.
    fn call_cycle_at(&mut self, surface_mm: f64) -> KlartextFlow {
        let Some(cycle) = self.modes.cycle.clone() else {
            let message = "a cycle is called, and none is defined";
            let diagnostic = Diagnostic::new(Code::NoCycle, self.span(self.here), message);
            self.kernel.report(diagnostic.help("write CYCL DEF before the call"));
            return KlartextFlow::Next;
        };
        self.check_side_at_call(&cycle);
        match cycle {
            StoredCycle::Program { name, .. } => return self.call_named_program(&name),
            StoredCycle::Lines { number, lines, .. } => self.run_old_cycle(number, &lines),
            StoredCycle::Parameters { number, values, .. }
                if matches!(
                    cycle_signature(number).map(|signature| signature.runner),
                    Some(KlartextCycleRunner::OnContours)
                ) =>
            {
                if surface_mm == 0.0 {
                    self.run_contour_cycle(number, &values);
                } else {
                    let what = format!("cycle {number} at another level is not followed");
                    self.not_followed(self.here, what);
                }
            }
            StoredCycle::Parameters { number, values, .. } => {
                let values = self.cycle_values(&values);
                let raised = values.length(203) + surface_mm;
                self.run_parameter_cycle(number, &values.with_surface(raised));
            }
        }
        KlartextFlow::Next
    }

    /// A cycle is called where the tool stands with R0 (TNC 640 cycle programming 34059x, "Please note while
    /// programming" of each cycle).
    fn check_side_at_call(&mut self, cycle: &StoredCycle) {
        let is_program = matches!(cycle, StoredCycle::Program { .. });
        if is_program || self.kernel.state.side == CompensationSide::Off {
            return;
        }
        let message = "a cycle is called with tool radius compensation active";
        let diagnostic = Diagnostic::new(Code::CycleInCompensation, self.span(self.here), message);
        let help = "go to the point of the call with R0";
        self.kernel.report(diagnostic.severity(Severity::Warning).help(help));
    }

    fn run_old_cycle(&mut self, number: u32, lines: &BTreeMap<u32, Vec<DataValue>>) {
        if old_cycle_lines(number).is_none() {
            return;
        }
        let old = self.old_cycle(number, lines);
        let context = self.cycle_context();
        let steps = match number {
            3..=5 => {
                self.report_assumed_path(number);
                match number {
                    3 => old_slot_steps(&old, &context),
                    _ => old_pocket_steps(&old, &context),
                }
            }
            _ => old_cycle_steps(&old, &context),
        };
        match steps {
            Ok(steps) => self.run_steps(&steps),
            Err(fault) => self.report_cycle(fault),
        }
    }

    fn run_parameter_cycle(&mut self, number: u32, values: &CycleValues) {
        let runner = cycle_signature(number).map(|signature| signature.runner);
        let steps = match runner {
            Some(KlartextCycleRunner::Exact(steps)) => steps,
            Some(KlartextCycleRunner::Assumed(steps)) => {
                self.report_assumed_path(number);
                steps
            }
            Some(KlartextCycleRunner::AssumedLines(steps)) => {
                let what = format!(
                    "the manuals do not say where the lines of cycle {number} begin and end: they are assumed"
                );
                self.assumed_once(&format!("lines of cycle {number}"), self.here, &what);
                steps
            }
            Some(KlartextCycleRunner::OnContours) => {
                let what = format!(
                    "cycle {number} in a pattern is not followed: it works on contours at their own places"
                );
                return self.not_followed_once(
                    &format!("pattern of cycle {number}"),
                    self.here,
                    &what,
                );
            }
            Some(KlartextCycleRunner::AtOnce | KlartextCycleRunner::Nothing) | None => return,
        };
        match steps(number, values, &self.cycle_context()) {
            Ok(steps) => self.run_steps(&steps),
            Err(fault) => self.report_cycle(fault),
        }
    }

    /// Says once for each cycle that its path is not that of the control in every move.
    pub(super) fn report_assumed_path(&mut self, number: u32) {
        self.report_assumption(
            &format!("path of cycle {number}"),
            &format!("the manuals do not give every move of cycle {number}: its path is assumed"),
            "shape, depth and end are those of the control; the order of the moves and the time may differ",
        );
    }

    /// Says once for each subject what of the moves of a cycle is assumed.
    fn report_assumption(&mut self, subject: &str, message: &str, help: &str) {
        if self.is_first_report(subject) {
            let diagnostic = Diagnostic::new(Code::CyclePathAssumed, self.span(self.here), message);
            self.kernel.report(diagnostic.help(help));
        }
    }

    pub(super) fn report_cycle(&mut self, fault: KlartextCycleFault) {
        let range = self.here;
        match fault {
            KlartextCycleFault::Incomplete(message) => {
                self.alarm(CYCLE_INCOMPLETE, Code::CycleLevels, range, message);
            }
            KlartextCycleFault::BadValue(message) => {
                self.problem(Code::CycleLevels, range, message);
            }
            KlartextCycleFault::ToolTooLarge(message) => {
                self.alarm(TOOL_TOO_LARGE, Code::PocketTooSmall, range, message);
            }
            KlartextCycleFault::NotFollowed(message) => self.not_followed(range, message),
            KlartextCycleFault::MissingRadius(cycle) => {
                let tool = self.kernel.state.tool;
                let message =
                    format!("cycle {cycle} needs the radius of tool {tool}, which is not given");
                let diagnostic = Diagnostic::new(Code::NotFollowed, self.span(range), message);
                let help = format!("set it with --set tools.{tool}.diameter=\"…\"");
                self.kernel.report(diagnostic.help(help));
            }
        }
    }

    /// The values of a cycle in mm and mm/s. Its data are Q parameters: what was assigned to one after the definition
    /// counts (TNC 640 cycle programming 34059x, 3.1).
    pub(super) fn cycle_values(&self, values: &BTreeMap<u32, CycleNumber>) -> CycleValues {
        let feed_unit = self.feed_mm(1.0, FeedMode::PerTime);
        let (mut numbers, mut feeds) = (BTreeMap::new(), BTreeMap::new());
        for (number, value) in values {
            match value {
                CycleNumber::Value(value) => {
                    let name = ParameterName { bank: ParameterBank::Shared, number: *number };
                    numbers.insert(*number, self.parameters.number(name).unwrap_or(*value));
                }
                CycleNumber::Max => {
                    feeds.insert(*number, CycleFeed::Rapid);
                }
                CycleNumber::OfTool => {
                    let feed = self.modes.tool_feed.map(|feed| CycleFeed::Speed(feed * feed_unit));
                    feeds.insert(*number, feed.unwrap_or(CycleFeed::Active));
                }
            }
        }
        CycleValues::new(numbers, feeds, self.unit_mm(), feed_unit)
    }

    pub(super) fn cycle_context(&self) -> CycleContext {
        let tool = self.kernel.state.tool;
        let settings = &self.programs.settings;
        let place = self.programmed();
        let (a, b, normal) = self.tool_plane().axes();
        CycleContext {
            level: place[normal],
            position: [place[a], place[b]],
            tool_radius: self.kernel.state.offsets.radius_mm(tool),
            point_angle: self.tools.get(&tool).and_then(|tool| tool.point_angle_rad),
            rpm: self.kernel.state.rpm,
            turns_left: self.kernel.state.spindle == SpindleState::Ccw,
            peck_stop: settings.peck_stop_mm,
            refuses_positive_depth: settings.positive_depth_is_error,
        }
    }

    /// Cycles 220 and 221: the cycle before them at each point.
    fn run_pattern(&mut self, number: u32, values: &BTreeMap<u32, CycleNumber>) -> KlartextFlow {
        let range = self.here;
        let values = self.cycle_values(values);
        let cycle = match self.modes.cycle.clone() {
            Some(StoredCycle::Program { .. }) | None => {
                let message =
                    format!("cycle {number} runs the cycle before it, and none is defined");
                let diagnostic = Diagnostic::new(Code::NoCycle, self.span(range), message);
                self.kernel.report(diagnostic.help("define a cycle before the pattern"));
                return KlartextFlow::Next;
            }
            Some(cycle) => cycle,
        };
        let pattern = match pattern_points(number, &values) {
            Ok(pattern) => pattern,
            Err(fault) => {
                self.report_cycle(fault);
                return KlartextFlow::Next;
            }
        };
        let (a, b, _) = self.tool_plane().axes();
        let clearance = values.length(203) + values.length(200);
        let end = clearance.max(values.length(203) + values.length(204));
        for point in pattern.points {
            let start = self.programmed();
            let mut place = [start[0], start[1], start[2]];
            (place[a], place[b]) = (point[0], point[1]);
            self.rapid_to(place, AxisMask(1 << a | 1 << b));
            match &cycle {
                StoredCycle::Parameters { number, values: own, .. } => {
                    let own = self.cycle_values(own).with(&values, &OF_PATTERN);
                    self.run_parameter_cycle(*number, &own);
                }
                // Old cycles begin where the tool is.
                StoredCycle::Lines { number, lines, .. } => {
                    self.run_steps(&[KlartextCycleStep::Rapid(clearance)]);
                    self.run_old_cycle(*number, lines);
                    self.run_steps(&[KlartextCycleStep::Rapid(end)]);
                }
                StoredCycle::Program { .. } => {}
            }
            if !self.kernel.count_repeated() {
                return KlartextFlow::End(EndReason::Budget);
            }
        }
        KlartextFlow::Next
    }
}

//! Transformations of coordinates and other cycles that act where they are defined.

use chordal_command::{CommandKind, SpindleState};
use chordal_diagnostics::{Code, TextRange};

use super::interpreter::KlartextInterpreter;
use super::run_state::ProgrammedFrame;
use super::transformations::Transformation;
use crate::alarms::CYCLE_INCOMPLETE;
use crate::datum_table::preset_name;
use crate::syntax::{CycleWord, PathWords};

/// The axes of transformations.
const LINEAR_AXES: [&str; 3] = ["X", "Y", "Z"];

impl KlartextInterpreter<'_> {
    /// Sets a transformation; the tool stays, its coordinates change.
    pub(super) fn transform(&mut self, new: Transformation) {
        self.modes.chain.set(new);
        self.update_frame();
    }

    pub(super) fn update_frame(&mut self) {
        self.modes.frame = ProgrammedFrame::new(self.modes.chain.map());
        self.modes.contour.direction = None;
    }

    /// A line of cycle 7, 8, 9, 10, 11, 13, 19, 26 or 32.
    pub(super) fn immediate_cycle(&mut self, number: u32, line: u32, words: &[CycleWord]) {
        match number {
            7 => self.cycle_datum_shift(words),
            8 if line == 1 => {
                let is_mirrored =
                    LINEAR_AXES.map(|axis| words.iter().any(|word| word.label == axis));
                self.transform(Transformation::Mirror(is_mirrored));
            }
            9 => self.cycle_dwell(words),
            10 => self.cycle_rotation(words),
            11 => self.cycle_scale(words),
            13 => self.kernel.set_spindle(SpindleState::Oriented),
            19 => self.cycle_working_plane(words),
            26 => self.cycle_axis_scale(words),
            32 => self.cycle_tolerance(line, words),
            _ => {}
        }
    }

    fn word_value(&mut self, word: &CycleWord) -> Option<f64> {
        self.operand(word.value?, word.range)
    }

    /// Cycle 7: the new datum on each axis; I adds to the last one.
    fn cycle_datum_shift(&mut self, words: &[CycleWord]) {
        let mut shift = self.modes.chain.shift();
        let unit = self.unit_mm();
        for word in words {
            if word.label == "#" {
                let Some(number) = self.word_value(word) else { continue };
                match self.table_datum(number, None, word.range) {
                    Some(datum) => self.take_datum(&datum, &mut shift, word.range),
                    None => return,
                }
                continue;
            }
            let (name, is_incremental) = match word.label.strip_prefix('I') {
                Some(name) => (name, true),
                None => (word.label.as_str(), false),
            };
            if ["A", "B", "C"].contains(&name) {
                if self.word_value(word).is_some_and(|degrees| degrees != 0.0) {
                    self.rotary_shift(word.range);
                }
                continue;
            }
            let Some(axis) = LINEAR_AXES.iter().position(|axis| *axis == name) else { continue };
            let Some(value) = self.word_value(word) else { continue };
            shift[axis] = if is_incremental { shift[axis] } else { 0.0 } + value * unit;
        }
        self.transform(Transformation::Shift(shift));
    }

    fn cycle_dwell(&mut self, words: &[CycleWord]) {
        let Some(word) = words.iter().find(|word| word.value.is_some()) else { return };
        let Some(seconds) = self.word_value(word) else { return };
        if seconds < 0.0 {
            let message = format!("the dwell is {seconds} s");
            return self.bad_value(word.range, message, "a time is not negative");
        }
        self.kernel.emit(CommandKind::Dwell { seconds, label: None });
    }

    fn cycle_rotation(&mut self, words: &[CycleWord]) {
        let Some(word) = words.iter().find(|word| word.label.ends_with("ROT")) else {
            return self.incomplete_cycle(10, "the angle ROT");
        };
        let Some(value) = self.word_value(word) else { return };
        let before = self.modes.chain.rotation_deg();
        let degrees = if word.label.starts_with('I') { before + value } else { value };
        let plane = self.tool_plane();
        self.transform(Transformation::Rotation(plane, degrees));
    }

    fn incomplete_cycle(&mut self, number: u32, what: &str) {
        let message = format!("cycle {number} lacks {what}");
        self.alarm(CYCLE_INCOMPLETE, Code::CycleLevels, self.here, message);
    }

    fn cycle_scale(&mut self, words: &[CycleWord]) {
        let Some(word) = words.iter().find(|word| word.value.is_some()) else {
            return self.incomplete_cycle(11, "the factor SCL");
        };
        let Some(factor) = self.word_value(word) else { return };
        if factor <= 0.0 {
            return self.bad_factor(word.range, factor);
        }
        self.transform(Transformation::Scale(factor));
    }

    fn bad_factor(&mut self, range: TextRange, factor: f64) {
        let message = format!("the factor is {factor}");
        self.bad_value(range, message, "a factor is above zero");
    }

    /// Cycle 26: a factor of each axis, and the point that does not move.
    fn cycle_axis_scale(&mut self, words: &[CycleWord]) {
        let (mut factors, mut center) = self.modes.chain.axis_scale();
        let unit = self.unit_mm();
        for word in words {
            let Some(value) = self.word_value(word) else { continue };
            let (name, is_center) = match word.label.strip_prefix("CC") {
                Some(name) => (name, true),
                None => (word.label.as_str(), false),
            };
            let Some(axis) = LINEAR_AXES.iter().position(|axis| *axis == name) else { continue };
            if is_center {
                center[axis] = value * unit;
            } else if value <= 0.0 {
                self.bad_factor(word.range, value);
            } else {
                factors[axis] = value;
            }
        }
        self.transform(Transformation::AxisScale(factors, center));
    }

    /// Cycle 19: spatial angles; without any the plane is level again.
    fn cycle_working_plane(&mut self, words: &[CycleWord]) {
        let mut angles = [None; 3];
        for word in words {
            let axis = ["A", "B", "C"].iter().position(|axis| *axis == word.label);
            if let Some(axis) = axis {
                angles[axis] = self.word_value(word);
            }
        }
        self.working_plane(angles);
    }

    /// Cycle 32: the path may be left by a tolerance.
    fn cycle_tolerance(&mut self, line: u32, words: &[CycleWord]) {
        let tolerance = words.iter().find(|word| word.label == "T");
        if line == 1 {
            let unit = self.unit_mm();
            let mm = tolerance.and_then(|word| self.word_value(word)).map(|value| value * unit);
            self.kernel.change_path_mode(|path| path.set_distance(mm.filter(|mm| *mm > 0.0)));
        }
    }

    /// Cycle 247: another preset; a datum shift ends.
    pub(super) fn activate_preset(&mut self, number: Option<f64>) {
        let range = self.here;
        self.modes.chain.clear_shift();
        self.update_frame();
        // A line of the preset table is the work offset with this number; line 0 stays what the run began with.
        let whole = number.filter(|number| number.fract() == 0.0 && *number >= 0.0);
        match whole.map(|number| number as u16) {
            Some(0) if self.kernel.state.offsets.active() == preset_name(1) => {}
            Some(number) if number > 0 => self.kernel.select_work(preset_name(number)),
            _ => {
                let what = "cycle 247 names a preset whose number is not known here";
                self.problem(Code::UnknownPath, range, what);
            }
        }
    }

    /// TRANS DATUM AXIS.
    pub(super) fn datum_shift(&mut self, words: &PathWords) {
        let Some(values) = self.values(words) else { return };
        let mut shift = self.modes.chain.shift();
        for (axis, value) in shift.iter_mut().enumerate() {
            if let Some(coordinate) = values.axes[axis] {
                *value = coordinate.from(*value);
            }
        }
        self.transform(Transformation::Shift(shift));
    }

    /// TRANS DATUM RESET.
    pub(super) fn reset_datum(&mut self) {
        self.transform(Transformation::Shift([0.0; 3]));
    }
}

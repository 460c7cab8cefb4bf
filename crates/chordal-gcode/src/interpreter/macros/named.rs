//! Named variables, and those that LinuxCNC defines ("Predefined Named Parameters").

use chordal_command::{CompensationSide, FeedMode, SpindleState, Units, WorkName};
use chordal_diagnostics::{Code, TextRange};
use chordal_dialect::Action;
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::ModalMotion;
use chordal_kernel::rules::ArcCenter;
use chordal_machine::AXES;

use super::super::Interpreter;
use crate::macros::evaluate::EvaluationError;
use crate::macros::names::normalized;
use crate::macros::value::MacroValue;

impl Interpreter<'_> {
    /// The value of a named variable.
    pub(super) fn named(
        &mut self,
        name: TextRange,
        range: TextRange,
    ) -> Result<MacroValue, EvaluationError> {
        let name = normalized(name.slice(self.reader.text()));
        if name == "_value" {
            return Ok(self.macros.owords.value);
        }
        if let Some(value) = self.macros.names.get(&name) {
            return Ok(value);
        }
        if let Some(value) = self.predefined(&name) {
            let by_machine_file = || self.machine.macros.named_variables.get(&name).copied();
            let cause = self.cause_of_name(&name);
            let value = MacroValue::or_unknown(value.or_else(by_machine_file), cause);
            self.note_unknown(value, range);
            return Ok(value);
        }
        Err(EvaluationError::new(
            Code::UnsetName,
            range,
            format!("`#<{name}>` is read but was never set"),
            "set it before, or check the spelling of its name",
        ))
    }

    /// EXISTS: true for a variable that is set or predefined.
    pub(super) fn is_named(&self, name: TextRange) -> bool {
        let name = normalized(name.slice(self.reader.text()));
        self.macros.names.get(&name).is_some() || self.predefined(&name).is_some()
    }

    pub(super) fn write_named(
        &mut self,
        name: TextRange,
        value: MacroValue,
        range: TextRange,
    ) -> Result<(), EvaluationError> {
        let name = normalized(name.slice(self.reader.text()));
        if self.predefined(&name).is_some() {
            return Err(EvaluationError::new(
                Code::ReadOnlyVariable,
                range,
                format!("`#<{name}>` shows the state of the control and cannot be written"),
                "use another name",
            ));
        }
        if self.macros.names.set(name, value) {
            return Ok(());
        }
        Err(EvaluationError::new(
            Code::BadVariable,
            range,
            "there are too many named variables",
            "use numbered ones: #31 to #5000",
        ))
    }

    /// The value of a predefined variable; `Some(None)` when the program does not determine it, `None` for no such
    /// variable.
    fn predefined(&self, name: &str) -> Option<Option<f64>> {
        let name = name.strip_prefix('_')?;
        let state = &self.kernel.state;
        let axis = |axis: usize| Some(self.axis_out(axis, state.known_position(axis)?));
        let machine = |axis: usize| Some(self.axis_out(axis, state.known_machine_position(axis)?));
        Some(match name {
            "x" => axis(0),
            "y" => axis(1),
            "z" => axis(2),
            "a" => axis(3),
            "b" => axis(4),
            "c" => axis(5),
            "abs_x" => machine(0),
            "abs_y" => machine(1),
            "abs_z" => machine(2),
            "abs_a" => machine(3),
            "abs_b" => machine(4),
            "abs_c" => machine(5),
            "tool_offset" => self.has_tool_offset().map(|has| f64::from(u8::from(has))),
            "feed" => self.feed_word(),
            "rpm" => self.speed_word(),
            "current_tool" => self.tool_in_spindle(),
            "current_pocket" | "selected_pocket" => None,
            // Pins and keys of the machine's configuration.
            _ if name.starts_with("hal[") || name.starts_with("ini[") => None,
            _ => Some(self.predefined_state(name)?),
        })
    }

    /// True when an active tool offset is not zero; `None` when they are not known.
    fn has_tool_offset(&self) -> Option<bool> {
        let offsets = &self.kernel.state.offsets;
        let mut has = false;
        for axis in 0..AXES {
            has |= offsets.known_tool_offset(axis)? != 0.0;
        }
        Some(has)
    }

    /// The value of a predefined variable that shows a mode.
    fn predefined_state(&self, name: &str) -> Option<f64> {
        let state = &self.kernel.state;
        let flag = |value: bool| if value { 1.0 } else { 0.0 };
        let inch = state.units == Units::Inch;
        Some(match name {
            "u" | "v" | "w" | "abs_u" | "abs_v" | "abs_w" => 0.0,
            "vmajor" => 2.9,
            "vminor" => 0.0,
            "line" => {
                self.look_at_all();
                f64::from(self.kernel.origin.line)
            }
            "motion_mode" => self.motion_mode(),
            "plane" => match state.plane {
                Plane::Xy => 170.0,
                Plane::Zx => 180.0,
                Plane::Yz => 190.0,
            },
            "ccomp" => match state.side {
                CompensationSide::Off => 400.0,
                CompensationSide::Left => 410.0,
                CompensationSide::Right => 420.0,
            },
            "metric" => flag(!inch),
            "imperial" => flag(inch),
            "absolute" => flag(!state.incremental),
            "incremental" => flag(state.incremental),
            "inverse_time" => flag(state.feed_mode == FeedMode::InverseTime),
            "units_per_minute" => flag(state.feed_mode == FeedMode::PerTime),
            "units_per_rev" => flag(state.feed_mode == FeedMode::PerRevolution),
            "coord_system" => match state.offsets.active() {
                WorkName::G(number) => f64::from(number) * 10.0,
                WorkName::G59(number) => 590.0 + f64::from(number),
                _ => 540.0,
            },
            "retract_r_plane" => flag(state.return_to_r),
            "retract_old_z" => flag(!state.return_to_r),
            "spindle_rpm_mode" => 1.0,
            "spindle_css_mode" | "lathe_diameter_mode" | "lathe_radius_mode" => 0.0,
            "adaptive_feed" | "remap_level" => 0.0,
            // 1 on the machine, 0 in a preview.
            "task" => 1.0,
            "speed_override" | "feed_override" | "feed_hold" => 1.0,
            "ijk_absolute_mode" => flag(state.arc_center == ArcCenter::Absolute),
            "spindle_on" => flag(matches!(state.spindle, SpindleState::Cw | SpindleState::Ccw)),
            "spindle_cw" => flag(state.spindle == SpindleState::Cw),
            "mist" => flag(state.coolant.mist),
            "flood" => flag(state.coolant.flood),
            "selected_tool" => state.selected_tool.map_or(-1.0, f64::from),
            // `named` reads it before, as it may be unknown.
            "value" => 0.0,
            "value_returned" => flag(self.macros.owords.value_returned),
            "call_level" => self.macros.names.depth() as f64,
            _ => return None,
        })
    }

    /// Ten times the active motion code.
    fn motion_mode(&self) -> f64 {
        if let Some(cycle) = self.kernel.state.cycle {
            let rows = self.control.table.g_codes;
            let row = rows.iter().find(|row| row.action == Action::Cycle(cycle.kind));
            return row.map_or(800.0, |row| f64::from(row.code));
        }
        match self.kernel.state.motion {
            ModalMotion::None => 800.0,
            ModalMotion::Rapid => 0.0,
            ModalMotion::Linear => 10.0,
            ModalMotion::Thread => 330.0,
            ModalMotion::RigidTap => 331.0,
            ModalMotion::Arc(TurnDirection::Cw) | ModalMotion::Spiral(TurnDirection::Cw) => 20.0,
            ModalMotion::Arc(TurnDirection::Ccw) | ModalMotion::Spiral(TurnDirection::Ccw) => 30.0,
            ModalMotion::Spline(form) => self.spline_code(form),
            ModalMotion::Turn(_) | ModalMotion::Probe { .. } | ModalMotion::ThreadPasses => {
                self.motion_row_code()
            }
        }
    }
}

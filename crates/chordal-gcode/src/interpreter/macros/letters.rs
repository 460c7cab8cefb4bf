//! Variables that are written as letters and a number (Fadal manual, section 18).

use chordal_command::WorkName;
use chordal_diagnostics::{Code, TextRange};
use chordal_geometry::TurnDirection;
use chordal_kernel::ModalMotion;
use chordal_kernel::ToolValue;
use chordal_machine::AXIS_LETTERS;

use super::super::Interpreter;
use super::words::decimal;
use crate::macros::evaluate::EvaluationError;
use crate::macros::value::{MacroValue, UnknownCause};

/// The last V variable.
const LAST_VARIABLE: u32 = 100;

/// Work offsets that have variables.
const LAST_OFFSET: u32 = 48;

/// Tools that have variables.
const LAST_TOOL: u32 = 99;

/// The axis of a variable's second letter.
fn axis_of(name: &str) -> Option<usize> {
    name.chars().nth(1).and_then(|letter| AXIS_LETTERS.find(letter))
}

impl Interpreter<'_> {
    pub(super) fn letter_variable(
        &mut self,
        letters: u8,
        number: f64,
        range: TextRange,
    ) -> Result<MacroValue, EvaluationError> {
        let name = self.letters_name(letters);
        let at = self.letters_number(name, number, range)?;
        let axis = axis_of(name).unwrap_or(0);
        let state = &self.kernel.state;
        let shown = |place: Option<f64>| Some(self.axis_out(axis, place?));
        let value = match name {
            "V" => {
                let written = self.macros.lines.variables.get(at as usize).copied().flatten();
                return Ok(
                    written.unwrap_or(MacroValue::Unknown(UnknownCause::Letters(letters, at)))
                );
            }
            "R" => match self.registers[at as usize] {
                Some(register) => Some(register.to_f64()),
                None => return Ok(MacroValue::Unknown(self.cause_of_register(letters, at))),
            },
            "AX" | "AY" | "AZ" | "AA" | "AB" | "AC" => shown(state.known_position(axis)),
            "PX" | "PY" | "PZ" | "PA" | "PB" => {
                let point = self.macros.probe.points[at as usize - 1][axis];
                shown(self.macros.probe.skipped.then_some(point))
            }
            "FX" | "FY" | "FZ" | "FA" | "FB" => {
                let key = state.offsets.key(WorkName::E(at as u16));
                shown(state.offsets.known_work_value(&key, axis))
            }
            "H" => state.offsets.length_mm(at).map(|length| length / self.unit()),
            "D" => state.offsets.radius_mm(at).map(|radius| 2.0 * radius / self.unit()),
            "TN" => self.tool_in_spindle(),
            "TL" => Some(f64::from(state.offsets.length().number.unwrap_or(0))),
            "VF" => self.feed_word(),
            "G" if at == 1 => Some(1.0 + self.motion_code()),
            _ => {
                let written = self.macros.lines.written.get(&(letters, at)).copied();
                return Ok(
                    written.unwrap_or(MacroValue::Unknown(UnknownCause::Letters(letters, at)))
                );
            }
        };
        Ok(MacroValue::or_unknown(value, UnknownCause::Letters(letters, at)))
    }

    pub(super) fn write_letters(
        &mut self,
        letters: u8,
        number: f64,
        value: MacroValue,
        range: TextRange,
    ) -> Result<(), EvaluationError> {
        let name = self.letters_name(letters);
        let at = self.letters_number(name, number, range)?;
        let unit = self.unit();
        if name == "V" {
            let variables = &mut self.macros.lines.variables;
            variables.resize(LAST_VARIABLE as usize + 1, None);
            variables[at as usize] = Some(value);
            return Ok(());
        }
        let value = match value.counted() {
            Ok(value) => value,
            Err(cause) if name == "R" => {
                self.registers[at as usize] = None;
                self.macros.unknown.lose_register(at as usize, cause);
                return Ok(());
            }
            Err(cause) => {
                self.lose_path_by(range, &format!("{name}{at}"), cause);
                return Ok(());
            }
        };
        match name {
            "R" => {
                let value = decimal(value).ok_or_else(|| {
                    EvaluationError::new(
                        Code::NumberOverflow,
                        range,
                        format!("{value} is too large for a register"),
                        "check the values that it is computed from",
                    )
                })?;
                self.registers[at as usize] = Some(value);
            }
            "FX" | "FY" | "FZ" | "FA" | "FB" => {
                let axis = axis_of(name).unwrap_or(0);
                let key = self.kernel.state.offsets.key(WorkName::E(at as u16));
                let value = if axis < 3 { value * unit } else { value.to_radians() };
                self.kernel.state.shift_coordinates(|offsets| {
                    offsets.write_work(&key, axis, value, false);
                });
                self.kernel.emit_work_offset();
            }
            "H" => self.kernel.store_tool_value(ToolValue::Length, at, value * unit, false),
            "D" => self.kernel.store_tool_value(ToolValue::Radius, at, value * unit, false),
            "TT" | "TU" | "HO" | "CP" | "CR" | "CC" | "O" => {
                self.macros.lines.written.insert((letters, at), MacroValue::Number(value));
            }
            _ => {
                return Err(EvaluationError::new(
                    Code::ReadOnlyVariable,
                    range,
                    format!("{name} can be read, but not written"),
                    "put the value into a V variable",
                ));
            }
        }
        Ok(())
    }

    pub(super) fn letters_name(&self, letters: u8) -> &'static str {
        let names = self.control.table.lexicon.grammar.letter_variables;
        names.get(letters as usize).copied().unwrap_or("V")
    }

    /// The whole number of a variable; an error when there is no such variable.
    fn letters_number(
        &self,
        name: &str,
        number: f64,
        range: TextRange,
    ) -> Result<u32, EvaluationError> {
        let (first, last) = match name {
            "V" => (1, LAST_VARIABLE),
            "R" => (0, 9),
            "PX" | "PY" | "PZ" | "PA" | "PB" => (1, 3),
            "FX" | "FY" | "FZ" | "FA" | "FB" => (1, LAST_OFFSET),
            "H" | "D" | "TT" | "TU" => (1, LAST_TOOL),
            _ => (0, 255),
        };
        let whole = libm::round(number);
        if (f64::from(first)..=f64::from(last)).contains(&whole) {
            return Ok(whole as u32);
        }
        Err(EvaluationError::new(
            Code::BadVariable,
            range,
            format!("there is no {name}{number}: {name} has the numbers {first} to {last}"),
            "check the value that the number is computed from",
        ))
    }

    fn motion_code(&self) -> f64 {
        match self.kernel.state.motion {
            ModalMotion::Rapid | ModalMotion::None => 0.0,
            ModalMotion::Linear | ModalMotion::Thread | ModalMotion::RigidTap => 1.0,
            ModalMotion::Arc(TurnDirection::Cw) | ModalMotion::Spiral(TurnDirection::Cw) => 2.0,
            ModalMotion::Arc(TurnDirection::Ccw) | ModalMotion::Spiral(TurnDirection::Ccw) => 3.0,
            ModalMotion::Spline(form) => self.spline_code(form) / 10.0,
            ModalMotion::Turn(_) | ModalMotion::Probe { .. } | ModalMotion::ThreadPasses => {
                self.motion_row_code() / 10.0
            }
        }
    }
}

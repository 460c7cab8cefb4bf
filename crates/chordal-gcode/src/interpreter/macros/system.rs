//! System variables: positions, offsets, modal codes, alarms.

use chordal_command::{AxisMask, WorkName};
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_dialect::macros::{OFFSET_STEP, ROTATION_INDEX, SystemVariable};
use chordal_dialect::{Control, OffsetMemory};
use chordal_kernel::ToolValue;
use chordal_kernel::rules::OffsetKind;
use chordal_machine::{AXES, Machine, PerAxis};

use super::super::Interpreter;
use super::ConditionOf;
use crate::macros::arguments::letter_of;
use crate::macros::evaluate::EvaluationError;
use crate::macros::value::{MacroValue, UnknownCause};

/// The first number of system variables.
const FIRST_OF_SYSTEM: f64 = 1000.0;

pub(super) fn no_variable(number: f64, range: TextRange) -> EvaluationError {
    if number >= FIRST_OF_SYSTEM {
        return EvaluationError::new(
            Code::BadVariable,
            range,
            format!("Chordal knows no system variable #{number} of this control"),
            "if the control has it, give its value in the machine file, in `variables` of `[macros]`",
        );
    }
    EvaluationError::new(
        Code::BadVariable,
        range,
        format!("there is no variable #{number} on this control"),
        "use a local variable (1 to 33) or a common one",
    )
}

pub(super) fn read_only(number: u32, range: TextRange) -> EvaluationError {
    EvaluationError::new(
        Code::ReadOnlyVariable,
        range,
        format!("#{number} can be read, but not written"),
        "put the value into another variable",
    )
}

/// The reference points that variables in the machine file give: machine coordinates, mm and rad.
pub(in super::super) fn initial_references(
    machine: &Machine,
    control: &Control,
) -> [PerAxis<Option<f64>>; 2] {
    let mut references = [[None; AXES]; 2];
    for (&number, &value) in &machine.macros.variables {
        let (at, axis) = match control.macros.system_at(number) {
            Some((SystemVariable::Home, axis)) => (0, axis as usize),
            Some((SystemVariable::SecondHome, axis)) => (1, axis as usize),
            _ => continue,
        };
        references[at][axis] = Some(stored_place(control, axis, value));
    }
    references
}

/// A coordinate, mm or rad, from a number in the tables of a control.
fn stored_place(control: &Control, axis: usize, written: f64) -> f64 {
    if axis >= 3 { written.to_radians() } else { written * machine_unit(control) }
}

/// The unit of the control's tables, mm.
fn machine_unit(control: &Control) -> f64 {
    control.parameters.rules.units.mm()
}

/// Number of tool offsets with the old variable numbers (#2001 to #2200).
const OFFSETS_OF_MEMORY: u32 = 200;

impl Interpreter<'_> {
    /// The meaning of a system variable on this machine, and its index; `None` for no such variable.
    pub(super) fn system_at(&self, number: u32) -> Option<(SystemVariable, u32)> {
        let (what, at) = self.rules().system_at(number)?;
        if what != SystemVariable::ToolOffsetByMemory {
            return Some((what, at));
        }
        match (self.control.parameters.offset_memory, at.checked_sub(OFFSETS_OF_MEMORY)) {
            (OffsetMemory::NotKnown, _) => Some((SystemVariable::NotSimulated, at)),
            (OffsetMemory::Whole, None) => Some((SystemVariable::LengthGeometry, at)),
            (OffsetMemory::Whole, Some(_)) => None,
            (OffsetMemory::GeometryAndWear, None) => Some((SystemVariable::LengthWear, at)),
            (OffsetMemory::GeometryAndWear, Some(at)) => Some((SystemVariable::LengthGeometry, at)),
        }
    }

    /// The value of a system variable: by the state of the run, else the value that the program or the machine file
    /// gave it; otherwise it is unknown.
    pub(super) fn read_system(
        &mut self,
        index: u32,
        range: TextRange,
    ) -> Result<MacroValue, EvaluationError> {
        let stored = self.macros.kept.get(&index).copied();
        let Some((what, at)) = self.system_at(index) else {
            return stored
                .map(MacroValue::Number)
                .ok_or_else(|| no_variable(f64::from(index), range));
        };
        if matches!(what, SystemVariable::Date | SystemVariable::Time) {
            return Ok(self.date_or_time(index, what, range));
        }
        let value = match what {
            SystemVariable::WorkSystem
            | SystemVariable::WorkTable
            | SystemVariable::ProbeResult => stored.or_else(|| self.system_value(what, at)),
            _ => self.system_value(what, at).or(stored),
        };
        Ok(MacroValue::or_unknown(value, UnknownCause::Variable(index)))
    }

    /// The value of a system variable, if it follows from the program and the machine file.
    fn system_value(&self, what: SystemVariable, at: u32) -> Option<f64> {
        let axis = at as usize;
        let state = &self.kernel.state;
        let shown = |place: Option<f64>| Some(self.axis_out(axis, place?));
        let stored = |place: Option<f64>| Some(self.stored_out(axis, place?));
        match what {
            SystemVariable::BlockEnd => shown(state.known_position(axis)),
            SystemVariable::MachinePosition => shown(state.known_machine_position(axis)),
            SystemVariable::WorkPosition => {
                let length = state.offsets.known_tool_offset(axis)?;
                shown(state.known_position(axis).map(|place| place + length))
            }
            SystemVariable::SkipPosition | SystemVariable::ProbePosition => {
                shown(self.macros.probe.skipped.then(|| self.macros.skip[axis]))
            }
            SystemVariable::ActiveToolOffset => shown(state.offsets.known_tool_offset(axis)),
            SystemVariable::ModalGroup => Some(match self.rules().modal_groups.get(axis) {
                Some(group) => self.modal_code(*group),
                None => 0.0,
            }),
            SystemVariable::ModalWord(letter) => self.modal_word(letter),
            SystemVariable::ModalArgument => self.modal_word(letter_of(at + 1)?),
            SystemVariable::LengthGeometry
            | SystemVariable::LengthWear
            | SystemVariable::RadiusGeometry
            | SystemVariable::RadiusWear => self.tool_value(what, at + 1),
            SystemVariable::ExternalOffset
            | SystemVariable::WorkOffsets
            | SystemVariable::ExtendedOffsets
            | SystemVariable::WorkOffsetsOfAxis(_) => {
                // `None` for an axis that Chordal does not have.
                let (key, axis) = self.offset_place(what, at)?;
                Some(self.axis_out(axis, state.offsets.known_work_value(&key, axis)?))
            }
            SystemVariable::Output
            | SystemVariable::Input
            | SystemVariable::Timer
            | SystemVariable::Setting
            | SystemVariable::NotSimulated
            | SystemVariable::ToolOffsetByMemory
            | SystemVariable::Date
            | SystemVariable::Time => None,
            SystemVariable::Suppression | SystemVariable::Alarm | SystemVariable::Message => {
                Some(0.0)
            }
            SystemVariable::Tool => self.tool_in_spindle(),
            SystemVariable::SpindleSpeed => self.speed_word(),
            SystemVariable::Constant(value) => Some(f64::from(value)),
            SystemVariable::Home => stored(self.stored_reference(1, axis)),
            SystemVariable::SecondHome => stored(self.stored_reference(2, axis)),
            SystemVariable::Preset => {
                let is_known = self.kernel.presets_known.has(axis);
                stored(is_known.then(|| self.kernel.kept_presets.values[axis]))
            }
            SystemVariable::PresetActs => {
                let is_known = self.kernel.presets_known != AxisMask::NONE;
                is_known.then(|| f64::from(u8::from(self.kernel.preset_acts)))
            }
            SystemVariable::WorkSystem => Some(self.work_system()),
            SystemVariable::WorkTable => self.work_table(at),
            SystemVariable::SpindleTool => {
                let tool = state.offsets.tool(state.tool)?;
                stored(tool.offset_of(axis))
            }
            SystemVariable::ToolDiameter => {
                Some(2.0 * self.stored_out(0, state.offsets.radius_mm(state.tool)?))
            }
            SystemVariable::ProbeResult => {
                let probe = &self.macros.probe;
                probe.skipped.then(|| f64::from(u8::from(probe.found)))
            }
        }
    }

    pub(super) fn write_system(
        &mut self,
        index: u32,
        value: MacroValue,
        range: TextRange,
    ) -> Result<(), EvaluationError> {
        let Some((what, at)) = self.system_at(index) else {
            let stored = self.macros.kept.get_mut(&index);
            let place = stored.ok_or_else(|| no_variable(f64::from(index), range))?;
            match value.known() {
                Some(value) => *place = value,
                None => {
                    self.macros.kept.remove(&index);
                }
            }
            return Ok(());
        };
        let value = match value.counted() {
            Ok(value) => value,
            Err(cause) => return self.write_unknown(index, what, cause, range),
        };
        match what {
            SystemVariable::Alarm => self.alarm(value, range),
            SystemVariable::Message => self.message_stop(),
            SystemVariable::Output
            | SystemVariable::Suppression
            | SystemVariable::Setting
            | SystemVariable::NotSimulated
            | SystemVariable::ToolOffsetByMemory => {
                self.macros.kept.insert(index, value);
            }
            // A timer continues from the written value, so its value is then unknown.
            SystemVariable::Timer => {
                self.macros.kept.remove(&index);
            }
            SystemVariable::Home | SystemVariable::SecondHome => {
                let axis = at as usize;
                let place = self.stored_in(axis, value);
                self.references[usize::from(what == SystemVariable::SecondHome)][axis] =
                    Some(place);
            }
            SystemVariable::Preset => {
                self.kernel.kept_presets.values[at as usize] = self.stored_in(at as usize, value);
                self.kernel.presets_known.insert(at as usize);
            }
            SystemVariable::PresetActs => self.kernel.preset_acts = value != 0.0,
            SystemVariable::ProbePosition => {
                self.macros.kept.insert(index, value);
                self.macros.skip[at as usize] = self.axis_in(at as usize, value);
            }
            SystemVariable::WorkSystem | SystemVariable::ProbeResult => {
                self.macros.kept.insert(index, value);
            }
            SystemVariable::WorkTable => {
                let acts = f64::from(at / OFFSET_STEP) + 1.0 == self.work_system();
                if acts || !self.write_work_table(at, value) {
                    self.macros.kept.insert(index, value);
                }
            }
            SystemVariable::LengthGeometry => {
                self.write_tool_value(ToolValue::Length, at + 1, value)
            }
            SystemVariable::LengthWear => {
                self.write_tool_value(ToolValue::LengthWear, at + 1, value)
            }
            SystemVariable::RadiusGeometry => {
                self.write_tool_value(ToolValue::Radius, at + 1, value)
            }
            SystemVariable::RadiusWear => {
                self.write_tool_value(ToolValue::RadiusWear, at + 1, value)
            }
            SystemVariable::ExternalOffset
            | SystemVariable::WorkOffsets
            | SystemVariable::ExtendedOffsets
            | SystemVariable::WorkOffsetsOfAxis(_) => match self.offset_place(what, at) {
                Some((key, axis)) => {
                    let value = self.axis_in(axis, value);
                    self.kernel.state.shift_coordinates(|offsets| {
                        offsets.write_work(&key, axis, value, false);
                    });
                    self.kernel.emit_work_offset();
                }
                None => return Err(no_variable(f64::from(index), range)),
            },
            _ => return Err(read_only(index, range)),
        }
        Ok(())
    }

    /// The unit of the program, mm.
    pub(in super::super) fn unit(&self) -> f64 {
        self.kernel.state.units.mm()
    }

    /// A coordinate (mm or rad) as a variable shows it.
    pub(super) fn axis_out(&self, axis: usize, value: f64) -> f64 {
        let written = value / self.per_word[axis];
        if axis < 3 { written / self.unit() } else { written.to_degrees() }
    }

    /// A coordinate (mm or rad) in the unit of the control's tables.
    fn stored_out(&self, axis: usize, value: f64) -> f64 {
        if axis >= 3 { value.to_degrees() } else { value / machine_unit(self.control) }
    }

    fn stored_in(&self, axis: usize, written: f64) -> f64 {
        stored_place(self.control, axis, written)
    }

    /// Forgets values that the program wrote into probe results, after a probe move.
    pub(super) fn forget_probe_result(&mut self) {
        let rules = self.rules();
        self.macros.kept.retain(|number, _| {
            !matches!(rules.system_at(*number), Some((SystemVariable::ProbeResult, _)))
        });
    }

    /// Writes a value of the work offset table; false for an entry without an effect here.
    fn write_work_table(&mut self, at: u32, value: f64) -> bool {
        let turn = self.work_turn(at);
        let place = self.work_place(at).map(|(key, axis)| (key, axis, self.stored_in(axis, value)));
        if turn.is_none() && place.is_none() {
            return false;
        }
        self.kernel.state.shift_coordinates(|offsets| {
            if let Some((key, axis, value)) = place {
                offsets.write_work(&key, axis, value, false);
            }
            if let Some(key) = turn {
                offsets.write_rotation(&key, value);
            }
        });
        true
    }

    /// Activates the values of the active work offset that the program has written as variables: they act once a code
    /// writes this system, or once another system is selected.
    pub(in super::super) fn take_written_offsets(&mut self) {
        let rules = self.rules();
        let is_work = |number: u32| match rules.system_at(number) {
            Some((SystemVariable::WorkTable, at)) => Some(at),
            _ => None,
        };
        let kept = std::mem::take(&mut self.macros.kept);
        let (written, kept): (Vec<_>, Vec<_>) =
            kept.into_iter().partition(|(number, _)| is_work(*number).is_some());
        let is_system =
            |number: u32| matches!(rules.system_at(number), Some((SystemVariable::WorkSystem, _)));
        self.macros.kept = kept.into_iter().filter(|(number, _)| !is_system(*number)).collect();
        if written.is_empty() {
            return;
        }
        for (number, value) in written {
            if let Some(at) = is_work(number)
                && !self.write_work_table(at, value)
            {
                self.macros.kept.insert(number, value);
            }
        }
        self.kernel.emit_work_offset();
    }

    /// Key and axis of an entry of the work offset table; `None` for an entry that is not a coordinate.
    fn work_place(&self, at: u32) -> Option<(String, usize)> {
        let axis = (at % OFFSET_STEP) as usize;
        (axis < AXES).then(|| (self.key_of_work_table(at), axis))
    }

    /// Key of the work offset whose rotation a variable holds; `None` for other variables.
    fn work_turn(&self, at: u32) -> Option<String> {
        let turned = self.control.parameters.rules.frames.work_rotation;
        (turned && at % OFFSET_STEP == ROTATION_INDEX).then(|| self.key_of_work_table(at))
    }

    fn key_of_work_table(&self, at: u32) -> String {
        let system = (at / OFFSET_STEP) as u16;
        let name = if system < 6 { WorkName::G(54 + system) } else { WorkName::G59(system - 5) };
        self.kernel.state.offsets.key(name)
    }

    /// A coordinate (mm or rad) from a number assigned to a variable.
    fn axis_in(&self, axis: usize, written: f64) -> f64 {
        let value = if axis < 3 { written * self.unit() } else { written.to_radians() };
        value * self.per_word[axis]
    }

    /// Key and axis of a work offset variable.
    fn offset_place(&self, what: SystemVariable, at: u32) -> Option<(String, usize)> {
        let (system, axis) = (at / OFFSET_STEP, (at % OFFSET_STEP) as usize);
        let name = match what {
            SystemVariable::ExternalOffset => return Some(("EXT".into(), at as usize)),
            SystemVariable::WorkOffsetsOfAxis(axis) if at == 0 => {
                return Some(("EXT".into(), axis as usize));
            }
            SystemVariable::WorkOffsetsOfAxis(axis) => {
                let key = self.kernel.state.offsets.key(WorkName::G(53 + at as u16));
                return Some((key, axis as usize));
            }
            SystemVariable::ExtendedOffsets => WorkName::Extended(system as u16 + 1),
            _ => WorkName::G(54 + system as u16),
        };
        (axis < 6).then(|| (self.kernel.state.offsets.key(name), axis))
    }

    fn work_system(&self) -> f64 {
        match self.kernel.state.offsets.active() {
            WorkName::G(number) => f64::from(number) - 53.0,
            WorkName::G59(number) => f64::from(number) + 6.0,
            _ => 1.0,
        }
    }

    /// A value of the table of nine work offsets, in the unit of the control's tables.
    fn work_table(&self, at: u32) -> Option<f64> {
        if let Some(key) = self.work_turn(at) {
            return self.kernel.state.offsets.known_rotation(&key);
        }
        let (key, axis) = self.work_place(at)?;
        let value = self.kernel.state.offsets.known_work_value(&key, axis)?;
        Some(self.stored_out(axis, value))
    }

    /// A value of the tool table in the unit of the program. A tool with a known size and no wear value has no wear.
    fn tool_value(&self, what: SystemVariable, number: u32) -> Option<f64> {
        let tool = self.kernel.state.offsets.tool(number)?;
        let per_radius = match self.control.parameters.rules.radius_offsets {
            OffsetKind::Diameter => 1.0,
            OffsetKind::Radius => 2.0,
        };
        let mm = match what {
            SystemVariable::LengthGeometry => tool.offset[2]?,
            SystemVariable::LengthWear => tool.offset_wear[2].or(tool.offset[2].map(|_| 0.0))?,
            SystemVariable::RadiusGeometry => tool.diameter_mm? / per_radius,
            _ => tool.diameter_wear_mm.or(tool.diameter_mm.map(|_| 0.0))? / per_radius,
        };
        Some(mm / self.unit())
    }

    /// The number of the tool in the spindle; `None` before a tool change.
    pub(super) fn tool_in_spindle(&self) -> Option<f64> {
        let tool = self.kernel.state.tool;
        (tool != 0 && !self.kernel.state.unknown.tool).then(|| f64::from(tool))
    }

    /// S, rev/min; `None` before an S and during G96.
    pub(super) fn speed_word(&self) -> Option<f64> {
        let state = &self.kernel.state;
        let is_known = state.rpm != 0.0 && state.surface_speed.is_none() && !state.unknown.speed;
        is_known.then_some(state.rpm)
    }

    fn write_tool_value(&mut self, of: ToolValue, number: u32, value: f64) {
        let mm = value * self.unit();
        self.kernel.store_tool_value(of, number, mm, false);
        let length = self.kernel.state.offsets.length();
        if length.number == Some(number) {
            self.kernel.emit_tool_length();
        }
    }

    /// Writes an unknown value into a system variable.
    fn write_unknown(
        &mut self,
        index: u32,
        what: SystemVariable,
        cause: UnknownCause,
        range: TextRange,
    ) -> Result<(), EvaluationError> {
        match what {
            SystemVariable::Alarm | SystemVariable::Message => {
                self.assume(range, cause, ConditionOf::Branch);
                Ok(())
            }
            SystemVariable::Output
            | SystemVariable::Suppression
            | SystemVariable::Timer
            | SystemVariable::Setting
            | SystemVariable::NotSimulated
            | SystemVariable::ToolOffsetByMemory => {
                self.macros.kept.remove(&index);
                Ok(())
            }
            SystemVariable::BlockEnd
            | SystemVariable::MachinePosition
            | SystemVariable::WorkPosition
            | SystemVariable::SkipPosition
            | SystemVariable::ActiveToolOffset
            | SystemVariable::ModalGroup
            | SystemVariable::ModalWord(_)
            | SystemVariable::ModalArgument
            | SystemVariable::Input
            | SystemVariable::Date
            | SystemVariable::Time
            | SystemVariable::Tool
            | SystemVariable::SpindleSpeed
            | SystemVariable::Constant(_)
            | SystemVariable::SpindleTool
            | SystemVariable::ToolDiameter => Err(read_only(index, range)),
            SystemVariable::LengthGeometry
            | SystemVariable::LengthWear
            | SystemVariable::RadiusGeometry
            | SystemVariable::RadiusWear
            | SystemVariable::ExternalOffset
            | SystemVariable::WorkOffsets
            | SystemVariable::ExtendedOffsets
            | SystemVariable::WorkOffsetsOfAxis(_)
            | SystemVariable::Home
            | SystemVariable::SecondHome
            | SystemVariable::Preset
            | SystemVariable::PresetActs
            | SystemVariable::ProbePosition
            | SystemVariable::ProbeResult
            | SystemVariable::WorkSystem
            | SystemVariable::WorkTable => {
                self.lose_path_by(range, &format!("#{index}"), cause);
                Ok(())
            }
        }
    }

    fn date_or_time(&mut self, index: u32, what: SystemVariable, range: TextRange) -> MacroValue {
        let macros = &self.machine.macros;
        let (value, name, form) = match what {
            SystemVariable::Date => (macros.date, "date", "2024-05-17"),
            _ => (macros.time, "time", "13:45:00"),
        };
        if let Some(value) = value {
            return MacroValue::Number(f64::from(value));
        }
        if let Some(&value) = self.macros.kept.get(&index) {
            return MacroValue::Number(value);
        }
        self.report_once(
            Diagnostic::new(
                Code::DateNotSet,
                self.span(range),
                format!(
                    "#{index} is the {name}, which the machine file does not give: it is not known"
                ),
            )
            .help(format!("give it in the machine file: `[macros] {name} = \"{form}\"`")),
        );
        MacroValue::Unknown(UnknownCause::Variable(index))
    }
}

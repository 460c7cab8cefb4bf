//! System variables: positions, offsets, modal codes, alarms.

use chordal_command::{AxisMask, WorkName};
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_dialect::macros::{OFFSET_STEP, System, TURN_PLACE};
use chordal_dialect::{Control, OffsetMemory};
use chordal_kernel::ToolValue;
use chordal_kernel::rules::OffsetKind;
use chordal_machine::{AXES, Machine, PerAxis};

use super::super::Interpreter;
use super::ConditionOf;
use crate::macros::arguments::letter_of;
use crate::macros::evaluate::Fault;
use crate::macros::value::{Cause, Value};

/// From here on variables are those of the system.
const FIRST_OF_SYSTEM: f64 = 1000.0;

pub(super) fn no_variable(number: f64, range: TextRange) -> Fault {
    if number >= FIRST_OF_SYSTEM {
        return Fault::new(
            Code::BadVariable,
            range,
            format!("Chordal knows no system variable #{number} of this control"),
            "if the control has it, give its value in the machine file, in `variables` of `[macros]`",
        );
    }
    Fault::new(
        Code::BadVariable,
        range,
        format!("there is no variable #{number} on this control"),
        "use a local variable (1 to 33) or a common one",
    )
}

pub(super) fn read_only(number: u32, range: TextRange) -> Fault {
    Fault::new(
        Code::ReadOnlyVariable,
        range,
        format!("#{number} can be read, but not written"),
        "put the value into another variable",
    )
}

/// The reference points that the variables of the machine file give: machine position, mm and rad.
pub(in super::super) fn given_references(
    machine: &Machine,
    control: &Control,
) -> [PerAxis<Option<f64>>; 2] {
    let mut references = [[None; AXES]; 2];
    for (&number, &value) in &machine.macros.variables {
        let (at, axis) = match control.macros.system_at(number) {
            Some((System::Home, axis)) => (0, axis as usize),
            Some((System::SecondHome, axis)) => (1, axis as usize),
            _ => continue,
        };
        references[at][axis] = Some(stored_place(control, axis, value));
    }
    references
}

/// A coordinate, mm or rad, from a number of the tables of a control.
fn stored_place(control: &Control, axis: usize, written: f64) -> f64 {
    if axis >= 3 { written.to_radians() } else { written * machine_unit(control) }
}

/// mm in one unit of the machine, as the tables of its control count.
fn machine_unit(control: &Control) -> f64 {
    control.parameters.rules.units.mm()
}

/// So many tool offsets have old numbers.
const OFFSETS_OF_MEMORY: u32 = 200;

impl Interpreter<'_> {
    /// What a variable of the system shows on this machine.
    pub(super) fn system_at(&self, number: u32) -> Option<(System, u32)> {
        let (what, at) = self.rules().system_at(number)?;
        if what != System::OffsetOfMemory {
            return Some((what, at));
        }
        match (self.control.parameters.offset_memory, at.checked_sub(OFFSETS_OF_MEMORY)) {
            (OffsetMemory::NotKnown, _) => Some((System::MachineState, at)),
            (OffsetMemory::Whole, None) => Some((System::Length, at)),
            (OffsetMemory::Whole, Some(_)) => None,
            (OffsetMemory::GeometryAndWear, None) => Some((System::LengthWear, at)),
            (OffsetMemory::GeometryAndWear, Some(at)) => Some((System::Length, at)),
        }
    }

    /// The value of a variable of the system: of the state of the run, else what the program or the machine file has
    /// written there. Neither of them: it is not known.
    pub(super) fn read_system(&mut self, index: u32, range: TextRange) -> Result<Value, Fault> {
        let given = self.macros.kept.get(&index).copied();
        let Some((what, at)) = self.system_at(index) else {
            return given.map(Value::Number).ok_or_else(|| no_variable(f64::from(index), range));
        };
        if matches!(what, System::Date | System::Time) {
            return Ok(self.date_or_time(index, what, range));
        }
        let value = match what {
            System::WorkSystem | System::WorkTable | System::ProbeResult => {
                given.or_else(|| self.system_value(what, at))
            }
            _ => self.system_value(what, at).or(given),
        };
        Ok(Value::or_unknown(value, Cause::Variable(index)))
    }

    /// What a variable of the system shows where that follows from the program and the machine file.
    fn system_value(&self, what: System, at: u32) -> Option<f64> {
        let axis = at as usize;
        let state = &self.kernel.state;
        let shown = |place: Option<f64>| Some(self.axis_out(axis, place?));
        let stored = |place: Option<f64>| Some(self.stored_out(axis, place?));
        match what {
            System::BlockEnd => shown(state.known_position(axis)),
            System::MachinePosition => shown(state.known_machine_position(axis)),
            System::WorkPosition => {
                let length = state.offsets.known_tool_offset(axis)?;
                shown(state.known_position(axis).map(|place| place + length))
            }
            System::SkipPosition | System::ProbePosition => {
                shown(self.macros.probe.skipped.then(|| self.macros.skip[axis]))
            }
            System::ActiveToolOffset => shown(state.offsets.known_tool_offset(axis)),
            System::ModalGroup => Some(match self.rules().modal_groups.get(axis) {
                Some(group) => self.modal_code(*group),
                None => 0.0,
            }),
            System::ModalWord(letter) => self.modal_word(letter),
            System::ModalArgument => self.modal_word(letter_of(at + 1)?),
            System::Length | System::LengthWear | System::Radius | System::RadiusWear => {
                self.tool_value(what, at + 1)
            }
            System::ExternalOffset
            | System::WorkOffsets
            | System::ExtendedOffsets
            | System::OffsetsOfAxis(_) => {
                // Of an axis that Chordal does not have: none.
                let (key, axis) = self.offset_place(what, at)?;
                Some(self.axis_out(axis, state.offsets.known_work_value(&key, axis)?))
            }
            System::Kept
            | System::Input
            | System::Timer
            | System::Setting
            | System::MachineState
            | System::OffsetOfMemory
            | System::Date
            | System::Time => None,
            System::Switch | System::Alarm | System::Message => Some(0.0),
            System::Tool => self.tool_in_spindle(),
            System::SpindleSpeed => self.speed_word(),
            System::Constant(value) => Some(f64::from(value)),
            System::Home => stored(self.stored_reference(1, axis)),
            System::SecondHome => stored(self.stored_reference(2, axis)),
            System::Preset => {
                let is_known = self.kernel.presets_known.has(axis);
                stored(is_known.then(|| self.kernel.kept_presets.values[axis]))
            }
            System::PresetActs => {
                let is_known = self.kernel.presets_known != AxisMask::NONE;
                is_known.then(|| f64::from(u8::from(self.kernel.preset_acts)))
            }
            System::WorkSystem => Some(self.work_system()),
            System::WorkTable => self.work_table(at),
            System::SpindleTool => {
                let tool = state.offsets.tool(state.tool)?;
                stored(tool.offset_of(axis))
            }
            System::ToolDiameter => {
                Some(2.0 * self.stored_out(0, state.offsets.radius_mm(state.tool)?))
            }
            System::ProbeResult => {
                let probe = &self.macros.probe;
                probe.skipped.then(|| f64::from(u8::from(probe.found)))
            }
        }
    }

    pub(super) fn write_system(
        &mut self,
        index: u32,
        value: Value,
        range: TextRange,
    ) -> Result<(), Fault> {
        let Some((what, at)) = self.system_at(index) else {
            let given = self.macros.kept.get_mut(&index);
            let place = given.ok_or_else(|| no_variable(f64::from(index), range))?;
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
            System::Alarm => self.alarm(value, range),
            System::Message => self.message_stop(),
            System::Kept
            | System::Switch
            | System::Setting
            | System::MachineState
            | System::OffsetOfMemory => {
                self.macros.kept.insert(index, value);
            }
            // It runs on from what was written.
            System::Timer => {
                self.macros.kept.remove(&index);
            }
            System::Home | System::SecondHome => {
                let axis = at as usize;
                let place = self.stored_in(axis, value);
                self.references[usize::from(what == System::SecondHome)][axis] = Some(place);
            }
            System::Preset => {
                self.kernel.kept_presets.values[at as usize] = self.stored_in(at as usize, value);
                self.kernel.presets_known.insert(at as usize);
            }
            System::PresetActs => self.kernel.preset_acts = value != 0.0,
            System::ProbePosition => {
                self.macros.kept.insert(index, value);
                self.macros.skip[at as usize] = self.axis_in(at as usize, value);
            }
            System::WorkSystem | System::ProbeResult => {
                self.macros.kept.insert(index, value);
            }
            System::WorkTable => {
                let acts = f64::from(at / OFFSET_STEP) + 1.0 == self.work_system();
                if acts || !self.write_work_table(at, value) {
                    self.macros.kept.insert(index, value);
                }
            }
            System::Length => self.write_tool_value(ToolValue::Length, at + 1, value),
            System::LengthWear => self.write_tool_value(ToolValue::LengthWear, at + 1, value),
            System::Radius => self.write_tool_value(ToolValue::Radius, at + 1, value),
            System::RadiusWear => self.write_tool_value(ToolValue::RadiusWear, at + 1, value),
            System::ExternalOffset
            | System::WorkOffsets
            | System::ExtendedOffsets
            | System::OffsetsOfAxis(_) => match self.offset_place(what, at) {
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

    /// mm in one unit of the program.
    pub(in super::super) fn unit(&self) -> f64 {
        self.kernel.state.units.mm()
    }

    /// A coordinate as a variable shows it.
    pub(super) fn axis_out(&self, axis: usize, value: f64) -> f64 {
        let written = value / self.per_word[axis];
        if axis < 3 { written / self.unit() } else { written.to_degrees() }
    }

    /// A coordinate as the tables of a control show it: in the units of the machine.
    fn stored_out(&self, axis: usize, value: f64) -> f64 {
        if axis >= 3 { value.to_degrees() } else { value / machine_unit(self.control) }
    }

    fn stored_in(&self, axis: usize, written: f64) -> f64 {
        stored_place(self.control, axis, written)
    }

    /// The result of a probe move takes the place of what the program has written.
    pub(super) fn forget_probe_result(&mut self) {
        let rules = self.rules();
        self.macros.kept.retain(|number, _| {
            !matches!(rules.system_at(*number), Some((System::ProbeResult, _)))
        });
    }

    /// Writes the number of a work offset, if it is one that acts.
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

    /// The numbers of the work offset in force that the program has written as variables: they act
    /// when this system is written by a code, and else from when another one is selected.
    pub(in super::super) fn take_written_offsets(&mut self) {
        let rules = self.rules();
        let is_work = |number: u32| match rules.system_at(number) {
            Some((System::WorkTable, at)) => Some(at),
            _ => None,
        };
        let kept = std::mem::take(&mut self.macros.kept);
        let (written, kept): (Vec<_>, Vec<_>) =
            kept.into_iter().partition(|(number, _)| is_work(*number).is_some());
        let is_system =
            |number: u32| matches!(rules.system_at(number), Some((System::WorkSystem, _)));
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

    /// Key and axis of a value of the table of work offsets.
    fn work_place(&self, at: u32) -> Option<(String, usize)> {
        let axis = (at % OFFSET_STEP) as usize;
        (axis < AXES).then(|| (self.key_of_work_table(at), axis))
    }

    /// Key of the work offset whose turn a variable holds.
    fn work_turn(&self, at: u32) -> Option<String> {
        let turned = self.control.parameters.rules.frames.work_rotation;
        (turned && at % OFFSET_STEP == TURN_PLACE).then(|| self.key_of_work_table(at))
    }

    fn key_of_work_table(&self, at: u32) -> String {
        let system = (at / OFFSET_STEP) as u16;
        let name = if system < 6 { WorkName::G(54 + system) } else { WorkName::G59(system - 5) };
        self.kernel.state.offsets.key(name)
    }

    /// A coordinate from the number that a variable got.
    fn axis_in(&self, axis: usize, written: f64) -> f64 {
        let value = if axis < 3 { written * self.unit() } else { written.to_radians() };
        value * self.per_word[axis]
    }

    /// Key and axis of a work offset's variable.
    fn offset_place(&self, what: System, at: u32) -> Option<(String, usize)> {
        let (system, axis) = (at / OFFSET_STEP, (at % OFFSET_STEP) as usize);
        let name = match what {
            System::ExternalOffset => return Some(("EXT".into(), at as usize)),
            System::OffsetsOfAxis(axis) if at == 0 => return Some(("EXT".into(), axis as usize)),
            System::OffsetsOfAxis(axis) => {
                let key = self.kernel.state.offsets.key(WorkName::G(53 + at as u16));
                return Some((key, axis as usize));
            }
            System::ExtendedOffsets => WorkName::Extended(system as u16 + 1),
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

    /// A value of the tables of the nine work offsets, in the units of the machine.
    fn work_table(&self, at: u32) -> Option<f64> {
        if let Some(key) = self.work_turn(at) {
            return self.kernel.state.offsets.known_rotation(&key);
        }
        let (key, axis) = self.work_place(at)?;
        let value = self.kernel.state.offsets.known_work_value(&key, axis)?;
        Some(self.stored_out(axis, value))
    }

    /// A value of the table of tools. A tool of which the size is known and no wear has none.
    fn tool_value(&self, what: System, number: u32) -> Option<f64> {
        let tool = self.kernel.state.offsets.tool(number)?;
        let per_radius = match self.control.parameters.rules.radius_offsets {
            OffsetKind::Diameter => 1.0,
            OffsetKind::Radius => 2.0,
        };
        let mm = match what {
            System::Length => tool.offset[2]?,
            System::LengthWear => tool.offset_wear[2].or(tool.offset[2].map(|_| 0.0))?,
            System::Radius => tool.diameter_mm? / per_radius,
            _ => tool.diameter_wear_mm.or(tool.diameter_mm.map(|_| 0.0))? / per_radius,
        };
        Some(mm / self.unit())
    }

    /// The tool in the spindle, where the program has changed it.
    pub(super) fn tool_in_spindle(&self) -> Option<f64> {
        let tool = self.kernel.state.tool;
        (tool != 0 && !self.kernel.state.unknown.tool).then(|| f64::from(tool))
    }

    /// S as the program wrote it, rev/min; none before it, and while a cutting speed is kept.
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

    /// A value that is not known is written into a variable of the system.
    fn write_unknown(
        &mut self,
        index: u32,
        what: System,
        cause: Cause,
        range: TextRange,
    ) -> Result<(), Fault> {
        match what {
            System::Alarm | System::Message => {
                self.assume(range, cause, ConditionOf::Branch);
                Ok(())
            }
            System::Kept
            | System::Switch
            | System::Timer
            | System::Setting
            | System::MachineState
            | System::OffsetOfMemory => {
                self.macros.kept.remove(&index);
                Ok(())
            }
            System::BlockEnd
            | System::MachinePosition
            | System::WorkPosition
            | System::SkipPosition
            | System::ActiveToolOffset
            | System::ModalGroup
            | System::ModalWord(_)
            | System::ModalArgument
            | System::Input
            | System::Date
            | System::Time
            | System::Tool
            | System::SpindleSpeed
            | System::Constant(_)
            | System::SpindleTool
            | System::ToolDiameter => Err(read_only(index, range)),
            System::Length
            | System::LengthWear
            | System::Radius
            | System::RadiusWear
            | System::ExternalOffset
            | System::WorkOffsets
            | System::ExtendedOffsets
            | System::OffsetsOfAxis(_)
            | System::Home
            | System::SecondHome
            | System::Preset
            | System::PresetActs
            | System::ProbePosition
            | System::ProbeResult
            | System::WorkSystem
            | System::WorkTable => {
                self.lose_path_by(range, &format!("#{index}"), cause);
                Ok(())
            }
        }
    }

    fn date_or_time(&mut self, index: u32, what: System, range: TextRange) -> Value {
        let macros = &self.machine.macros;
        let (value, name, form) = match what {
            System::Date => (macros.date, "date", "2024-05-17"),
            _ => (macros.time, "time", "13:45:00"),
        };
        if let Some(value) = value {
            return Value::Number(f64::from(value));
        }
        if let Some(&value) = self.macros.kept.get(&index) {
            return Value::Number(value);
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
        Value::Unknown(Cause::Variable(index))
    }
}

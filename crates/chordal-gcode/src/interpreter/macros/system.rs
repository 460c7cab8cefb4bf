//! System variables: positions, offsets, modal codes, alarms.

use chordal_command::{FeedMode, Side, Units, WorkName};
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_dialect::Action;
use chordal_dialect::macros::{ModalGroup, OFFSET_STEP, System, TURN_PLACE};
use chordal_geometry::{Direction, Plane};
use chordal_kernel::Motion;
use chordal_kernel::ToolValue;
use chordal_kernel::rules::{CycleKind, OffsetKind};
use chordal_machine::AXES;

use super::super::Interpreter;
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

impl Interpreter<'_> {
    pub(super) fn read_system(&mut self, index: u32, range: TextRange) -> Result<Value, Fault> {
        let Some((what, at)) = self.rules().system_at(index) else {
            let given = self.macros.kept.get(&index).copied();
            return given.map(Value::Number).ok_or_else(|| no_variable(f64::from(index), range));
        };
        let axis = at as usize;
        let unknown = Value::Unknown(Cause::Variable(index));
        let place = |place: Option<f64>| {
            Value::or_unknown(
                place.map(|place| self.stored_out(axis, place)),
                Cause::Variable(index),
            )
        };
        let value = match what {
            System::BlockEnd => self.axis_out(axis, self.kernel.state.position[axis]),
            System::MachinePosition => {
                self.axis_out(axis, self.kernel.state.machine_position(axis))
            }
            System::WorkPosition => {
                let offsets = &self.kernel.state.offsets;
                let length = offsets.total()[axis] - offsets.work()[axis];
                self.axis_out(axis, self.kernel.state.position[axis] + length)
            }
            System::SkipPosition | System::ProbePosition => {
                self.axis_out(axis, self.macros.skip[axis])
            }
            System::ActiveToolOffset => {
                self.axis_out(axis, self.kernel.state.offsets.tool_in_force()[axis])
            }
            System::ModalGroup => match self.rules().modal_groups.get(axis) {
                Some(group) => self.modal_code(*group),
                None => 0.0,
            },
            System::ModalWord(letter) => return Ok(self.modal_word(index, letter)),
            System::ModalArgument => match letter_of(at + 1) {
                Some(letter) => return Ok(self.modal_word(index, letter)),
                None => 0.0,
            },
            System::Length | System::LengthWear | System::Radius | System::RadiusWear => {
                self.tool_value(what, at + 1)
            }
            System::ExternalOffset
            | System::WorkOffsets
            | System::ExtendedOffsets
            | System::OffsetsOfAxis(_) => match self.offset_place(what, at) {
                Some((key, axis)) => {
                    let value = self.kernel.state.offsets.work_value(&key, axis).unwrap_or(0.0);
                    self.axis_out(axis, value)
                }
                // Of an axis that Chordal does not have.
                None => return Ok(unknown),
            },
            System::Kept => self.macros.kept.get(&index).copied().unwrap_or(0.0),
            System::Input | System::Timer | System::Setting | System::MachineState => {
                let given = self.macros.kept.get(&index).copied();
                return Ok(given.map_or(unknown, Value::Number));
            }
            System::Date | System::Time => return Ok(self.date_or_time(index, what, range)),
            System::Alarm | System::Message => 0.0,
            System::Tool => f64::from(self.kernel.state.tool),
            System::SpindleSpeed => self.kernel.state.rpm,
            System::Constant(value) => f64::from(value),
            System::Home => return Ok(place(self.reference(1)[axis])),
            System::SecondHome => return Ok(place(self.reference(2)[axis])),
            System::Preset => self.stored_out(axis, self.kernel.kept_presets.values[axis]),
            System::PresetActs => f64::from(u8::from(self.kernel.preset_acts)),
            System::WorkSystem => self.kept_or(index, self.work_system()),
            System::WorkTable => self.kept_or(index, self.work_table(at)),
            System::SpindleTool => {
                let state = &self.kernel.state;
                let tool = state.offsets.tool(state.tool);
                let offset = tool.and_then(|tool| tool.offset_of(axis));
                self.stored_out(axis, offset.unwrap_or(0.0))
            }
            System::ToolDiameter => {
                let radius = self.kernel.state.offsets.radius_mm(self.kernel.state.tool);
                2.0 * self.stored_out(0, radius.unwrap_or(0.0))
            }
            System::ProbeResult => {
                self.kept_or(index, f64::from(u8::from(self.macros.probe.found)))
            }
        };
        Ok(Value::Number(value))
    }

    pub(super) fn write_system(
        &mut self,
        index: u32,
        value: Value,
        range: TextRange,
    ) -> Result<(), Fault> {
        let Some((what, at)) = self.rules().system_at(index) else {
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
            System::Kept | System::Timer | System::Setting | System::MachineState => {
                self.macros.kept.insert(index, value);
            }
            System::Home | System::SecondHome => {
                let axis = at as usize;
                let place = self.stored_in(axis, value);
                self.references[usize::from(what == System::SecondHome)][axis] = Some(place);
            }
            System::Preset => {
                self.kernel.kept_presets.values[at as usize] = self.stored_in(at as usize, value);
            }
            System::PresetActs => self.kernel.preset_acts = value != 0.0,
            System::ProbePosition => {
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
    pub(super) fn unit(&self) -> f64 {
        match self.kernel.state.units {
            Units::Inch => 25.4,
            Units::Millimetre => 1.0,
        }
    }

    /// A coordinate as a variable shows it.
    pub(super) fn axis_out(&self, axis: usize, value: f64) -> f64 {
        let written = value / self.per_word[axis];
        if axis < 3 { written / self.unit() } else { written.to_degrees() }
    }

    /// A coordinate as the tables of a control show it: in the units of the machine.
    fn stored_out(&self, axis: usize, value: f64) -> f64 {
        if axis >= 3 { value.to_degrees() } else { value / self.machine_unit() }
    }

    fn stored_in(&self, axis: usize, written: f64) -> f64 {
        if axis >= 3 { written.to_radians() } else { written * self.machine_unit() }
    }

    /// mm in one unit of the machine.
    fn machine_unit(&self) -> f64 {
        match self.control.parameters.rules.units {
            Units::Inch => 25.4,
            Units::Millimetre => 1.0,
        }
    }

    /// The result of a probe move takes the place of what the program has written.
    pub(super) fn forget_probe_result(&mut self) {
        let rules = self.rules();
        self.macros.kept.retain(|number, _| {
            !matches!(rules.system_at(*number), Some((System::ProbeResult, _)))
        });
    }

    /// What the program has written there, else a value.
    fn kept_or(&self, index: u32, value: f64) -> f64 {
        self.macros.kept.get(&index).copied().unwrap_or(value)
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
    fn work_table(&self, at: u32) -> f64 {
        if let Some(key) = self.work_turn(at) {
            return self.kernel.state.offsets.rotation(&key);
        }
        let Some((key, axis)) = self.work_place(at) else { return 0.0 };
        let value = self.kernel.state.offsets.work_value(&key, axis).unwrap_or(0.0);
        self.stored_out(axis, value)
    }

    fn tool_value(&self, what: System, number: u32) -> f64 {
        let Some(tool) = self.kernel.state.offsets.tool(number) else { return 0.0 };
        let per_radius = match self.control.parameters.rules.radius_offsets {
            OffsetKind::Diameter => 1.0,
            OffsetKind::Radius => 2.0,
        };
        let mm = match what {
            System::Length => tool.offset[2].unwrap_or(0.0),
            System::LengthWear => tool.offset_wear[2].unwrap_or(0.0),
            System::Radius => tool.diameter_mm.unwrap_or(0.0) / per_radius,
            _ => tool.diameter_wear_mm.unwrap_or(0.0) / per_radius,
        };
        mm / self.unit()
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
                self.assume_not(range, cause);
                Ok(())
            }
            System::Kept | System::Timer | System::Setting | System::MachineState => {
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

    /// The last word of a letter.
    fn modal_word(&self, index: u32, letter: u8) -> Value {
        let state = &self.kernel.state;
        let is_unknown = match letter {
            b'D' => state.unknown.radius_offset,
            b'F' => state.unknown.feed,
            b'S' => state.unknown.speed,
            b'T' => state.unknown.tool,
            _ => false,
        };
        if is_unknown {
            return Value::Unknown(Cause::Variable(index));
        }
        Value::Number(match letter {
            b'B' => state.position[4].to_degrees(),
            b'D' => f64::from(state.radius_offset.unwrap_or(0)),
            b'F' => self.feed_word(),
            b'H' => f64::from(state.named_length.or(state.offsets.length().number).unwrap_or(0)),
            b'N' => self.sequence.map_or(0.0, |number| number.to_f64()),
            b'O' => f64::from(self.program_at(self.program).head.number.unwrap_or(0)),
            b'S' => state.rpm,
            b'T' => f64::from(state.selected_tool.unwrap_or(state.tool)),
            b'P' => match state.offsets.active() {
                WorkName::Extended(number) => f64::from(number),
                _ => 0.0,
            },
            _ => {
                let last = self.macros.last_words.get((letter - b'A') as usize);
                let given = || self.macros.kept.get(&index).copied();
                let word = last.copied().flatten().or_else(given);
                return Value::or_unknown(word, Cause::Variable(index));
            }
        })
    }

    /// F as the program wrote it.
    pub(super) fn feed_word(&self) -> f64 {
        let state = &self.kernel.state;
        let Some(feed) = state.feed else { return 0.0 };
        match state.feed_mode {
            FeedMode::PerTime => feed * 60.0 / self.unit(),
            FeedMode::InverseTime => feed * 60.0,
            FeedMode::PerRevolution => feed / self.unit(),
        }
    }

    /// Ten times the code of the motion in force, by its row.
    pub(super) fn motion_row_code(&self) -> f64 {
        let action = self.kernel.state.motion_mode().map(Action::from);
        let row = self.control.table.g_codes.iter().find(|row| Some(row.action) == action);
        row.map_or(0.0, |row| f64::from(row.code))
    }

    /// The code in force of a group.
    fn modal_code(&self, group: ModalGroup) -> f64 {
        let state = &self.kernel.state;
        match group {
            ModalGroup::Motion => match state.motion {
                Motion::Rapid | Motion::None => 0.0,
                Motion::Linear => 1.0,
                Motion::Thread | Motion::RigidTap => 33.0,
                Motion::Arc(Direction::Cw) | Motion::Spiral(Direction::Cw) => 2.0,
                Motion::Arc(Direction::Ccw) | Motion::Spiral(Direction::Ccw) => 3.0,
                Motion::Spline(form) => self.spline_code(form) / 10.0,
                Motion::Turn(_) => self.motion_row_code() / 10.0,
            },
            ModalGroup::Plane => match state.plane {
                Plane::Xy => 17.0,
                Plane::Zx => 18.0,
                Plane::Yz => 19.0,
            },
            ModalGroup::Distance if state.incremental => 91.0,
            ModalGroup::Distance => 90.0,
            ModalGroup::FeedMode => match state.feed_mode {
                FeedMode::PerTime => 94.0,
                FeedMode::InverseTime => 93.0,
                FeedMode::PerRevolution => 95.0,
            },
            ModalGroup::Units => self.units_code(),
            ModalGroup::Compensation => match state.side {
                Side::Off => 40.0,
                Side::Left => 41.0,
                Side::Right => 42.0,
            },
            ModalGroup::Length => match state.offsets.length() {
                length if length.number.is_none() => 49.0,
                length if length.minus => 44.0,
                _ => 43.0,
            },
            ModalGroup::Cycle => state.cycle.map_or(80.0, |cycle| self.cycle_code(cycle.kind)),
            ModalGroup::ReturnLevel if state.return_to_r => 99.0,
            ModalGroup::ReturnLevel => 98.0,
            ModalGroup::WorkOffset => match state.offsets.active() {
                WorkName::G(number) => f64::from(number),
                WorkName::Extended(_) => self.extended_code(),
                _ => 54.0,
            },
            ModalGroup::ModalCall if self.macros.active > 0 => 66.0,
            ModalGroup::ModalCall => 67.0,
            ModalGroup::Fixed(code) => f64::from(code),
        }
    }

    fn units_code(&self) -> f64 {
        let by_g70 = self.control.parameters.unit_codes == chordal_dialect::UnitCodes::G70;
        match self.kernel.state.units {
            Units::Inch if by_g70 => 70.0,
            Units::Millimetre if by_g70 => 71.0,
            Units::Inch => 20.0,
            Units::Millimetre => 21.0,
        }
    }

    fn cycle_code(&self, kind: CycleKind) -> f64 {
        let rows = self.control.table.g_codes;
        let row = rows.iter().find(|row| row.action == Action::Cycle(kind));
        row.map_or(80.0, |row| f64::from(row.code) / 10.0)
    }

    /// 54.1 or 154.
    fn extended_code(&self) -> f64 {
        let code = self.control.table.work_names.extended;
        code.trim_start_matches('G').parse().unwrap_or(54.0)
    }
}

//! What lies between program and machine coordinates: work offsets, shifts, presets, tool length. Also the radius
//! offset of compensation.

use chordal_command::{AxisMask, CommandKind, CompensationSide, Position, WorkName};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_geometry::Plane;
use chordal_machine::{AXES, PerAxis};

use crate::kernel::Kernel;
use crate::offsets::LengthOffset;
use crate::rules::OffsetKind;
use crate::statement::{Statement, WordMeaning};

/// A value of a tool in the offset table.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ToolValue {
    /// Length.
    Length,
    /// Wear of the length.
    LengthWear,
    /// Radius, or diameter where the table holds diameters.
    Radius,
    /// Wear of the radius or diameter.
    RadiusWear,
}

impl Kernel<'_> {
    /// Emits the active work offset.
    pub fn emit_work_offset(&mut self) {
        let state = &self.state;
        let kind = CommandKind::WorkOffset {
            name: state.offsets.active(),
            offset: state.offsets.work(),
            zero: state.offsets.zero(),
            turned: state.offsets.turned(),
            known: state.offsets.known(),
            position: state.position,
        };
        self.emit(kind);
    }

    /// Chooses a work coordinate system.
    pub fn select_work(&mut self, name: WorkName) {
        if self.state.offsets.active() == name {
            return;
        }
        let before = self.state.offsets.work();
        self.state.shift_coordinates(|offsets| offsets.select(name));
        if self.rules.frames.rotation_stays {
            let after = self.state.offsets.work();
            let by = std::array::from_fn(|axis| before[axis] - after[axis]);
            self.state.change_frames(|frames| frames.move_rotation(&by));
        }
        self.emit_work_offset();
    }

    /// Activates a tool length; without a number, ends the active one.
    pub fn set_length(&mut self, at: &dyn Statement, length: LengthOffset) {
        let cancel = self.rules.cycles.cancel;
        self.end_cycle_if(length.number.is_none() && cancel.by_length_cancel);
        let copied = self.rules.length_is_copied;
        self.state.shift_coordinates(|offsets| offsets.set_length(length, copied));
        let length_mm = self.state.offsets.length_in_force();
        if let (Some(number), None) = (length.number, length_mm) {
            let span = at.words(WordMeaning::LengthOffset);
            if self.machine.turns() || self.rules.starts_in == Plane::Zx {
                return self.report_no_geometry(span, number);
            }
            self.report_no_length(span, number);
        }
        self.emit_tool_length();
    }

    /// Ends the active length where another code (a tool change, M30) does so on this control.
    pub(crate) fn end_length_if(&mut self, ends: bool) {
        if ends && self.state.offsets.has_length() {
            let none = LengthOffset { number: None, minus: false };
            self.state.shift_coordinates(|offsets| offsets.set_length(none, false));
            self.emit_tool_length();
        }
    }

    /// Reports a length that the machine file does not give. Where it gives that of the tool in the spindle, the number is
    /// probably wrong: the table of the control has a 0 there.
    fn report_no_length(&mut self, span: Span, number: u32) {
        let message = format!("the machine file gives no length for tool {number}");
        let tool = self.state.tool;
        if tool == number || self.state.offsets.length_mm(tool).is_none() {
            let help = format!("set it with --set tools.{number}.length=\"…\"");
            return self.report_unset(Code::OffsetNotSet, span, "length".into(), message, help);
        }
        let diagnostic = Diagnostic::new(Code::OffsetNotSet, span, message)
            .severity(Severity::Warning)
            .label(format!("tool {tool} is in the spindle, and its length is given"))
            .help(format!("write H{tool}, or set tools.{number}.length"));
        self.report(diagnostic);
    }

    /// Reports a turning tool whose X and Z the machine file does not give.
    fn report_no_geometry(&mut self, span: Span, number: u32) {
        self.report_unset(
            Code::OffsetNotSet,
            span,
            format!("geometry {number}"),
            format!("the machine file gives no geometry for offset {number}: X and Z of the tool are not known"),
            format!("set it with --set tools.{number}.offset.X=\"…\" and tools.{number}.offset.Z"),
        );
        self.emit_tool_length();
    }

    /// Activates tool offsets by their values, mm and rad: replacing the active ones, or added to them.
    pub fn set_tool_offsets(&mut self, values: &PerAxis<Option<f64>>, add: bool) {
        self.state.shift_coordinates(|offsets| {
            let mut tool = offsets.tool_in_force();
            for (axis, value) in values.iter().enumerate() {
                let Some(value) = *value else { continue };
                tool[axis] = if add { tool[axis] + value } else { value };
            }
            offsets.set_tool_values(tool);
        });
        self.emit_tool_length();
    }

    /// Emits the active tool offset.
    pub fn emit_tool_length(&mut self) {
        let offsets = &self.state.offsets;
        let kind = CommandKind::ToolLength {
            number: offsets.length().number,
            length_mm: offsets.length_in_force(),
            is_subtracted: offsets.length().minus,
            offset: offsets.tool_in_force(),
            known: offsets.known(),
        };
        self.emit(kind);
    }

    /// Reports a missing value once for each offset.
    pub(crate) fn report_unset(
        &mut self,
        code: Code,
        span: Span,
        name: String,
        message: String,
        help: String,
    ) {
        if self.reported.offsets.contains(&name) {
            return;
        }
        self.reported.offsets.push(name);
        self.report(Diagnostic::new(code, span, message).help(help));
    }

    /// Emits that compensation starts or ends, or that its offset changes.
    pub fn emit_compensation(&mut self, number: Option<u32>, toward: Option<[f64; 2]>, span: Span) {
        let side = self.state.side;
        let cancelled = number == Some(0);
        let radius_mm = match number {
            Some(0) => Some(0.0),
            other => other.and_then(|number| self.state.offsets.radius_mm(number)),
        };
        if cancelled && side != CompensationSide::Off {
            self.report(
                Diagnostic::new(
                    Code::CompensationWithoutOffset,
                    span,
                    "with D0 the tool is not offset",
                )
                .severity(Severity::Note)
                .help("write the number of the tool's offset"),
            );
        }
        let tip = number.map_or([0.0; 2], |number| self.tip(number));
        self.emit(CommandKind::Compensation { side, number, radius_mm, toward, tip });
        if let (Some(number), None) = (number, radius_mm)
            && side != CompensationSide::Off
            && !cancelled
        {
            self.report_unset(
                Code::DiameterNotSet,
                span,
                format!("radius {number}"),
                format!(
                    "the machine file gives no diameter for offset {number}: compensation has no \
                     effect, and the programmed contour is shown"
                ),
                format!("set it with --set tools.{number}.diameter=\"…\""),
            );
        }
    }

    /// From the centre of a turning tool's nose to its programmed point, in nose radii on the axes of the plane,
    /// by the tip number of Fanuc and Haas (3 for turning outside towards the chuck).
    fn tip(&self, number: u32) -> [f64; 2] {
        let tip = self.state.offsets.tool(number).and_then(|tool| tool.tip);
        self.direction_of_tip(tip)
    }

    /// The same for a tip number; zero for tip 0 or 9, without a number and in other planes than ZX.
    pub fn direction_of_tip(&self, tip: Option<u32>) -> [f64; 2] {
        // From the programmed point to the centre, along X and along Z.
        let (x, z) = match tip {
            _ if self.state.plane != Plane::Zx => (0.0, 0.0),
            Some(1) => (-1.0, -1.0),
            Some(2) => (-1.0, 1.0),
            Some(3) => (1.0, 1.0),
            Some(4) => (1.0, -1.0),
            Some(5) => (0.0, -1.0),
            Some(6) => (-1.0, 0.0),
            Some(7) => (0.0, 1.0),
            Some(8) => (1.0, 0.0),
            _ => (0.0, 0.0),
        };
        let x = if self.rules.turning.tips_mirrored { -x } else { x };
        // `0.0 -` instead of a minus sign: −0 would appear in the output.
        [0.0 - z, 0.0 - x]
    }

    /// Writes one value of a tool, mm, or adds to it. A radius is stored as a diameter.
    pub fn store_tool_value(&mut self, value: ToolValue, number: u32, mm: f64, add: bool) {
        let diameter = match self.rules.radius_offsets {
            OffsetKind::Diameter => 1.0,
            OffsetKind::Radius => 2.0,
        };
        self.state.shift_coordinates(|offsets| {
            let tool = offsets.tool_mut(number);
            let (field, mm) = match value {
                ToolValue::Length => (&mut tool.offset[2], mm),
                ToolValue::LengthWear => (&mut tool.offset_wear[2], mm),
                ToolValue::Radius => (&mut tool.diameter_mm, mm * diameter),
                ToolValue::RadiusWear => (&mut tool.diameter_wear_mm, mm * diameter),
            };
            *field = Some(if add { field.unwrap_or(0.0) + mm } else { mm });
        });
    }

    /// True when values of work offsets are added to those in the table.
    pub fn adds_to_work_values(&self) -> bool {
        self.rules.work_values_add && self.state.incremental
    }

    /// Writes a work offset: the values themselves, or (`from_position`) the offset with which the present
    /// position gets these coordinates.
    pub fn write_work_values(
        &mut self,
        key: &str,
        values: &PerAxis<Option<f64>>,
        from_position: bool,
    ) {
        let add = self.adds_to_work_values() && !from_position;
        let machine: Vec<f64> = (0..AXES).map(|axis| self.state.machine_position(axis)).collect();
        let active = self.state.offsets.key(self.state.offsets.active());
        let offsets = &self.state.offsets;
        // `beyond`: what is added to every system (EXT, shifts, presets); the system's own part changes.
        let own = |key: &str, axis: usize| offsets.work_value(key, axis).unwrap_or(0.0);
        let total = offsets.total();
        let beyond: Position = std::array::from_fn(|axis| total[axis] - own(&active, axis));
        let map = match offsets.own_turn(key) {
            Some(turn) => turn,
            None => *self.state.frames.map(),
        };
        let mut named = AxisMask::with_values(values);
        let meant = if from_position {
            named = map.reached(named);
            let work = std::array::from_fn(|axis| machine[axis] - beyond[axis] - own(key, axis));
            let place = map.inverse().point(&work);
            map.point(&std::array::from_fn(|axis| values[axis].unwrap_or(place[axis])))
        } else {
            values.map(|value| value.unwrap_or(0.0))
        };
        self.state.shift_coordinates(|offsets| {
            for axis in named.iter().map(|axis| axis as usize) {
                let stored = if from_position {
                    // So that the present position gets this coordinate.
                    machine[axis] - meant[axis] - beyond[axis]
                } else {
                    meant[axis]
                };
                offsets.write_work(key, axis, stored, add);
            }
        });
        self.emit_written_offset(key);
    }

    /// Rotates a work coordinate system about its zero, degrees.
    pub fn write_work_rotation(&mut self, key: &str, degrees: f64) {
        self.state.write_work_rotation(key, degrees);
        self.emit_written_offset(key);
    }

    /// Emits the work offset when the written system is the active one, or `EXT`, which acts on all.
    fn emit_written_offset(&mut self, key: &str) {
        let offsets = &self.state.offsets;
        if key == "EXT" || key == offsets.key(offsets.active()) {
            self.emit_work_offset();
        }
    }

    /// G52.
    pub fn local_shift(&mut self, values: &PerAxis<Option<f64>>) {
        if self.rules.shift_is_preset {
            return self.shift_by_preset(values);
        }
        self.state.shift_coordinates(|offsets| {
            for (axis, value) in values.iter().enumerate() {
                if let Some(value) = value {
                    offsets.set_shift(axis, *value);
                }
            }
        });
        self.emit_work_offset();
    }

    /// G52 where it writes the values of G92.
    fn shift_by_preset(&mut self, values: &PerAxis<Option<f64>>) {
        let mut presets = self.state.offsets.presets();
        for (preset, value) in presets.values.iter_mut().zip(values) {
            *preset = value.unwrap_or(*preset);
        }
        self.state.shift_coordinates(|offsets| offsets.set_presets(presets));
        let named = AxisMask::with_values(values);
        self.note_preset(named, named);
        self.emit_work_offset();
    }

    /// Remembers that G92 or G52 acts from here on, on the axes `named`; of those, the values of `known` are known.
    fn note_preset(&mut self, named: AxisMask, known: AxisMask) {
        self.presets_known = self.presets_known.without(named).or(known);
        self.kept_presets = self.state.offsets.presets();
        self.preset_acts = true;
    }

    /// G92: the present position gets these coordinates.
    pub fn preset_position(&mut self, values: &PerAxis<Option<f64>>) {
        let inside = self.state.frames.are_inside_presets();
        let (position, meant) = match inside {
            true => (self.state.work_position(), self.in_work_coordinates(values)),
            false => (self.state.position, values.map(|value| value.unwrap_or(0.0))),
        };
        let machine_known = self.state.machine_known;
        let clears_shift = self.rules.preset_clears_shift;
        let mut named = AxisMask::with_values(values);
        if inside {
            named = self.state.frames.map().reached(named);
        }
        let somewhere = named.without(self.state.known);
        let placed = named.without(somewhere).without(self.state.start.program);
        self.state.shift_coordinates(|offsets| {
            offsets.preset_somewhere(somewhere);
            for axis in 0..AXES {
                if named.has(axis) {
                    if clears_shift {
                        offsets.move_shift_to_preset(axis);
                    }
                    let by = position[axis] - meant[axis];
                    offsets.add_preset(axis, by, machine_known.has(axis));
                }
            }
        });
        for (axis, value) in values.iter().enumerate() {
            if let Some(value) = value {
                // Exactly what was written, not a difference of sums.
                self.state.position[axis] = *value;
                self.state.known.insert(axis);
                self.state.start.program.remove(axis);
            }
        }
        self.note_preset(named, placed);
        self.emit_work_offset();
    }

    /// A point of program coordinates in the work coordinate system; an axis without a value keeps its position.
    fn in_work_coordinates(&self, values: &PerAxis<Option<f64>>) -> Position {
        let position = self.state.position;
        let place = std::array::from_fn(|axis| values[axis].unwrap_or(position[axis]));
        self.state.frames.map().point(&place)
    }

    /// G92.1 and G92.2; the second keeps the values for G92.3 (`keep`).
    pub fn clear_preset(&mut self, keep: bool) {
        if !keep {
            self.kept_presets = self.kept_presets.ended();
            self.presets_known = AxisMask::ALL;
        }
        self.preset_acts = false;
        let none = self.state.offsets.presets().ended();
        self.state.shift_coordinates(|offsets| offsets.set_presets(none));
        self.emit_work_offset();
    }

    /// G92.3: the presets that G92.2 has kept.
    pub fn restore_preset(&mut self) {
        let kept = self.kept_presets;
        self.preset_acts = true;
        self.state.shift_coordinates(|offsets| offsets.set_presets(kept));
        self.emit_work_offset();
    }
}

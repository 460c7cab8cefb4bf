//! Work offsets, shifts and tool length: what lies between program and machine coordinates.

use std::collections::{BTreeMap, BTreeSet};

use chordal_command::{AxisMask, Position, UnknownPresets, WorkName, WorkNaming, WorkZero};
use chordal_geometry::Plane;
use chordal_machine::{AXES, Axis, Machine, PerAxis, Tool};

use crate::frames::{FrameMap, Frames};

const X: usize = Axis::X as usize;
/// The axis of the tool length. A mill's table has no other: its missing offsets on other axes count as zero.
const Z: usize = Axis::Z as usize;

/// The offset tables and which of them are active.
#[derive(Clone, PartialEq, Debug)]
pub struct Offsets {
    systems: BTreeMap<String, PerAxis<Option<f64>>>,
    /// The rotation of a system about its zero, degrees.
    rotations: BTreeMap<String, f64>,
    external: PerAxis<Option<f64>>,
    tools: BTreeMap<u32, Tool>,
    naming: WorkNaming,
    /// The linear axes that the machine does not have: their offsets count as known.
    absent: AxisMask,
    /// The axes along which tools differ: that of the tool, Z at first, and X on lathes.
    tool_axes: AxisMask,
    /// Tools are those of a turret.
    is_turret: bool,
    active: WorkName,
    /// G52, added to every system.
    shift: Position,
    /// G92, added to every system.
    preset: Position,
    /// Axes whose machine position G92 made known or unknown, regardless of the table; `None` by the table.
    preset_known: PerAxis<Option<bool>>,
    /// Presets that were programmed at an unknown position of the work coordinate system.
    unknown_presets: UnknownPresets,
    /// The error of a clamped part, which turns with the tables.
    fixture: FixtureError,
    length: LengthOffset,
    /// Tool offsets that are active by their values, not by the table.
    tool_values: Option<Position>,
    total: Position,
    work: Position,
    system: Position,
    system_known: AxisMask,
    known: AxisMask,
    /// What was written since [`Offsets::take_written`].
    written: Vec<WrittenOffset>,
    /// All that was written since the start.
    touched: BTreeSet<WrittenOffset>,
}

/// An entry of the offset tables that a program has written.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum WrittenOffset {
    /// A work coordinate system by its key, on an axis.
    Work(String, usize),
    /// Its rotation.
    Rotation(String),
    /// A tool.
    Tool(u32),
}

/// What G92 and similar codes add to the coordinates.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
pub struct CoordinatePresets {
    /// What they add on every axis, mm and rad.
    pub values: Position,
    /// Presets programmed at an unknown position.
    pub unknown: UnknownPresets,
}

impl CoordinatePresets {
    /// Ends all presets; the count is kept, so that later ones differ from earlier ones.
    pub(crate) fn ended(self) -> CoordinatePresets {
        let unknown = UnknownPresets { axes: AxisMask::NONE, ..self.unknown };
        CoordinatePresets { values: [0.0; AXES], unknown }
    }
}

/// The error of a clamped part that is added to the work offset.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FixtureError {
    /// Its number in the table; 0: none is in force.
    pub number: u16,
    /// What it adds to X, Y and Z as the tables stand, mm.
    pub shift: [f64; 3],
    /// Whether the table gives it, and how the tables stand is known.
    pub is_known: bool,
}

impl FixtureError {
    /// None.
    pub const NONE: FixtureError = FixtureError { number: 0, shift: [0.0; 3], is_known: true };

    /// Its name in the table of work offsets of a machine file.
    pub fn key(number: u16) -> String {
        format!("G54.2 P{number}")
    }
}

/// The tool length in force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LengthOffset {
    /// Its number; `None` when cancelled.
    pub number: Option<u32>,
    /// Subtracted (G44), not added.
    pub minus: bool,
}

/// Identifies the active offsets, because two unknown offsets are not equal.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct OffsetIdentity {
    active: WorkName,
    length: LengthOffset,
    tool_axes: AxisMask,
    is_turret: bool,
    /// The axes whose system offset is known.
    system_known: AxisMask,
    is_length_known: bool,
    unknown_presets: u32,
    /// The error of a clamped part that is not known; 0: none is in force, or it is known.
    unknown_fixture: u16,
}

impl OffsetIdentity {
    /// True when both mean the same offset of an axis.
    pub fn same_for(&self, other: &OffsetIdentity, axis: usize) -> bool {
        self.active == other.active
            && (!self.is_tool_axis(other, axis) || self.length == other.length)
    }

    /// Whether the tool of one of both lies along an axis.
    fn is_tool_axis(&self, other: &OffsetIdentity, axis: usize) -> bool {
        self.tool_axes.or(other.tool_axes).has(axis)
    }

    /// True when the unknown parts of both offsets of an axis are the same, so that their difference is known.
    pub fn same_unknowns_for(&self, other: &OffsetIdentity, axis: usize) -> bool {
        // When tools differ along X (a lathe), another offset is another tool of the turret, whose position comes from
        // the block that names it.
        let is_of_one_tip = !self.is_turret;
        let are_lengths_related = match (self.is_length_known, other.is_length_known) {
            (true, true) => is_of_one_tip || self.length == other.length,
            (false, false) => self.length == other.length,
            _ => false,
        };
        self.active == other.active
            && self.system_known.has(axis) == other.system_known.has(axis)
            && (!self.is_tool_axis(other, axis) || are_lengths_related)
            && self.unknown_presets == other.unknown_presets
            && self.unknown_fixture == other.unknown_fixture
    }
}

impl Offsets {
    /// The offset tables of a machine, with the system `active` selected.
    pub fn new(machine: &Machine, active: WorkName, naming: WorkNaming) -> Offsets {
        let systems =
            machine.work_offsets.iter().map(|(name, o)| (name.clone(), o.values)).collect();
        let external = machine.work_offsets.get("EXT").map_or([None; AXES], |o| o.values);
        let mut absent = AxisMask::NONE;
        (0..3).filter(|axis| machine.axes[*axis].is_none()).for_each(|axis| absent.insert(axis));
        let mut tool_axes = AxisMask(1 << Z);
        if machine.turns() {
            tool_axes.insert(X);
        }
        let mut offsets = Offsets {
            absent,
            tool_axes,
            is_turret: machine.turns(),
            systems,
            rotations: BTreeMap::new(),
            external,
            tools: machine.tools.clone(),
            naming,
            active,
            shift: [0.0; AXES],
            preset: [0.0; AXES],
            preset_known: [None; AXES],
            unknown_presets: UnknownPresets::default(),
            fixture: FixtureError::NONE,
            length: LengthOffset { number: None, minus: false },
            tool_values: None,
            total: [0.0; AXES],
            work: [0.0; AXES],
            system: [0.0; AXES],
            system_known: AxisMask::NONE,
            known: AxisMask::NONE,
            written: Vec::new(),
            touched: BTreeSet::new(),
        };
        offsets.update();
        offsets
    }

    /// What is added to program coordinates to get machine coordinates, mm and rad.
    #[inline]
    pub fn total(&self) -> Position {
        self.total
    }

    /// The same without the tool length.
    pub fn work(&self) -> Position {
        self.work
    }

    /// The parts of the work offset: system and unknown presets.
    pub fn zero(&self) -> WorkZero {
        WorkZero {
            system: self.system,
            system_known: self.system_known,
            unknown_presets: self.unknown_presets,
        }
    }

    /// The axes for which the total is known.
    #[inline]
    pub fn known(&self) -> AxisMask {
        self.known
    }

    /// Which offsets are active.
    pub fn identity(&self) -> OffsetIdentity {
        OffsetIdentity {
            active: self.active,
            length: self.length,
            tool_axes: self.tool_axes,
            is_turret: self.is_turret,
            system_known: self.system_known,
            is_length_known: self.length_in_force().is_some(),
            unknown_presets: self.unknown_presets.count,
            unknown_fixture: if self.fixture.is_known { 0 } else { self.fixture.number },
        }
    }

    /// The error of a clamped part in force.
    #[inline]
    pub fn fixture(&self) -> FixtureError {
        self.fixture
    }

    /// Brings the error of a clamped part into force, as the tables stand.
    pub fn set_fixture(&mut self, error: FixtureError) {
        self.fixture = error;
    }

    /// The work coordinate system in force.
    pub fn active(&self) -> WorkName {
        self.active
    }

    /// The tool length in force.
    pub fn length(&self) -> LengthOffset {
        self.length
    }

    /// True when a tool length is active, by its number or by its values.
    pub fn has_length(&self) -> bool {
        self.length.number.is_some() || self.tool_values.is_some()
    }

    /// Active tool offsets that the program gives by value, not by number, mm and rad; `None` otherwise.
    pub fn own_length(&self) -> Option<Position> {
        self.tool_values.filter(|_| self.length.number.is_none())
    }

    /// Chooses a work coordinate system.
    pub fn select(&mut self, name: WorkName) {
        self.active = name;
        self.preset_known = [None; AXES];
    }

    /// Activates a tool length: with later changes of the table, or (`copied`) with its present values.
    pub fn set_length(&mut self, length: LengthOffset, copied: bool) {
        self.length = length;
        self.tool_values = None;
        if copied && length.number.is_some() && self.length_in_force().is_some() {
            self.tool_values = Some(self.tool_in_force());
        }
    }

    /// Activates tool offsets by their values, mm and rad.
    pub fn set_tool_values(&mut self, values: Position) {
        self.length = LengthOffset { number: None, minus: false };
        self.tool_values = Some(values);
    }

    /// G52: sets the shift of an axis, mm or rad.
    pub fn set_shift(&mut self, axis: usize, value: f64) {
        self.shift[axis] = value;
    }

    /// Ends G52 on an axis; the preset takes over its value, so that the coordinates do not change.
    pub fn move_shift_to_preset(&mut self, axis: usize) {
        self.preset[axis] += std::mem::take(&mut self.shift[axis]);
    }

    /// G92: adds `by` to the preset of an axis, whose machine position is then known or not.
    pub fn add_preset(&mut self, axis: usize, by: f64, known: bool) {
        self.preset[axis] += by;
        self.preset_known[axis] = Some(known);
    }

    /// Presets axes at an unknown position of the work coordinate system.
    pub fn preset_somewhere(&mut self, axes: AxisMask) {
        if axes != AxisMask::NONE {
            self.unknown_presets.axes = self.unknown_presets.axes.or(axes);
            self.unknown_presets.count += 1;
        }
    }

    /// The presets, to restore them later.
    pub fn presets(&self) -> CoordinatePresets {
        CoordinatePresets { values: self.preset, unknown: self.unknown_presets }
    }

    /// Restores presets.
    pub fn set_presets(&mut self, presets: CoordinatePresets) {
        self.preset = presets.values;
        self.unknown_presets = presets.unknown;
        self.preset_known = [None; AXES];
    }

    /// The name of a system in the tables.
    pub fn key(&self, name: WorkName) -> String {
        name.table_key(self.naming)
    }

    /// Writes one value of a work offset (G10), mm or rad, or adds to it.
    pub fn write_work(&mut self, key: &str, axis: usize, value: f64, add: bool) {
        let values = if key == "EXT" {
            &mut self.external
        } else {
            self.systems.entry(key.to_string()).or_insert([None; AXES])
        };
        let old = values[axis].unwrap_or(0.0);
        values[axis] = Some(if add { old + value } else { value });
        self.note_written(WrittenOffset::Work(key.to_string(), axis));
    }

    /// Writes the rotation of a work coordinate system, degrees.
    pub fn write_rotation(&mut self, key: &str, degrees: f64) {
        self.rotations.insert(key.to_string(), degrees);
        self.note_written(WrittenOffset::Rotation(key.to_string()));
    }

    /// Remembers a written entry, each once.
    fn note_written(&mut self, place: WrittenOffset) {
        self.touched.insert(place.clone());
        self.written.retain(|other| *other != place);
        self.written.push(place);
    }

    /// True when something was written since [`Offsets::take_written`].
    #[inline]
    pub fn has_written(&self) -> bool {
        !self.written.is_empty()
    }

    /// What was written since the last call.
    #[inline]
    pub fn take_written(&mut self) -> Vec<WrittenOffset> {
        std::mem::take(&mut self.written)
    }

    /// All written entries with their present values.
    pub(crate) fn all_written(&self) -> Vec<(String, Vec<Option<f64>>)> {
        let places = self.touched.iter();
        places.map(|place| (format!("{place:?}"), self.written_values(place))).collect()
    }

    /// The distance by which G52 and G92 have moved the zero of an axis, mm or rad.
    pub(crate) fn shift_of(&self, axis: usize) -> f64 {
        self.shift[axis] + self.preset[axis]
    }

    /// The present values of a written entry.
    pub fn written_values(&self, place: &WrittenOffset) -> Vec<Option<f64>> {
        match place {
            WrittenOffset::Work(key, axis) => vec![self.work_value(key, *axis)],
            WrittenOffset::Rotation(key) => vec![Some(self.rotation(key))],
            WrittenOffset::Tool(number) => self.tool(*number).map_or_else(Vec::new, |tool| {
                let offsets = tool.offset.iter().chain(&tool.offset_wear).copied();
                let tip = tool.tip.map(f64::from);
                offsets.chain([tool.diameter_mm, tool.diameter_wear_mm, tip]).collect()
            }),
        }
    }

    /// The rotation of a work coordinate system, degrees.
    pub fn rotation(&self, key: &str) -> f64 {
        self.rotations.get(key).copied().unwrap_or(0.0)
    }

    /// Updates the frames with the rotation of the active system. Shifts and presets rotate with the system.
    pub(crate) fn turn_coordinates(&self, frames: &mut Frames) {
        if self.rotations.is_empty() {
            return;
        }
        frames.set_work_rotation(self.turned(), self.zero_of_turn());
    }

    /// The rotation of the active system, degrees.
    pub fn turned(&self) -> f64 {
        if self.rotations.is_empty() { 0.0 } else { self.rotation(&self.key(self.active)) }
    }

    /// The rotation of a system about its zero; `None` while no system is rotated.
    pub(crate) fn own_turn(&self, key: &str) -> Option<FrameMap> {
        let turned = !self.rotations.is_empty();
        turned.then(|| FrameMap::rotation(Plane::Xy, self.zero_of_turn(), self.rotation(key)))
    }

    /// The zero of the active system, before shift and preset, in its shifted coordinates, mm.
    pub(crate) fn zero_of_turn(&self) -> [f64; 2] {
        [0, 1].map(|axis| -(self.shift[axis] + self.preset[axis]))
    }

    /// One value of a work offset, mm or rad; `None` when neither machine file nor program gives it.
    pub fn work_value(&self, key: &str, axis: usize) -> Option<f64> {
        if key == "EXT" {
            return self.external[axis];
        }
        self.systems.get(key)?[axis]
    }

    /// The offsets of a tool; `None` when neither machine file nor program gives it.
    pub fn tool(&self, number: u32) -> Option<&Tool> {
        self.tools.get(&number)
    }

    /// The tool of a mill lies along an axis from now on; [`update`](Self::update) follows.
    pub fn set_tool_axis(&mut self, axis: usize) {
        self.tool_axes = AxisMask(1 << axis);
    }

    /// The offsets of a tool, to change them.
    pub fn tool_mut(&mut self, number: u32) -> &mut Tool {
        self.note_written(WrittenOffset::Tool(number));
        self.tools.entry(number).or_default()
    }

    /// Length with wear, mm; `None` when the table has none.
    pub fn length_mm(&self, number: u32) -> Option<f64> {
        self.tools.get(&number)?.offset_of(Z)
    }

    /// Radius with wear, mm; `None` when the table has none.
    pub fn radius_mm(&self, number: u32) -> Option<f64> {
        self.tools.get(&number)?.radius_mm()
    }

    /// What the tool length adds to Z, mm; `None` when it is not known.
    pub fn length_in_force(&self) -> Option<f64> {
        if let Some(values) = self.tool_values {
            return Some(values[Z]);
        }
        match self.length.number {
            None => Some(0.0),
            Some(number) => {
                let length = self.length_mm(number)?;
                Some(if self.length.minus { -length } else { length })
            }
        }
    }

    /// What the tool offsets add on every axis, mm and rad; zero where the table has none.
    pub fn tool_in_force(&self) -> Position {
        if let Some(values) = self.tool_values {
            return values;
        }
        let Some(tool) = self.length.number.and_then(|number| self.tools.get(&number)) else {
            return [0.0; AXES];
        };
        let sign = if self.length.minus { -1.0 } else { 1.0 };
        std::array::from_fn(|axis| tool.offset_of(axis).map_or(0.0, |value| sign * value))
    }

    /// What the tool offsets add on an axis, mm or rad; `None` where the table has no value.
    pub fn known_tool_offset(&self, axis: usize) -> Option<f64> {
        let by_table = self.length.number.filter(|_| self.tool_values.is_none());
        if let Some(number) = by_table
            && self.tool_axes.has(axis)
        {
            self.tools.get(&number)?.offset_of(axis)?;
        }
        Some(self.tool_in_force()[axis])
    }

    /// One value of a work offset, mm or rad; `None` when it is not given. A missing external offset is zero once
    /// any other offset is given.
    pub fn known_work_value(&self, key: &str, axis: usize) -> Option<f64> {
        let has_any = || self.systems.values().flatten().any(Option::is_some);
        let absent = || (key == "EXT" && has_any()).then_some(0.0);
        self.work_value(key, axis).or_else(absent)
    }

    /// The rotation of a work coordinate system, degrees, zero for a given system without one; `None` for a system
    /// that is not given.
    pub fn known_rotation(&self, key: &str) -> Option<f64> {
        let is_defined =
            || self.systems.get(key).is_some_and(|values| values.iter().any(Option::is_some));
        self.rotations.get(key).copied().or_else(|| is_defined().then_some(0.0))
    }

    /// Recomputes totals and what is known; to be called after any change.
    pub fn update(&mut self) {
        let machine = self.active == WorkName::Machine;
        let system = if machine {
            Some([Some(0.0); AXES])
        } else {
            self.systems.get(&self.key(self.active)).copied()
        };
        let length_known = self.length_in_force().is_some();
        let tool = self.tool_in_force();
        (self.known, self.system_known) = (AxisMask::NONE, AxisMask::NONE);
        for axis in 0..AXES {
            let base =
                system.and_then(|values| values[axis].or_else(|| default_rotary(&values, axis)));
            let external = if machine { 0.0 } else { self.external[axis].unwrap_or(0.0) };
            self.system[axis] = base.unwrap_or(0.0) + external;
            let fixture = if axis < LINEAR_AXES { self.fixture.shift[axis] } else { 0.0 };
            self.work[axis] = self.system[axis] + self.shift[axis] + self.preset[axis] + fixture;
            if base.is_some() || self.absent.has(axis) {
                self.system_known.insert(axis);
            }
            let mut is_known = self.preset_known[axis].unwrap_or(base.is_some());
            self.total[axis] = self.work[axis] + tool[axis];
            if self.tool_axes.has(axis) {
                is_known &= length_known;
            }
            is_known &= axis >= LINEAR_AXES || self.fixture.is_known;
            if is_known || self.absent.has(axis) {
                self.known.insert(axis);
            }
        }
    }
}

/// The value of an axis that a work coordinate system does not give: where it gives a linear axis, the rotary ones are at 0.
fn default_rotary(system: &[Option<f64>; AXES], axis: usize) -> Option<f64> {
    (axis >= LINEAR_AXES && system[..LINEAR_AXES].iter().any(Option::is_some)).then_some(0.0)
}

/// The number of linear axes, before which none is rotary.
const LINEAR_AXES: usize = 3;

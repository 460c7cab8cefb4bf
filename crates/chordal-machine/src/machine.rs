//! The machine as plain data. Millimetres, seconds and radians.

use std::collections::{BTreeMap, BTreeSet};

use crate::axis::{AXES, Axis, PerAxis};
use crate::control::ControlName;
use crate::error::{MachineError, ValueLocation};
use crate::motion::MotionSettings;
use crate::setup::Setup;
use crate::tool::Tool;
use crate::value::SettingEntry;

/// A machine and what its shop has set on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Machine {
    /// The name it is called by: the file's name without folder and ending, unless it says one.
    pub name: String,
    /// A name for people; the same as `name` where the file gives none.
    pub title: String,
    /// Remarks.
    pub notes: Vec<String>,
    /// Whose rules its programs are read by.
    pub control: ControlName,
    /// On which side of the axis the turret of a lathe stands.
    pub turret: Turret,
    /// How near to what is cut the turret of a lathe may turn, mm; `None`: anywhere outside.
    pub turret_clearance_mm: Option<f64>,
    /// The axes by `axis as usize`; `None`: the machine has no such axis.
    pub axes: PerAxis<Option<AxisLimits>>,
    /// What A, B and C turn, in this order.
    pub rotary: [RotaryAxis; 3],
    /// The fastest feeds that may be programmed.
    pub feed: FeedLimits,
    /// The path of a rapid move; `None`: the control's default.
    pub rapid: Option<RapidShape>,
    /// The fastest spindle speed, revolutions per minute.
    pub spindle_max_rpm: Option<f64>,
    /// The fastest speed of live tools, revolutions per minute.
    pub live_tool_max_rpm: Option<f64>,
    /// The power that the spindle has for a cut, kW.
    pub spindle_power_kw: Option<f64>,
    /// The tools by number.
    pub tools: BTreeMap<u32, Tool>,
    /// The work offsets by the names that [`work_offset_name`](crate::work_offset_name) gives.
    pub work_offsets: BTreeMap<String, WorkOffset>,
    /// The control's own settings, by the names its manual uses.
    pub settings: BTreeMap<String, SettingEntry>,
    /// Reference point 1, in machine coordinates.
    pub home: PerAxis<Option<f64>>,
    /// Reference points 2, 3 and 4, in machine coordinates.
    pub reference_points: [PerAxis<Option<f64>>; 3],
    /// The switches of the operator's panel.
    pub switches: Switches,
    /// The plane above which rapids may move freely, Z in work coordinates.
    pub clearance_mm: Option<f64>,
    /// How it moves, in addition to the limits of its axes.
    pub motion: MotionSettings,
    /// What takes time besides moving.
    pub times: NonMotionTimes,
    /// What macro programs find.
    pub macros: Macros,
    /// What probe moves find.
    pub probe: Probe,
    /// M codes that the shop has of its own, by number.
    pub shop_codes: BTreeMap<u16, CustomCodeSpec>,
    /// Programs that are called and that no text holds, by number.
    pub shop_programs: BTreeMap<u32, CustomCodeSpec>,
    /// What lies on it.
    pub setup: Setup,
    /// What was read from its file otherwise than it was written.
    pub notices: MachineNotices,
}

/// What is to be told about a machine file that was read; machines are equal whatever it is.
#[derive(Clone, Debug, Default)]
pub struct MachineNotices(pub Vec<MachineError>);

impl PartialEq for MachineNotices {
    fn eq(&self, _: &MachineNotices) -> bool {
        true
    }
}

/// The limits of an axis: millimetres, or radians on a rotary axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisLimits {
    /// What its words and offsets say. Here and everywhere inside a place is a radius.
    pub programmed: DiameterProgramming,
    /// The lowest and the highest position, machine coordinates, mm or rad.
    pub travel: Option<(f64, f64)>,
    /// Rapid speed, mm/s or rad/s.
    pub max_velocity: Option<f64>,
    /// mm/s² or rad/s².
    pub max_acceleration: Option<f64>,
    /// mm/s³ or rad/s³.
    pub max_jerk: Option<f64>,
    /// The acceleration of rapids where it is another, mm/s² or rad/s².
    pub rapid_acceleration: Option<f64>,
    /// The jerk of rapids where it is another, mm/s³ or rad/s³.
    pub rapid_jerk: Option<f64>,
}

/// What the words, offsets and limits of a linear axis say, on the control and in the machine file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DiameterProgramming {
    /// How far the slide is from its zero.
    #[default]
    Radius,
    /// Twice that, as X of a lathe.
    Diameter,
}

impl DiameterProgramming {
    /// The word of a machine file.
    pub const fn as_str(self) -> &'static str {
        match self {
            DiameterProgramming::Radius => "radius",
            DiameterProgramming::Diameter => "diameter",
        }
    }

    /// What a place is multiplied by to be written: 1, or 2 of a diameter. A power of two, so that
    /// nothing is rounded either way.
    pub const fn factor(self) -> f64 {
        match self {
            DiameterProgramming::Radius => 1.0,
            DiameterProgramming::Diameter => 2.0,
        }
    }
}

/// What a rotary axis turns, as far as pictures need it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RotaryAxis {
    /// `None`: not known.
    pub turns: Option<RotaryTarget>,
    /// It counts the other way than ISO 841: there a positive angle turns the tool about the part
    /// as a right-hand screw goes along the linear axis.
    pub reversed: bool,
    /// A place that its axis goes through, program coordinates by X, Y, Z, mm; where nothing is
    /// given, the program's zero.
    pub center_mm: [Option<f64>; 3],
}

/// What a rotary axis turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RotaryTarget {
    /// The part.
    Table,
    /// The tool.
    Head,
}

impl RotaryTarget {
    /// Both.
    pub const ALL: [RotaryTarget; 2] = [RotaryTarget::Table, RotaryTarget::Head];

    /// The word of a machine file.
    pub const fn as_str(self) -> &'static str {
        match self {
            RotaryTarget::Table => "table",
            RotaryTarget::Head => "head",
        }
    }
}

/// The fastest feeds that may be programmed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FeedLimits {
    /// Of a move with a linear axis in it, mm/s.
    pub max_mm_per_s: Option<f64>,
    /// Of a move of rotary axes alone, rad/s.
    pub max_rad_per_s: Option<f64>,
}

/// The path of a rapid move of several axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RapidShape {
    /// Every axis at its own speed until it arrives.
    DogLeg,
    /// A straight line, as fast as the slowest axis allows.
    Straight,
}

impl RapidShape {
    /// Both.
    pub const ALL: [RapidShape; 2] = [RapidShape::DogLeg, RapidShape::Straight];

    /// The word of a machine file.
    pub const fn as_str(self) -> &'static str {
        match self {
            RapidShape::DogLeg => "dog-leg",
            RapidShape::Straight => "straight",
        }
    }
}

/// On which side of the axis the turret of a lathe stands. Programs are the same: pictures turn round.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Turret {
    /// Behind the axis as the operator sees it: X goes up in pictures.
    #[default]
    Rear,
    /// Between the operator and the axis: X goes down in pictures.
    Front,
}

impl Turret {
    /// Every side.
    pub const ALL: [Turret; 2] = [Turret::Rear, Turret::Front];

    /// The word of a machine file.
    pub const fn as_str(self) -> &'static str {
        match self {
            Turret::Rear => "rear",
            Turret::Front => "front",
        }
    }
}

/// A work offset: where the zero of a work coordinate system is, in machine coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WorkOffset {
    /// By `axis as usize`, mm or rad; `None`: not given.
    pub values: PerAxis<Option<f64>>,
}

/// The switches of the operator's panel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Switches {
    /// Block delete: `/1` to `/9` by number. Number 0 is the bare `/` and equals number 1.
    pub block_delete: [bool; 10],
    /// Optional stop: M01 stops.
    pub optional_stop: bool,
}

/// What takes time besides moving.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NonMotionTimes {
    /// A change of tool, from M06 to the next move.
    pub tool_change_s: Option<f64>,
    /// The spindle speeds up or slows down by 1000 rpm.
    pub spindle_per_1000_rpm_s: Option<f64>,
    /// The time to orient the spindle (M19), in addition to the time it needs to stop.
    pub spindle_orient_s: Option<f64>,
    /// A probe touches and the control takes the place over.
    pub probe_s: Option<f64>,
    /// An M code that switches coolant, until the control goes on.
    pub m_code_s: Option<f64>,
}

/// What the machine does for an M code that its control does not have, or for a program that no text holds.
#[derive(Clone, Debug, Default)]
pub struct CustomCodeSpec {
    /// How long the machine takes for it; `None`: no time.
    pub time_s: Option<f64>,
    /// What it is, for people.
    pub label: Option<String>,
    /// The blocks that it runs, as a subprogram would.
    pub blocks: Option<String>,
    /// Where it was written.
    pub location: Option<ValueLocation>,
}

impl PartialEq for CustomCodeSpec {
    /// Codes that do the same are equal, wherever they were written.
    fn eq(&self, other: &Self) -> bool {
        let what = |code: &Self| (code.time_s, code.label.clone(), code.blocks.clone());
        what(self) == what(other)
    }
}

/// What macro programs find when the program starts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Macros {
    /// Values of variables by number (`#500`).
    pub variables: BTreeMap<u32, f64>,
    /// Values of the control's own variables by name (`#<_hal[spindle.0.at-speed]>`): in lower case, without blanks.
    pub named_variables: BTreeMap<String, f64>,
    /// Variables that are known to be vacant.
    pub vacant: BTreeSet<u32>,
    /// The date as a control shows it, YYYYMMDD.
    pub date: Option<u32>,
    /// The time, HHMMSS.
    pub time: Option<u32>,
    /// What the operator types where the program asks (Fadal INPUT), in order.
    pub inputs: Vec<f64>,
}

/// Where probe and skip moves (G31, G38.2) touch the part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Probe {
    /// What they touch; `None`: nothing is said, and they touch where they end.
    pub hit: Option<ProbeHit>,
    /// Planes of which the nearest on the way is touched: work coordinates by `axis as usize`,
    /// mm or rad. They hold where `hit` is `None`.
    pub planes: PerAxis<Option<f64>>,
}

/// What a probe move meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProbeHit {
    /// Something where the move ends.
    End,
    /// Nothing.
    Nothing,
}

impl ProbeHit {
    /// Both.
    pub const ALL: [ProbeHit; 2] = [ProbeHit::End, ProbeHit::Nothing];

    /// The word of a machine file.
    pub const fn as_str(self) -> &'static str {
        match self {
            ProbeHit::End => "end",
            ProbeHit::Nothing => "none",
        }
    }
}

impl Machine {
    /// Whether blocks are given for a code or a program; a run takes them in as further texts.
    pub fn answers_with_blocks(&self) -> bool {
        self.shop_codes
            .values()
            .chain(self.shop_programs.values())
            .any(|code| code.blocks.is_some())
    }

    /// A machine of which only the control is known: X, Y and Z without limits.
    pub fn new(name: &str, control: ControlName) -> Machine {
        let mut machine = Machine::without_axes(name, control);
        machine.give_default_axes();
        machine
    }

    pub(crate) fn without_axes(name: &str, control: ControlName) -> Machine {
        Machine {
            name: name.to_string(),
            title: name.to_string(),
            notes: Vec::new(),
            control,
            axes: [None; AXES],
            rotary: [RotaryAxis::default(); 3],
            feed: FeedLimits::default(),
            turret: Turret::Rear,
            turret_clearance_mm: None,
            rapid: None,
            spindle_max_rpm: None,
            live_tool_max_rpm: None,
            spindle_power_kw: None,
            tools: BTreeMap::new(),
            work_offsets: BTreeMap::new(),
            settings: BTreeMap::new(),
            home: [None; AXES],
            reference_points: [[None; AXES]; 3],
            switches: Switches::default(),
            clearance_mm: None,
            motion: MotionSettings::default(),
            times: NonMotionTimes::default(),
            macros: Macros::default(),
            probe: Probe::default(),
            shop_codes: BTreeMap::new(),
            shop_programs: BTreeMap::new(),
            setup: Setup::default(),
            notices: MachineNotices::default(),
        }
    }

    /// X, Y and Z without limits, where no axis is known.
    pub(crate) fn give_default_axes(&mut self) {
        if self.axes.iter().all(Option::is_none) {
            for axis in [Axis::X, Axis::Y, Axis::Z] {
                self.axes[axis as usize] = Some(AxisLimits::default());
            }
        }
    }

    /// A lathe: X is programmed as a diameter.
    pub fn turns(&self) -> bool {
        self.written_factors()[0] != 1.0
    }

    /// What a place of an axis is multiplied by to be written in a program: 1, or 2 of a diameter.
    pub fn written_factor(&self, axis: usize) -> f64 {
        self.axes[axis].map_or(1.0, |limits| limits.programmed.factor())
    }

    /// The same for every axis.
    pub fn written_factors(&self) -> PerAxis<f64> {
        std::array::from_fn(|axis| self.written_factor(axis))
    }

    /// It is described, and without this axis: a lathe of two axes has no Y.
    pub fn lacks(&self, axis: Axis) -> bool {
        let is_described =
            [Axis::X, Axis::Y, Axis::Z].iter().any(|axis| self.axis(*axis).is_some());
        is_described && self.axis(axis).is_none()
    }

    /// The limits of an axis; `None`: the machine has no such axis.
    pub fn axis(&self, axis: Axis) -> Option<&AxisLimits> {
        self.axes[axis as usize].as_ref()
    }
}

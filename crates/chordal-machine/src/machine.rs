//! The machine as plain data, in millimetres, seconds and radians.

use std::collections::{BTreeMap, BTreeSet};

use chordal_kinematics::RolloverRule;

use crate::axis::{AXES, Axis, PerAxis};
use crate::control::ControlName;
use crate::error::{MachineError, ValueLocation};
use crate::motion::MotionSettings;
use crate::setup::Setup;
use crate::solid::{LinearOrder, MachineSolid};
use crate::tool::Tool;
use crate::value::SettingEntry;

/// A machine with its settings.
#[derive(Clone, Debug, PartialEq)]
pub struct Machine {
    /// Its name: the `name` in the file, or else the name of the file without folder and extension.
    pub name: String,
    /// A name for display; the same as `name` if the file gives none.
    pub title: String,
    /// Remarks from the file.
    pub notes: Vec<String>,
    /// Its control, by whose rules its programs are run.
    pub control: ControlName,
    /// On which side of the spindle axis the turret of a lathe is.
    pub turret: Turret,
    /// The smallest distance from what is cut at which the turret of a lathe may index, mm; `None`: anywhere outside of
    /// it.
    pub turret_clearance_mm: Option<f64>,
    /// The axes by `axis as usize`; `None`: the machine has no such axis.
    pub axes: PerAxis<Option<AxisLimits>>,
    /// What A, B and C turn, in this order.
    pub rotary: [RotaryAxis; 3],
    /// The frame of the tip with tool centre point control.
    pub tcp_frame: TcpFrame,
    /// What X, Y and Z mean where a program begins, on a control that switches its kinematics; `None`: it does not.
    pub starting_kinematics: Option<StartingKinematics>,
    /// What carries the linear axes.
    pub linear: LinearCarriers,
    /// The bodies of the machine, by name.
    pub solids: BTreeMap<String, MachineSolid>,
    /// The largest feeds that may be programmed.
    pub feed: FeedLimits,
    /// The path of a rapid move; `None`: the control's default.
    pub rapid: Option<RapidShape>,
    /// The largest spindle speed, 1/min; `None`: not known.
    pub spindle_max_rpm: Option<f64>,
    /// The largest speed of live tools, 1/min; `None`: not known.
    pub live_tool_max_rpm: Option<f64>,
    /// The power of the spindle for cutting, kW; `None`: not known.
    pub spindle_power_kw: Option<f64>,
    /// The tools, by number.
    pub tools: BTreeMap<u32, Tool>,
    /// The work offsets by the names that [`work_offset_name`](crate::work_offset_name) gives.
    pub work_offsets: BTreeMap<String, WorkOffset>,
    /// The settings of the control, by their names in its manual.
    pub settings: BTreeMap<String, SettingEntry>,
    /// Reference point 1, machine coordinates by `axis as usize`, mm or rad; `None`: not given.
    pub home: PerAxis<Option<f64>>,
    /// Reference points 2, 3 and 4, machine coordinates by `axis as usize`, mm or rad; `None`: not given.
    pub reference_points: [PerAxis<Option<f64>>; 3],
    /// The switches of the operator's panel.
    pub switches: Switches,
    /// The height above which rapids may move freely, Z in work coordinates, mm; `None`: not given.
    pub clearance_mm: Option<f64>,
    /// The settings of motion that are not limits of one axis.
    pub motion: MotionSettings,
    /// The times of actions other than motion.
    pub times: NonMotionTimes,
    /// The state that macro programs find.
    pub macros: Macros,
    /// What probe moves touch.
    pub probe: Probe,
    /// Custom M codes of the machine, by number.
    pub shop_codes: BTreeMap<u16, CustomCodeSpec>,
    /// Programs that are called but are in none of the texts, by number.
    pub shop_programs: BTreeMap<u32, CustomCodeSpec>,
    /// The setup: stock, fixtures and target.
    pub setup: Setup,
    /// Notices about values that were read with another meaning than written.
    pub notices: MachineNotices,
}

/// Notices from reading a machine file; they do not matter for the equality of machines.
#[derive(Clone, Debug, Default)]
pub struct MachineNotices(pub Vec<MachineError>);

impl PartialEq for MachineNotices {
    fn eq(&self, _: &MachineNotices) -> bool {
        true
    }
}

/// An axis with its limits, in millimetres, or radians on a rotary axis. `None` means that a limit is not known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisLimits {
    /// Whether its words and offsets are radii or diameters. Positions in this crate are always radii.
    pub programmed: DiameterProgramming,
    /// The lowest and the highest position in machine coordinates, mm or rad.
    pub travel: Option<(f64, f64)>,
    /// Rapid speed, mm/s or rad/s.
    pub max_velocity: Option<f64>,
    /// The largest acceleration, mm/s² or rad/s².
    pub max_acceleration: Option<f64>,
    /// The largest jerk, mm/s³ or rad/s³.
    pub max_jerk: Option<f64>,
    /// The acceleration of rapids if it differs, mm/s² or rad/s².
    pub rapid_acceleration: Option<f64>,
    /// The jerk of rapids if it differs, mm/s³ or rad/s³.
    pub rapid_jerk: Option<f64>,
}

/// Whether the words, offsets and limits of a linear axis are radii or diameters, on the control and in the machine file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DiameterProgramming {
    /// The distance of the slide from its zero.
    #[default]
    Radius,
    /// Twice that distance, as X of a lathe.
    Diameter,
}

impl DiameterProgramming {
    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            DiameterProgramming::Radius => "radius",
            DiameterProgramming::Diameter => "diameter",
        }
    }

    /// The factor from a position to its written value: 1, or 2 for a diameter. It is a power of two, so that there is no
    /// rounding.
    pub const fn factor(self) -> f64 {
        match self {
            DiameterProgramming::Radius => 1.0,
            DiameterProgramming::Diameter => 2.0,
        }
    }
}

/// The kinematics of a rotary axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RotaryAxis {
    /// What it turns; `None`: not known.
    pub turns: Option<RotaryTarget>,
    /// Its positive direction is opposite to ISO 841, where a positive angle turns the tool relative to the part by the
    /// right-hand rule about the linear axis.
    pub reversed: bool,
    /// A point on its axis of rotation, program coordinates X, Y, Z, mm; a coordinate that is `None` is the program zero.
    /// Pictures use it.
    pub center_mm: [Option<f64>; 3],
    /// A point on its axis of rotation with every rotary axis at zero, X, Y, Z, mm: machine coordinates for a table, from
    /// the gauge point for a head; `None`: not given.
    pub point_mm: [Option<f64>; 3],
    /// The direction of its axis of rotation, of any length above zero; `None`: that of its linear axis.
    pub direction: Option<[f64; 3]>,
    /// The rotary axis that carries it; `None`: by the order of the letters.
    pub on: Option<Axis>,
    /// How it reaches a programmed absolute angle; `None`: not given.
    pub rollover: Option<RolloverRule>,
}

/// The frame in which the tip follows its path with tool centre point control, if tables turn the part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum TcpFrame {
    /// It lies on the part as with the tables at zero.
    #[default]
    Zero,
    /// It lies on the part as the tables are where the control is activated.
    Activation,
}

/// What X, Y and Z mean where a program begins, on a control that switches its kinematics (LinuxCNC, switchkins).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StartingKinematics {
    /// Positions of the axes: its kinematics begin with `identityfirst`.
    Axes,
    /// The tip on the part.
    Tip,
}

impl StartingKinematics {
    /// Both values.
    pub const ALL: [StartingKinematics; 2] = [StartingKinematics::Axes, StartingKinematics::Tip];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            StartingKinematics::Axes => "axes",
            StartingKinematics::Tip => "tip",
        }
    }

    /// Whether the kinematics with a number follow the tip: 0 are those of the start, 1 the others. `None` for more.
    pub fn follow_tip(self, number: u32) -> Option<bool> {
        let at_start = self == StartingKinematics::Tip;
        match number {
            0 => Some(at_start),
            1 => Some(!at_start),
            _ => None,
        }
    }
}

impl TcpFrame {
    /// Both values.
    pub const ALL: [TcpFrame; 2] = [TcpFrame::Zero, TcpFrame::Activation];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            TcpFrame::Zero => "zero",
            TcpFrame::Activation => "activation",
        }
    }
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
    /// Both values.
    pub const ALL: [RotaryTarget; 2] = [RotaryTarget::Table, RotaryTarget::Head];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            RotaryTarget::Table => "table",
            RotaryTarget::Head => "head",
        }
    }
}

/// What carries the linear axes X, Y and Z.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LinearCarriers {
    /// Whether X, Y and Z move the part or the tool; `None`: not given.
    pub sides: [Option<RotaryTarget>; 3],
    /// Which of them carries which; `None`: not given.
    pub order: Option<LinearOrder>,
}

/// The largest feeds that may be programmed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FeedLimits {
    /// The limit for moves with a linear axis, mm/s; `None`: not known.
    pub max_mm_per_s: Option<f64>,
    /// The limit for moves of rotary axes only, rad/s; `None`: not known.
    pub max_rad_per_s: Option<f64>,
}

/// The path of a rapid move of several axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RapidShape {
    /// Every axis moves at its own speed until it arrives.
    DogLeg,
    /// A straight line, as fast as the slowest axis allows.
    Straight,
}

impl RapidShape {
    /// Both values.
    pub const ALL: [RapidShape; 2] = [RapidShape::DogLeg, RapidShape::Straight];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            RapidShape::DogLeg => "dog-leg",
            RapidShape::Straight => "straight",
        }
    }
}

/// On which side of the spindle axis the turret of a lathe is. It does not affect programs, only drawings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Turret {
    /// Behind the axis as seen by the operator: X is drawn upward.
    #[default]
    Rear,
    /// Between the operator and the axis: X is drawn downward.
    Front,
}

impl Turret {
    /// Both sides.
    pub const ALL: [Turret; 2] = [Turret::Rear, Turret::Front];

    /// The word for it in machine files.
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
    /// Block delete switches, by number: `/1` to `/9`. Number 0 is for `/` without a number and equals number 1.
    pub block_delete: [bool; 10],
    /// The optional stop is on: M01 stops.
    pub optional_stop: bool,
}

/// The times of actions other than motion, s; `None`: not given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NonMotionTimes {
    /// A tool change, from M06 to the next move.
    pub tool_change_s: Option<f64>,
    /// Acceleration or deceleration of the spindle by 1000 rpm.
    pub spindle_per_1000_rpm_s: Option<f64>,
    /// Orientation of the spindle (M19), in addition to the time to stop it.
    pub spindle_orient_s: Option<f64>,
    /// A probe touch, until the control has stored the position.
    pub probe_s: Option<f64>,
    /// An M code for coolant, until the control continues.
    pub m_code_s: Option<f64>,
}

/// The behaviour of an M code that the control does not have, or of a program that is in none of the texts.
#[derive(Clone, Debug, Default)]
pub struct CustomCodeSpec {
    /// How long it takes, s; `None`: no time.
    pub time_s: Option<f64>,
    /// A description for users.
    pub label: Option<String>,
    /// The blocks that it runs like a subprogram; `None`: none.
    pub blocks: Option<String>,
    /// Its position in the file.
    pub location: Option<ValueLocation>,
}

impl PartialEq for CustomCodeSpec {
    /// The position does not matter for equality.
    fn eq(&self, other: &Self) -> bool {
        let what = |code: &Self| (code.time_s, code.label.clone(), code.blocks.clone());
        what(self) == what(other)
    }
}

/// The state that macro programs find when the program starts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Macros {
    /// Values of variables by number (`#500`).
    pub variables: BTreeMap<u32, f64>,
    /// Values of variables of the control, by name (`#<_hal[spindle.0.at-speed]>`) in lower case without blanks.
    pub named_variables: BTreeMap<String, f64>,
    /// Variables that are known to be vacant.
    pub vacant: BTreeSet<u32>,
    /// The date as YYYYMMDD; `None`: not given.
    pub date: Option<u32>,
    /// The time as HHMMSS; `None`: not given.
    pub time: Option<u32>,
    /// The inputs of the operator, in order (Fadal INPUT).
    pub inputs: Vec<f64>,
}

/// Where probe and skip moves (G31, G38.2) touch the part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Probe {
    /// What they touch; `None`: not given, and they touch at their end.
    pub hit: Option<ProbeHit>,
    /// Planes, of which the first one on the path is touched: work coordinates by `axis as usize`, mm or rad. They are
    /// used if `hit` is `None`.
    pub planes: PerAxis<Option<f64>>,
}

/// What a probe move touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProbeHit {
    /// Something at the end of the move.
    End,
    /// Nothing.
    Nothing,
}

impl ProbeHit {
    /// Both values.
    pub const ALL: [ProbeHit; 2] = [ProbeHit::End, ProbeHit::Nothing];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            ProbeHit::End => "end",
            ProbeHit::Nothing => "none",
        }
    }
}

impl Machine {
    /// Whether there are blocks for a custom code or a program, which a run needs as additional texts.
    pub fn answers_with_blocks(&self) -> bool {
        self.shop_codes
            .values()
            .chain(self.shop_programs.values())
            .any(|code| code.blocks.is_some())
    }

    /// A machine of which only the control is known: it has X, Y and Z without limits.
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
            tcp_frame: TcpFrame::Zero,
            starting_kinematics: None,
            linear: LinearCarriers::default(),
            solids: BTreeMap::new(),
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

    /// Adds X, Y and Z without limits if no axis is known.
    pub(crate) fn give_default_axes(&mut self) {
        if self.axes.iter().all(Option::is_none) {
            for axis in [Axis::X, Axis::Y, Axis::Z] {
                self.axes[axis as usize] = Some(AxisLimits::default());
            }
        }
    }

    /// Whether it is a lathe: X is programmed as a diameter.
    pub fn turns(&self) -> bool {
        self.written_factors()[0] != 1.0
    }

    /// The factor from a position of an axis to its value in a program: 1, or 2 for a diameter.
    pub fn written_factor(&self, axis: usize) -> f64 {
        self.axes[axis].map_or(1.0, |limits| limits.programmed.factor())
    }

    /// The factor of every axis.
    pub fn written_factors(&self) -> PerAxis<f64> {
        std::array::from_fn(|axis| self.written_factor(axis))
    }

    /// Whether the machine is described and does not have this axis, such as Y on a lathe with two axes.
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

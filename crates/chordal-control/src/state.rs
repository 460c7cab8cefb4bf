//! The modal state of a control.

use chordal_diagnostics::Span;
use chordal_geometry::{Direction, Plane};
use chordal_machine::AXES;
use chordal_syntax::Decimal;

use crate::command::{AxisMask, Coolant, FeedMode, Overrides, Position, Side, SpindleState, Units};
use crate::offsets::Offsets;
use crate::parameters::{ArcCenter, DecimalPoint, Parameters};
use crate::path_modes::PathState;
use crate::table::CycleKind;

/// The motion that a block without a motion code makes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Motion {
    Rapid,
    Linear,
    Arc(Direction),
    Spiral(Direction),
    /// None: an axis word needs a motion code (LinuxCNC after G80).
    None,
}

/// A canned cycle in force: its kind and the words that stay.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct CycleState {
    pub kind: CycleKind,
    /// Index of the drilling axis.
    pub axis: usize,
    /// Level of the drilling axis when the series of cycles began.
    pub initial: f64,
    /// R and the depth: levels, or as written where the control reads them again.
    pub r: Option<f64>,
    pub z: Option<f64>,
    pub q: Option<f64>,
    /// I, J and K, mm.
    pub vector: [Option<f64>; 3],
    pub dwell_s: Option<f64>,
    /// P where it is the lift of a peck, mm.
    pub lift: Option<f64>,
    /// F where it is the speed of a tap.
    pub tap_rpm: Option<f64>,
    /// J where it says how much faster a tap leaves.
    pub out_factor: Option<f64>,
    /// `,R1` or `,R0` of a tap.
    pub synchronous: Option<bool>,
    /// E: speed of the spindle, reversed, after the hole.
    pub after_rpm: Option<f64>,
    /// The present block has made its hole.
    pub fired: bool,
}

impl CycleState {
    pub fn new(kind: CycleKind, axis: usize, initial: f64) -> CycleState {
        CycleState {
            kind,
            axis,
            initial,
            r: None,
            z: None,
            q: None,
            vector: [None; 3],
            dwell_s: None,
            lift: None,
            tap_rpm: None,
            out_factor: None,
            synchronous: None,
            after_rpm: None,
            fired: false,
        }
    }
}

/// How literals become millimetres: `mantissa · factor / 10^(scale + extra)`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Scale {
    factor: i64,
    with_point: u8,
    without_point: u8,
    angle_without_point: u8,
    /// Decimals of a length that the control keeps as they are.
    pub decimals: u8,
}

impl Scale {
    pub fn new(units: Units, parameters: &Parameters) -> Scale {
        let whole = parameters.decimal_point == DecimalPoint::Calculator;
        let digits = |digits: u8| if whole { 0 } else { digits };
        let decimals = parameters.kept_decimals(units);
        match units {
            Units::Inch => Scale {
                factor: 254,
                with_point: 1,
                without_point: 1 + digits(parameters.increment_digits_inch),
                angle_without_point: digits(3),
                decimals,
            },
            Units::Millimetre => Scale {
                factor: 1,
                with_point: 0,
                without_point: digits(parameters.increment_digits_mm),
                angle_without_point: digits(3),
                decimals,
            },
        }
    }

    /// A length in mm.
    #[inline]
    pub fn length(&self, number: Decimal) -> f64 {
        let extra = if number.has_point { self.with_point } else { self.without_point };
        number.times(self.factor, extra)
    }

    /// An angle in rad.
    #[inline]
    pub fn angle(&self, number: Decimal) -> f64 {
        let extra = if number.has_point { 0 } else { self.angle_without_point };
        number.times(1, extra).to_radians()
    }
}

/// What keeps the panel's overrides from acting.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OverrideState {
    /// By M48, M49 and their like.
    pub by_code: Overrides,
    /// G63 is in force.
    pub tapping_mode: bool,
    /// A tap is in its hole.
    pub in_tap: bool,
    /// What the sink was told last.
    pub told: Overrides,
}

impl Default for OverrideState {
    fn default() -> OverrideState {
        let (by_code, told) = (Overrides::ON, Overrides::ON);
        OverrideState { by_code, tapping_mode: false, in_tap: false, told }
    }
}

impl OverrideState {
    /// What acts now.
    pub fn in_force(&self) -> Overrides {
        let feed = self.by_code.feed && !self.tapping_mode && !self.in_tap;
        Overrides { feed, ..self.by_code }
    }
}

/// Everything a control remembers from block to block.
#[derive(Clone, Debug)]
pub(crate) struct State {
    /// The tool tip in program coordinates.
    pub position: Position,
    /// The axes whose program coordinate is known.
    pub known: AxisMask,
    /// The axes whose machine coordinate is known.
    pub machine_known: AxisMask,
    pub offsets: Offsets,
    pub units: Units,
    pub scale: Scale,
    pub plane: Plane,
    pub incremental: bool,
    /// Where the tool stood when G91 came into force.
    pub incremental_from: Position,
    pub motion: Motion,
    pub armed: Option<Direction>,
    /// The last block cut an arc while G0 is in force (where G2 and G3 do not cancel it).
    pub arc_over_rapid: bool,
    pub arc_center: ArcCenter,
    pub feed_mode: FeedMode,
    /// F as the mode counts it: mm/s, 1/s, mm per revolution; NaN before any F.
    pub feed: f64,
    /// F of rotary moves alone, rad/s.
    pub feed_angular: f64,
    /// The F word in force where it is above a limit of the machine that no move has met yet.
    pub feed_over: Option<Span>,
    pub spindle: SpindleState,
    pub rpm: f64,
    pub coolant: Coolant,
    pub tool: u32,
    pub selected_tool: Option<u32>,
    pub side: Side,
    pub radius_offset: Option<u32>,
    pub return_to_r: bool,
    pub cycle: Option<CycleState>,
    /// The last dwell that a cycle was given, s.
    pub cycle_dwell_s: Option<f64>,
    pub path: PathState,
    pub overrides: OverrideState,
    pub registers: [Decimal; 10],
}

impl State {
    pub fn new(parameters: &Parameters, offsets: Offsets, home: Position) -> State {
        let mut position = home;
        let known = offsets.known();
        let total = offsets.total();
        for axis in 0..AXES {
            position[axis] -= total[axis];
        }
        State {
            position,
            known,
            machine_known: AxisMask::ALL,
            offsets,
            units: parameters.units,
            scale: Scale::new(parameters.units, parameters),
            plane: Plane::Xy,
            incremental: parameters.starts_incremental,
            incremental_from: [0.0; AXES],
            motion: if parameters.starts_linear { Motion::Linear } else { Motion::Rapid },
            armed: None,
            arc_over_rapid: false,
            arc_center: parameters.arc_center,
            feed_mode: FeedMode::PerTime,
            feed: f64::NAN,
            feed_angular: f64::NAN,
            feed_over: None,
            spindle: SpindleState::Off,
            rpm: 0.0,
            coolant: Coolant::default(),
            tool: 0,
            selected_tool: None,
            side: Side::Off,
            radius_offset: None,
            return_to_r: false,
            cycle: None,
            cycle_dwell_s: None,
            path: PathState::new(&parameters.path),
            overrides: OverrideState::default(),
            registers: [Decimal::integer(0); 10],
        }
    }

    /// The machine coordinate of an axis.
    pub fn machine_position(&self, axis: usize) -> f64 {
        self.position[axis] + self.offsets.total()[axis]
    }

    /// Changes the offsets: the machine stands still and the program coordinates change.
    pub fn shift_coordinates(&mut self, change: impl FnOnce(&mut Offsets)) {
        let old_total = self.offsets.total();
        let old_known = self.offsets.known();
        let old_identity = self.offsets.identity();
        change(&mut self.offsets);
        self.offsets.update();
        let new_total = self.offsets.total();
        let new_known = self.offsets.known();
        let identity = self.offsets.identity();
        for axis in 0..AXES {
            let same = identity.same_for(&old_identity, axis);
            let unchanged = new_total[axis] == old_total[axis]
                && old_known.has(axis) == new_known.has(axis)
                && (same || new_known.has(axis));
            if unchanged {
                continue;
            }
            self.position[axis] += old_total[axis] - new_total[axis];
            if self.machine_known.has(axis) && new_known.has(axis) {
                self.known.insert(axis);
            } else {
                self.known = self.known.without(AxisMask(1 << axis));
            }
        }
    }
}

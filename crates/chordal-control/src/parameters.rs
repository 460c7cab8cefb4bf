//! The numbers and habits of a control that may differ from machine to machine.

use chordal_syntax::Decimal;

use crate::command::{FeedAlong, RapidPath, Units};
use crate::compensation::CompensationRules;
use crate::cycle_rules::CycleRules;
use crate::path_modes::PathRules;

/// How a number without a decimal point is read.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum DecimalPoint {
    /// `X10` is ten units, as on a pocket calculator.
    Calculator,
    /// `X10` is ten least increments (0.001 mm, 0.0001 in, 0.001°).
    LeastIncrement,
}

/// What I, J and K say.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ArcCenter {
    /// The way from the start to the centre, in G90 and G91.
    FromStart,
    /// The centre in program coordinates.
    Absolute,
    /// The way from the centre to the start.
    FromCenter,
}

/// Which plane G18 and G19 choose.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum PlaneCodes {
    /// G18 is ZX and G19 is YZ, as every control has it.
    Standard,
    /// G18 is YZ and G19 is ZX, as one textbook prints it.
    Swapped,
}

/// What happens when the end is off the arc by less than the tolerance.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ArcMismatch {
    /// The radius goes linearly with the angle, so that the end is met.
    Spiral,
    /// The arc keeps its radius to the angle of the end; a straight move follows.
    ArcThenLine,
}

/// The spiral commands that a control has.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SpiralForm {
    /// None.
    None,
    /// G2.1 and G3.1 with P (Mitsubishi type 1).
    Pitches,
    /// G2 and G3 with Q, K or L, in this precedence (Mitsubishi type 2).
    IncrementHeightCount,
    /// G2 and G3 with Q and L, the count rounded up (Fanuc).
    IncrementCount,
}

/// How an end on the ray from the centre through the start counts, where L gives the turns.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SpiralOnRay {
    /// As no turn: L1 is a straight line, L2 one turn.
    NoTurn,
    /// As a full turn: L1 is one turn.
    FullTurn,
}

/// What a centre word left out is, where centre words are coordinates.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum OmittedCenter {
    /// The coordinate of the start.
    Start,
    /// Zero.
    Zero,
}

/// What is done with decimals beyond the least increment (`X1.23456` in inch).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ExcessDecimals {
    /// The control computes with all of them.
    Exact,
    /// They are cut off.
    Cut,
    /// They are rounded.
    Rounded,
    /// Not known: Chordal computes with all of them, and says so.
    Unknown,
}

/// What an R word does beside I, J or K.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CenterAndRadius {
    /// R is followed.
    RadiusWins,
    /// The control refuses the block.
    Refused,
}

/// What happens to a full circle given by R.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FullCircleByRadius {
    /// The control alarms.
    Refused,
    /// Nothing moves.
    NoMotion,
}

/// The codes that choose inch and millimetres.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum UnitCodes {
    /// G20 and G21.
    G20,
    /// G70 and G71.
    G70,
    /// Either pair.
    Both,
}

/// What counts when a radius value is in the offset table.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum OffsetKind {
    /// The table holds diameters.
    Diameter,
    /// The table holds radii.
    Radius,
}

/// How compensation goes round an outside corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum OutsideCorner {
    /// Straight on to the intersection, with a further line where that is far away.
    Linear,
    /// An arc about the corner.
    Arc,
}

/// How compensation starts and ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CompensationEntry {
    /// Perpendicular to the first block of the contour.
    A,
    /// By the intersection, or round the corner with a further line.
    B,
    /// As if the first move were already part of the contour.
    Contour,
}

/// What the last two digits of a fixed pocket routine (Fadal L96NN to L99NN) do.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FixedRoutineCount {
    /// The routine runs as often, as subroutines do.
    Repeat,
    /// It runs once.
    Once,
}

/// The parameters of a control, as the tables set them and a machine file may change them.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Parameters {
    /// Units at power-on.
    pub units: Units,
    /// G1, not G0, at power-on.
    pub starts_linear: bool,
    /// G91, not G90, at power-on.
    pub starts_incremental: bool,
    /// How axis words without a point are read.
    pub decimal_point: DecimalPoint,
    /// Digits behind the point that a number without one has, in inch (4: 0.0001 in).
    pub increment_digits_inch: u8,
    /// The same in millimetres (3: 0.001 mm).
    pub increment_digits_mm: u8,
    /// Decimals of a length beyond the least increment.
    pub excess_decimals: ExcessDecimals,
    /// Most digits of a length; 0 for no limit.
    pub most_digits: u8,
    /// Digits behind the point that an F without one has, in inch.
    pub feed_digits_inch: u8,
    /// What I, J and K say.
    pub arc_center: ArcCenter,
    /// Which plane G18 and G19 choose.
    pub plane_codes: PlaneCodes,
    /// Largest difference of the radii at start and end of an arc, mm.
    pub radius_error_tolerance_mm: f64,
    /// Above the tolerance a difference is still accepted up to this part of the radius
    /// (LinuxCNC 0.001), and never above the limit. 0 where the control has no such rule.
    pub radius_error_relative: f64,
    /// See `radius_error_relative`, mm.
    pub radius_error_limit_mm: f64,
    /// What happens within the tolerance.
    pub arc_mismatch: ArcMismatch,
    /// `|2R − chord|` up to here makes the middle of the chord the centre, mm; `None` for two least
    /// increments of the units in force.
    pub semicircle_tolerance_mm: Option<f64>,
    /// Points closer than this are one point, mm: far below any least increment, far above
    /// rounding.
    pub coincidence_mm: f64,
    /// Along what F is measured on a helix.
    pub helix_feed: FeedAlong,
    /// Spiral commands.
    pub spiral: SpiralForm,
    /// Turns of a spiral that ends on the ray of its start.
    pub spiral_on_ray: SpiralOnRay,
    /// Rotary axes may turn with an arc.
    pub rotary_in_arc: bool,
    /// A centre word left out, where they are the centre's coordinates.
    pub omitted_center: OmittedCenter,
    /// A move in machine coordinates (G53) is a rapid, whatever motion is in force.
    pub machine_move_is_rapid: bool,
    /// G0 takes back the direction that G2 or G3 armed.
    pub rapid_disarms_arc: bool,
    /// Largest distance of a computed spiral end from the programmed one, mm.
    pub spiral_end_tolerance_mm: f64,
    /// R beside I, J, K.
    pub center_and_radius: CenterAndRadius,
    /// Full circle by R.
    pub full_circle_by_radius: FullCircleByRadius,
    /// Rapids.
    pub rapid: RapidPath,
    /// Largest radius, mm.
    pub max_radius_mm: f64,
    /// Largest radius with compensation, mm.
    pub max_radius_compensated_mm: f64,
    /// Largest turn of a rotary axis in a block, rad.
    pub max_rotary_per_block_rad: f64,
    /// What the radius offsets of the table are.
    pub radius_offsets: OffsetKind,
    /// Outside corners with compensation.
    pub outside_corner: OutsideCorner,
    /// Start and end of compensation.
    pub compensation_entry: CompensationEntry,
    /// All else of compensation.
    pub compensation: CompensationRules,
    /// H brings the length offset into force by itself (Fadal Format 1).
    pub length_by_h_alone: bool,
    /// How deep calls may be nested.
    pub nesting: u32,
    /// Largest count of a repeat or a call.
    pub max_repeats: u32,
    /// Repeats and program number share one P (`P100013`: 10 × O0013).
    pub packed_calls: bool,
    /// Lift of a chip-breaking peck (G73), mm.
    pub chip_break_mm: f64,
    /// Clearance of a full-retract peck (G83), mm.
    pub peck_clearance_mm: f64,
    /// H differing from the tool number is an alarm (Haas Setting 15).
    pub length_must_match_tool: bool,
    /// The codes that choose inch and millimetres.
    pub unit_codes: UnitCodes,
    /// G92 takes G52 back on the axes it names.
    pub preset_clears_shift: bool,
    /// `M98 P` looks only for a program of the file, not in the folder.
    pub calls_within_file: bool,
    /// G28 without axis words sends all axes home.
    pub bare_home_moves_all: bool,
    /// `M99 P` jumps in the running program instead of the calling one.
    pub return_label_in_callee: bool,
    /// Largest stepover of fixed pocket routines, mm; never more than leaves nothing standing.
    pub pocket_stepover_mm: f64,
    /// The count of fixed pocket routines.
    pub fixed_routine_count: FixedRoutineCount,
    /// The register word that gives fixed bore milling its diameter.
    pub bore_diameter_register: u8,
    /// Canned cycles.
    pub cycles: CycleRules,
    /// ATAN and ASIN of macro programs give 0 to 360 degrees, not -180 to 180.
    pub macro_angles_full_circle: bool,
    /// How ends of moves are passed.
    pub path: PathRules,
    /// Codes that call macros.
    pub aliases: Aliases,
}

/// Codes that call macros, by their numbers; 0 where there is none.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Aliases {
    /// There is any.
    pub any: bool,
    /// G codes.
    pub g: [u16; 10],
    /// M codes that call a macro.
    pub m: [u16; 10],
    /// M codes that call a subprogram.
    pub m_subprogram: [u16; 9],
}

impl Parameters {
    /// `|2R − chord|` up to here makes the middle of the chord the centre, mm.
    pub fn semicircle_tolerance(&self, units: Units) -> f64 {
        self.semicircle_tolerance_mm.unwrap_or(2.0 * self.least_increment(units))
    }

    /// Decimals of a length that the control keeps; the rest is cut, rounded or not known to be either.
    pub fn kept_decimals(&self, units: Units) -> u8 {
        match (self.excess_decimals, units) {
            (ExcessDecimals::Exact, _) => u8::MAX,
            (_, Units::Inch) => self.increment_digits_inch,
            (_, Units::Millimetre) => self.increment_digits_mm,
        }
    }

    /// The length that the control makes of a number with a decimal point.
    pub fn kept(&self, number: Decimal, units: Units) -> Decimal {
        if number.scale <= self.kept_decimals(units) {
            return number;
        }
        match (self.excess_decimals, number.at_decimals(self.kept_decimals(units))) {
            (ExcessDecimals::Cut, Some((cut, _))) => cut,
            (ExcessDecimals::Rounded, Some((_, rounded))) => rounded,
            _ => number,
        }
    }

    /// The smallest length that a word can give, mm.
    pub fn least_increment(&self, units: Units) -> f64 {
        let (unit, digits) = match units {
            Units::Inch => (25.4, self.increment_digits_inch),
            Units::Millimetre => (1.0, self.increment_digits_mm),
        };
        unit / 10f64.powi(i32::from(digits))
    }

    /// What most controls share; a table names only what it has otherwise.
    pub const COMMON: Parameters = Parameters {
        units: Units::Inch,
        starts_linear: false,
        starts_incremental: false,
        decimal_point: DecimalPoint::LeastIncrement,
        increment_digits_inch: 4,
        increment_digits_mm: 3,
        excess_decimals: ExcessDecimals::Unknown,
        most_digits: 0,
        feed_digits_inch: 0,
        arc_center: ArcCenter::FromStart,
        plane_codes: PlaneCodes::Standard,
        radius_error_tolerance_mm: 0.0127,
        radius_error_relative: 0.0,
        radius_error_limit_mm: 0.0,
        arc_mismatch: ArcMismatch::Spiral,
        semicircle_tolerance_mm: None,
        coincidence_mm: 1e-6,
        helix_feed: FeedAlong::Path,
        spiral: SpiralForm::None,
        spiral_on_ray: SpiralOnRay::NoTurn,
        rotary_in_arc: true,
        omitted_center: OmittedCenter::Start,
        machine_move_is_rapid: false,
        rapid_disarms_arc: false,
        spiral_end_tolerance_mm: 0.01,
        center_and_radius: CenterAndRadius::RadiusWins,
        full_circle_by_radius: FullCircleByRadius::Refused,
        rapid: RapidPath::DogLeg,
        max_radius_mm: f64::INFINITY,
        max_radius_compensated_mm: f64::INFINITY,
        max_rotary_per_block_rad: f64::INFINITY,
        radius_offsets: OffsetKind::Radius,
        outside_corner: OutsideCorner::Linear,
        compensation_entry: CompensationEntry::A,
        compensation: CompensationRules::COMMON,
        length_by_h_alone: false,
        nesting: 4,
        max_repeats: 9999,
        packed_calls: false,
        chip_break_mm: 0.254,
        peck_clearance_mm: 0.254,
        length_must_match_tool: false,
        unit_codes: UnitCodes::G20,
        preset_clears_shift: false,
        calls_within_file: false,
        bare_home_moves_all: false,
        return_label_in_callee: false,
        pocket_stepover_mm: f64::INFINITY,
        fixed_routine_count: FixedRoutineCount::Repeat,
        bore_diameter_register: 1,
        cycles: CycleRules::COMMON,
        macro_angles_full_circle: false,
        path: PathRules::COMMON,
        aliases: Aliases { any: false, g: [0; 10], m: [0; 10], m_subprogram: [0; 9] },
    };
}

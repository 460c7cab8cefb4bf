//! What differs between controls, as plain data: a number or a choice for each rule.
//!
//! A dialect gives each rule its value, and a machine file may change it. The kernel uses the rule and
//! never the name of the control.

mod arc;
mod compensation;
mod corner;
mod cycle;
mod frame;
mod path_mode;
mod rotary_feed;
mod tool_lengths;
mod turning;

use chordal_command::{FeedMode, RapidPath, Units};
use chordal_geometry::{HalfCircleTolerance, Plane};

pub use arc::*;
pub use compensation::*;
pub use corner::*;
pub use cycle::*;
pub use frame::*;
pub use path_mode::*;
pub use rotary_feed::*;
pub use tool_lengths::*;
pub use turning::*;

/// The speed of G0.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RapidFeed {
    /// The rapid speed of the axes.
    OfMachine,
    /// At the active F, as G1 does (Marlin).
    Programmed,
    /// This speed, mm/s; F is for the other moves.
    Fixed(f64),
}

/// The rules of a numerical control, without those of its language.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rules {
    /// Units at power-on.
    pub units: Units,
    /// G1, not G0, at power-on.
    pub starts_linear: bool,
    /// No motion code at power-on: an axis word needs one.
    pub starts_without_motion: bool,
    /// G91, not G90, at power-on.
    pub starts_incremental: bool,
    /// The plane of arcs at power-on.
    pub starts_in: Plane,
    /// Feed per revolution, not per minute, at power-on.
    pub starts_per_revolution: bool,
    /// Decimal digits of the least increment in inch (4: 0.0001 in).
    pub increment_digits_inch: u8,
    /// The same in millimetres (3: 0.001 mm).
    pub increment_digits_mm: u8,
    /// A move in machine coordinates (G53) is a rapid, whatever motion is active.
    pub machine_move_is_rapid: bool,
    /// G53 is ignored in G91: its block does not move.
    pub machine_move_needs_absolute: bool,
    /// The path of rapids.
    pub rapid: RapidPath,
    /// The speed of G0.
    pub rapid_feed: RapidFeed,
    /// F at power-on, mm/s; `None` when a program must give one.
    pub starting_feed_mm_s: Option<f64>,
    /// Largest rotation of a rotary axis in a block, rad.
    pub max_rotary_per_block_rad: f64,
    /// A code of the feed mode ends F, also where that mode is active (RS274/NGC: G94 after F100 needs an F again).
    pub feed_mode_code_ends_feed: bool,
    /// What F measures on straight cuts with rotary axes.
    pub rotary_feed: RotaryFeedRules,
    /// Whether the offset table contains radii or diameters.
    pub radius_offsets: OffsetKind,
    /// Many machines with this control have a spindle switched by hand, or none (pen, knife; GRBL): a cut without
    /// M3 is not reported.
    pub spindle_by_hand: bool,
    /// A tool change stops the spindle.
    pub spindle_stops_at_tool_change: bool,
    /// M3 without S turns the spindle at a speed set by hand.
    pub speed_by_hand: bool,
    /// The path of compensation round outside corners.
    pub outside_corner: OutsideCorner,
    /// How compensation starts and ends.
    pub compensation_entry: CompensationEntry,
    /// All other rules of compensation.
    pub compensation: CompensationRules,
    /// Lift of a chip-breaking peck (G73), mm.
    pub chip_break_mm: f64,
    /// Clearance of a full-retract peck (G83), mm.
    pub peck_clearance_mm: f64,
    /// G92 ends G52 on the axes it names.
    pub preset_clears_shift: bool,
    /// G10 L2 in G91 adds to the work offset.
    pub work_values_add: bool,
    /// G52 writes the values of G92; those of other axes stay (LinuxCNC).
    pub shift_is_preset: bool,
    /// G43 copies the offsets of the tool: later changes of the table act at the next G43.
    pub length_is_copied: bool,
    /// Tool lengths.
    pub length: LengthRules,
    /// G28 without axis words sends all axes home.
    pub bare_home_moves_all: bool,
    /// A circular pocket is one circle about the present position: out along X by I, round and back, without the
    /// radius of a tool (Mach3).
    pub pocket_is_one_circle: bool,
    /// Largest stepover of fixed pocket routines, mm; limited to what leaves no ridges.
    pub pocket_stepover_mm: f64,
    /// Canned cycles.
    pub cycles: CycleRules,
    /// Path modes.
    pub path: PathRules,
    /// Arcs and spirals.
    pub arc: ArcRules,
    /// Roundings and chamfers at the end of a block.
    pub corner: RoundingRules,
    /// Mirror, scaling and rotation.
    pub frames: FrameRules,
    /// Cycles of lathes.
    pub turning: TurningRules,
}

/// Rounding of a radius that is exactly half the chord, mm.
const HALF_CIRCLE_ROUNDING_MM: f64 = 1e-9;

impl Rules {
    /// The difference of 2R and the chord up to which the centre is the middle of the chord.
    pub fn half_circle_tolerance(&self, units: Units) -> HalfCircleTolerance {
        let own = self.arc.semicircle_tolerance_mm;
        let mm = own.unwrap_or(2.0 * self.least_increment(units)) + HALF_CIRCLE_ROUNDING_MM;
        HalfCircleTolerance {
            too_short_mm: mm,
            too_long_mm: if self.arc.semicircle_of_long_radius {
                mm
            } else {
                HALF_CIRCLE_ROUNDING_MM
            },
        }
    }

    /// The unit of F at power-on.
    pub fn starting_feed_mode(&self) -> FeedMode {
        match self.starts_per_revolution {
            true => FeedMode::PerRevolution,
            false => FeedMode::PerTime,
        }
    }

    /// The least increment of a length word, mm.
    pub fn least_increment(&self, units: Units) -> f64 {
        let (unit, digits) = match units {
            Units::Inch => (25.4, self.increment_digits_inch),
            Units::Millimetre => (1.0, self.increment_digits_mm),
        };
        unit / 10f64.powi(i32::from(digits))
    }

    /// The rules most controls share; a table names only its differences.
    pub const COMMON: Rules = Rules {
        units: Units::Inch,
        starts_linear: false,
        starts_without_motion: false,
        starts_incremental: false,
        starts_in: Plane::Xy,
        starts_per_revolution: false,
        increment_digits_inch: 4,
        increment_digits_mm: 3,
        machine_move_is_rapid: false,
        machine_move_needs_absolute: false,
        rapid: RapidPath::DogLeg,
        rapid_feed: RapidFeed::OfMachine,
        starting_feed_mm_s: None,
        max_rotary_per_block_rad: f64::INFINITY,
        spindle_by_hand: false,
        spindle_stops_at_tool_change: false,
        speed_by_hand: false,
        feed_mode_code_ends_feed: false,
        rotary_feed: RotaryFeedRules::COMMON,
        radius_offsets: OffsetKind::Radius,
        outside_corner: OutsideCorner::Linear,
        compensation_entry: CompensationEntry::A,
        compensation: CompensationRules::COMMON,
        chip_break_mm: 0.254,
        peck_clearance_mm: 0.254,
        preset_clears_shift: false,
        work_values_add: true,
        shift_is_preset: false,
        length_is_copied: false,
        length: LengthRules::COMMON,
        bare_home_moves_all: false,
        pocket_is_one_circle: false,
        pocket_stepover_mm: f64::INFINITY,
        cycles: CycleRules::COMMON,
        path: PathRules::COMMON,
        arc: ArcRules::COMMON,
        corner: RoundingRules::COMMON,
        frames: FrameRules::COMMON,
        turning: TurningRules::COMMON,
    };
}

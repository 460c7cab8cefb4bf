//! What a control may do one way or another, as plain data: a number or a choice for each rule.
//!
//! A dialect gives each rule its value, and a machine file may change it. The kernel asks the rule;
//! it never asks which control it is.

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

/// How fast G0 moves.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RapidFeed {
    /// As fast as the axes can.
    OfMachine,
    /// At the F in force, as G1 does (Marlin).
    Programmed,
    /// At this speed, mm/s, and F is for the other moves.
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
    /// F counts per revolution, not per minute, at power-on.
    pub starts_per_revolution: bool,
    /// Digits behind the point that a number without one has, in inch (4: 0.0001 in).
    pub increment_digits_inch: u8,
    /// The same in millimetres (3: 0.001 mm).
    pub increment_digits_mm: u8,
    /// A move in machine coordinates (G53) is a rapid, whatever motion is in force.
    pub machine_move_is_rapid: bool,
    /// In G91 it is ignored: its block does not move.
    pub machine_move_needs_absolute: bool,
    /// Rapids.
    pub rapid: RapidPath,
    /// How fast G0 moves.
    pub rapid_feed: RapidFeed,
    /// F at power-on, mm/s, where there is one without a word.
    pub starting_feed_mm_s: Option<f64>,
    /// Largest turn of a rotary axis in a block, rad.
    pub max_rotary_per_block_rad: f64,
    /// A code of the feed mode ends F, also where that mode is in force (RS274/NGC: G94 behind F100 needs an F again).
    pub feed_mode_code_ends_feed: bool,
    /// F of straight cuts with rotary axes.
    pub rotary_feed: RotaryFeedRules,
    /// What the radius offsets of the table are.
    pub radius_offsets: OffsetKind,
    /// Many of its machines have a spindle that is switched by hand, or none: a pen, a knife (GRBL).
    pub spindle_by_hand: bool,
    /// A tool change stops the spindle by itself.
    pub spindle_stops_at_tool_change: bool,
    /// M3 without an S turns the spindle at the speed that was set by hand.
    pub speed_by_hand: bool,
    /// Outside corners with compensation.
    pub outside_corner: OutsideCorner,
    /// Start and end of compensation.
    pub compensation_entry: CompensationEntry,
    /// All else of compensation.
    pub compensation: CompensationRules,
    /// Lift of a chip-breaking peck (G73), mm.
    pub chip_break_mm: f64,
    /// Clearance of a full-retract peck (G83), mm.
    pub peck_clearance_mm: f64,
    /// G92 takes G52 back on the axes it names.
    pub preset_clears_shift: bool,
    /// G10 L2 in G91 adds to the work offset.
    pub work_values_add: bool,
    /// G52 writes the values of G92, and G92 of the others stays (LinuxCNC).
    pub shift_is_preset: bool,
    /// G43 takes a copy of the tool's offsets: what is written into the table later acts at the next G43.
    pub length_is_copied: bool,
    /// How tools of different length are made to work on the same part.
    pub length: LengthRules,
    /// G28 without axis words sends all axes home.
    pub bare_home_moves_all: bool,
    /// A circular pocket is one circle about the present place: out along X by I, round and back, without the
    /// radius of a tool (Mach3).
    pub pocket_is_one_circle: bool,
    /// Largest stepover of fixed pocket routines, mm; never more than leaves nothing standing.
    pub pocket_stepover_mm: f64,
    /// Canned cycles.
    pub cycles: CycleRules,
    /// How ends of moves are passed.
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

/// What arithmetic makes of a radius that is half the chord, mm.
const HALF_CIRCLE_ROUNDING_MM: f64 = 1e-9;

impl Rules {
    /// Up to which difference of 2R and the chord the middle of the chord is the centre.
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

    /// What F counts at power-on.
    pub fn starting_feed_mode(&self) -> FeedMode {
        match self.starts_per_revolution {
            true => FeedMode::PerRevolution,
            false => FeedMode::PerTime,
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

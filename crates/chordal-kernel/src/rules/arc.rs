//! The rules of a control for arcs and spirals, as data.

use chordal_command::{FeedAlong, Units};

/// The meaning of I, J and K.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ArcCenter {
    /// The vector from the start to the centre, in G90 and G91.
    FromStart,
    /// The centre in program coordinates.
    Absolute,
    /// The vector from the centre to the start.
    FromCenter,
}

/// What happens when the end is off the arc by less than the tolerance.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ArcMismatch {
    /// The radius changes linearly with the angle, so that the arc meets the end.
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

/// How an end on the ray from the centre through the start counts when L gives the turns.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SpiralOnRay {
    /// As no turn: L1 is a straight line, L2 one turn.
    NoTurn,
    /// As a full turn: L1 is one turn.
    FullTurn,
}

/// The value of an omitted centre word when centre words are coordinates.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum OmittedCenter {
    /// The coordinate of the start.
    Start,
    /// Zero.
    Zero,
}

/// What happens to a full circle programmed by R.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FullCircleByRadius {
    /// The control stops with an alarm.
    Refused,
    /// Nothing moves.
    NoMotion,
    /// A straight line to the end, where another axis moves (GRBL).
    Straight,
}

/// The rules of arcs, helices and spirals.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ArcRules {
    /// The meaning of I, J and K.
    pub arc_center: ArcCenter,
    /// Largest difference of the radii at start and end of an arc, mm.
    pub radius_error_tolerance_mm: f64,
    /// Above the tolerance, a difference is still accepted up to this fraction of the radius
    /// (LinuxCNC 0.001), but never above the limit. 0 when the control has no such rule.
    pub radius_error_relative: f64,
    /// See `radius_error_relative`, mm.
    pub radius_error_limit_mm: f64,
    /// The firmware checks each arc in its own arithmetic before (GRBL): the radii are not checked again.
    pub judged_before: bool,
    /// Factor of tolerance and limit in inch programs.
    pub radius_error_inch_factor: f64,
    /// What happens to a difference within the tolerance.
    pub arc_mismatch: ArcMismatch,
    /// Up to this `|2R − chord|` the centre is the middle of the chord, mm; `None` for two least
    /// increments of the active units.
    pub semicircle_tolerance_mm: Option<f64>,
    /// This also applies to a radius that is too long; otherwise its centre is computed.
    pub semicircle_of_long_radius: bool,
    /// Points closer than this coincide, mm: far below any least increment, far above rounding.
    pub coincidence_mm: f64,
    /// What F measures on a helix.
    pub helix_feed: FeedAlong,
    /// Spiral commands.
    pub spiral: SpiralForm,
    /// Turns of a spiral that ends on the ray of its start.
    pub spiral_on_ray: SpiralOnRay,
    /// Rotary axes may turn with an arc.
    pub rotary_in_arc: bool,
    /// The value of an omitted centre word when centre words are coordinates.
    pub omitted_center: OmittedCenter,
    /// Largest distance of a computed spiral end from the programmed one, mm.
    pub spiral_end_tolerance_mm: f64,
    /// What happens to a full circle programmed by R.
    pub full_circle_by_radius: FullCircleByRadius,
    /// Largest radius of an arc, mm.
    pub max_radius_mm: f64,
    /// Largest radius of an arc with cutter compensation, mm.
    pub max_radius_compensated_mm: f64,
}

impl ArcRules {
    /// The factor of the radius error tolerance in programs of these units.
    pub fn radius_error_factor(&self, units: Units) -> f64 {
        match units {
            Units::Inch => self.radius_error_inch_factor,
            Units::Millimetre => 1.0,
        }
    }

    /// The rules most controls share; a table names only its differences.
    pub const COMMON: ArcRules = ArcRules {
        arc_center: ArcCenter::FromStart,
        radius_error_tolerance_mm: 0.0127,
        radius_error_relative: 0.0,
        radius_error_limit_mm: 0.0,
        judged_before: false,
        radius_error_inch_factor: 1.0,
        arc_mismatch: ArcMismatch::Spiral,
        semicircle_tolerance_mm: None,
        semicircle_of_long_radius: false,
        coincidence_mm: 1e-6,
        helix_feed: FeedAlong::Path,
        spiral: SpiralForm::None,
        spiral_on_ray: SpiralOnRay::NoTurn,
        rotary_in_arc: true,
        omitted_center: OmittedCenter::Start,
        spiral_end_tolerance_mm: 0.01,
        full_circle_by_radius: FullCircleByRadius::Refused,
        max_radius_mm: f64::INFINITY,
        max_radius_compensated_mm: f64::INFINITY,
    };
}

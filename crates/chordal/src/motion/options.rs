//! What the caller may set for motion, and the numbers in force.

use chordal_command::PathMode;
use chordal_machine::Machine;
use chordal_motion::PlannerLevel;

use super::operations::OperationStart;

/// What may be other than the machine file and the program say. `None`: as they say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionOptions {
    /// How hard the planner tries.
    pub level: PlannerLevel,
    /// The feed override; 1 is as programmed.
    pub feed_override: Option<f64>,
    /// The rapid override; 1 is full speed.
    pub rapid_override: Option<f64>,
    /// The path mode of every cut, whatever the program says.
    pub path_mode: Option<PathMode>,
    /// The tolerance of corners where the mode rounds them and names none, mm.
    pub corner_tolerance_mm: Option<f64>,
    /// Dog-leg rapids keep their shape, as a chain of straight moves: for places, not for times,
    /// since every bend costs a little. Otherwise such a rapid is planned along its chord, which
    /// takes as long as its slowest axis does and is the time of the machine.
    pub dog_leg_shape: bool,
    /// Splines are planned in even parts, exactly. Where none is even (at a cusp, at a start without speed)
    /// they are lines within this distance of the curve, mm.
    pub spline_tolerance_mm: f64,
    /// Where operations begin.
    pub operations: OperationStart,
}

impl Default for MotionOptions {
    fn default() -> MotionOptions {
        MotionOptions {
            level: PlannerLevel::Fast,
            feed_override: None,
            rapid_override: None,
            path_mode: None,
            corner_tolerance_mm: None,
            dog_leg_shape: false,
            spline_tolerance_mm: 1e-6,
            operations: OperationStart::ToolChange,
        }
    }
}

/// The active numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct ActiveMotionModes {
    pub feed_override: f64,
    pub rapid_override: f64,
    pub corner_tolerance_mm: f64,
    pub exact_path_tolerance_mm: f64,
    pub rapid_corner_tolerance_mm: f64,
    pub rotary_tolerance_rad: f64,
}

impl ActiveMotionModes {
    pub fn new(machine: &Machine, options: &MotionOptions) -> ActiveMotionModes {
        let motion = &machine.motion;
        // An override of zero or NaN is no speed at all; the panel's 100 % stands for it.
        let sane = |value: f64| if value > 0.0 && value.is_finite() { value } else { 1.0 };
        ActiveMotionModes {
            feed_override: sane(options.feed_override.unwrap_or_else(|| motion.feed_override())),
            rapid_override: sane(options.rapid_override.unwrap_or_else(|| motion.rapid_override())),
            corner_tolerance_mm: options
                .corner_tolerance_mm
                .unwrap_or_else(|| motion.corner_tolerance_mm()),
            exact_path_tolerance_mm: motion.exact_path_tolerance_mm(),
            rapid_corner_tolerance_mm: motion.rapid_corner_tolerance_mm(),
            rotary_tolerance_rad: motion.rotary_tolerance_rad(),
        }
    }
}

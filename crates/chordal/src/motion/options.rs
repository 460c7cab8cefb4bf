//! What the caller may set for motion, and the values that result.

use chordal_command::PathMode;
use chordal_machine::Machine;
use chordal_motion::PlannerLevel;

use super::operations::OperationStart;

/// Values that replace those of the machine file and the program. `None` keeps theirs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionOptions {
    /// How much computing the planner spends on a faster motion.
    pub level: PlannerLevel,
    /// The feed override as a factor; 1 is as programmed.
    pub feed_override: Option<f64>,
    /// The rapid override as a factor; 1 is full speed.
    pub rapid_override: Option<f64>,
    /// The path mode of every cut, whatever the program says.
    pub path_mode: Option<PathMode>,
    /// The corner tolerance where the path mode rounds corners without naming a tolerance, mm.
    pub corner_tolerance_mm: Option<f64>,
    /// Dog-leg rapids keep their shape, as a chain of straight moves. This gives the right positions but slightly
    /// long times, since every bend costs a little. Otherwise such a rapid is planned along its chord, which takes as
    /// long as its slowest axis and so as long as on the machine.
    pub dog_leg_shape: bool,
    /// Splines are planned exactly, in parts along which the parameter speed is even. Where it is not (at a cusp, at
    /// a start without speed), lines within this distance of the curve take their place, mm.
    pub spline_tolerance_mm: f64,
    /// Under tool centre point control the axes go on curves while the rotary axes turn: they are planned in straight
    /// motions that keep the tip within this distance of its path, mm.
    pub axis_chord_tolerance_mm: f64,
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
            axis_chord_tolerance_mm: 1e-3,
            operations: OperationStart::ToolChange,
        }
    }
}

/// The active overrides and tolerances: those of the options, or else of the machine.
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
        // With an override of zero or NaN nothing would move; 100 % is taken instead.
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

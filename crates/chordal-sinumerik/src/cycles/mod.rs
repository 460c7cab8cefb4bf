//! The standard cycles as pure functions: the arguments of a call go in, levels and points come out. Nothing here knows
//! the text of a program or the kernel.
//!
//! Sources: Cycles, Programming Guide 11/2006 (PGZ), NC Programming 12/2019 (6FC5398-2EP40) for parameters that were
//! added later, Siemens' cycle files of version 06.02.09, Diagnostics Manual 03/2013 (6FC5398-8BP40) for the alarms.

mod arguments;
mod bores;
mod holes;
mod levels;
mod milling_signatures;
mod patterns;
mod pecks;
mod signatures;
mod steps;
mod taps;
mod threads;

pub use arguments::{CycleArguments, CycleFault, NO_ALARM};
pub use holes::{drilling_axis, drilling_moves};
pub use patterns::{PatternContext, pattern_points};
pub use signatures::{CYCLES, CycleParameter, CycleSignature, cycle_signature};
pub use steps::{HoleContext, HoleStep};
pub use threads::thread_depths;

/// What the sources leave open about the standard cycles, and what a builder or the control may set. Lengths are in
/// millimetres, whatever unit the program uses.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CycleSettings {
    /// The lift that breaks the chip when `_VRT` is missing, 0 or negative: 1 mm (PGZ, CYCLE83 and CYCLE84).
    pub chip_break_mm: f64,
    /// The distance above the last depth at which the feed starts again (CYCLE83, VARI 1) when `_DIS1` is 0: 0.6 mm down
    /// to `shallow_depth_mm` (PGZ).
    pub reentry_mm: f64,
    /// Down to this depth below the reference plane `reentry_mm` applies: 30 mm (PGZ).
    pub shallow_depth_mm: f64,
    /// Below `shallow_depth_mm` the distance is the depth divided by this number: 50 (PGZ).
    pub reentry_divisor: f64,
    /// The largest distance above the last depth: 7 mm (PGZ).
    pub max_reentry_mm: f64,
    /// The lift of a chip break ends at the start plane (reference plane and safety distance). The sources do not say
    /// what happens when the first peck is smaller than the lift.
    pub lift_ends_at_start_plane: bool,
    /// The spindle after CYCLE84 when SDAC is missing: 5, because the spindle is in position control during the cycle.
    /// The sources name 3, 4 and 5 and no default.
    pub spindle_after_tapping: u8,
    /// CYCLE801 starts at the corner of the grid that is nearer the tool, as the comparisons of the cycle file suggest.
    /// Otherwise it starts at the reference point.
    pub grid_starts_near_tool: bool,
    /// The last decimal digit of `_XA` and `_YA` of CYCLE802 belongs to the first point; otherwise the first digit does.
    /// All digits of known calls are the same, so that both readings agree.
    pub last_digit_is_first_point: bool,
    /// The largest number of pecks of a hole and of holes of a pattern: more is a slip in an argument.
    pub max_repetitions: u32,
}

impl Default for CycleSettings {
    fn default() -> CycleSettings {
        CycleSettings {
            chip_break_mm: 1.0,
            reentry_mm: 0.6,
            shallow_depth_mm: 30.0,
            reentry_divisor: 50.0,
            max_reentry_mm: 7.0,
            lift_ends_at_start_plane: true,
            spindle_after_tapping: 5,
            grid_starts_near_tool: true,
            last_digit_is_first_point: true,
            max_repetitions: 100_000,
        }
    }
}

//! The standard cycles as pure functions: the arguments of a call go in, levels and points come out. Nothing here knows
//! the text of a program or the kernel.
//!
//! Sources: Cycles, Programming Guide 11/2006 (PGZ), NC Programming 12/2019 (6FC5398-2EP40) for parameters that were
//! added later, Siemens' cycle files of version 06.02.09, Diagnostics Manual 03/2013 (6FC5398-8BP40) for the alarms.

mod arguments;
mod bores;
mod cycle_parameters;
mod holes;
mod levels;
mod milling;
mod milling_signatures;
mod patterns;
mod pecks;
mod signatures;
mod steps;
mod taps;
mod threads;

pub use crate::alarms::NO_ALARM;
pub use arguments::{CycleArguments, CycleFault};
pub use cycle_parameters::{CycleParameter, CycleSignature};
pub use holes::{drilling_axis, drilling_moves};
pub use milling::{MillStep, MillingContext, MillingMoves, is_milling_cycle, milling_moves};
pub use patterns::{PatternContext, pattern_points};
pub use signatures::{CYCLES, cycle_signature};
pub use steps::{HoleContext, HoleStep};
pub use threads::{ThreadStep, thread_depths, thread_moves};

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

#[cfg(test)]
mod tests {
    /// Short texts of steps and arguments, in which the expectations of tests are written.
    pub(in crate::cycles) mod notation {
        use crate::cycles::{CycleArguments, HoleContext, HoleStep, drilling_moves};

        /// Arguments from a text as in a call: `10,0,,-25`.
        pub(in crate::cycles) fn arguments(text: &str) -> CycleArguments {
            let value = |part: &str| match part.trim() {
                "" => None,
                number => Some(number.parse().expect("a number")),
            };
            CycleArguments::new(&text.split(',').map(value).collect::<Vec<_>>())
        }

        /// The steps of a call as `r2 f-10 d0.5s r10`; the number and the parameter of its fault otherwise.
        pub(in crate::cycles) fn steps(call: &str) -> String {
            steps_in(call, &HoleContext { current_level: 100.0, ..HoleContext::default() })
        }

        pub(in crate::cycles) fn steps_in(call: &str, context: &HoleContext) -> String {
            let (name, list) = call.trim_end_matches(')').split_once('(').expect("a call");
            match drilling_moves(name, &arguments(list), context) {
                Ok(steps) => steps.iter().map(text).collect::<Vec<_>>().join(" "),
                Err(fault) => {
                    let number = format!("alarm {}:", fault.alarm);
                    assert_eq!(fault.alarm != 0, fault.message.starts_with(&number), "{fault:?}");
                    format!("{} at {:?}", fault.alarm, fault.parameter)
                }
            }
        }

        fn text(step: &HoleStep) -> String {
            // Six places are the finest resolution of the control.
            let short = |value: f64| {
                let rounded = (value * 1e6).round() / 1e6;
                format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
            };
            let speed =
                |rpm: Option<f64>| rpm.map_or(String::new(), |rpm| format!("@{}", short(rpm)));
            match *step {
                HoleStep::Rapid(to) => format!("r{}", short(to)),
                HoleStep::Feed { to, factor: 1.0 } => format!("f{}", short(to)),
                HoleStep::Feed { to, factor } => format!("f{}*{}", short(to), short(factor)),
                HoleStep::FeedAt { to, feed } => format!("f{}@{}", short(to), short(feed)),
                HoleStep::Dwell { seconds } => format!("d{}s", short(seconds)),
                HoleStep::DwellRevolutions { revolutions } => format!("d{}rev", short(revolutions)),
                HoleStep::SpindleStop => "M5".to_string(),
                HoleStep::SpindleReverse => "reverse".to_string(),
                HoleStep::SpindleRestore(direction) => format!("m{direction}"),
                HoleStep::Orient { degrees } => {
                    format!("spos{}", degrees.map_or(String::new(), short))
                }
                HoleStep::RapidInPlane { a, b, normal } => {
                    format!("i{},{},{}", short(a), short(b), short(normal))
                }
                HoleStep::Stop => "M0".to_string(),
                HoleStep::TapIn { to, pitch_mm, spindle_rpm } => {
                    format!("in{}/{}{}", short(to), short(pitch_mm), speed(spindle_rpm))
                }
                HoleStep::TapOut { to, pitch_mm, spindle_rpm } => {
                    format!("out{}/{}{}", short(to), short(pitch_mm), speed(spindle_rpm))
                }
            }
        }
    }
}

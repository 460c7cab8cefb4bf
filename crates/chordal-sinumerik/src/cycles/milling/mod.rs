//! The milling cycles as pure functions: the arguments of a call go in, moves come out.
//!
//! What the sources give: the shape, the planes, the number and the size of the infeeds, the stepover, the direction, where
//! a cycle begins and ends (PGZ, chapter 3). What they leave open is the order of the cuts inside a shape: here they are
//! loops at equal distances from the inside out.

mod call_values;
#[cfg(test)]
mod checks;
mod clearing;
mod faces;
mod mill_path;
mod outlines;
mod pockets;
mod slots;
mod spigots;
mod thread_mills;

use chordal_geometry::TurnDirection;

use super::arguments::{CycleArguments, CycleCall, CycleFault};
use crate::alarms::NO_ALARM;
use mill_path::MillPath;

/// The cycles of this module.
const MILLING_CYCLES: [&str; 12] = [
    "POCKET1", "POCKET2", "POCKET3", "POCKET4", "SLOT1", "SLOT2", "LONGHOLE", "CYCLE61", "CYCLE71",
    "CYCLE76", "CYCLE77", "CYCLE90",
];

/// What a milling cycle takes from the program around it. Lengths are in units of the program.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MillingContext {
    /// Where the tool is: along the first and the second axis of the plane and along its normal.
    pub position: [f64; 3],
    /// Millimetres of a unit of length of the program: 1, or 25.4 for inches.
    pub unit_mm: f64,
    /// The radius of the active edge; `None` when it is not known.
    pub tool_radius: Option<f64>,
    /// Whether a feed is active, which acts where the cycle gives none.
    pub has_feed: bool,
    /// The spindle before the cycle: 3 (M3), 4 (M4) or 5 (stopped).
    pub spindle_direction: u8,
    /// The G code of the plane: 17, 18 or 19.
    pub plane_code: u8,
    /// The cycle runs at a position of the program (MCALL): a reference point that is left out is that position.
    pub is_modal: bool,
    /// The largest number of loops and levels: more is a slip in an argument.
    pub max_repetitions: u32,
}

impl Default for MillingContext {
    /// 100 above the origin in G17, M3, a feed, in millimetres; the tool is not known.
    fn default() -> MillingContext {
        MillingContext {
            position: [0.0, 0.0, 100.0],
            unit_mm: 1.0,
            tool_radius: None,
            has_feed: true,
            spindle_direction: 3,
            plane_code: 17,
            is_modal: false,
            max_repetitions: 20_000,
        }
    }
}

/// A move of a milling cycle, or a change of speed. Points are coordinates of the program in its units: along the first and
/// the second axis of the plane and along its normal. Feeds are per minute or per revolution, as F; `None` is the feed of
/// the program.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum MillStep {
    /// A rapid.
    Rapid([f64; 3]),
    /// A straight cut.
    Line {
        /// Its end.
        to: [f64; 3],
        /// Its feed.
        feed: Option<f64>,
    },
    /// An arc about the normal of the plane; a helix when the level changes. A full circle when it ends in the plane where
    /// it begins.
    Arc {
        /// Its centre in the plane.
        center: [f64; 2],
        /// Its direction, seen against the normal.
        direction: TurnDirection,
        /// Its end.
        to: [f64; 3],
        /// Full circles in addition.
        turns: u32,
        /// Its feed.
        feed: Option<f64>,
    },
    /// The speed of the spindle in revolutions a minute; `None` is that of the program again.
    SpindleSpeed(Option<f64>),
}

/// What a milling cycle does.
#[derive(Clone, PartialEq, Debug)]
pub struct MillingMoves {
    /// The moves in order.
    pub steps: Vec<MillStep>,
    /// The radius that the corners of a pocket get, when the tool is too large for the one that is programmed.
    pub enlarged_corner: Option<f64>,
}

/// Whether a cycle is one of this module.
pub fn is_milling_cycle(name: &str) -> bool {
    MILLING_CYCLES.contains(&name)
}

/// The moves of a milling cycle. There are none when the depth is the reference plane.
///
/// # Errors
/// The alarm with which the control refuses the arguments; [`NO_ALARM`] for a cycle that does not mill, for arguments that
/// are not modelled, and when the radius of the tool is not known.
pub fn milling_moves(
    name: &str,
    arguments: &CycleArguments,
    context: &MillingContext,
) -> Result<MillingMoves, CycleFault> {
    let call = CycleCall::new(name, arguments)?;
    let mut path = MillPath::new(context.position);
    let mut enlarged_corner = None;
    match call.name() {
        "POCKET1" => enlarged_corner = pockets::old_rectangle(&call, context, &mut path)?,
        "POCKET2" => pockets::old_circle(&call, context, &mut path)?,
        "POCKET3" => enlarged_corner = pockets::rectangle(&call, context, &mut path)?,
        "POCKET4" => pockets::circle(&call, context, &mut path)?,
        "SLOT1" => slots::radial(&call, context, &mut path)?,
        "SLOT2" => slots::circumferential(&call, context, &mut path)?,
        "LONGHOLE" => slots::long_holes(&call, context, &mut path)?,
        "CYCLE61" => faces::between_corners(&call, context, &mut path)?,
        "CYCLE71" => faces::rectangle(&call, context, &mut path)?,
        "CYCLE76" => spigots::rectangle(&call, context, &mut path)?,
        "CYCLE77" => spigots::circle(&call, context, &mut path)?,
        "CYCLE90" => thread_mills::mill(&call, context, &mut path)?,
        other => {
            let text = format!("{other} is no milling cycle");
            return Err(call.fault(NO_ALARM, None, &text));
        }
    }
    Ok(MillingMoves { steps: path.steps, enlarged_corner })
}

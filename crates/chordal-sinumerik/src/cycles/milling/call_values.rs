//! What the milling cycles take from their arguments alike: tool, feeds, direction, depths, digits of the editor.

use chordal_geometry::TurnDirection;

use super::MillingContext;
use crate::alarms::NO_ALARM;
use crate::cycles::arguments::{CycleCall, CycleFault};
use crate::cycles::bores::{NO_FEED, NO_SPINDLE_DIRECTION};
use crate::cycles::levels::{HoleLevels, unmodelled};

/// The kind of machining does not exist.
pub(super) const KIND_OF_MACHINING: u32 = 61_002;
/// The radius of the tool is too large.
pub(super) const TOOL_TOO_LARGE: u32 = 61_105;
/// `_RAD1` or `_DP1` does not fit.
pub(super) const INSERTION_VALUES: u32 = 61_108;
/// `_CDIR` has no such value.
const MILLING_DIRECTION: u32 = 61_109;
/// The finishing allowance of the base is larger than an infeed.
pub(super) const BASE_ALLOWANCE: u32 = 61_110;
/// The stepover is larger than the diameter of the tool.
const STEPOVER_TOO_LARGE: u32 = 61_111;
/// The radius of the tool is 0 or negative.
const TOOL_RADIUS: u32 = 61_117;
/// The angle of insertion is 0.
pub(super) const INSERTION_ANGLE: u32 = 61_128;
/// A length or a width is 0.
pub(super) const NO_SIZE: u32 = 61_118;

/// The stepover when none is programmed, as a fraction of the diameter of the tool (PGZ, POCKET3).
const DEFAULT_STEPOVER: f64 = 0.8;

/// The largest number of full circles in one helix (TURN).
const MAX_TURNS: u32 = 999;

/// On which side of the tool's path the part stays.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum MilledSide {
    /// The tool is inside: a pocket.
    Inside,
    /// The tool is outside: a spigot.
    Outside,
}

/// The radius of the tool.
///
/// # Errors
/// 61117 when it is 0; [`NO_ALARM`] when it is not known.
pub(super) fn tool_radius(
    call: &CycleCall<'_>,
    context: &MillingContext,
) -> Result<f64, CycleFault> {
    match context.tool_radius {
        None => {
            let text = format!(
                "{} needs the radius of the tool, which the machine file does not give",
                call.name()
            );
            Err(call.fault(NO_ALARM, None, &text))
        }
        Some(radius) if radius > 0.0 => Ok(radius),
        Some(_) => Err(call.fault(TOOL_RADIUS, None, "the radius of the tool is 0")),
    }
}

/// A feed of the cycle; `None` for the feed of the program, which acts when the cycle gives none.
///
/// # Errors
/// 61003 when neither gives one. That the feed of the program replaces a missing argument is no rule of the manual.
pub(super) fn feed(
    call: &CycleCall<'_>,
    context: &MillingContext,
    parameter: &str,
) -> Result<Option<f64>, CycleFault> {
    let feed = call.number(parameter);
    if feed > 0.0 {
        return Ok(Some(feed));
    }
    if feed == 0.0 && context.has_feed {
        return Ok(None);
    }
    let text = format!("{parameter} must be more than 0");
    Err(call.fault(NO_FEED, Some(parameter), &text))
}

/// The direction in which the tool goes round a shape: 0 climb, 1 conventional, by the direction of the spindle; 2 G2, 3 G3.
///
/// # Errors
/// 61109 for other values, 61102 when the spindle stands and its direction decides.
pub(super) fn direction(
    call: &CycleCall<'_>,
    context: &MillingContext,
    parameter: &str,
    side: MilledSide,
) -> Result<TurnDirection, CycleFault> {
    let is_climb = match call.integer(parameter) {
        0 => true,
        1 => false,
        2 => return Ok(TurnDirection::Cw),
        3 => return Ok(TurnDirection::Ccw),
        _ => {
            let text = format!("{parameter} must be 0 to 3");
            return Err(call.fault(MILLING_DIRECTION, Some(parameter), &text));
        }
    };
    let turns_right = match context.spindle_direction {
        3 => true,
        4 => false,
        _ => {
            let text = "climb and conventional milling need the direction of the spindle";
            return Err(call.fault(NO_SPINDLE_DIRECTION, Some(parameter), text));
        }
    };
    // With M3 a climb cut has the part on its right: counterclockwise in a pocket, clockwise round a spigot.
    let climb = match side {
        MilledSide::Inside => TurnDirection::Ccw,
        MilledSide::Outside => TurnDirection::Cw,
    };
    Ok(climb.mirrored_if(is_climb != turns_right))
}

/// The largest stepover: `_MIDA` as a length, or as a percentage of the diameter where `_AMODE` says so.
///
/// # Errors
/// 61111 when it is larger than the diameter.
pub(super) fn stepover(
    call: &CycleCall<'_>,
    radius: f64,
    is_percentage: bool,
) -> Result<f64, CycleFault> {
    let programmed = call.magnitude("_MIDA");
    let stepover = match programmed {
        0.0 => 2.0 * radius * DEFAULT_STEPOVER,
        _ if is_percentage => 2.0 * radius * programmed / 100.0,
        _ => programmed,
    };
    if stepover > 2.0 * radius * (1.0 + 1e-12) {
        let text = "the stepover _MIDA is larger than the diameter of the tool";
        return Err(call.fault(STEPOVER_TOO_LARGE, Some("_MIDA"), text));
    }
    Ok(stepover)
}

/// Equal parts of a length, none larger than `largest` (0: one part).
///
/// # Errors
/// [`NO_ALARM`] when there would be more than the context allows.
pub(super) fn equal_parts(
    call: &CycleCall<'_>,
    context: &MillingContext,
    length: f64,
    largest: f64,
) -> Result<u32, CycleFault> {
    if length <= 0.0 {
        return Ok(0);
    }
    if largest <= 0.0 {
        return Ok(1);
    }
    // A quotient that is a whole number but for rounding takes no further part.
    let parts = (length / largest * (1.0 - 1e-12)).ceil().max(1.0);
    if parts > f64::from(context.max_repetitions) {
        let text = format!(
            "{} would take {parts:.0} cuts, more than {}: check the steps",
            call.name(),
            context.max_repetitions
        );
        return Err(call.fault(NO_ALARM, None, &text));
    }
    Ok(parts as u32)
}

/// Refuses a helix of more turns than one block has.
///
/// # Errors
/// [`NO_ALARM`].
pub(super) fn check_turns(call: &CycleCall<'_>, turns: f64) -> Result<(), CycleFault> {
    if turns > f64::from(MAX_TURNS) {
        let text = format!("{} would take {turns:.0} turns of a helix", call.name());
        return Err(call.fault(NO_ALARM, None, &text));
    }
    Ok(())
}

/// The depths below the reference plane after each of equal infeeds from one depth to another.
///
/// The machine datum `_ZSD[1]` decides whether the infeeds are counted from the reference plane or from the safety distance
/// above it (PGZ, 1.5): the sources do not agree on its default. It changes their number, not the shape.
pub(super) fn infeed_depths(
    call: &CycleCall<'_>,
    context: &MillingContext,
    from: f64,
    to: f64,
    largest: f64,
) -> Result<Vec<f64>, CycleFault> {
    let count = equal_parts(call, context, to - from, largest)?;
    let depth = |index: u32| match index == count {
        true => to,
        false => from + (to - from) * f64::from(index) / f64::from(count),
    };
    Ok((1..=count).map(depth).collect())
}

/// The planes of a cycle whose only depth is absolute, or incremental where the last digit of `_AMODE` is 1: names of the
/// retract plane, the reference plane, the safety distance and the depth.
///
/// # Errors
/// 61101, as for a hole; [`NO_ALARM`] for other digits.
pub(super) fn planes(
    call: &CycleCall<'_>,
    [retract, reference, safety, depth]: [&str; 4],
) -> Result<Option<HoleLevels>, CycleFault> {
    let [retract, surface] = [call.number(retract), call.number(reference)];
    let is_incremental = match call.integer("_AMODE") % 10 {
        0 | 2 => false,
        1 => true,
        _ => return Err(unmodelled(call, "_AMODE")),
    };
    let above = if retract < surface { -1.0 } else { 1.0 };
    let bottom = match is_incremental {
        true => surface - above * call.magnitude(depth),
        false => call.number(depth),
    };
    HoleLevels::between(call, reference, [retract, surface, call.magnitude(safety), bottom])
}

/// Refuses digits of the editor that choose what is not modelled: another plane than the active one, the calculation of a
/// start point alone, a reference point that is a corner.
pub(super) fn check_display_digits(
    call: &CycleCall<'_>,
    context: &MillingContext,
) -> Result<(), CycleFault> {
    let plane = call.integer("_DMODE") % 10;
    if plane != 0 && plane + 16 != i64::from(context.plane_code) {
        return Err(unmodelled(call, "_DMODE"));
    }
    let geometry = call.integer("_GMODE");
    let (machining, dimension) = (geometry / 100 % 10, geometry / 1000 % 10);
    if machining > 1 || dimension > 1 {
        return Err(unmodelled(call, "_GMODE"));
    }
    Ok(())
}

/// The reference point of a cycle: its two arguments. One that is left out is the position of the tool where the cycle runs
/// at positions of the program (MCALL), and 0 otherwise.
pub(super) fn reference_point(
    call: &CycleCall<'_>,
    context: &MillingContext,
    parameters: [&str; 2],
) -> [f64; 2] {
    let [a, b, _] = context.position;
    let missing = if context.is_modal { [a, b] } else { [0.0; 2] };
    [0, 1].map(|index| call.argument(parameters[index]).unwrap_or(missing[index]))
}

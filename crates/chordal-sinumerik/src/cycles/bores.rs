//! Boring and reaming: CYCLE85 to CYCLE89 (PGZ). Each ends before the rapid to the retract plane.

use super::arguments::{CycleCall, CycleFault};
use super::levels::{HoleLevels, dwell_at_bottom};
use super::steps::{HoleStep, StepList};

/// No direction of the spindle is programmed: SDIR, or SDR of CYCLE840.
pub(super) const NO_SPINDLE_DIRECTION: u32 = 61_102;

/// No feed is programmed.
pub(super) const NO_FEED: u32 = 61_003;

/// CYCLE85: in and out at feeds that are arguments.
pub(super) fn ream(
    call: &CycleCall<'_>,
    levels: &HoleLevels,
    list: &mut StepList,
) -> Result<(), CycleFault> {
    let [inward, outward] = [feed(call, "FFR")?, feed(call, "RFF")?];
    list.rapid(levels.start);
    list.feed_at(levels.bottom, inward);
    list.dwell(dwell_at_bottom(call)?);
    list.feed_at(levels.start, outward);
    Ok(())
}

fn feed(call: &CycleCall<'_>, parameter: &str) -> Result<f64, CycleFault> {
    let feed = call.number(parameter);
    if feed <= 0.0 {
        let text = format!("{parameter} must be more than 0");
        return Err(call.fault(NO_FEED, Some(parameter), &text));
    }
    Ok(feed)
}

/// CYCLE86: the spindle stops at an angle, the tool leaves the wall and comes out at rapid.
pub(super) fn bore_with_orientation(
    call: &CycleCall<'_>,
    levels: &HoleLevels,
    list: &mut StepList,
) -> Result<(), CycleFault> {
    start_spindle(call, list)?;
    list.rapid(levels.start);
    list.feed(levels.bottom, 1.0);
    list.dwell(dwell_at_bottom(call)?);
    list.push(HoleStep::Orient { degrees: call.argument("POSS") });
    list.rapid_by(lift_off(call));
    list.rapid(levels.start);
    Ok(())
}

/// The increments by which CYCLE86 leaves the wall: RPA, RPO and RPAP.
pub(super) fn lift_off(call: &CycleCall<'_>) -> [f64; 3] {
    ["RPA", "RPO", "RPAP"].map(|parameter| call.number(parameter))
}

/// CYCLE87 and CYCLE88: the spindle and the program stop at the bottom; after NC start the tool comes out at rapid.
pub(super) fn bore_with_stop(
    call: &CycleCall<'_>,
    levels: &HoleLevels,
    list: &mut StepList,
) -> Result<(), CycleFault> {
    start_spindle(call, list)?;
    list.rapid(levels.start);
    list.feed(levels.bottom, 1.0);
    list.dwell(dwell_at_bottom(call)?);
    list.push(HoleStep::SpindleStop);
    list.push(HoleStep::Stop);
    Ok(())
}

/// CYCLE89: in and out at the feed of the program.
pub(super) fn bore_and_feed_out(
    call: &CycleCall<'_>,
    levels: &HoleLevels,
    list: &mut StepList,
) -> Result<(), CycleFault> {
    list.rapid(levels.start);
    list.feed(levels.bottom, 1.0);
    list.dwell(dwell_at_bottom(call)?);
    list.feed(levels.start, 1.0);
    Ok(())
}

fn start_spindle(call: &CycleCall<'_>, list: &mut StepList) -> Result<(), CycleFault> {
    match call.integer("SDIR") {
        3 => list.push(HoleStep::SpindleRestore(3)),
        4 => list.push(HoleStep::SpindleRestore(4)),
        _ => {
            let text = "SDIR must be 3 or 4";
            return Err(call.fault(NO_SPINDLE_DIRECTION, Some("SDIR"), text));
        }
    }
    Ok(())
}

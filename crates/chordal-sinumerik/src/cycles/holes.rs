//! One hole: CYCLE81 to CYCLE89 and CYCLE840.

use super::arguments::{CycleArguments, CycleCall, CycleFault};
use super::levels::{HoleLevels, dwell_at_bottom, unmodelled};
use super::steps::{HoleContext, HoleStep, StepList};
use super::{bores, is_milling_cycle, pecks, taps};
use crate::alarms::NO_ALARM;

/// The steps of a drilling cycle at the place where the tool is. There are none when the depth is the reference plane.
///
/// # Errors
/// The alarm with which the control refuses the arguments; [`NO_ALARM`] for a cycle that does not drill and for arguments
/// that are not modelled.
pub fn drilling_moves(
    name: &str,
    arguments: &CycleArguments,
    context: &HoleContext,
) -> Result<Vec<HoleStep>, CycleFault> {
    let call = CycleCall::new(name, arguments)?;
    let is_drilling = call.signature.parameters.first().is_some_and(|first| first.name == "RTP");
    if !is_drilling || is_milling_cycle(call.name()) {
        let text = format!("{} is no drilling cycle", call.name());
        return Err(call.fault(NO_ALARM, None, &text));
    }
    let Some(levels) = HoleLevels::of_call(&call)? else { return Ok(Vec::new()) };
    let mut list = StepList::new(context.current_level);
    match call.name() {
        "CYCLE81" | "CYCLE82" => drill(&call, &levels, &mut list)?,
        "CYCLE83" => pecks::deep_hole(&call, &levels, context, &mut list)?,
        "CYCLE84" => taps::rigid(&call, &levels, context, &mut list)?,
        "CYCLE840" => taps::compensating(&call, &levels, context, &mut list)?,
        "CYCLE85" => bores::ream(&call, &levels, &mut list)?,
        "CYCLE86" => bores::bore_with_orientation(&call, &levels, &mut list)?,
        "CYCLE87" | "CYCLE88" => bores::bore_with_stop(&call, &levels, &mut list)?,
        // CYCLE89 is the last of the cycles that are carried out and begin with RTP.
        _ => bores::bore_and_feed_out(&call, &levels, &mut list)?,
    }
    list.rapid(levels.retract);
    if call.name() == "CYCLE86" {
        let [a, b, _] = bores::lift_off(&call);
        list.rapid_by([-a, -b, 0.0]);
    }
    Ok(list.steps)
}

/// The drilling axis of a call: 0 and 1 for the axes of the plane, 2 for its normal, which is the default (`_AXN`).
pub fn drilling_axis(name: &str, arguments: &CycleArguments) -> usize {
    let axis = CycleCall::new(name, arguments).map_or(0, |call| call.integer("_AXN"));
    match axis {
        1 => 0,
        2 => 1,
        _ => 2,
    }
}

/// CYCLE81 and CYCLE82: down at feed, dwell, up at rapid.
fn drill(call: &CycleCall<'_>, levels: &HoleLevels, list: &mut StepList) -> Result<(), CycleFault> {
    // Bits and digits of _VARI select predrilling and through drilling at feeds of their own.
    if call.integer("_VARI") != 0 {
        return Err(unmodelled(call, "_VARI"));
    }
    list.rapid(levels.start);
    list.feed(levels.bottom, 1.0);
    list.dwell(dwell_at_bottom(call)?);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cycles::CYCLES;
    use crate::cycles::tests::notation::{arguments, steps, steps_in};

    #[test]
    fn plain_drilling() {
        assert_eq!(steps("CYCLE81(10,0,2,-25)"), "r2 f-25 r10");
        assert_eq!(steps("CYCLE81(10,0,2,-25,,0.5)"), "r2 f-25 d0.5s r10");
        assert_eq!(steps("CYCLE82(110,102,4,75,,2)"), "r106 f75 d2s r110");
        assert_eq!(steps("cycle82(10,0,2,-25,,-3)"), "r2 f-25 d3rev r10");
    }

    #[test]
    fn boring() {
        assert_eq!(steps("CYCLE85(10,0,2,-25,,1,100,300)"), "r2 f-25@100 d1s f2@300 r10");
        assert_eq!(
            steps("CYCLE86(10,0,2,-25,,1,3,-1,0.5,1,45)"),
            "m3 r2 f-25 d1s spos45 i-1,0.5,1 r2 r10 i1,-0.5,0"
        );
        // No lift-off is programmed: nothing moves in the plane.
        assert_eq!(steps("CYCLE86(10,0,2,-25,,,4)"), "m4 r2 f-25 spos r2 r10");
        assert_eq!(steps("CYCLE87(10,0,2,-25,,3)"), "m3 r2 f-25 M5 M0 r10");
        assert_eq!(steps("CYCLE88(10,0,2,-25,,2,4)"), "m4 r2 f-25 d2s M5 M0 r10");
        assert_eq!(steps("CYCLE89(10,0,2,-25,,2)"), "r2 f-25 d2s f2 r10");
    }

    #[test]
    fn a_relative_depth_wins() {
        assert_eq!(steps("CYCLE81(10,0,2,-25,30)"), "r2 f-30 r10");
        assert_eq!(steps("CYCLE81(10,3,2,,30)"), "r5 f-27 r10");
        // Signs of SDIS and DPR are ignored, as the cycle file does.
        assert_eq!(steps("CYCLE81(10,3,-2,,-30)"), "r5 f-27 r10");
        // Upward, since the retract plane is below the surface.
        assert_eq!(steps("CYCLE81(-10,-3,2,,30)"), "r-5 f27 r-10");
    }

    #[test]
    fn amode_chooses_the_depth_and_the_unit_of_the_dwell() {
        assert_eq!(steps("CYCLE81(10,0,2,-25,30,1,0,1,2)"), "r2 f-25 d1s r10");
        assert_eq!(steps("CYCLE81(10,0,2,-25,30,1,0,1,21)"), "r2 f-30 d1rev r10");
        assert_eq!(steps("CYCLE81(10,0,2,-25,30,-1,0,1,12)"), "r2 f-25 d1s r10");
        assert_eq!(steps("CYCLE81(10,0,2,-25,30,1,0,1,112)"), "0 at Some(8)");
        assert_eq!(steps("CYCLE81(10,0,2,-25,30,1,0,1,3)"), "0 at Some(8)");
    }

    #[test]
    fn the_planes_must_agree() {
        assert_eq!(steps("CYCLE81(10,5,2,5)"), "", "nothing to drill");
        assert_eq!(steps("CYCLE81(0,0,2,,30)"), "61101 at Some(1)");
        // With an absolute depth both planes may be the same.
        assert_eq!(steps("CYCLE81(0,0,2,-30)"), "r2 f-30 r0");
        assert_eq!(steps("CYCLE81(10,0,2,25)"), "61101 at Some(1)");
        assert_eq!(steps("CYCLE81(-10,0,2,-25)"), "61101 at Some(1)");
        for cycle in CYCLES.iter().filter(|cycle| cycle.parameters[0].name == "RTP") {
            if cycle.is_carried_out && !is_milling_cycle(cycle.name) {
                assert_eq!(steps(&format!("{}(10,0,2,25)", cycle.name)), "61101 at Some(1)");
            }
        }
    }

    #[test]
    fn faults_of_parameters() {
        assert_eq!(steps("CYCLE85(10,0,2,-25,,1,0,300)"), "61003 at Some(6)");
        assert_eq!(steps("CYCLE85(10,0,2,-25,,1,100)"), "61003 at Some(7)");
        assert_eq!(steps("CYCLE86(10,0,2,-25,,1)"), "61102 at Some(6)");
        assert_eq!(steps("CYCLE87(10,0,2,-25,,5)"), "61102 at Some(5)");
        assert_eq!(steps("CYCLE88(10,0,2,-25,,1,0)"), "61102 at Some(6)");
        assert_eq!(steps("CYCLE87(10,0,2,-25,,3,1)"), "12340 at None");
        assert_eq!(steps("CYCLE87(10,0,2,-25,,3,,,)"), "m3 r2 f-25 M5 M0 r10");
        assert_eq!(steps("CYCLE82(10,0,2,-25,,1,0,1,12,1,2)"), "0 at Some(9)");
        assert_eq!(steps("CYCLE81(10,NaN,2,-25)"), "0 at Some(1)");
        assert_eq!(steps("CYCLE81(10,0,2,-inf)"), "0 at Some(3)");
        assert_eq!(steps("CYCLE81(1e300,0,2,-25)"), "0 at Some(0)");
        assert_eq!(steps("POCKET3(10,0,2,-25)"), "0 at None");
        assert_eq!(steps("CYCLE9(10)"), "0 at None");
        assert_eq!(steps("HOLES1(1,2,3,4,5,6)"), "0 at None");
    }

    #[test]
    fn a_rapid_that_does_not_move_is_left_out() {
        let at = HoleContext { current_level: 2.0, ..HoleContext::default() };
        assert_eq!(steps_in("CYCLE81(2,0,2,-25)", &at), "f-25 r2");
        assert_eq!(steps_in("CYCLE89(2,0,2,-25)", &at), "f-25 f2");
    }

    #[test]
    fn the_drilling_axis() {
        let axis = |list| drilling_axis("CYCLE83", &arguments(list));
        assert_eq!(axis("10,0,2,-25"), 2);
        let axes = ["0", "1", "2", "3"]
            .map(|number| axis(&format!("10,0,2,-25,,,5,0,,,1,0,{number}").leak()[..]));
        assert_eq!(axes, [2, 0, 1, 2]);
        assert_eq!(drilling_axis("CYCLE81", &arguments("10,0,2,-25")), 2);
    }
}

//! Tapping: CYCLE84 with the spindle in position control, CYCLE840 with a compensating chuck (PGZ). Each ends before
//! the rapid to the retract plane.

use core::f64::consts::PI;

use super::arguments::{CycleCall, CycleFault};
use super::bores::NO_SPINDLE_DIRECTION;
use super::levels::{HoleLevels, dwell_at_bottom, unmodelled};
use super::pecks::{DEPTH_EPSILON, chip_break};
use super::steps::{HoleContext, HoleStep, StepList};
use crate::alarms::NO_ALARM;

/// The lead of the thread is defined incorrectly.
pub(super) const THREAD_LEAD: u32 = 61_001;

/// Leads in millimetres that differ by less are the same: MPIT and PIT may both be written.
const LEAD_EPSILON_MM: f64 = 1e-3;

/// Millimetres of an inch.
const MM_PER_INCH: f64 = 25.4;

/// Size and lead in millimetres of the coarse metric threads of MPIT, M3 to M48 (ISO 261).
const METRIC_LEADS_MM: [(f64, f64); 21] = [
    (3.0, 0.5),
    (4.0, 0.7),
    (5.0, 0.8),
    (6.0, 1.0),
    (8.0, 1.25),
    (10.0, 1.5),
    (12.0, 1.75),
    (14.0, 2.0),
    (16.0, 2.0),
    (18.0, 2.5),
    (20.0, 2.5),
    (22.0, 2.5),
    (24.0, 3.0),
    (27.0, 3.0),
    (30.0, 3.5),
    (33.0, 3.5),
    (36.0, 4.0),
    (39.0, 4.0),
    (42.0, 4.5),
    (45.0, 4.5),
    (48.0, 5.0),
];

/// CYCLE84: orient, into the thread, out with the spindle reversed.
pub(super) fn rigid(
    call: &CycleCall<'_>,
    levels: &HoleLevels,
    context: &HoleContext,
    list: &mut StepList,
) -> Result<(), CycleFault> {
    let pitch_mm = required_lead(call, context)?;
    let speed = |parameter| Some(call.magnitude(parameter)).filter(|rpm| *rpm != 0.0);
    let speed_in = speed("SST");
    let speed_out = speed("SST1").or(speed_in);
    let variant = call.integer("_VARI");
    let depths = tap_depths(call, levels, context)?;
    let bottom_dwell = dwell_at_bottom(call)?;
    list.rapid(levels.start);
    list.push(HoleStep::Orient { degrees: call.argument("POSS") });
    for (index, depth) in depths.iter().copied().enumerate() {
        list.tap_in(levels.at_depth(depth), pitch_mm, speed_in);
        if index + 1 == depths.len() {
            list.dwell(bottom_dwell);
            list.tap_out(levels.start, pitch_mm, speed_out);
        } else if variant == 1 {
            let lifted = levels.at_depth_below_start(depth - chip_break(call, context));
            list.tap_out(lifted, pitch_mm, speed_out);
        } else {
            list.tap_out(levels.start, pitch_mm, speed_out);
        }
    }
    let after = match call.integer("SDAC") {
        direction @ 3..=5 => direction as u8,
        _ => context.settings.spindle_after_tapping,
    };
    list.push(HoleStep::SpindleRestore(after));
    Ok(())
}

/// The depths of CYCLE84 below the reference plane: in one go for `_VARI` 0, otherwise pecks of `_DAM`.
fn tap_depths(
    call: &CycleCall<'_>,
    levels: &HoleLevels,
    context: &HoleContext,
) -> Result<Vec<f64>, CycleFault> {
    let peck = call.magnitude("_DAM");
    match call.integer("_VARI") {
        0 => Ok(vec![levels.total()]),
        1 | 2 if peck == 0.0 => Ok(vec![levels.total()]),
        1 | 2 => {
            let most = context.settings.max_repetitions;
            // The last peck is what remains: unlike for CYCLE83, no source halves it.
            let before_last = ((levels.total() - DEPTH_EPSILON) / peck).floor().max(0.0);
            if before_last >= f64::from(most) {
                let text = format!("{most} pecks do not reach the depth");
                return Err(call.fault(NO_ALARM, Some("_DAM"), &text));
            }
            let pecks = (1..=before_last as u32).map(|index| f64::from(index) * peck);
            Ok(pecks.chain([levels.total()]).collect())
        }
        _ => Err(unmodelled(call, "_VARI")),
    }
}

/// CYCLE840: into the thread, reverse, out. With ENC = 1 the feed of the program makes the lead.
pub(super) fn compensating(
    call: &CycleCall<'_>,
    levels: &HoleLevels,
    context: &HoleContext,
    list: &mut StepList,
) -> Result<(), CycleFault> {
    let direction_out = call.integer("SDR");
    let direction_in = match direction_out {
        0 => context.spindle_direction,
        3 => 4,
        4 => 3,
        _ => return Err(call.fault(NO_SPINDLE_DIRECTION, Some("SDR"), "SDR must be 0, 3 or 4")),
    };
    if !matches!(direction_in, 3 | 4) {
        let text = "with SDR = 0 the spindle must turn before the cycle";
        return Err(call.fault(NO_SPINDLE_DIRECTION, Some("SDR"), text));
    }
    let pitch_mm = match call.integer("ENC") {
        1 => None,
        0 | 11 | 20 => {
            let magnitude = required_lead(call, context)?.abs();
            Some(if direction_in == 3 { magnitude } else { -magnitude })
        }
        _ => return Err(unmodelled(call, "ENC")),
    };
    list.rapid(levels.start);
    match pitch_mm {
        Some(pitch_mm) => list.tap_in(levels.bottom, pitch_mm, None),
        None => list.feed(levels.bottom, 1.0),
    }
    list.dwell(dwell_at_bottom(call)?);
    list.push(match direction_out {
        0 => HoleStep::SpindleReverse,
        direction => HoleStep::SpindleRestore(direction as u8),
    });
    match pitch_mm {
        Some(pitch_mm) => list.tap_out(levels.start, pitch_mm, None),
        None => list.feed(levels.start, 1.0),
    }
    // With SDR = 0 SDAC has no meaning: the spindle turns again as before the cycle.
    let after = match call.integer("SDAC") {
        direction @ 3..=5 if direction_out != 0 => direction as u8,
        _ => direction_in,
    };
    list.rapid(levels.retract);
    list.push(HoleStep::SpindleRestore(after));
    Ok(())
}

fn required_lead(call: &CycleCall<'_>, context: &HoleContext) -> Result<f64, CycleFault> {
    lead_mm(call, context)?.ok_or_else(|| {
        call.fault(THREAD_LEAD, Some("PIT"), "neither MPIT nor PIT is the lead of a thread")
    })
}

/// The lead in millimetres a revolution; negative for a left-hand thread. `None` when neither MPIT nor PIT is written.
pub(super) fn lead_mm(
    call: &CycleCall<'_>,
    context: &HoleContext,
) -> Result<Option<f64>, CycleFault> {
    let (size, pitch) = (call.number("MPIT"), call.number("PIT"));
    let by_size = METRIC_LEADS_MM
        .iter()
        .find(|(metric, _)| *metric == size.abs())
        .map(|(_, lead_mm)| lead_mm * size.signum());
    if size != 0.0 && by_size.is_none() {
        let text = "MPIT is no size from M3 to M48";
        return Err(call.fault(THREAD_LEAD, Some("MPIT"), text));
    }
    let by_pitch = match call.integer("_PITA") {
        _ if pitch == 0.0 => None,
        0 => Some(pitch * context.unit_mm),
        1 => Some(pitch),
        2 => Some(MM_PER_INCH / pitch),
        3 => Some(pitch * MM_PER_INCH),
        4 => Some(pitch * PI),
        _ => return Err(unmodelled(call, "_PITA")),
    };
    if let (Some(by_size), Some(by_pitch)) = (by_size, by_pitch)
        && (by_size - by_pitch).abs() > LEAD_EPSILON_MM
    {
        let text = "MPIT and PIT are different leads";
        return Err(call.fault(THREAD_LEAD, Some("PIT"), text));
    }
    Ok(by_pitch.or(by_size))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cycles::tests::notation::{steps, steps_in};

    #[test]
    fn rigid_tapping() {
        assert_eq!(
            steps("CYCLE84(10,0,2,-25,,1,3,,1.5,90,200,500)"),
            "r2 spos90 in-25/1.5@200 d1s out2/1.5@500 m3 r10"
        );
        // M12 left-hand; SST1 as SST; the spindle stays in position control.
        assert_eq!(
            steps("CYCLE84(10,0,2,-25,,,,-12,,,200)"),
            "r2 spos in-25/-1.75@200 out2/-1.75@200 m5 r10"
        );
    }

    #[test]
    fn rigid_tapping_in_pecks() {
        let call = |variant: u8, lift: &str| {
            format!("CYCLE84(10,0,2,-25,,1,5,,1,0,200,0,3,1,0,{variant},10,{lift})")
        };
        assert_eq!(
            steps(&call(1, "")),
            "r2 spos0 in-10/1@200 out-9/1@200 in-20/1@200 out-19/1@200 in-25/1@200 d1s \
             out2/1@200 m5 r10"
        );
        assert_eq!(
            steps(&call(1, "3")),
            "r2 spos0 in-10/1@200 out-7/1@200 in-20/1@200 out-17/1@200 in-25/1@200 d1s \
             out2/1@200 m5 r10"
        );
        assert_eq!(
            steps(&call(2, "")),
            "r2 spos0 in-10/1@200 out2/1@200 in-20/1@200 out2/1@200 in-25/1@200 d1s \
             out2/1@200 m5 r10"
        );
        assert_eq!(steps(&call(0, "")), "r2 spos0 in-25/1@200 d1s out2/1@200 m5 r10");
        assert_eq!(steps(&call(4, "")), "0 at Some(15)");
        // Two whole pecks; and a peck that is deeper than the hole.
        assert_eq!(
            steps("CYCLE84(10,0,2,-20,,,5,,1,0,200,0,3,1,0,2,10)"),
            "r2 spos0 in-10/1@200 out2/1@200 in-20/1@200 out2/1@200 m5 r10"
        );
        assert_eq!(
            steps("CYCLE84(10,0,2,-8,,,5,,1,0,200,0,3,1,0,2,10)"),
            "r2 spos0 in-8/1@200 out2/1@200 m5 r10"
        );
        assert_eq!(steps("CYCLE84(10,0,2,-200,,,5,,1,0,200,0,3,1,0,2,0.001)"), "0 at Some(16)");
    }

    #[test]
    fn leads() {
        let lead = |size: &str, pitch: &str, unit: u8| {
            steps(&format!("CYCLE84(10,0,2,-25,,,3,{size},{pitch},,,,,{unit})"))
        };
        let expected = |lead: &str| format!("r2 spos in-25/{lead} out2/{lead} m3 r10");
        assert_eq!(lead("3", "", 0), expected("0.5"));
        assert_eq!(lead("48", "", 0), expected("5"));
        assert_eq!(lead("6", "1", 1), expected("1"));
        assert_eq!(lead("", "20", 2), expected("1.27"));
        assert_eq!(lead("", "0.05", 3), expected("1.27"));
        assert_eq!(lead("", "0.5", 4), expected("1.570796"));
        assert_eq!(lead("", "1", 5), "0 at Some(13)");
        assert_eq!(lead("7", "", 0), "61001 at Some(7)");
        assert_eq!(lead("6", "1.25", 1), "61001 at Some(8)");
        assert_eq!(lead("", "", 0), "61001 at Some(8)");
        let inches = HoleContext { unit_mm: 25.4, ..HoleContext::default() };
        let call = "CYCLE84(10,0,2,-25,,,3,,0.05)";
        assert_eq!(steps_in(call, &inches), expected("1.27"));
    }

    #[test]
    fn tapping_with_a_compensating_chuck() {
        assert_eq!(steps("CYCLE840(10,0,2,-25,,,0,,,6)"), "r2 in-25/1 reverse out2/1 r10 m3");
        // Out with M3, so that the thread is left-hand; M4 again after the cycle.
        assert_eq!(
            steps("CYCLE840(10,0,2,-25,,1,3,4,11,,1.5)"),
            "r2 in-25/-1.5 d1s m3 out2/-1.5 r10 m4"
        );
        // The feed makes the lead.
        assert_eq!(steps("CYCLE840(10,0,2,-25,,,4,3,1)"), "r2 f-25 m4 f2 r10 m3");
        let reverse = HoleContext { spindle_direction: 4, ..HoleContext::default() };
        assert_eq!(
            steps_in("CYCLE840(10,0,2,-25,,,0,3,0,6)", &reverse),
            "r2 in-25/-1 reverse out2/-1 r10 m4"
        );
        let stopped = HoleContext { spindle_direction: 5, ..HoleContext::default() };
        let call = "CYCLE840(10,0,2,-25,,,0,3,0,6)";
        assert_eq!(steps_in(call, &stopped), "61102 at Some(6)");
        assert_eq!(steps("CYCLE840(10,0,2,-25,,,5,3,0,6)"), "61102 at Some(6)");
        assert_eq!(steps("CYCLE840(10,0,2,-25,,,0,3,0)"), "61001 at Some(10)");
        assert_eq!(steps("CYCLE840(10,0,2,-25,,,0,3,7,6)"), "0 at Some(8)");
    }
}

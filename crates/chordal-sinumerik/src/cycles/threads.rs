//! Thread turning, CYCLE97.

use super::arguments::{CycleArguments, CycleCall, CycleFault};
use super::levels::unmodelled;
use super::steps::HoleContext;
use super::taps::{THREAD_LEAD, lead_mm};

/// A parameter has a value that the cycle does not know.
const WRONG_VARIANT: u32 = 61_002;

/// How far the tool lifts from the thread where the program does not say it, in the unit of the program (PGZ, CYCLE97).
const LIFT: f64 = 1.0;

/// The largest number of cuts of a thread: more is a slip in an argument.
const MAX_CUTS: u32 = 1_000;

/// The largest number of starts of a thread.
const MAX_STARTS: u32 = 100;

/// The depths of the cuts of CYCLE97 in order: `nrc` roughing cuts down to `tdep`, then `nid` cuts without infeed. The
/// infeeds are equal for VARI 1 and 2; for VARI 3 and 4 the sections of the chip are, so that the depth of cut i of n is
/// tdep·√(i/n) (PGZ, CYCLE97). With a finishing allowance the roughing depth is TDEP less FAL, which the caller subtracts.
pub fn thread_depths(tdep: f64, nrc: u32, nid: u32, vari: u32) -> Vec<f64> {
    let has_equal_sections = matches!(vari, 3 | 4);
    let cuts = nrc.min(MAX_CUTS);
    let roughing = (1..=cuts).map(|cut| {
        let share = f64::from(cut) / f64::from(cuts);
        if has_equal_sections { tdep * share.sqrt() } else { tdep * share }
    });
    roughing.chain((0..nid.min(MAX_CUTS)).map(|_| tdep)).collect()
}

/// A move of thread turning: X (a radius) and Z in the unit of the program.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ThreadStep {
    /// A rapid.
    Rapid([f64; 2]),
    /// A cut in step with the spindle.
    Cut {
        /// Its end.
        to: [f64; 2],
        /// The lead, mm per revolution.
        lead_mm: f64,
    },
}

/// The moves of CYCLE97 for threads along Z. The flank infeed moves the start of each cut along Z; on which side of the
/// last cut is not documented, so that the cuts before the last one begin up to depth · tan(IANG) further away.
///
/// # Errors
/// No lead (61001), another VARI than 1 to 4 (61002), or a thread in the face, which is not modelled.
pub fn thread_moves(arguments: &CycleArguments) -> Result<Vec<ThreadStep>, CycleFault> {
    let call = CycleCall::new("CYCLE97", arguments)?;
    let lead_mm = lead_mm(&call, &HoleContext::default())?.ok_or_else(|| {
        call.fault(THREAD_LEAD, Some("PIT"), "neither MPIT nor PIT is the lead of a thread")
    })?;
    let vari = call.integer("VARI");
    if !(1..=4).contains(&vari) {
        return Err(call.fault(WRONG_VARIANT, Some("VARI"), "VARI must be 1 to 4"));
    }
    let (first, last) = (call.number("SPL"), call.number("FPL"));
    let [at_first, at_last] = ["DM1", "DM2"].map(|name| call.number(name) / 2.0);
    if (at_last - at_first).abs() > (last - first).abs() {
        return Err(unmodelled(&call, "DM2"));
    }
    let forth = if last < first { -1.0 } else { 1.0 };
    let slope = if last == first { 0.0 } else { (at_last - at_first) / (last - first) };
    let begin = first - forth * call.magnitude("APP");
    let end = last + forth * call.magnitude("ROP");
    let radius_at = |z: f64| at_first + slope * (z - first);
    // Outside the thread is cut towards the axis, inside away from it.
    let inward = if vari % 2 == 1 { -1.0 } else { 1.0 };
    let lift = if call.number("_VRT") > 0.0 { call.number("_VRT") } else { LIFT };
    let depth = call.magnitude("TDEP");
    let rough = (depth - call.magnitude("FAL")).max(0.0);
    let count = |name: &str| call.magnitude(name).round().min(f64::from(MAX_CUTS)) as u32;
    let mut depths = thread_depths(rough, count("NRC"), 0, vari as u32);
    if rough < depth || depths.is_empty() {
        depths.push(depth);
    }
    depths.extend(std::iter::repeat_n(depth, count("NID") as usize));
    let away = |z: f64| [radius_at(z) - inward * lift, z];
    let tangent = libm::tan(call.number("IANG").abs().min(89.0).to_radians());
    let alternates = call.number("IANG") < 0.0;
    let mut steps = vec![ThreadStep::Rapid(away(begin))];
    for _start in 0..count("NUMT").clamp(1, MAX_STARTS) {
        for (number, cut) in depths.iter().enumerate() {
            let side = if alternates && number % 2 == 1 { -1.0 } else { 1.0 };
            let from = begin - forth * side * (depth - cut) * tangent;
            let at = |z: f64| [radius_at(z) + inward * cut, z];
            steps.push(ThreadStep::Rapid(away(from)));
            steps.push(ThreadStep::Rapid(at(from)));
            steps.push(ThreadStep::Cut { to: at(end), lead_mm: lead_mm.abs() });
            steps.push(ThreadStep::Rapid(away(end)));
            steps.push(ThreadStep::Rapid(away(begin)));
        }
    }
    Ok(steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(depths: &[f64], expected: &[f64]) {
        assert_eq!(depths.len(), expected.len(), "{depths:?}");
        for (depth, expected) in depths.iter().zip(expected) {
            assert!((depth - expected).abs() < 5e-5, "{depths:?}");
        }
    }

    #[test]
    fn sections_are_equal() {
        let depths = thread_depths(1.227, 10, 0, 3);
        check(
            &depths,
            &[0.3880, 0.5487, 0.6721, 0.7760, 0.8676, 0.9504, 1.0266, 1.0975, 1.1640, 1.227],
        );
        assert_eq!(thread_depths(1.227, 10, 0, 4), depths);
    }

    #[test]
    fn infeeds_are_equal_and_cuts_without_infeed_follow() {
        check(&thread_depths(1.2, 4, 2, 1), &[0.3, 0.6, 0.9, 1.2, 1.2, 1.2]);
        check(&thread_depths(1.2, 0, 1, 2), &[1.2]);
        check(&thread_depths(1.2, 0, 0, 3), &[]);
    }

    #[test]
    fn a_thread_along_z() {
        let values = [
            Some(2.0),
            None,
            Some(0.0),
            Some(-30.0),
            Some(36.0),
            Some(36.0),
            Some(6.0),
            Some(3.0),
            Some(1.2),
            Some(0.0),
            Some(0.0),
            Some(0.0),
            Some(2.0),
            Some(1.0),
            Some(1.0),
            Some(1.0),
            Some(1.5),
        ];
        let steps = thread_moves(&CycleArguments::new(&values)).expect("moves");
        let cut = |radius: f64| ThreadStep::Cut { to: [radius, -33.0], lead_mm: 2.0 };
        let cuts: Vec<ThreadStep> =
            steps.iter().copied().filter(|step| matches!(step, ThreadStep::Cut { .. })).collect();
        assert_eq!(cuts, [cut(17.4), cut(16.8), cut(16.8)]);
        assert_eq!(steps[0], ThreadStep::Rapid([19.5, 6.0]));
        assert_eq!(steps.last(), Some(&ThreadStep::Rapid([19.5, 6.0])));
    }
}

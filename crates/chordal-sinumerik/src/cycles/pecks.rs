//! Deep holes, CYCLE83 (PGZ): the pecks, and the moves between them.

use super::CycleSettings;
use super::arguments::{CycleCall, CycleFault};
use super::levels::{HoleLevels, dwell_at_bottom};
use super::steps::{HoleContext, StepList};
use crate::alarms::NO_ALARM;

/// The first drilling depth is defined incorrectly.
const FIRST_DEPTH: u32 = 61_107;

/// Depths closer than this are the same: sums of pecks are not exact. It is the finest resolution of the control in
/// millimetres.
pub(super) const DEPTH_EPSILON: f64 = 1e-6;

/// The smallest and the largest FRF.
const FEED_FACTORS: [f64; 2] = [0.001, 1.0];

/// How the pecks after the first become smaller.
#[derive(Clone, Copy, PartialEq, Debug)]
enum PeckDegression {
    /// Each is the one before times `factor`, but at least `minimum` (DAM ≤ 0).
    Factor { factor: f64, minimum: f64 },
    /// Each is the one before less `amount`, but at least `amount` (DAM > 0).
    Amount(f64),
}

impl PeckDegression {
    /// DAM and `_MDEP` of a call. DAM = 0 repeats the first peck.
    fn of_call(call: &CycleCall<'_>, first: f64) -> PeckDegression {
        let amount = call.number("DAM");
        if amount > 0.0 {
            PeckDegression::Amount(amount)
        } else if amount < 0.0 {
            PeckDegression::Factor { factor: -amount, minimum: call.magnitude("_MDEP") }
        } else {
            PeckDegression::Factor { factor: 1.0, minimum: first }
        }
    }

    fn next(self, peck: f64) -> f64 {
        match self {
            PeckDegression::Factor { factor, minimum } => (peck * factor).max(minimum),
            PeckDegression::Amount(amount) => (peck - amount).max(amount),
        }
    }

    /// The rest of the hole is drilled in two equal pecks instead of a peck that would leave too little.
    fn ends_in_halves(self, peck: f64, rest: f64) -> bool {
        match self {
            PeckDegression::Factor { minimum, .. } => rest - peck < minimum - DEPTH_EPSILON,
            PeckDegression::Amount(amount) => {
                rest <= 2.0 * amount + DEPTH_EPSILON || rest - peck < amount - DEPTH_EPSILON
            }
        }
    }
}

/// The depths of the pecks below the reference plane; the last is `total`. `None` when there would be more than `most`.
fn peck_depths(total: f64, first: f64, degression: PeckDegression, most: u32) -> Option<Vec<f64>> {
    let mut depths = vec![first.min(total)];
    let (mut depth, mut peck) = (first, first);
    while depth < total - DEPTH_EPSILON {
        peck = degression.next(peck);
        let rest = total - depth;
        if degression.ends_in_halves(peck, rest) {
            depths.push(depth + rest / 2.0);
            depth = total;
        } else {
            depth += peck;
        }
        depths.push(depth);
        if depths.len() > most as usize {
            return None;
        }
    }
    // The sum of the pecks may miss the bottom by a rounding error.
    if let Some(last) = depths.last_mut() {
        *last = total;
    }
    Some(depths)
}

/// CYCLE83 without the rapid to the retract plane at its end.
pub(super) fn deep_hole(
    call: &CycleCall<'_>,
    levels: &HoleLevels,
    context: &HoleContext,
    list: &mut StepList,
) -> Result<(), CycleFault> {
    let first = first_depth(call, levels)?;
    let degression = PeckDegression::of_call(call, first);
    let most = context.settings.max_repetitions;
    let Some(depths) = peck_depths(levels.total(), first, degression, most) else {
        let text = format!("{most} pecks do not reach the depth");
        return Err(call.fault(NO_ALARM, Some("DAM"), &text));
    };
    let dwell = dwell_at_bottom(call)?;
    let last_dwell = Some(call.number("_DTD")).filter(|dwell| *dwell != 0.0).unwrap_or(dwell);
    let removes_chips = call.integer("VARI") == 1;
    list.rapid(levels.start);
    for (index, depth) in depths.iter().copied().enumerate() {
        let factor = if index == 0 { feed_factor(call) } else { 1.0 };
        list.feed(levels.at_depth(depth), factor);
        if index + 1 == depths.len() {
            list.dwell(last_dwell);
        } else if removes_chips {
            list.dwell(dwell);
            list.rapid(levels.start);
            list.dwell(call.number("DTS"));
            list.rapid(levels.at_depth_below_start(depth - reentry(call, depth, context)));
        } else {
            list.dwell(dwell);
            let lifted = depth - chip_break(call, context);
            list.rapid(if context.settings.lift_ends_at_start_plane {
                levels.at_depth_below_start(lifted)
            } else {
                levels.at_depth(lifted)
            });
        }
    }
    Ok(())
}

/// The depth of the first peck below the reference plane: FDPR if it is not 0, otherwise FDEP.
fn first_depth(call: &CycleCall<'_>, levels: &HoleLevels) -> Result<f64, CycleFault> {
    let relative = call.magnitude("FDPR");
    if relative != 0.0 {
        return Ok(relative);
    }
    let depth = (levels.reference - call.number("FDEP")) * levels.direction;
    if depth <= 0.0 {
        let text = "the first depth must be below the reference plane";
        return Err(call.fault(FIRST_DEPTH, Some("FDEP"), text));
    }
    Ok(depth)
}

/// FRF within its limits; 1 when it is missing or 0.
fn feed_factor(call: &CycleCall<'_>) -> f64 {
    match call.number("FRF") {
        0.0 => 1.0,
        factor => factor.clamp(FEED_FACTORS[0], FEED_FACTORS[1]),
    }
}

/// The lift that breaks the chip, in units of the program: `_VRT` if it is positive.
pub(super) fn chip_break(call: &CycleCall<'_>, context: &HoleContext) -> f64 {
    let lift = call.number("_VRT");
    if lift > 0.0 { lift } else { context.settings.chip_break_mm / context.unit_mm }
}

/// The distance above a depth at which the feed starts again, in units of the program: `_DIS1` if it is positive.
fn reentry(call: &CycleCall<'_>, depth: f64, context: &HoleContext) -> f64 {
    let distance = call.number("_DIS1");
    if distance > 0.0 {
        return distance;
    }
    reentry_mm(depth * context.unit_mm, &context.settings) / context.unit_mm
}

fn reentry_mm(depth_mm: f64, settings: &CycleSettings) -> f64 {
    if depth_mm <= settings.shallow_depth_mm {
        settings.reentry_mm
    } else {
        (depth_mm / settings.reentry_divisor).min(settings.max_reentry_mm)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::cycles::tests::notation::{arguments, steps, steps_in};
    use crate::cycles::{HoleStep, drilling_moves};

    /// The levels of the feeds alone.
    fn feeds(call: &str) -> Vec<f64> {
        let (name, list) = call.trim_end_matches(')').split_once('(').expect("a call");
        let steps = drilling_moves(name, &arguments(list), &HoleContext::default());
        feed_levels(&steps.expect("a call without a fault"))
    }

    fn feed_levels(steps: &[HoleStep]) -> Vec<f64> {
        let level = |step: &HoleStep| match step {
            HoleStep::Feed { to, .. } => Some(*to),
            _ => None,
        };
        steps.iter().filter_map(level).collect()
    }

    #[track_caller]
    fn check(levels: &[f64], expected: &[f64]) {
        assert_eq!(levels.len(), expected.len(), "{levels:?}");
        for (level, expected) in levels.iter().zip(expected) {
            assert!((level - expected).abs() < 1e-9, "{levels:?}");
        }
    }

    #[test]
    fn equal_pecks_break_chips() {
        let expected = "r2 f-10 r-9 f-17.5 r-16.5 f-25 r10";
        assert_eq!(steps("CYCLE83(10,0,2,-25,,,10,0,,,,0)"), expected);
        // The first depth is absolute.
        assert_eq!(steps("CYCLE83(10,0,2,-25,,-10)"), expected);
        // FDPR wins over FDEP.
        assert_eq!(steps("CYCLE83(10,0,2,-25,,-3,10)"), expected);
    }

    #[test]
    fn the_last_two_equal_pecks_are_halves() {
        check(&feeds("CYCLE83(10,0,2,-30,,,10)"), &[-10.0, -20.0, -25.0, -30.0]);
        check(&feeds("CYCLE83(10,0,2,-20,,,10)"), &[-10.0, -15.0, -20.0]);
        check(&feeds("CYCLE83(10,0,2,-12,,,10)"), &[-10.0, -11.0, -12.0]);
        check(&feeds("CYCLE83(10,0,2,-10,,,10)"), &[-10.0]);
        check(&feeds("CYCLE83(10,0,2,-9,,,10)"), &[-9.0]);
    }

    #[test]
    fn chips_are_removed() {
        assert_eq!(
            steps("CYCLE83(10,0,2,-32,,,10,,,,,1)"),
            "r2 f-10 r2 r-9.4 f-20 r2 r-19.4 f-26 r2 r-25.4 f-32 r10"
        );
    }

    #[test]
    fn an_amount_of_degression() {
        // Below 30 mm the distance is a fiftieth of the depth: 33/50 = 0.66, 36/50 = 0.72, 38/50 = 0.76.
        assert_eq!(
            steps("CYCLE83(10,0,2,-40,,,10,3,,,,1)"),
            "r2 f-10 r2 r-9.4 f-17 r2 r-16.4 f-21 r2 r-20.4 f-24 r2 r-23.4 f-27 r2 r-26.4 f-30 \
             r2 r-29.4 f-33 r2 r-32.34 f-36 r2 r-35.28 f-38 r2 r-37.24 f-40 r10"
        );
        // Exactly twice the amount remains: -10 -17 -21, then 6 in two halves.
        check(&feeds("CYCLE83(10,0,2,-27,,,10,3)"), &[-10.0, -17.0, -21.0, -24.0, -27.0]);
        // A peck of 7 would leave 1 of 8, less than the amount: 4 and 4.
        check(&feeds("CYCLE83(10,0,2,-18,,,10,3)"), &[-10.0, -14.0, -18.0]);
        // The first peck is smaller than the amount.
        check(&feeds("CYCLE83(10,0,2,-12,,,2,3)"), &[-2.0, -5.0, -8.0, -10.0, -12.0]);
    }

    #[test]
    fn a_factor_of_degression() {
        let expected = [-10.0, -18.0, -24.4, -29.52, -33.616, -36.8928, -38.4464, -40.0];
        check(&feeds("CYCLE83(10,0,2,-40,,,10,-0.8,,,,,,2)"), &expected);
    }

    #[test]
    fn pecks_of_a_real_program() {
        let levels =
            feeds("CYCLE83 (52,50,2,-4.887,,,2,-1,0,0,1,0,,2,1,0,0)".replace(' ', "").as_str());
        let mut expected: Vec<f64> = (0..26).map(|peck| 48.0 - 2.0 * f64::from(peck)).collect();
        expected.extend([-3.4435, -4.887]);
        assert_eq!(levels.len(), 28);
        check(&levels[24..], &[0.0, -2.0, -3.4435, -4.887]);
        check(&levels, &expected);
    }

    #[test]
    fn dwells_lifts_and_the_first_feed() {
        assert_eq!(
            steps("CYCLE83(10,0,2,-25,,,10,0,0.5,1,0.4,0,,,2,1.5)"),
            "r2 f-10*0.4 d0.5s r-8 f-17.5 d0.5s r-15.5 f-25 d1.5s r10"
        );
        assert_eq!(
            steps("CYCLE83(10,0,2,-20,,,10,0,-2,1,5,1,,,,,0.2)"),
            "r2 f-10 d2rev r2 d1s r-9.8 f-15 d2rev r2 d1s r-14.8 f-20 d2rev r10"
        );
        // A dwell at the final depth of its own, in revolutions.
        assert_eq!(steps("CYCLE83(10,0,2,-9,,,10,0,1,,,,,,,-4)"), "r2 f-9 d4rev r10");
    }

    #[test]
    fn inches() {
        let inches = HoleContext { unit_mm: 25.4, current_level: 9.0, ..HoleContext::default() };
        // 1 mm is 0.03937 inches, 0.6 mm is 0.023622; 2 inches are deeper than 30 mm: 2/50.
        assert_eq!(
            steps_in("CYCLE83(1,0,0.1,-2,,,1)", &inches),
            "r0.1 f-1 r-0.96063 f-1.5 r-1.46063 f-2 r1"
        );
        assert_eq!(
            steps_in("CYCLE83(1,0,0.1,-3,,,1,,,,,1)", &inches),
            "r0.1 f-1 r0.1 r-0.976378 f-2 r0.1 r-1.96 f-2.5 r0.1 r-2.45 f-3 r1"
        );
    }

    #[test]
    fn a_lift_ends_at_the_start_plane() {
        let call = "CYCLE83(10,0,0.2,-1,,,0.5)";
        assert_eq!(steps(call), "r0.2 f-0.5 r0.2 f-0.75 r0.2 f-1 r10");
        let settings = CycleSettings { lift_ends_at_start_plane: false, ..Default::default() };
        let free = HoleContext { settings, ..HoleContext::default() };
        assert_eq!(steps_in(call, &free), "r0.2 f-0.5 r0.5 f-0.75 r0.25 f-1 r10");
    }

    #[test]
    fn the_distance_of_reentry_has_a_largest_value() {
        let distance = |depth| reentry_mm(depth, &CycleSettings::default());
        assert_eq!([30.0, 100.0, 350.0, 500.0].map(distance), [0.6, 2.0, 7.0, 7.0]);
    }

    #[test]
    fn faults() {
        assert_eq!(steps("CYCLE83(10,0,2,-25,,3)"), "61107 at Some(5)");
        assert_eq!(steps("CYCLE83(10,0,2,-25)"), "61107 at Some(5)");
        assert_eq!(steps("CYCLE83(10,0,2,-2500,,,0.001)"), "0 at Some(7)");
        // Ever smaller pecks: 10/(1 - 0.5) = 20 is never passed.
        assert_eq!(steps("CYCLE83(10,0,2,-25,,,10,-0.5)"), "0 at Some(7)");
        assert_eq!(
            steps("CYCLE83(10,0,2,-25,,,10,-0.9,0,0,90,1,,1,1,1,1,0,1,11212)"),
            "0 at Some(19)"
        );
    }

    /// A call with the bottom below (`side` 1) or above (-1) a surface at 0.
    fn call(side: f64, [depth, first, dam, least]: [f64; 4], removes_chips: bool) -> Vec<HoleStep> {
        let mut values = vec![Some(0.0); 17];
        values[0] = Some(side * 10.0);
        values[2] = Some(2.0);
        values[3] = Some(side * -depth);
        values[6] = Some(first);
        values[7] = Some(dam);
        values[11] = Some(if removes_chips { 1.0 } else { 0.0 });
        values[13] = Some(least);
        let context = HoleContext { current_level: side * 50.0, ..HoleContext::default() };
        let arguments = crate::cycles::CycleArguments::new(&values);
        drilling_moves("CYCLE83", &arguments, &context).expect("a call without a fault")
    }

    proptest! {
        #[test]
        fn pecks_end_at_the_depth_within_the_rules(
            depth in 0.01..300.0_f64,
            first in 0.5..60.0_f64,
            dam in prop_oneof![Just(0.0), 0.1..20.0_f64, -1.0..-0.1_f64],
            least in 0.2..5.0_f64,
            removes_chips: bool,
        ) {
            let steps = call(1.0, [depth, first, dam, least], removes_chips);
            let levels = feed_levels(&steps);
            prop_assert_eq!(levels.last(), Some(&-depth));
            prop_assert_eq!(levels[0], -first.min(depth));
            let mut before = levels[0];
            let pecks: Vec<f64> = levels[1..]
                .iter()
                .map(|level| {
                    let peck = before - level;
                    before = *level;
                    peck
                })
                .collect();
            let mut regular = first;
            for (index, peck) in pecks.iter().enumerate() {
                prop_assert!(*peck > 0.0);
                let rest = depth + levels[index];
                regular = match dam {
                    0.0 => first,
                    dam if dam > 0.0 => (regular - dam).max(dam),
                    dam => (regular * -dam).max(least),
                };
                // One of the last two is half of what remained before them; the others follow DAM.
                let is_half = index + 2 == pecks.len() && (peck - rest / 2.0).abs() < 1e-6;
                let is_last_half = index + 1 == pecks.len()
                    && index > 0
                    && (peck - pecks[index - 1]).abs() < 1e-6;
                prop_assert!(
                    (peck - regular).abs() < 1e-6 || is_half || is_last_half,
                    "{pecks:?}"
                );
            }
            for step in &steps {
                if let HoleStep::Rapid(to) | HoleStep::Feed { to, .. } = step {
                    prop_assert!((-depth..=10.0).contains(to));
                }
            }
        }

        #[test]
        fn a_hole_upward_is_the_mirrored_hole(
            depth in 0.01..300.0_f64,
            first in 0.5..60.0_f64,
            dam in prop_oneof![Just(0.0), 0.1..20.0_f64, -1.0..-0.1_f64],
            least in 0.2..5.0_f64,
            removes_chips: bool,
        ) {
            let down = call(1.0, [depth, first, dam, least], removes_chips);
            let up = call(-1.0, [depth, first, dam, least], removes_chips);
            let mirrored: Vec<HoleStep> = up
                .into_iter()
                .map(|step| match step {
                    HoleStep::Rapid(to) => HoleStep::Rapid(-to),
                    HoleStep::Feed { to, factor } => HoleStep::Feed { to: -to, factor },
                    other => other,
                })
                .collect();
            prop_assert_eq!(down, mirrored);
        }

        #[test]
        fn any_numbers_give_finite_levels_or_a_fault(
            values in prop::collection::vec(
                prop::option::of(prop_oneof![-50.0..50.0_f64, any::<f64>(), -3.0..5.0_f64]),
                0..22,
            ),
            cycle in 0..14_usize,
        ) {
            let name = crate::cycles::CYCLES[cycle].name;
            let arguments = crate::cycles::CycleArguments::new(&values);
            let settings = CycleSettings { max_repetitions: 1000, ..CycleSettings::default() };
            let context = HoleContext { settings, ..HoleContext::default() };
            if let Ok(steps) = drilling_moves(name, &arguments, &context) {
                prop_assert!(steps.len() < 5010);
                prop_assert!(feed_levels(&steps).iter().all(|level| level.is_finite()));
            }
            let context = crate::cycles::PatternContext { position: [0.0; 2], settings };
            if let Ok(points) = crate::cycles::pattern_points(name, &arguments, &context) {
                prop_assert!(points.len() <= 1000);
                prop_assert!(points.iter().flatten().all(|value| value.is_finite()));
            }
        }
    }
}

//! The infeeds of thread turning, CYCLE97.

/// The largest number of cuts of a thread: more is a slip in an argument.
const MAX_CUTS: u32 = 100_000;

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
}

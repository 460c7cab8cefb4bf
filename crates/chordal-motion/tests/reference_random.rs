//! The bound, the reference and the profile of the level best on random runs.

mod support;

use chordal_motion::{
    KinematicLimits, PathPiece, PathRun, PlannedTrajectory, ReferenceQuality, largest_use,
    reference, time_bound,
};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use support::best::{Best, best};
use support::figures::{chain, reversed, scaled};
use support::limits;

/// Turns from nothing to sharp, lengths over four decades.
fn steps() -> impl Strategy<Value = Vec<(f64, [f64; 4])>> {
    let turn = prop_oneof![Just(0.0), -0.05..0.05, -1.0..1.0];
    let turns = [turn.clone(), turn.clone(), turn.clone(), turn];
    prop::collection::vec(((-3.0..1.0f64).prop_map(|power| 10f64.powf(power)), turns), 1..8)
}

const EFFORT: ReferenceQuality = ReferenceQuality {
    step_s: 0.003,
    least_nodes: 100,
    most_nodes: 800,
    total_nodes: 800,
    programs: 8,
};

struct Times {
    bound: f64,
    reference: f64,
    best: Best,
}

fn times(pieces: &[PathPiece], speeds: &[f64], limits: &KinematicLimits) -> Times {
    let run = PathRun::new(pieces, speeds, 0.0, limits).unwrap();
    let bound = time_bound(&run);
    let law = reference(&run, &bound, &EFFORT).unwrap();
    let best = best(&run).expect("a law from rest to rest");
    Times { bound: bound.time_s, reference: law.time_s, best }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4, failure_persistence: None, max_shrink_iters: 0, rng_seed: RngSeed::Fixed(2026), ..ProptestConfig::default() })]

    #[test]
    fn best_holds_every_limit_and_is_close_to_the_reference(steps in steps(), feed in 5.0..400.0f64) {
        let pieces = chain(&steps);
        let speeds = vec![feed; pieces.len()];
        let limits = limits(200.0, 2000.0, 1e5);
        let times = times(&pieces, &speeds, &limits);
        prop_assert!(times.bound <= times.reference);
        prop_assert!(times.best.time_s <= 1.03 * times.reference, "{} {}", times.best.time_s, times.reference);
        let phases = times.best.phases.clone();
        let trajectory = PlannedTrajectory { pieces: pieces.clone(), phases, overlap_s: 0.0 };
        let used = largest_use(&trajectory, &limits, 30);
        for share in [used.velocity, used.acceleration, used.jerk] {
            prop_assert!(share <= 1.0 + 1e-6, "{used:?}");
        }
        let end = times.best.phases.last().unwrap();
        let end = end.at(end.duration_s);
        let length: f64 = pieces.iter().map(|piece| piece.length).sum();
        prop_assert!((end.sigma - length).abs() <= 1e-12 * length);
        prop_assert!(end.speed.abs() <= 1e-9 * feed);
        for phase in &times.best.phases {
            prop_assert!(phase.speed >= -1e-12 * feed && phase.speed <= feed * (1.0 + 1e-6));
        }
    }

    #[test]
    fn a_run_backwards_takes_as_long(steps in steps()) {
        let pieces = chain(&steps);
        let back = reversed(&pieces);
        let speeds = vec![150.0; pieces.len()];
        let limits = limits(200.0, 2000.0, 1e5);
        let (there, back) = (times(&pieces, &speeds, &limits), times(&back, &speeds, &limits));
        prop_assert!((there.bound - back.bound).abs() <= 2e-4 * there.bound);
        prop_assert!((there.reference - back.reference).abs() <= 5e-3 * there.reference);
        prop_assert!((there.best.time_s - back.best.time_s).abs() <= 2e-2 * there.best.time_s);
    }

    #[test]
    fn units_do_not_matter(steps in steps()) {
        let pieces = chain(&steps);
        let inches = scaled(&pieces, 1.0 / 25.4);
        let speeds = vec![150.0; pieces.len()];
        let mm = times(&pieces, &speeds, &limits(200.0, 2000.0, 1e5));
        let speeds = vec![150.0 / 25.4; pieces.len()];
        let inch = times(&inches, &speeds, &limits(200.0 / 25.4, 2000.0 / 25.4, 1e5 / 25.4));
        prop_assert!((mm.bound - inch.bound).abs() <= 1e-9 * mm.bound);
        prop_assert!((mm.reference - inch.reference).abs() <= 1e-4 * mm.reference);
        prop_assert!((mm.best.time_s - inch.best.time_s).abs() <= 1e-2 * mm.best.time_s);
    }
}

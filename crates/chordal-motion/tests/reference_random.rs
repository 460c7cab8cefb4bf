//! The bound, the reference and the level best on random runs.

mod shapes;

use chordal_motion::{
    Best, Cursor, Effort, Limits, Phase, Piece, Run, Stretch, best, bound, reference,
};
use proptest::prelude::*;
use shapes::{chain, limits, reversed, scaled};

/// Turns from nothing to sharp, lengths over four decades.
fn steps() -> impl Strategy<Value = Vec<(f64, [f64; 4])>> {
    let turn = prop_oneof![Just(0.0), -0.05..0.05, -1.0..1.0];
    let turns = [turn.clone(), turn.clone(), turn.clone(), turn];
    prop::collection::vec(((-3.0..1.0f64).prop_map(|power| 10f64.powf(power)), turns), 1..8)
}

const EFFORT: Effort = Effort { step_s: 0.003, least_nodes: 100, most_nodes: 800, programs: 8 };

struct Times {
    bound: f64,
    reference: f64,
    best: Best,
}

fn times(pieces: &[Piece], speeds: &[f64], limits: &Limits) -> Times {
    let run = Run::new(pieces, speeds, 0.0, limits).unwrap();
    let bound = bound(&run);
    let law = reference(&run, &bound, &EFFORT).unwrap();
    let best = best(&run, &law).expect("a law from rest to rest");
    Times { bound: bound.time_s, reference: law.time_s, best }
}

/// Largest shares of velocity with feed, acceleration and jerk at `count` even times.
fn measured(
    pieces: &[Piece],
    speeds: &[f64],
    phases: &[Phase],
    limits: &Limits,
    count: usize,
) -> [f64; 3] {
    let stretch = Stretch { pieces: pieces.to_vec(), phases: phases.to_vec(), overlap_s: 0.0 };
    let total = stretch.duration_s();
    let mut cursor = Cursor::default();
    let mut most = [0.0f64; 3];
    for index in 0..=count {
        let state = cursor.at(&stretch, total * index as f64 / count as f64);
        for axis in 0..6 {
            let Some(limit) = limits.axis(axis) else { continue };
            most[0] = most[0].max(state.velocity[axis].abs() / limit.velocity);
            most[1] = most[1].max(state.acceleration[axis].abs() / limit.acceleration);
            most[2] = most[2].max(state.jerk[axis].abs() / limit.jerk);
        }
    }
    for phase in phases {
        let feed = speeds.iter().fold(0.0f64, |most, speed| most.max(*speed));
        most[0] = most[0].max(phase.speed / feed);
    }
    most
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, max_shrink_iters: 0, ..ProptestConfig::default() })]

    #[test]
    fn best_holds_every_limit_and_is_near_the_reference(steps in steps(), feed in 5.0..400.0f64) {
        let pieces = chain(&steps);
        let speeds = vec![feed; pieces.len()];
        let limits = limits(200.0, 2000.0, 1e5);
        let times = times(&pieces, &speeds, &limits);
        println!("bound {:.5} reference {:.5} best {:.5} {:.4}", times.bound, times.reference, times.best.time_s, times.best.time_s / times.reference);
        prop_assert!(times.bound <= times.reference);
        prop_assert!(times.best.time_s <= 1.03 * times.reference, "{} {}", times.best.time_s, times.reference);
        for share in measured(&pieces, &speeds, &times.best.phases, &limits, 20_000) {
            prop_assert!(share <= 1.0 + 1e-6, "{share}");
        }
        let end = times.best.phases.last().unwrap();
        let end = end.at(end.duration_s);
        let length: f64 = pieces.iter().map(|piece| piece.length).sum();
        prop_assert!((end.sigma - length).abs() <= 1e-12 * length);
        prop_assert!(end.speed.abs() <= 1e-9 * feed);
        for phase in &times.best.phases {
            prop_assert!(phase.speed >= -1e-12 * feed);
        }
    }

    #[test]
    fn a_run_backwards_takes_as_long(steps in steps()) {
        let pieces = chain(&steps);
        let back = reversed(&pieces);
        let speeds = vec![150.0; pieces.len()];
        let limits = limits(200.0, 2000.0, 1e5);
        let (there, back) = (times(&pieces, &speeds, &limits), times(&back, &speeds, &limits));
        println!("{:.6} {:.6}  {:.6} {:.6}  {:.6} {:.6}", there.bound, back.bound, there.reference, back.reference, there.best.time_s, back.best.time_s);
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
        println!("{:.6} {:.6}  {:.6} {:.6}  {:.6} {:.6}", mm.bound, inch.bound, mm.reference, inch.reference, mm.best.time_s, inch.best.time_s);
        prop_assert!((mm.bound - inch.bound).abs() <= 1e-9 * mm.bound);
        prop_assert!((mm.reference - inch.reference).abs() <= 1e-4 * mm.reference);
        prop_assert!((mm.best.time_s - inch.best.time_s).abs() <= 1e-2 * mm.best.time_s);
    }
}

#[test]
fn survey() {
    use proptest::strategy::ValueTree;
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    for _ in 0..16 {
        let steps = steps().new_tree(&mut runner).unwrap().current();
        let pieces = chain(&steps);
        let speeds = vec![120.0; pieces.len()];
        let limits = limits(200.0, 2000.0, 1e5);
        let times = times(&pieces, &speeds, &limits);
        println!(
            "bound {:.5} reference {:.5} best {:.5} {:.4} {:?}",
            times.bound,
            times.reference,
            times.best.time_s,
            times.best.time_s / times.reference,
            steps.iter().map(|s| s.0).collect::<Vec<_>>()
        );
    }
}

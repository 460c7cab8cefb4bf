//! Dense moves for which a law of time is not found everywhere: they have a sound plan all the same.
//!
//! About one window in 1,500 of these paths has none. `CHORDAL_ROUNDS=n` takes n paths, else the test ends with the
//! first that has such a window.

#![allow(clippy::disallowed_methods, reason = "a test reads how many rounds it is to run")]

mod support;

use chordal_motion::{
    Corner, Level, Limits, Move, Planner, PlannerOptions, Step, Stretch, Use, Work, largest_use,
};
use support::random::{Dice, Mix, random_limits, random_path};
use support::time_of;

/// What rounding may add to a limit.
const ABOVE: f64 = 1.0 + 1e-6;

fn rounds() -> Option<u64> {
    std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok())
}

fn plan(moves: &[Move], limits: Limits, joins: bool) -> (Vec<Stretch>, Work) {
    let options = PlannerOptions { joins, ..PlannerOptions::new(Level::Fast) };
    let mut planner = Planner::new(limits, options);
    let mut stretches = Vec::new();
    let mut take = |step: Step<'_>| {
        if let Step::Stretch(stretch) = step {
            stretches.push(stretch.clone());
        }
    };
    moves.iter().for_each(|motion| planner.push(motion, &mut take).expect("a good move"));
    planner.finish(&mut take);
    let work = planner.work();
    (stretches, work)
}

/// Every stretch begins where the last ended and goes from rest to rest, over all of its path.
fn check_chain(name: &str, moves: &[Move], stretches: &[Stretch]) {
    let mut at = moves[0].from();
    for stretch in stretches {
        let near = |a: &[f64; 6], b: &[f64; 6]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(near(&at, &stretch.from()), "{name}: {at:?} {:?}", stretch.from());
        at = stretch.to();
        let (first, last) = (stretch.phases[0], stretch.phases[stretch.phases.len() - 1]);
        let end = last.at(last.duration_s);
        let length = stretch.length();
        assert_eq!(first.speed, 0.0, "{name}");
        assert!(end.speed.abs() < 1e-6 && end.acceleration.abs() < 1e-3, "{name}: {end:?}");
        assert!((end.sigma - length).abs() < 1e-9 * length.max(1.0), "{name}: {end:?} of {length}");
    }
    let target = moves[moves.len() - 1].to();
    assert!(at.iter().zip(&target).all(|(a, b)| (a - b).abs() < 1e-9), "{name}: {at:?} {target:?}");
}

#[test]
fn moves_without_a_law_have_a_sound_plan() {
    let mix =
        Mix { moves: 120, curves: false, rotary: true, shortest: 1e-3, longest: 2.0, turn: 0.7 };
    let (mut windows, mut failed, mut paths) = (0, 0, 0);
    for seed in 0..rounds().unwrap_or(150) {
        let mut dice = Dice(seed * 7919 + 5);
        let limits = random_limits(&mut dice);
        let mut moves = random_path(&mut dice, &Mix { curves: seed % 3 == 0, ..mix });
        let linear_mm = dice.decades(1e-3, 0.3);
        for motion in &mut moves {
            // Speeds that differ from move to move take windows to their limits.
            motion.speed = dice.decades(5.0, 1000.0);
            motion.corner = Corner::Within { linear_mm, rotary_rad: 1e-3 };
        }
        let (stretches, work) = plan(&moves, limits, true);
        windows += work.windows;
        failed += work.failed;
        if work.failed == 0 {
            continue;
        }
        paths += 1;
        let name = format!("seed {seed}");
        let used =
            stretches.iter().map(|s| largest_use(s, &limits, 5)).fold(Use::default(), Use::or);
        let most = used.velocity.max(used.acceleration).max(used.jerk);
        assert!(most <= ABOVE, "{name}: {used:?}");
        check_chain(&name, &moves, &stretches);
        // Corners by themselves are the last resort.
        let by_corners = time_of(&plan(&moves, limits, false).0);
        let ours = time_of(&stretches);
        assert!(ours <= by_corners * (1.0 + 1e-9), "{name}: {ours} s, by corners {by_corners} s");
        if rounds().is_none() {
            break;
        }
    }
    println!("{failed} of {windows} windows without a law, on {paths} paths");
    assert!(failed > 0, "no window without a law in {windows}: the test shows nothing");
}

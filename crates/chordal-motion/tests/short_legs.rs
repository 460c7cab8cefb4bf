//! Easing a joint is never slower than stopping there, whatever the lengths of its legs.

mod support;

use chordal_motion::{CornerMode, MoveRequest, PlannerLevel};
use support::random::{Dice, Mix, random_limits, random_path};
use support::{plan, time_of};

/// A longer run: `CHORDAL_ROUNDS=20000 cargo test --release -p chordal-motion --test short_legs`.
fn rounds() -> u64 {
    option_env!("CHORDAL_ROUNDS").and_then(|rounds| rounds.parse().ok()).unwrap_or(1000)
}

fn all_with(moves: &[MoveRequest], corner: CornerMode) -> Vec<MoveRequest> {
    moves.iter().map(|motion| MoveRequest { corner, ..*motion }).collect()
}

fn random_case(
    seed: u64,
    curves: bool,
) -> (chordal_motion::KinematicLimits, Vec<MoveRequest>, f64) {
    let mut dice = Dice(seed * 7919 + 13);
    let limits = random_limits(&mut dice);
    let mix = Mix {
        moves: 2 + dice.below(if seed.is_multiple_of(4) { 30 } else { 3 }) as usize,
        curves,
        rotary: seed % 5 == 4,
        shortest: 0.01,
        longest: 10f64.powf(dice.even(-1.5, 2.0)),
        turn: if seed.is_multiple_of(3) { 4.0 } else { dice.decades(0.01, 3.0) },
    };
    let moves = random_path(&mut dice, &mix);
    let tolerance = dice.decades(1e-4, 1.0);
    (limits, moves, tolerance)
}

#[test]
fn easing_is_not_slower_than_stopping() {
    for seed in 0..rounds() {
        for curves in [false, true] {
            let (limits, moves, linear_mm) = random_case(seed, curves);
            let time =
                |corner| time_of(&plan(&all_with(&moves, corner), limits, PlannerLevel::Fast));
            let eased = time(CornerMode::Joined { linear_mm, rotary_rad: linear_mm / 100.0 });
            let stops = time(CornerMode::Stop);
            assert!(
                eased <= stops * (1.0 + 1e-9),
                "seed {seed}, curves {curves}: {eased} s, stopping {stops} s"
            );
        }
    }
}

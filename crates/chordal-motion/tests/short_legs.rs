//! Easing a joint is never slower than stopping there, whatever the lengths of its legs.

mod support;

use chordal_motion::{Corner, Level, Move};
use support::{Dice, Mix, plan, random_limits, random_path, time_of};

/// Rounds of the survey. `CHORDAL_ROUNDS=100000 cargo test --release -p chordal-motion --test
/// short_legs` is a longer one.
fn rounds() -> u64 {
    option_env!("CHORDAL_ROUNDS").and_then(|rounds| rounds.parse().ok()).unwrap_or(400)
}

fn all_with(moves: &[Move], corner: Corner) -> Vec<Move> {
    moves.iter().map(|motion| Move { corner, ..*motion }).collect()
}

fn random_case(seed: u64, curves: bool) -> (chordal_motion::Limits, Vec<Move>, f64) {
    let mut dice = Dice(seed * 7919 + 13);
    let limits = random_limits(&mut dice);
    let mix = Mix {
        moves: 2 + dice.below(if seed % 4 == 0 { 30 } else { 3 }) as usize,
        curves,
        rotary: seed % 5 == 4,
        shortest: 0.01,
        longest: 10f64.powf(dice.even(-1.5, 2.0)),
        turn: if seed % 3 == 0 { 4.0 } else { dice.decades(0.01, 3.0) },
    };
    let moves = random_path(&mut dice, &mix);
    let tolerance = dice.decades(1e-4, 1.0);
    (limits, moves, tolerance)
}

#[test]
fn survey() {
    for curves in [false, true] {
        let mut worst: Vec<(f64, u64)> = Vec::new();
        let mut wider: Vec<(f64, u64)> = Vec::new();
        for seed in 0..rounds() {
            let (limits, moves, linear_mm) = random_case(seed, curves);
            let time = |corner| time_of(&plan(&all_with(&moves, corner), limits, Level::Fast));
            let within =
                |linear_mm| time(Corner::Within { linear_mm, rotary_rad: linear_mm / 100.0 });
            let (stops, eased) = (time(Corner::Stop), within(linear_mm));
            worst.push((eased / stops, seed));
            wider.push((within(2.0 * linear_mm) / eased, seed));
        }
        for (name, list) in [("stops", &mut worst), ("wider", &mut wider)] {
            list.sort_by(|a, b| b.0.total_cmp(&a.0));
            let above = list.iter().filter(|(ratio, _)| *ratio > 1.0 + 1e-9).count();
            println!("curves {curves} {name}: {above} of {} above; {:?}", list.len(), &list[..6]);
        }
    }
}

#[test]
fn look() {
    let Ok(seed) = std::env::var("SEED") else { return };
    let curves = std::env::var("CURVES").is_ok();
    let (limits, moves, linear_mm) = random_case(seed.parse().unwrap(), curves);
    println!(
        "tolerance {linear_mm} v {:?}\na {:?}\nj {:?}",
        limits.velocity(),
        limits.acceleration(),
        limits.jerk()
    );
    for motion in &moves {
        use chordal_geometry::ParamCurve;
        println!(
            "len {:.4} rot {:?} speed {:.2} head {:?} tail {:?}",
            motion.curve.length(),
            motion.rotary_to,
            motion.speed,
            motion.curve.tangent_at(0.0),
            motion.curve.tangent_at(motion.curve.length())
        );
    }
    for corner in [
        Corner::Stop,
        Corner::Within { linear_mm, rotary_rad: linear_mm / 100.0 },
        Corner::Within { linear_mm: 2.0 * linear_mm, rotary_rad: linear_mm / 50.0 },
    ] {
        let stretches = plan(&all_with(&moves, corner), limits, Level::Fast);
        println!("{corner:?} {}", time_of(&stretches));
        for s in &stretches {
            println!(
                "  stretch {:.4} s overlap {:.4} pieces {:?}",
                s.duration_s(),
                s.overlap_s,
                s.pieces
                    .iter()
                    .map(|p| (p.tag, (p.length * 1e4).round() / 1e4))
                    .collect::<Vec<_>>()
            );
            println!(
                "   phases {:?}",
                s.phases
                    .iter()
                    .map(|p| format!(
                        "{:.4}@{:.3} v{:.3} a{:.0} j{:.0}",
                        p.duration_s, p.from, p.speed, p.acceleration, p.jerk
                    ))
                    .collect::<Vec<_>>()
            );
        }
    }
}

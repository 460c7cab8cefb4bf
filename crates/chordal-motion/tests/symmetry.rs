//! What must not change a time: cuts, direction, units.

mod support;

use chordal_geometry::{Curve, Line, ParamCurve, Transform};
use chordal_motion::{
    AxisLimit, CornerMode, KinematicLimits, MotionPlanner, MoveRequest, PlannerLevel,
    PlannerOptions, PlannerStep,
};
use support::random::{Dice, Mix, random_limits, random_path};
use support::{limits, line, plan, time_of};

const MIX: Mix =
    Mix { moves: 80, curves: false, rotary: false, shortest: 0.05, longest: 40.0, turn: 0.6 };

fn same(name: &str, seed: u64, a: f64, b: f64) {
    near(name, seed, a, b, 1e-9);
}

/// Profiles of smooth curves are within 2e-4 of the best on grids that begin at their start.
const LAW: f64 = 1e-3;

fn near(name: &str, seed: u64, a: f64, b: f64, most: f64) {
    assert!(
        (a - b).abs() <= most * a,
        "{name}, seed {seed}: {a} s and {b} s, {:e} apart",
        (a - b) / a
    );
}

fn one_mode(dice: &mut Dice, moves: &mut [MoveRequest]) {
    let mode = match dice.below(3) {
        0 => CornerMode::Exact,
        1 => CornerMode::Stop,
        _ => CornerMode::Joined { linear_mm: dice.decades(1e-3, 0.1), rotary_rad: 1e-3 },
    };
    moves.iter_mut().for_each(|motion| motion.corner = mode);
}

/// Each line in `parts` equal parts, none shorter than 0.02 mm.
fn cut(moves: &[MoveRequest], dice: &mut Dice) -> Vec<MoveRequest> {
    let mut all = Vec::new();
    for motion in moves {
        let Curve::Line(line) = motion.curve else {
            all.push(*motion);
            continue;
        };
        let most = (line.length() / 0.02).floor().clamp(1.0, 40.0) as u64;
        let parts = 1 + dice.below(most);
        let mut from = *motion;
        for part in 1..=parts {
            let share = part as f64 / parts as f64;
            let end =
                if part == parts { line.end } else { line.start + (line.end - line.start) * share };
            let start = from.curve.start();
            let turn: [f64; 3] = std::array::from_fn(|i| {
                let (a, b) = (motion.rotary_from[i], motion.rotary_to[i]);
                if part == parts { b } else { a + (b - a) * share }
            });
            let corner = if part == parts { motion.corner } else { CornerMode::Exact };
            let piece =
                MoveRequest { curve: Line { start, end }.into(), rotary_to: turn, corner, ..from };
            all.push(piece);
            from.curve = Line { start: end, end }.into();
            from.rotary_from = turn;
        }
    }
    all
}

#[test]
fn cutting_lines_changes_no_time() {
    for seed in 0..20 {
        let mut dice = Dice(seed);
        let limits = random_limits(&mut dice);
        let mut moves = random_path(&mut dice, &Mix { rotary: seed % 2 == 1, ..MIX });
        one_mode(&mut dice, &mut moves);
        let whole = time_of(&plan(&moves, limits, PlannerLevel::Fast));
        let pieces = cut(&moves, &mut dice);
        assert!(pieces.len() > 3 * moves.len());
        same("cut", seed, whole, time_of(&plan(&pieces, limits, PlannerLevel::Fast)));
    }
}

#[test]
fn the_published_line_takes_its_time_however_it_is_cut() {
    let limits = limits(500.0, 5000.0, 1e5);
    for parts in [1, 10, 100, 1000, 5000, 100_000] {
        let at = |i: i32| [100.0 * f64::from(i) / f64::from(parts), 0.0, 0.0];
        let part = |i| support::cut(line(at(i), at(i + 1)), 1e9, CornerMode::Exact);
        let moves: Vec<MoveRequest> = (0..parts).map(part).collect();
        let time = time_of(&plan(&moves, limits, PlannerLevel::Fast));
        assert!((time - 0.35).abs() < 1e-9, "{parts} parts: {time} s");
    }
}

#[test]
fn backwards_takes_as_long() {
    for seed in 0..20 {
        let mut dice = Dice(seed + 500);
        let limits = random_limits(&mut dice);
        let mut moves = random_path(&mut dice, &Mix { curves: seed % 2 == 1, ..MIX });
        one_mode(&mut dice, &mut moves);
        let back: Vec<MoveRequest> = moves
            .iter()
            .rev()
            .map(|motion| MoveRequest {
                curve: motion.curve.reversed(),
                rotary_from: motion.rotary_to,
                rotary_to: motion.rotary_from,
                ..*motion
            })
            .collect();
        near(
            "backwards",
            seed,
            time_of(&plan(&moves, limits, PlannerLevel::Fast)),
            time_of(&plan(&back, limits, PlannerLevel::Fast)),
            LAW,
        );
    }
}

#[test]
fn units_change_no_time() {
    for seed in 0..20 {
        let mut dice = Dice(seed + 900);
        let limits = random_limits(&mut dice);
        let mut moves = random_path(&mut dice, &Mix { curves: seed % 2 == 1, ..MIX });
        one_mode(&mut dice, &mut moves);
        moves.iter_mut().for_each(|motion| {
            if motion.corner == CornerMode::Exact {
                motion.corner = CornerMode::Joined { linear_mm: 1e-3, rotary_rad: 1e-3 };
            }
        });
        let scale = 1.0 / 25.4;
        let transform = Transform::scale(scale).unwrap();
        let scaled: Vec<MoveRequest> = moves
            .iter()
            .map(|motion| MoveRequest {
                curve: motion.curve.transformed(&transform),
                speed: motion.speed * scale,
                corner: match motion.corner {
                    CornerMode::Joined { linear_mm, rotary_rad } => {
                        CornerMode::Joined { linear_mm: linear_mm * scale, rotary_rad }
                    }
                    other => other,
                },
                ..*motion
            })
            .collect();
        let axes = std::array::from_fn(|axis| {
            limits.axis(axis).map(|limit| AxisLimit {
                velocity: limit.velocity * scale,
                acceleration: limit.acceleration * scale,
                jerk: limit.jerk * scale,
            })
        });
        let small = KinematicLimits::new(axes).unwrap();
        near(
            "units",
            seed,
            time_of(&plan(&moves, limits, PlannerLevel::Fast)),
            time_of(&plan(&scaled, small, PlannerLevel::Fast)),
            LAW,
        );
    }
}

#[test]
fn rows_of_any_length_give_one_time() {
    for seed in 0..12 {
        let mut dice = Dice(seed + 1300);
        let limits = random_limits(&mut dice);
        let mut moves = random_path(&mut dice, &Mix { turn: 0.1, ..MIX });
        one_mode(&mut dice, &mut moves);
        let whole = time_of(&plan(&moves, limits, PlannerLevel::Fast));
        let mut first = None;
        for look_ahead_s in [0.01, 0.3, 1e9] {
            let mut planner = MotionPlanner::new(
                limits,
                PlannerOptions {
                    look_ahead_s,
                    joins: false,
                    ..PlannerOptions::new(PlannerLevel::Fast)
                },
            );
            let mut time = 0.0;
            let mut take = |step: PlannerStep<'_>| {
                if let PlannerStep::Trajectory(trajectory) = step {
                    time += trajectory.duration_s() - trajectory.overlap_s;
                }
            };
            moves.iter().for_each(|motion| planner.push(motion, &mut take).unwrap());
            planner.finish(&mut take);
            same("rows", seed, *first.get_or_insert(time), time);
            assert!(whole <= time * (1.0 + 1e-9), "seed {seed}: {whole} s whole, {time} s in rows");
        }
    }
}

#[test]
fn a_short_corner_is_no_slower_with_more_room() {
    let limits = limits(200.0, 2000.0, 1e5);
    // Two legs of 1 mm that turn by 30 degrees.
    let corner = [1.0, 0.0, 0.0];
    let end = [1.0 + 0.75_f64.sqrt(), 0.5, 0.0];
    let time = |mode: CornerMode| {
        let leg = |from, to| support::cut(line(from, to), 50.0, mode);
        let moves = [leg([0.0; 3], corner), leg(corner, end)];
        time_of(&plan(&moves, limits, PlannerLevel::Fast))
    };
    let within = |linear_mm: f64| time(CornerMode::Joined { linear_mm, rotary_rad: 1e-3 });
    let times = [time(CornerMode::Stop), within(0.01), within(0.1)];
    assert!(times.windows(2).all(|pair| pair[1] < pair[0]), "{times:?}");
}

#[test]
fn times_without_a_path_are_those_with_one() {
    for seed in 0..16 {
        let mut dice = Dice(seed + 2100);
        let limits = random_limits(&mut dice);
        let mix = Mix { curves: seed % 2 == 1, rotary: seed % 3 == 2, turn: 1.0, ..MIX };
        let moves = random_path(&mut dice, &mix);
        let mut planner = MotionPlanner::of_times(limits);
        let mut time = 0.0;
        let mut take = |step: PlannerStep<'_, _>| {
            if let PlannerStep::Trajectory(trajectory) = step {
                time += trajectory.duration_s() - trajectory.overlap_s;
            }
        };
        moves.iter().for_each(|motion| planner.push(motion, &mut take).unwrap());
        planner.finish(&mut take);
        same("without a path", seed, time_of(&plan(&moves, limits, PlannerLevel::Fast)), time);
    }
}

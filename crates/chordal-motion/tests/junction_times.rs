//! Times of the firmware's own planner, profiles by hand, and what holds for any path.

use std::f64::consts::{PI, TAU};

use chordal_geometry::{Arc, Curve, Line, Plane, Vec3};

use chordal_motion::{
    AxisLimit, AxisValues, CornerMode, JunctionRule, KinematicLimits, MotionPlanner, MoveKind,
    MoveRequest, PlannedTrajectory, PlannerLevel, PlannerOptions, PlannerStep,
};

const LOOK_AHEAD: usize = 15;

fn rule(deviation_mm: f64, blocks: usize) -> JunctionRule {
    JunctionRule {
        deviation_mm,
        blocks,
        arc_tolerance_mm: 0.002,
        arc_segments: None,
        speed_steps_mm_s: None,
        steps_per_mm: [0.0; 3],
        limited_jerk: false,
    }
}

/// All axes alike: mm/min and mm/s².
fn limits(velocity: f64, acceleration: f64) -> KinematicLimits {
    let axis = Some(AxisLimit { velocity: velocity / 60.0, acceleration, jerk: 1e9 });
    KinematicLimits::new([axis, axis, axis, None, None, None]).expect("positive limits")
}

fn cut(curve: Curve, feed: f64) -> MoveRequest {
    let corner = CornerMode::Joined { linear_mm: 0.01, rotary_rad: 0.0 };
    let (rotary_from, rotary_to) = ([0.0; 3], [0.0; 3]);
    let speed = feed / 60.0;
    MoveRequest {
        curve,
        rotary_from,
        rotary_to,
        path_length: None,
        speed,
        corner,
        kind: MoveKind::Cut,
        tag: 1,
    }
}

/// Lines from place to place, mm, at a feed, mm/min.
fn lines(places: &[[f64; 2]], feed: f64) -> Vec<MoveRequest> {
    let at = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
    let each = places
        .windows(2)
        .map(|pair| cut(Curve::Line(Line { start: at(pair[0]), end: at(pair[1]) }), feed));
    each.collect()
}

/// Equal lines along X.
fn row(count: usize, length: f64, feed: f64) -> Vec<MoveRequest> {
    let places: Vec<[f64; 2]> = (0..=count).map(|k| [k as f64 * length, 0.0]).collect();
    lines(&places, feed)
}

fn circle(radius: f64, angle: f64) -> Vec<MoveRequest> {
    vec![cut(Arc::new(Plane::Xy.frame(), radius, angle, 0.0).into(), 3000.0)]
}

/// The trajectories from rest to rest.
fn planned(
    moves: &[MoveRequest],
    limits: KinematicLimits,
    rule: JunctionRule,
) -> Vec<PlannedTrajectory> {
    let options =
        PlannerOptions { junctions: Some(rule), ..PlannerOptions::new(PlannerLevel::Fast) };
    let mut planner = MotionPlanner::new(limits, options);
    let mut trajectories = Vec::new();
    let mut take = |step: PlannerStep<'_>| {
        if let PlannerStep::Trajectory(trajectory) = step {
            trajectories.push(trajectory.clone());
        }
    };
    for motion in moves {
        planner.push(motion, &mut take).expect("a move");
    }
    planner.finish(&mut take);
    trajectories
}

fn time_s(moves: &[MoveRequest], limits: KinematicLimits, rule: JunctionRule) -> f64 {
    planned(moves, limits, rule).iter().map(PlannedTrajectory::duration_s).sum()
}

#[track_caller]
fn takes(moves: &[MoveRequest], limits: KinematicLimits, rule: JunctionRule, expected_s: f64) {
    let planned_s = time_s(moves, limits, rule);
    let off = (planned_s / expected_s - 1.0).abs();
    assert!(off < 1e-3, "{planned_s} s for {expected_s} s: {off:.1e}");
}

/// Times that GRBL's own planner gave, on steps of 1/40 mm.
#[test]
fn times_are_those_of_the_firmware() {
    let router = limits(5000.0, 400.0);
    let steps_per_mm = [40.0; 3];
    let own = JunctionRule { steps_per_mm, ..rule(0.02, LOOK_AHEAD) };
    let far = JunctionRule { blocks: 100, ..own };
    takes(&row(1, 100.0, 3000.0), router, own, 2.125);
    takes(&lines(&[[0.0, 0.0], [300.0, 100.0]], f64::INFINITY), router, own, 3.8083);
    let square = [[0.0, 0.0], [50.0, 0.0], [50.0, 50.0], [0.0, 50.0], [0.0, 0.0]];
    takes(&lines(&square, 3000.0), router, own, 4.4257);
    takes(&circle(20.0, TAU), router, own, 2.6386);
    takes(&circle(20.0, TAU), router, far, 2.6386);
    takes(&circle(2.0, TAU), router, own, 0.3815);
    takes(&circle(2.0, TAU), router, far, 0.3789);
    takes(&row(100, 1.0, 3000.0), router, own, 2.125);
    takes(&row(1000, 0.1, 3000.0), router, own, 3.0463);
    takes(&row(1000, 0.1, 1000.0), router, own, 6.0417);
    takes(&row(1000, 0.1, 3000.0), router, far, 2.125);
    // The standard build.
    let small = limits(500.0, 10.0);
    let own = JunctionRule { steps_per_mm: [250.0; 3], ..rule(0.01, LOOK_AHEAD) };
    takes(&row(1, 100.0, 3000.0), small, own, 12.8333);
    takes(&lines(&square, 3000.0), small, own, 26.995);
    takes(&circle(20.0, TAU), small, own, 14.4318);
}

/// Two lines of 20 mm with a corner: entry and exit by hand.
#[test]
fn a_corner_is_passed_at_the_speed_of_its_detour() {
    let router = limits(60_000.0, 400.0);
    for degrees in [1.0_f64, 30.0, 90.0, 150.0, 179.0] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let bend = [[0.0, 0.0], [20.0, 0.0], [20.0 + 20.0 * cosine, 20.0 * sine]];
        let half = (degrees.to_radians() / 2.0).cos();
        // The axes along the turn: the one that changes more has all of its acceleration.
        let turn = [cosine - 1.0, sine];
        let size = turn[0].hypot(turn[1]);
        let most = (size / turn[0].abs()).min(size / turn[1].abs());
        let junction = (400.0 * most * 0.02 * half / (1.0 - half)).sqrt();
        // On one line speed would reach that of half the way, and on the second its own acceleration counts.
        let second = 400.0 * (1.0 / cosine.abs()).min(1.0 / sine.abs());
        let at_corner =
            junction.min((2.0 * 400.0 * 20.0_f64).sqrt()).min(second.sqrt() * 40.0_f64.sqrt());
        let leg = |acceleration: f64| {
            let top = (at_corner * at_corner / 2.0 + acceleration * 20.0).sqrt();
            (top + (top - at_corner)) / acceleration
        };
        let expected = leg(400.0) + leg(second);
        let planned_s = time_s(&lines(&bend, f64::INFINITY), router, rule(0.02, LOOK_AHEAD));
        assert!((planned_s - expected).abs() < 1e-9, "{degrees}: {planned_s} for {expected}");
    }
}

/// No axis is faster or accelerated more than it can; speeds meet at every phase, and the way is whole.
#[test]
fn limits_hold_and_speeds_meet() {
    let axes = [(3000.0, 200.0), (5000.0, 400.0), (600.0, 50.0)]
        .map(|(v, acceleration)| Some(AxisLimit { velocity: v / 60.0, acceleration, jerk: 1e9 }));
    let limits =
        KinematicLimits::new([axes[0], axes[1], axes[2], None, None, None]).expect("limits");
    let mut seed = 1_u64;
    let mut random = || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    for round in 0..100 {
        let mut at = Vec3::new(0.0, 0.0, 0.0);
        let mut moves = Vec::new();
        for _ in 0..60 {
            let size = 10f64.powf(-2.0 + 3.0 * random());
            let mut away = || size * (random() - 0.5);
            let end = Vec3::new(at.x + away(), at.y + away(), at.z + away());
            let feed = [300.0, 2000.0, f64::INFINITY][(random() * 3.0) as usize];
            moves.push(cut(Curve::Line(Line { start: at, end }), feed));
            at = end;
        }
        let own = rule(0.01, [1, 15, 100][round % 3]);
        for trajectory in planned(&moves, limits, own) {
            let (mut speed, mut from, mut piece, mut begin) = (0.0, 0.0, 0, 0.0);
            for phase in &trajectory.phases {
                assert!((phase.speed - speed).abs() < 1e-9 && (phase.from - from).abs() < 1e-9);
                let end = phase.at(phase.duration_s);
                (speed, from) = (end.speed, end.sigma);
                let middle = phase.at(phase.duration_s / 2.0).sigma;
                while begin + trajectory.pieces[piece].length < middle {
                    begin += trajectory.pieces[piece].length;
                    piece += 1;
                }
                for (axis, limit) in axes.iter().enumerate() {
                    let share = trajectory.pieces[piece].start[1][axis].abs();
                    let limit = limit.expect("an axis");
                    assert!(share * phase.speed.max(speed) <= limit.velocity * (1.0 + 1e-12));
                    let used = share * phase.acceleration.abs();
                    assert!(used <= limit.acceleration * (1.0 + 1e-12), "{used}");
                }
            }
            assert!(speed.abs() < 1e-9);
            let length: f64 = trajectory.pieces.iter().map(|piece| piece.length).sum();
            assert!((from - length).abs() < 1e-9 * length.max(1.0), "{from} of {length}");
        }
    }
}

#[test]
fn a_line_cut_in_two_takes_as_long() {
    let router = limits(5000.0, 400.0);
    let whole = time_s(&row(4, 25.0, 3000.0), router, rule(0.02, 100));
    let halves = time_s(&row(8, 12.5, 3000.0), router, rule(0.02, 100));
    assert!((whole - halves).abs() < 1e-9, "{whole} and {halves}");
}

#[test]
fn without_deviation_every_segment_ends_at_rest() {
    let router = limits(5000.0, 400.0);
    let square = [[0.0, 0.0], [50.0, 0.0], [50.0, 50.0]];
    let one = time_s(&row(1, 50.0, 3000.0), router, rule(0.0, LOOK_AHEAD));
    let two = time_s(&lines(&square, 3000.0), router, rule(0.0, LOOK_AHEAD));
    assert!((two - 2.0 * one).abs() < 1e-9);
}

/// Straight lines between places, mm, each at its feed, mm/s.
fn path(places: &[[f64; 3]], feeds: &[f64]) -> Vec<MoveRequest> {
    let at = |[x, y, z]: [f64; 3]| Vec3::new(x, y, z);
    let line = |pair: &[[f64; 3]]| Curve::Line(Line { start: at(pair[0]), end: at(pair[1]) });
    places.windows(2).zip(feeds).map(|(pair, feed)| cut(line(pair), 60.0 * feed)).collect()
}

/// Two legs with a corner of so many degrees.
fn bend(degrees: f64, leg: f64) -> Vec<MoveRequest> {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let corner = [leg, 0.0, 0.0];
    path(&[[0.0; 3], corner, [leg + leg * cosine, leg * sine, 0.0]], &[50.0, 50.0])
}

/// Equal lines at 200 mm/s.
fn steps(count: usize, length: f64) -> Vec<MoveRequest> {
    let places: Vec<[f64; 3]> = (0..=count).map(|k| [k as f64 * length, 0.0, 0.0]).collect();
    path(&places, &vec![200.0; count])
}

/// Worked by hand with 200 mm/s, 100 mm/s² and a deviation of 0.02 mm where nothing else is said.
#[test]
fn profiles_by_hand() {
    let alike = limits(12_000.0, 100.0);
    let usual = rule(0.02, LOOK_AHEAD);
    let blocks = |blocks| rule(0.02, blocks);
    let axis = |velocity, acceleration| Some(AxisLimit { velocity, acceleration, jerk: 1e9 });
    let slow_z = [axis(200.0, 100.0), axis(200.0, 100.0), axis(10.0, 20.0), None, None, None];
    let slow_z = KinematicLimits::new(slow_z).expect("limits");
    let [x100, x50, there] = [[100.0, 0.0, 0.0], [50.0, 0.0, 0.0], [30.0, 40.0, 0.0]];
    let zero = [0.0; 3];
    let quarter = || vec![cut(Arc::new(Plane::Xy.frame(), 10.0, PI / 2.0, 0.0).into(), 3000.0)];
    let chords = JunctionRule { arc_tolerance_mm: 0.5, ..usual };
    let on_steps = JunctionRule { steps_per_mm: [40.0; 3], ..usual };
    let programs: Vec<(&str, Vec<MoveRequest>, KinematicLimits, JunctionRule, f64)> = vec![
        // 0.5 s and 12.5 mm for each ramp, 75 mm at 50 mm/s.
        ("one line", path(&[zero, x100], &[50.0]), alike, usual, 2.5),
        // It never reaches its feed: 30 mm/s in the middle.
        ("a short line", path(&[zero, [9.0, 0.0, 0.0]], &[50.0]), alike, usual, 0.6),
        ("straight on", path(&[zero, x50, x100], &[50.0; 2]), alike, usual, 2.5),
        ("back", path(&[zero, x100, zero], &[50.0; 2]), alike, usual, 5.0),
        // The second line is 1/cos faster off the mark; the corner is passed at 50 mm/s.
        ("1 degree", bend(1.0, 100.0), alike, usual, 4.499_961_924),
        // v² = 103.528 · 0.02 · 28.3477: 7.6613 mm/s.
        ("30 degrees", bend(30.0, 100.0), alike, usual, 4.801_003_669),
        // v² = 115.470 · 0.02 · 6.4641: 3.8637 mm/s.
        ("60 degrees", bend(60.0, 100.0), alike, usual, 4.863_700_657),
        // v² = 141.421 · 0.02 · 2.4142: 2.6131 mm/s.
        ("90 degrees", bend(90.0, 100.0), alike, usual, 4.949_103_167),
        // v² = 115.470 · 0.02 · 1.0000: 1.5197 mm/s.
        ("120 degrees", bend(120.0, 100.0), alike, usual, 4.905_086_188),
        // 0.8503 mm/s.
        ("150 degrees", bend(150.0, 100.0), alike, usual, 4.917_280_555),
        // 0.1327 mm/s: nearly a stop.
        ("179 degrees", bend(179.0, 100.0), alike, usual, 4.997_273_714),
        // Each leg has its peak at 30.0569 mm/s.
        ("90 degrees, short legs", bend(90.0, 9.0), alike, usual, 1.150_011_469),
        ("a stop at the corner", bend(90.0, 9.0), alike, rule(0.0, LOOK_AHEAD), 1.2),
        // 0.5 + 0.54 + 0.3 s, then 2.4 + 0.2 s.
        ("a slower second feed", path(&[zero, x50, x100], &[50.0, 20.0]), alike, usual, 3.94),
        // Ten times 1 mm: each alone, with the next one known, with two, and with all.
        ("nothing known ahead", steps(10, 1.0), alike, blocks(1), 2.0),
        // 14.142 mm/s between them, 17.321 in the middle of each.
        ("one segment ahead", steps(10, 1.0), alike, blocks(2), 0.791_382_305),
        ("two segments ahead", steps(10, 1.0), alike, blocks(3), 0.683_281_573),
        ("all segments ahead", steps(10, 1.0), alike, blocks(100), 0.632_455_532),
        // 250 mm/s and 125 mm/s² along 3-4-5.
        ("a slanted rapid", path(&[zero, there], &[f64::INFINITY]), alike, usual, 1.264_911_064),
        // Z allows 12.5 mm/s and 25 mm/s² along the line.
        ("a slow axis", path(&[zero, [30.0, 0.0, 40.0]], &[f64::INFINITY]), slow_z, usual, 4.5),
        // Two chords of 7.654 mm, 45 degrees apart.
        ("a quarter circle, coarse", quarter(), alike, chords, 0.966_360_124),
        // Shorter than half a step.
        ("less than a step", path(&[zero, [0.012, 0.0, 0.0]], &[50.0]), alike, on_steps, 0.0),
    ];
    assert!(programs.len() >= 20);
    for (name, moves, limits, rule, expected) in programs {
        let planned_s = time_s(&moves, limits, rule);
        assert!((planned_s - expected).abs() < 1e-8, "{name}: {planned_s} s for {expected} s");
    }
}

/// 100 mm/s² and 1000 mm/s³: 0.1 s until the acceleration is there.
#[test]
fn limited_jerk_is_an_even_acceleration_that_takes_as_long() {
    let axis = Some(AxisLimit { velocity: 200.0, acceleration: 100.0, jerk: 1000.0 });
    let limits = KinematicLimits::new([axis, axis, axis, None, None, None]).expect("limits");
    let own = JunctionRule { limited_jerk: true, ..rule(0.02, LOOK_AHEAD) };
    let line = |feed| path(&[[0.0; 3], [100.0, 0.0, 0.0]], &[feed]);
    // Each ramp to 50 mm/s takes 0.6 s and 15 mm.
    assert!((time_s(&line(50.0), limits, own) - 2.6).abs() < 1e-9);
    // To 8 mm/s: 2 √(8/1000) s.
    assert!((time_s(&line(8.0), limits, own) - (12.5 + 0.032_f64.sqrt())).abs() < 1e-9);
}

/// A path of random lines, for what holds for every path.
fn random_path(random: &mut impl FnMut() -> f64, count: usize) -> Vec<MoveRequest> {
    let mut places = vec![[0.0; 3]];
    let mut feeds = Vec::new();
    for k in 0..count {
        let size = 10f64.powf(-1.0 + 2.5 * random());
        let from = places[k];
        places.push(std::array::from_fn(|axis| from[axis] + size * (random() - 0.5)));
        feeds.push([5.0, 35.0, f64::INFINITY][(random() * 3.0) as usize]);
    }
    path(&places, &feeds)
}

/// Each line in two, anywhere.
fn cut_in_two(moves: &[MoveRequest], random: &mut impl FnMut() -> f64) -> Vec<MoveRequest> {
    let mut halves = Vec::new();
    for motion in moves {
        let [from, to] = [motion.from(), motion.to()];
        let share = 0.1 + 0.8 * random();
        let middle: AxisValues =
            std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis]));
        let at = |place: &AxisValues| [place[0], place[1], place[2]];
        halves.extend(path(&[at(&from), at(&middle), at(&to)], &[motion.speed; 2]));
    }
    halves
}

#[test]
fn cut_anywhere_a_path_takes_as_long_and_a_longer_look_ahead_never_longer() {
    let mut seed = 7_u64;
    let mut random = || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let router = limits(5000.0, 400.0);
    for _ in 0..100 {
        let moves = random_path(&mut random, 30);
        let halves = cut_in_two(&moves, &mut random);
        let whole = time_s(&moves, router, rule(0.02, 1000));
        let cut = time_s(&halves, router, rule(0.02, 1000));
        assert!((whole - cut).abs() < 1e-9 * whole.max(1.0), "{whole} and {cut}");
        let mut last = f64::INFINITY;
        for blocks in [1, 2, 4, 15, 100] {
            let time = time_s(&moves, router, rule(0.02, blocks));
            assert!(time <= last + 1e-9, "{blocks} blocks: {time} after {last}");
            last = time;
        }
        let wider = time_s(&moves, router, rule(0.05, 1000));
        assert!(wider <= whole + 1e-9, "{wider} with more deviation, {whole} with less");
    }
}

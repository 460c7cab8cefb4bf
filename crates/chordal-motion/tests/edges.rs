//! Moves at the edge of sense: a clear error, or a plan that holds every limit and ends exactly
//! where the program does.

mod support;

use chordal_geometry::{AXES, Arc, Curve, Frame, ParamCurve, Spiral, Vec3};
use chordal_motion::{
    AxisLimit, CornerMode, KinematicLimits, LimitUse, LimitedQuantity, MotionPlanner, MoveError,
    MoveRequest, PlannedTrajectory, PlannerLevel, PlannerOptions, PlannerStep, largest_use,
};
use support::random::Dice;
use support::{cut, distance, plan, samples, time_of};

/// What rounding may add to a limit.
const ABOVE: f64 = 1.0 + 1e-6;

const WITHIN: CornerMode = CornerMode::Joined { linear_mm: 0.01, rotary_rad: 1e-4 };

fn machine() -> KinematicLimits {
    let linear = Some(AxisLimit { velocity: 200.0, acceleration: 2000.0, jerk: 1e5 });
    let rotary = Some(AxisLimit { velocity: 2.0, acceleration: 20.0, jerk: 500.0 });
    KinematicLimits::new([linear, linear, linear, rotary, rotary, rotary]).unwrap()
}

/// Velocity, acceleration and jerk of each axis.
fn limits_of(axes: [(f64, f64, f64); AXES]) -> KinematicLimits {
    KinematicLimits::new(
        axes.map(|(velocity, acceleration, jerk)| Some(AxisLimit { velocity, acceleration, jerk })),
    )
    .unwrap()
}

fn vec(p: [f64; 3]) -> Vec3 {
    Vec3::new(p[0], p[1], p[2])
}

fn motion(curve: impl Into<Curve>, corner: CornerMode) -> MoveRequest {
    cut(curve.into(), 50.0, corner)
}

fn line(from: [f64; 3], to: [f64; 3], corner: CornerMode) -> MoveRequest {
    motion(support::line(from, to), corner)
}

/// Lines from place to place, tagged in order.
fn lines(places: &[[f64; 3]], corner: CornerMode) -> Vec<MoveRequest> {
    let legs = places.windows(2).enumerate();
    legs.map(|(tag, ends)| MoveRequest { tag: tag as u64, ..line(ends[0], ends[1], corner) })
        .collect()
}

/// From the origin, tangent to X, in the plane XY.
fn arc(radius: f64, sweep: f64, corner: CornerMode) -> MoveRequest {
    let out = vec([0.0, -1.0, 0.0]);
    let centre = vec([0.0, radius, 0.0]);
    let frame = Frame::from_normal(centre, vec([0.0, 0.0, 1.0]), out).unwrap();
    motion(Arc::new(frame, radius, sweep, 0.0), corner)
}

/// Holds every limit, looked at so many places between the ends of each part.
#[track_caller]
fn holds_limits(trajectories: &[PlannedTrajectory], limits: KinematicLimits, probes: u32) {
    let used = trajectories
        .iter()
        .map(|s| largest_use(s, &limits, probes))
        .fold(LimitUse::default(), LimitUse::or);
    let worst = used.velocity.max(used.acceleration).max(used.jerk);
    assert!(worst <= ABOVE, "{used:?}");
}

/// Plans and checks limits, path and ends; hands back the time. Positions may be wrong by
/// `rounding_mm`, which far from the origin is more than near it.
#[track_caller]
fn checked_time_s(moves: &[MoveRequest], limits: KinematicLimits, rounding_mm: f64) -> f64 {
    let trajectories = plan(moves, limits, PlannerLevel::Fast);
    holds_limits(&trajectories, limits, 6);
    ends(moves, &trajectories, rounding_mm);
    let time_s = time_of(&trajectories);
    assert!(time_s.is_finite() && time_s >= 0.0, "{time_s} s");
    if trajectories.is_empty() {
        return time_s;
    }
    let tolerance = moves.iter().fold(1e-6_f64, |most, motion| match motion.corner {
        CornerMode::Joined { linear_mm, .. } => most.max(linear_mm),
        _ => most,
    });
    // A few thousand places of the path, however long it takes.
    for sample in samples(&trajectories, (time_s / 3000.0).max(1e-4)) {
        let off = distance(moves, sample.tag as usize, 40, &sample.position);
        assert!(off <= tolerance * ABOVE + rounding_mm, "{off} mm off at {} s", sample.time_s);
    }
    time_s
}

#[track_caller]
fn ends(moves: &[MoveRequest], trajectories: &[PlannedTrajectory], rounding_mm: f64) {
    let (Some(first), Some(last)) = (trajectories.first(), trajectories.last()) else {
        let (from, to) = (moves[0].from(), moves[moves.len() - 1].to());
        let offset = from.iter().zip(to).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        assert!(offset <= 1e-6, "nothing was planned for {offset} mm");
        return;
    };
    for (is, due) in [(first.from(), moves[0].from()), (last.to(), moves[moves.len() - 1].to())] {
        let off = is.iter().zip(due).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        assert!(off <= 1e-9 + rounding_mm, "{is:?} in place of {due:?}");
    }
}

/// What a planner says to moves of which the last is wrong.
fn refusal(moves: &[MoveRequest], limits: KinematicLimits) -> MoveError {
    let mut planner = MotionPlanner::new(limits, PlannerOptions::new(PlannerLevel::Fast));
    let (last, good) = moves.split_last().unwrap();
    for motion in good {
        planner.push(motion, |_| {}).unwrap();
    }
    planner.push(last, |_| {}).unwrap_err()
}

#[test]
fn moves_of_no_length_take_no_time() {
    let here = [3.0, 4.0, 5.0];
    for corner in [CornerMode::Stop, CornerMode::Exact, WITHIN] {
        assert_eq!(checked_time_s(&[line(here, here, corner)], machine(), 0.0), 0.0);
        let (a, b, c) = ([0.0; 3], [10.0, 0.0, 0.0], [20.0, 0.0, 0.0]);
        let without = checked_time_s(&lines(&[a, b, c], corner), machine(), 0.0);
        let with = checked_time_s(&lines(&[a, a, b, b, b, c, c], corner), machine(), 0.0);
        assert!((with - without).abs() < 1e-9, "{corner:?}: {with} s, {without} s");
    }
}

#[test]
fn steps_below_rounding_end_where_they_should() {
    let tiny = 1e-12;
    for corner in [CornerMode::Stop, CornerMode::Exact, WITHIN] {
        let chain: Vec<_> = (0..=10_000).map(|k| [tiny * f64::from(k), 0.0, 0.0]).collect();
        checked_time_s(&lines(&chain, corner), machine(), 1e-8);
        // Between ordinary moves, in all directions.
        let mut dice = Dice(3);
        let mut places = vec![[0.0; 3]];
        for k in 0..300 {
            let [x, y, z] = *places.last().unwrap();
            let step = if k % 10 == 0 { dice.even(0.1, 5.0) } else { dice.decades(1e-13, 1e-7) };
            let offset = dice.direction() * step;
            places.push([x + offset.x, y + offset.y, z + offset.z]);
        }
        checked_time_s(&lines(&places, corner), machine(), 1e-7);
    }
}

#[test]
fn arcs_as_wide_and_as_long_as_a_country() {
    for corner in [CornerMode::Stop, CornerMode::Exact, WITHIN] {
        // A sweep that is hardly a bend, and a whole kilometre of 5 mm turns.
        checked_time_s(&[arc(1e6, 1e-4, corner)], machine(), 1e-8);
        let turns = arc(5.0, 1e6 / 5.0, corner);
        let time_s = checked_time_s(&[turns], machine(), 1e-8);
        assert!(time_s >= 1e6 / 50.0, "{time_s}");
        let fast = MoveRequest { speed: 1e9, ..arc(1e6, 1.0, corner) };
        let time_s = checked_time_s(&[fast], machine(), 1e-6);
        // 479 m to the side and 841 m ahead: X alone takes this long.
        assert!(time_s >= 841_470.0 / 200.0, "{time_s}");
    }
}

#[test]
fn a_line_joins_the_widest_arc() {
    for corner in [CornerMode::Stop, CornerMode::Exact, WITHIN] {
        let bend = MoveRequest { tag: 1, ..arc(1e6, 1e-5, corner) };
        let time_s =
            checked_time_s(&[line([-10.0, 0.0, 0.0], [0.0; 3], corner), bend], machine(), 1e-8);
        assert!(time_s < 0.4 + 2.0 * 0.2, "{time_s}");
    }
}

#[test]
fn a_spiral_from_its_very_centre() {
    for (radii, turns) in [((0.0, 10.0), 3.0), ((10.0, 0.0), 3.0), ((0.0, 0.5), 0.4)] {
        let frame = Frame::from_normal(Vec3::ZERO, vec([0.0, 0.0, 1.0]), vec([1.0, 0.0, 0.0]));
        let sweep = turns * std::f64::consts::TAU;
        for rise in [0.0, 2.0] {
            let spiral = Spiral::new(frame.unwrap(), radii, sweep, rise);
            for corner in [CornerMode::Stop, CornerMode::Exact, WITHIN] {
                let time_s = checked_time_s(&[motion(spiral, corner)], machine(), 1e-9);
                assert!(time_s >= spiral.length() / 50.0, "{time_s}");
            }
        }
    }
}

#[test]
fn feeds_from_a_nanometre_a_second_to_beyond_light() {
    let corner = WITHIN;
    let places = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 1.0]];
    for speed in [1e-6, 1e9, f64::INFINITY] {
        let moves: Vec<MoveRequest> =
            lines(&places, corner).into_iter().map(|m| MoveRequest { speed, ..m }).collect();
        let time_s = checked_time_s(&moves, machine(), 1e-9);
        let length: f64 = moves.iter().map(MoveRequest::length).sum();
        assert!(time_s >= (length - 0.1) / speed, "{time_s}");
    }
    // From one to the other and back.
    let mut moves = lines(&[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]], corner);
    for (motion, speed) in moves.iter_mut().zip([1e9, 1e-6, 1e9]) {
        motion.speed = speed;
    }
    let time_s = checked_time_s(&moves, machine(), 1e-9);
    assert!((time_s / 1e6 - 1.0).abs() < 1e-3, "{time_s}");
}

#[test]
fn both_levels_plan_crawls() {
    let turn = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 1.0]];
    for speed in [1e-3, 1e-6, 1e-9, 1e-15, 1e-100] {
        for corner in [WITHIN, CornerMode::Exact] {
            let at_speed = |motion: MoveRequest| MoveRequest { speed, ..motion };
            let row: Vec<MoveRequest> = lines(&turn, corner).into_iter().map(at_speed).collect();
            let circle = [at_speed(arc(1.0, 3.0, corner))];
            for moves in [&row[..], &row[..1], &circle] {
                for level in [PlannerLevel::Fast, PlannerLevel::Best] {
                    let time_s = time_of(&plan(moves, machine(), level));
                    let length: f64 = moves.iter().map(MoveRequest::length).sum();
                    let due = length / speed;
                    assert!((time_s / due - 1.0).abs() < 0.05, "{level:?}: {time_s} s for {due}");
                }
            }
        }
    }
}

#[test]
fn limits_without_measure_have_a_plan() {
    let usual = (200.0, 2000.0, 1e5);
    let row = lines(&[[0.0; 3], [10.0, 0.0, 0.0], [10.0, 10.0, 0.0], [0.0; 3]], WITHIN);
    for size in [1e-6, 1e-27, 1e-300, 5e-324, 1e27, 1e300] {
        for x in [(size, usual.1, usual.2), (usual.0, size, usual.2), (usual.0, usual.1, size)] {
            let mut axes = [usual; AXES];
            axes[0] = x;
            for level in [PlannerLevel::Fast, PlannerLevel::Best] {
                let time_s = time_of(&plan(&row, limits_of(axes), level));
                assert!(time_s > 0.0, "{x:?}, {level:?}: {time_s}");
            }
        }
    }
}

/// A move on the spot in which rotary axes turn.
fn turn(at: [f64; 3], from: [f64; 3], to: [f64; 3], corner: CornerMode) -> MoveRequest {
    MoveRequest { rotary_from: from, rotary_to: to, speed: 1.0, ..line(at, at, corner) }
}

#[test]
fn rotary_axes_alone() {
    for corner in [CornerMode::Stop, CornerMode::Exact, WITHIN] {
        // One radian at 1 rad/s, with ramps of 20 rad/s² and 500 rad/s³.
        let time_s =
            checked_time_s(&[turn([0.0; 3], [0.0; 3], [1.0, 0.0, 0.0], corner)], machine(), 0.0);
        assert!((time_s - 1.09).abs() < 1e-9, "{time_s}");
        let places = [[0.0; 3], [0.5, 0.2, 0.0], [0.5, 0.2, -1.0], [0.0, 0.2, -1.0], [0.0; 3]];
        let moves: Vec<MoveRequest> = places
            .windows(2)
            .enumerate()
            .map(|(tag, ends)| MoveRequest {
                tag: tag as u64,
                ..turn([1.0, 2.0, 3.0], ends[0], ends[1], corner)
            })
            .collect();
        checked_time_s(&moves, machine(), 1e-9);
    }
}

#[test]
fn rotary_and_linear_axes_in_turns() {
    for corner in [CornerMode::Stop, CornerMode::Exact, WITHIN] {
        let mut moves = Vec::new();
        for k in 0..20_u64 {
            let (at, angle) = (5.0 * (k / 2) as f64, 0.1 * k.div_ceil(2) as f64);
            let motion = if k % 2 == 0 {
                let to = [at + 5.0, 0.0, 0.0];
                let rotary = [angle, 0.0, 0.0];
                let motion = line([at, 0.0, 0.0], to, corner);
                MoveRequest { rotary_from: rotary, rotary_to: rotary, ..motion }
            } else {
                let from = [angle - 0.1, 0.0, 0.0];
                turn([at + 5.0, 0.0, 0.0], from, [angle, 0.0, 0.0], corner)
            };
            moves.push(MoveRequest { tag: k, ..motion });
        }
        checked_time_s(&moves, machine(), 1e-9);
    }
}

#[test]
fn no_tolerance_is_the_exact_path() {
    let none = CornerMode::Joined { linear_mm: 0.0, rotary_rad: 0.0 };
    let places = [[0.0; 3], [10.0, 0.0, 0.0], [10.0, 10.0, 0.0], [15.0, 15.0, 1.0]];
    let time_s = checked_time_s(&lines(&places, none), machine(), 0.0);
    // A millionth of a millimetre is exact: it leaves room for half a thousandth of a second.
    let stops = checked_time_s(&lines(&places, CornerMode::Stop), machine(), 0.0);
    assert!(time_s <= stops && time_s > stops - 2.0 * 5e-4, "{time_s} s, {stops} s");
}

#[test]
fn a_tolerance_wider_than_the_legs() {
    let wide = CornerMode::Joined { linear_mm: 10.0, rotary_rad: 1.0 };
    let mut dice = Dice(5);
    for step in [0.01, 0.1, 1.0] {
        let mut places = vec![[0.0; 3]];
        for _ in 0..100 {
            let [x, y, z] = *places.last().unwrap();
            let offset = dice.direction() * step;
            places.push([x + offset.x, y + offset.y, z + offset.z]);
        }
        checked_time_s(&lines(&places, wide), machine(), 1e-9);
    }
}

#[test]
fn there_and_back_on_one_line() {
    let (a, b) = ([0.0; 3], [10.0, 0.0, 0.0]);
    let once = checked_time_s(&lines(&[a, b], CornerMode::Stop), machine(), 0.0);
    for corner in [CornerMode::Stop, CornerMode::Exact, WITHIN] {
        let time_s = checked_time_s(&lines(&[a, b, a, b, a], corner), machine(), 1e-9);
        assert!(time_s <= 4.0 * once * (1.0 + 1e-9), "{corner:?}: {time_s} s");
        // A reversal within the tolerance need not go all the way, but nearly.
        assert!(time_s > 4.0 * once * 0.8, "{corner:?}: {time_s} s");
    }
}

#[test]
fn what_is_no_move_is_refused() {
    let good = line([0.0; 3], [1.0, 0.0, 0.0], WITHIN);
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..3 {
            let mut to = [2.0, 0.0, 0.0];
            to[axis] = wrong;
            let bad = line([1.0, 0.0, 0.0], to, WITHIN);
            assert_eq!(refusal(&[good, bad], machine()), MoveError::NotFinite);
            let mut bad = line([1.0, 0.0, 0.0], [2.0, 0.0, 0.0], WITHIN);
            bad.rotary_to[axis] = wrong;
            assert_eq!(refusal(&[good, bad], machine()), MoveError::NotFinite);
        }
    }
    // Coordinates that are finite, and a length that is not.
    let bad = line([-1e308, 0.0, 0.0], [1e308, 1e308, 0.0], WITHIN);
    assert_eq!(refusal(&[bad], machine()), MoveError::NotFinite);
    for speed in [0.0, -1.0, f64::NAN] {
        let error = refusal(&[MoveRequest { speed, ..good }], machine());
        assert!(matches!(error, MoveError::Speed(_)), "{error}");
    }
    for tolerance in [-1e-9, f64::NAN] {
        let linear = CornerMode::Joined { linear_mm: tolerance, rotary_rad: 0.0 };
        let rotary = CornerMode::Joined { linear_mm: 0.0, rotary_rad: tolerance };
        for corner in [linear, rotary] {
            let error = refusal(&[MoveRequest { corner, ..good }], machine());
            assert!(matches!(error, MoveError::Tolerance(_)), "{error}");
        }
    }
    let far = line([1.5, 0.0, 0.0], [2.0, 0.0, 0.0], WITHIN);
    assert_eq!(refusal(&[good, far], machine()), MoveError::Gap(0.5));
}

#[test]
fn an_axis_that_is_not_there_must_not_move() {
    let limit = AxisLimit { velocity: 200.0, acceleration: 2000.0, jerk: 1e5 };
    let two = KinematicLimits::new([Some(limit), Some(limit), None, None, None, None]).unwrap();
    checked_time_s(&[line([0.0; 3], [10.0, 5.0, 0.0], WITHIN)], two, 0.0);
    checked_time_s(&[arc(5.0, 6.0, WITHIN)], two, 1e-9);
    let down = line([0.0; 3], [10.0, 5.0, -1e-9], WITHIN);
    assert_eq!(refusal(&[down], two), MoveError::NoAxis(2));
    let turned =
        MoveRequest { rotary_to: [0.0, 0.1, 0.0], ..line([0.0; 3], [1.0, 0.0, 0.0], WITHIN) };
    assert_eq!(refusal(&[turned], two), MoveError::NoAxis(4));
}

#[test]
fn limits_are_positive_numbers() {
    let good = AxisLimit { velocity: 1.0, acceleration: 1.0, jerk: 1.0 };
    for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for (quantity, wrong) in [
            (LimitedQuantity::Velocity, AxisLimit { velocity: value, ..good }),
            (LimitedQuantity::Acceleration, AxisLimit { acceleration: value, ..good }),
            (LimitedQuantity::Jerk, AxisLimit { jerk: value, ..good }),
        ] {
            let error = KinematicLimits::new([Some(good), Some(wrong), None, None, None, None])
                .unwrap_err();
            assert_eq!((error.axis, error.quantity), (1, quantity));
        }
    }
}

#[test]
fn a_refused_move_leaves_the_planner_as_it_was() {
    let moves = lines(&[[0.0; 3], [10.0, 0.0, 0.0], [20.0, 1.0, 0.0]], WITHIN);
    let without = time_of(&plan(&moves, machine(), PlannerLevel::Fast));
    let mut planner = MotionPlanner::new(machine(), PlannerOptions::new(PlannerLevel::Fast));
    let mut time_s = 0.0;
    let mut take = |step: PlannerStep<'_>| {
        if let PlannerStep::Trajectory(trajectory) = step {
            time_s += trajectory.duration_s() - trajectory.overlap_s;
        }
    };
    planner.push(&moves[0], &mut take).unwrap();
    let bad = line([10.0, 0.0, 0.0], [f64::NAN, 0.0, 0.0], WITHIN);
    planner.push(&bad, &mut take).unwrap_err();
    planner.push(&line([99.0; 3], [1.0; 3], WITHIN), &mut take).unwrap_err();
    planner.push(&moves[1], &mut take).unwrap();
    planner.finish(&mut take);
    assert!((time_s - without).abs() < 1e-12, "{time_s} s, {without} s");
}

#[test]
fn circle_after_circle_in_bounded_memory() {
    // Whole circles tangent to each other, without a tolerance and with one.
    for corner in [CornerMode::Exact, WITHIN] {
        let circle = arc(3.0, std::f64::consts::TAU, corner);
        let mut planner = MotionPlanner::new(machine(), PlannerOptions::new(PlannerLevel::Fast));
        let (mut pushed, mut planned, mut waiting) = (0.0, 0.0, 0.0_f64);
        for _ in 0..200_000 {
            pushed += circle.length();
            let take = |step: PlannerStep<'_>| {
                if let PlannerStep::Trajectory(trajectory) = step {
                    planned += trajectory.length();
                }
            };
            planner.push(&circle, take).unwrap();
            waiting = waiting.max(pushed - planned);
        }
        // As many as a row has pieces, and the one that is under way.
        let most = 8_193.0 * circle.length();
        assert!(waiting < most, "{corner:?}: {} circles wait", waiting / circle.length());
        planner.finish(|_| {});
    }
}

/// A line eased at length into a wide helix: on the long piece between them Z rises, and turns back where none of
/// the places looked at lies.
#[test]
fn an_axis_that_turns_back_on_a_long_eased_piece_holds_its_velocity() {
    let limits = limits_of([
        (125.0, 20_000.0, 1e6),
        (2000.0, 20_000.0, 1e6),
        (1.35, 280.0, 8.7e5),
        (140.0, 13.0, 2.8e5),
        (700.0, 7000.0, 2.8e5),
        (700.0, 7000.0, 2.8e5),
    ]);
    let (radius, wide) = (797.922_633_6, CornerMode::Joined { linear_mm: 0.8, rotary_rad: 0.008 });
    let out = vec([0.0, 0.314_119_53, 0.949_383_44]);
    let axis = vec([-0.050_329_193, 0.948_180_272, -0.313_721_444]);
    let start = vec([14.040_311_5, 0.0, 0.0]);
    let frame = Frame::from_normal(start - out * radius, axis, out).unwrap();
    let helix = Arc::new(frame, radius, 0.017_596_081, -4.405_164_88);
    let fast = |curve: Curve, corner| cut(curve, f64::INFINITY, corner);
    let moves = [
        fast(support::line([0.0; 3], helix.start().to_array()), wide),
        fast(helix.into(), CornerMode::Stop),
    ];
    holds_limits(&plan(&moves, limits, PlannerLevel::Fast), limits, 40);
}

/// So slow that what eases the end of a spiral is narrower than rounding: it must leave nothing on the lines.
#[test]
fn a_spiral_into_a_line_at_a_crawl_ends_where_the_line_does() {
    let spiral = Spiral::new(
        Frame::from_normal(
            vec([0.0, -34.770_575_8, 8_812.409_270_6]),
            vec([0.0, -0.999_992_216, -0.003_945_607_2]),
            vec([0.0, 0.003_945_607_2, -0.999_992_216]),
        )
        .unwrap(),
        (8_812.477_866_4, 8_674.513_964_2),
        0.034_042_638_7,
        0.009_155_27,
    );
    let (from, offset) = (spiral.end(), spiral.tangent_at(spiral.length()));
    let (middle, end) = (from + offset * 0.0525, from + offset * 300.0);
    let slow = |curve: Curve, corner| cut(curve, 0.001, corner);
    let tight = CornerMode::Joined { linear_mm: 8e-6, rotary_rad: 1.0 };
    let moves = [
        slow(spiral.into(), CornerMode::Joined { linear_mm: 10.0, rotary_rad: 0.08 }),
        slow(support::line(from.to_array(), middle.to_array()), tight),
        cut(support::line(middle.to_array(), end.to_array()), f64::INFINITY, CornerMode::Stop),
    ];
    ends(&moves, &plan(&moves, machine(), PlannerLevel::Fast), 1e-8);
}

/// A spiral that rises steeply turns faster than its curvature says, and must hold the velocity of X between the
/// places that are looked at.
#[test]
fn a_steep_spiral_eased_into_a_wide_arc_holds_the_velocity_of_every_axis() {
    let limits = limits_of([
        (1.0, 13.47, 1009.0),
        (1.0, 67.37, 40_171.0),
        (80.0, 800.0, 20_224.0),
        (80.0, 15_757.0, 749_048.0),
        (1279.0, 15_757.0, 749_048.0),
        (1576.0, 15_757.0, 41_649.0),
    ]);
    let wide = CornerMode::Joined { linear_mm: 0.75, rotary_rad: 7e-4 };
    let radius = 749.048_267_6;
    let out = vec([-0.001_311_711_7, 0.707_761_724_6, -0.706_450_012_8]);
    let around = vec([0.306_150_830_6, -0.672_244_710_3, -0.674_061_361]);
    let frame = Frame::from_normal(out * -radius, around, out).unwrap();
    let arc = Arc::new(frame, radius, 0.017_362_942_5, -0.816_427_243_2);
    let out = vec([0.334_123_688_3, -0.873_246_260_8, -0.354_686_240_0]);
    let around = vec([0.148_164_893_9, 0.420_297_599, -0.895_207_848_8]);
    let frame = Frame::from_normal(arc.end() - out * 0.020_780_07, around, out).unwrap();
    // From where the frame has it, whose first axis is square to the other.
    let spiral = Spiral::new(frame, (0.020_780_07, 0.014_002_2), 100.0, 24.957_275_4);
    let frame = Frame { origin: frame.origin + (arc.end() - spiral.start()), ..frame };
    let spiral = Spiral::new(frame, (0.020_780_07, 0.014_002_2), 100.0, 24.957_275_4);
    let moves =
        [cut(arc.into(), f64::INFINITY, wide), cut(spiral.into(), f64::INFINITY, CornerMode::Stop)];
    holds_limits(&plan(&moves, limits, PlannerLevel::Fast), limits, 12);
}

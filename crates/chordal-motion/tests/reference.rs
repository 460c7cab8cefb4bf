//! The least time with limits of jerk, and the profile of the level best, against worked figures.

mod support;

use chordal_motion::{
    CornerMode, JerkPhase, KinematicLimits, LeastTimeGauge, MotionPlanner, MoveRequest, PathPiece,
    PathRun, PlannedTrajectory, PlannerLevel, PlannerOptions, PlannerStep, ReferenceProfile,
    ReferenceQuality, TimeBound, largest_use, reference, time_bound,
};
use support::best::{Best, best};
use support::figures::{arc, bang_bang, ellipse, near};
use support::law::{Law as Ramps, straight_piece as line};
use support::{cut, limits};

/// Time from rest to rest over a length with limits of jerk.
fn seven_phases(length: f64, speed: f64, acceleration: f64, jerk: f64) -> f64 {
    Ramps { speed, acceleration, jerk }.time_s(length)
}

struct SolvedRun {
    bound: TimeBound,
    law: ReferenceProfile,
    best: Best,
}

/// All three profiles; the best one is compared with the limits.
#[track_caller]
fn solve(pieces: &[PathPiece], speeds: &[f64], limits: &KinematicLimits) -> SolvedRun {
    let run = PathRun::new(pieces, speeds, 0.0, limits).unwrap();
    let bound = time_bound(&run);
    let law = reference(&run, &bound, &ReferenceQuality::default()).unwrap();
    let best = best(&run).unwrap();
    println!(
        "bound {:.5} reference {:.5} (change {:.0e}, {} nodes) best {:.5}",
        bound.time_s,
        law.time_s,
        law.change_s,
        law.sigma.len(),
        best.time_s
    );
    let trajectory =
        PlannedTrajectory { pieces: pieces.to_vec(), phases: best.phases.clone(), overlap_s: 0.0 };
    let used = largest_use(&trajectory, limits, 16);
    for share in [used.velocity, used.acceleration, used.jerk] {
        assert!(share <= 1.0 + 1e-6, "{used:?}");
    }
    near(trajectory.duration_s(), best.time_s, 1e-12);
    assert!(bound.time_s <= law.time_s);
    assert!(best.time_s <= 1.03 * law.time_s, "{} for {}", best.time_s, law.time_s);
    SolvedRun { bound, law, best }
}

#[test]
fn a_line_takes_its_seven_phases() {
    for (distance, speed) in [(100.0, 500.0), (100.0, 100.0), (1.0, 500.0), (0.001, 500.0)] {
        let solved =
            solve(&[line([0.0; 3], [distance, 0.0, 0.0])], &[speed], &limits(500.0, 5000.0, 1e5));
        let expected = seven_phases(distance, speed, 5000.0, 1e5);
        near(solved.law.time_s, expected, 1e-3);
        // The planner has the seven phases of a line themselves; the profile is near them.
        near(solved.best.time_s, expected, 6e-3);
    }
    // The figure of the 100 mm line: 0.350 s.
    near(seven_phases(100.0, 500.0, 5000.0, 1e5), 0.35, 1e-9);
}

#[test]
fn a_diagonal_uses_all_axes() {
    // Along the diagonal of a cube the path may do √3 times what an axis may.
    let solved = solve(&[line([0.0; 3], [30.0; 3])], &[f64::INFINITY], &limits(500.0, 5000.0, 1e5));
    near(solved.best.time_s, seven_phases(30.0, 500.0, 5000.0, 1e5), 4e-3);
}

#[test]
fn a_lap_of_the_ellipse() {
    let pieces = ellipse(30.0, 10.0, 200);
    let speeds = vec![f64::INFINITY; pieces.len()];
    let solved = solve(&pieces, &speeds, &limits(500.0, 5000.0, 1e5));
    near(solved.bound.time_s, 0.468, 1e-3);
    near(solved.law.time_s, 0.541, 4e-3);
}

#[test]
fn circles_and_helix() {
    let machine = limits(200.0, 2000.0, 1e5);
    let large = solve(&[arc(20.0, 1.0, 0.0)], &[100.0], &machine);
    near(large.best.time_s, 1.33, 5e-3);
    let small = solve(&[arc(2.0, 5.0, 0.0)], &[100.0], &machine);
    assert!(small.best.time_s < 1.1);
    // The way at the feed, one ramp up and one down: nothing else slows an arc this wide.
    let helix = arc(10.0, 3.0, 15.0);
    let solved = solve(&[helix], &[100.0], &machine);
    assert!(solved.best.time_s > helix.length / 100.0 + 0.05);
    assert!(solved.best.time_s < helix.length / 100.0 + 0.08);
}

#[test]
fn cutting_a_line_changes_nothing() {
    let machine = limits(500.0, 5000.0, 1e5);
    let whole = solve(&[line([0.0; 3], [100.0, 0.0, 0.0])], &[400.0], &machine);
    let cuts: Vec<PathPiece> = (0..1000)
        .map(|k| line([0.1 * f64::from(k), 0.0, 0.0], [0.1 * f64::from(k + 1), 0.0, 0.0]))
        .collect();
    let cut = solve(&cuts, &[400.0; 1000], &machine);
    near(cut.bound.time_s, whole.bound.time_s, 1e-4);
    near(cut.law.time_s, whole.law.time_s, 1e-5);
    near(cut.best.time_s, whole.best.time_s, 2e-4);
}

#[test]
fn a_slow_feed_in_the_middle_stays() {
    let pieces = [
        line([0.0; 3], [20.0, 0.0, 0.0]),
        line([20.0, 0.0, 0.0], [25.0, 0.0, 0.0]),
        line([25.0, 0.0, 0.0], [45.0, 0.0, 0.0]),
    ];
    let machine = limits(500.0, 5000.0, 1e5);
    let solved = solve(&pieces, &[200.0, 50.0, 200.0], &machine);
    // With even speed at the seams: 5 mm at 50 mm/s take 0.1 s; on each side 20 mm from rest up
    // to 200 mm/s (0.09 s, 9 mm), on for 1 mm, and down to 50 (0.08 s, 10 mm). The least time is
    // shorter: the brake may be let go of after the seam, a little below 50 mm/s.
    let even = 0.1 + 2.0 * (0.09 + 0.08 + 1.0 / 200.0);
    assert!(solved.best.time_s < even && solved.best.time_s > 0.96 * even);
    for phase in &solved.best.phases {
        if phase.from > 20.0 - 1e-9 && phase.from < 25.0 + 1e-9 {
            assert!(phase.speed <= 50.0 * (1.0 + 1e-6), "{}", phase.speed);
        }
    }
}

#[test]
fn a_run_may_begin_at_speed() {
    let machine = limits(500.0, 5000.0, 1e5);
    let pieces = [line([0.0; 3], [10.0, 0.0, 0.0])];
    let run = PathRun::new(&pieces, &[50.0], 50.0, &machine).unwrap();
    let law = reference(&run, &time_bound(&run), &ReferenceQuality::default()).unwrap();
    // The stop from 50 mm/s takes 2√(50/1e5) s, over half that time at 50 mm/s.
    let stop = 2.0 * (50.0f64 / 1e5).sqrt();
    near(law.time_s, (10.0 - 25.0 * stop) / 50.0 + stop, 1e-3);
    near(best(&run).unwrap().time_s, law.time_s, 2e-3);
}

#[test]
fn the_same_run_has_the_same_law_to_the_bit() {
    let machine = limits(200.0, 2000.0, 1e5);
    let first = solve(&[arc(2.0, 1.0, 0.0)], &[100.0], &machine);
    let again = solve(&[arc(2.0, 1.0, 0.0)], &[100.0], &machine);
    assert_eq!(first.law, again.law);
    assert_eq!(first.best, again.best);
}

#[test]
fn a_planned_square_is_gauged_side_by_side() {
    let machine = limits(200.0, 2000.0, 1e5);
    let corners = [[0.0; 3], [50.0, 0.0, 0.0], [50.0, 50.0, 0.0], [0.0, 50.0, 0.0], [0.0; 3]];
    let mut planner = MotionPlanner::new(machine, PlannerOptions::new(PlannerLevel::Fast));
    let mut gauge = LeastTimeGauge::new(machine, ReferenceQuality::default());
    let mut runs = Vec::new();
    for (tag, ends) in corners.windows(2).enumerate() {
        let motion = cut(support::line(ends[0], ends[1]), 50.0, CornerMode::Stop);
        let motion = MoveRequest { tag: tag as u64, ..motion };
        planner.push(&motion, |step| gauge.push(step, |_| 50.0, |run| runs.push(*run))).unwrap();
    }
    planner.finish(|step| gauge.push(step, |_| 50.0, |run| runs.push(*run)));
    let least = gauge.finish(|run| runs.push(*run));
    assert_eq!(runs.len(), 4);
    assert_eq!(
        runs.iter().map(|run| run.tags).collect::<Vec<_>>(),
        [(0, 0), (1, 1), (2, 2), (3, 3)]
    );
    for run in &runs {
        let reference_s = run.reference_s.unwrap();
        near(run.bound_s, bang_bang(50.0, 50.0, 2000.0), 1e-9);
        near(reference_s, seven_phases(50.0, 50.0, 2000.0, 1e5), 1e-9);
        assert!(run.bound_s < reference_s && reference_s <= run.time_s);
    }
    near(least.reference_s, runs.iter().filter_map(|run| run.reference_s).sum(), 1e-12);
    assert_eq!(least.unknown_s, 0.0);
}

/// The times of one trajectory from rest to rest that was planned at even jerk, very slowly.
fn gauged(
    pieces: Vec<PathPiece>,
    feed: f64,
    effort: ReferenceQuality,
) -> chordal_motion::LeastTimes {
    let length: f64 = pieces.iter().map(|piece| piece.length).sum();
    let slow = JerkPhase {
        duration_s: 100.0,
        from: 0.0,
        speed: length / 100.0,
        acceleration: 0.0,
        jerk: 0.0,
    };
    let trajectory = PlannedTrajectory { pieces, phases: vec![slow], overlap_s: 0.0 };
    let mut gauge = LeastTimeGauge::new(limits(500.0, 5000.0, 1e5), effort);
    gauge.push(
        PlannerStep::Trajectory(&trajectory),
        |_| feed,
        |_| panic!("the stretch ends at speed"),
    );
    gauge.push(PlannerStep::Wait { seconds: 1.0, tag: 0 }, |_| feed, |_| {});
    let mut runs = 0;
    let least = gauge.finish(|_| runs += 1);
    assert_eq!(runs, 1);
    least
}

#[test]
fn lines_are_gauged_by_their_closed_form() {
    for (distance, speed) in
        [(100.0, 500.0), (100.0, 100.0), (30.0, 500.0), (1.0, 500.0), (1e-3, 1.0)]
    {
        let pieces = vec![
            line([0.0; 3], [distance / 3.0, 0.0, 0.0]),
            line([distance / 3.0, 0.0, 0.0], [distance, 0.0, 0.0]),
        ];
        let least = gauged(pieces, speed, ReferenceQuality::default());
        near(least.bound_s - 1.0, bang_bang(distance, speed, 5000.0), 1e-9);
        near(least.reference_s - 1.0, seven_phases(distance, speed, 5000.0, 1e5), 1e-9);
        near(least.time_s, 101.0, 1e-12);
    }
}

#[test]
fn a_gauge_without_work_left_says_so() {
    let effort = ReferenceQuality { total_nodes: 10, ..ReferenceQuality::default() };
    let least = gauged(vec![arc(5.0, 1.0, 0.0)], 100.0, effort);
    near(least.unknown_s, 100.0, 1e-12);
    near(least.reference_s, 101.0, 1e-12);
    assert!(least.bound_s < 2.0);
}

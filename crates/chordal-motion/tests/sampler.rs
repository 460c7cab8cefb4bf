//! Setpoints of trajectories made by hand.

mod support;

use chordal_geometry::{AXES, Arc, Curve, Frame, Plane, Spiral, Vec3};
use chordal_motion::{
    AxisValues, MotionSample, PlannedTrajectory, PlannerStep, SetpointSampler, TrajectoryCursor,
};
use support::law::{LAW, Law, piece, straight};

const X: AxisValues = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
const Y: AxisValues = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0];

fn sampled(period_s: f64, steps: &[PlannerStep<'_>]) -> Vec<MotionSample> {
    let mut samples = Vec::new();
    let mut sampler = SetpointSampler::new(period_s);
    for step in steps {
        sampler.push(*step, |sample| samples.push(*sample));
    }
    sampler.finish(|sample| samples.push(*sample));
    samples
}

fn line(from: AxisValues, direction: AxisValues, length: f64, tag: u64) -> PlannedTrajectory {
    LAW.trajectory(vec![straight(from, direction, length, tag)])
}

#[test]
fn a_line_of_a_second_has_a_thousand_and_one_setpoints() {
    // 100 mm at 100 mm/s, and a ramp of 0.07 s at either end that costs half of itself: 1.07 s.
    let line = line([0.0; AXES], X, 100.0, 7);
    assert!((line.duration_s() - 1.07).abs() < 1e-12);
    let samples = sampled(0.001, &[PlannerStep::Trajectory(&line)]);
    assert_eq!(samples.len(), 1071);
    for (index, sample) in samples.iter().enumerate() {
        assert_eq!(sample.time_s, index as f64 * 0.001);
        assert_eq!(sample.tag, 7);
    }
    assert_eq!(samples[0].position, [0.0; AXES]);
    assert_eq!(samples[0].velocity, [0.0; AXES]);
    // At even speed halfway, at rest at the end.
    let middle = &samples[535];
    assert!((middle.position[0] - 50.0).abs() < 1e-12);
    assert_eq!((middle.velocity[0], middle.acceleration[0], middle.jerk[0]), (100.0, 0.0, 0.0));
    let end = &samples[1070];
    assert_eq!((end.position, end.velocity), ([100.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0; AXES]));
}

#[test]
fn the_last_setpoint_is_the_end_at_a_whole_period() {
    let line = line([1.0, 2.0, 3.0, 0.4, 0.0, 0.0], Y, 30.0, 1);
    let duration_s = line.duration_s();
    for period_s in [0.001, 0.00025, 0.0037, 0.1, 5.0] {
        let samples = sampled(period_s, &[PlannerStep::Trajectory(&line)]);
        let last = samples.last().unwrap();
        assert_eq!(last.position, [1.0, 32.0, 3.0, 0.4, 0.0, 0.0]);
        assert_eq!(
            (last.velocity, last.acceleration, last.jerk),
            ([0.0; AXES], [0.0; AXES], [0.0; AXES])
        );
        assert!(last.time_s > duration_s - 1e-9 && last.time_s < duration_s + period_s);
        assert_eq!(last.time_s, (samples.len() - 1) as f64 * period_s);
    }
}

#[test]
fn no_setpoint_gets_lost_between_trajectories() {
    let first = line([0.0; AXES], X, 20.0, 1);
    let second = line([20.0, 0.0, 0.0, 0.0, 0.0, 0.0], Y, 20.0, 2);
    let samples =
        sampled(0.001, &[PlannerStep::Trajectory(&first), PlannerStep::Trajectory(&second)]);
    for pair in samples.windows(2) {
        assert!((pair[1].time_s - pair[0].time_s - 0.001).abs() < 1e-12);
    }
    assert_eq!(samples.iter().filter(|sample| sample.tag == 1).count(), 270);
    // Both take 0.27 s: without overlap the second begins with the sample at the corner.
    let corner = samples.iter().find(|sample| sample.tag == 2).unwrap();
    assert!((corner.time_s - 0.27).abs() < 1e-12);
    assert_eq!(corner.position, [20.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert_eq!(samples.last().unwrap().position, [20.0, 20.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn movements_add_up_where_trajectories_overlap() {
    let first = line([0.0; AXES], X, 20.0, 1);
    let mut second = line([20.0, 0.0, 0.0, 0.0, 0.0, 0.0], Y, 20.0, 2);
    second.overlap_s = 0.02;
    let samples =
        sampled(0.001, &[PlannerStep::Trajectory(&first), PlannerStep::Trajectory(&second)]);
    assert!((samples.last().unwrap().time_s - 0.52).abs() < 1e-12);
    for sample in &samples {
        // Each axis by itself is the profile of its own trajectory.
        let (x, y) = (TrajectoryCursor::default(), TrajectoryCursor::default());
        let [mut x, mut y] = [x, y];
        let x = x.at(&first, sample.time_s);
        let y = y.at(&second, sample.time_s - 0.25);
        assert!((sample.position[0] - x.position[0]).abs() < 1e-12);
        assert!((sample.position[1] - y.position[1]).abs() < 1e-12);
        assert!((sample.velocity[0] - x.velocity[0]).abs() < 1e-9);
        assert!((sample.velocity[1] - y.velocity[1]).abs() < 1e-9);
    }
    let both = &samples[260];
    assert!(both.velocity[0] > 0.0 && both.velocity[1] > 0.0);
    assert!(both.position[0] < 20.0 && both.position[1] > 0.0);
}

#[test]
fn an_overlap_reaches_no_farther_than_the_trajectory_before() {
    let first = line([0.0; AXES], X, 20.0, 1);
    let mut second = line([20.0, 0.0, 0.0, 0.0, 0.0, 0.0], Y, 20.0, 2);
    second.overlap_s = 9.0;
    let steps = [PlannerStep::Wait { seconds: 0.1, tag: 0 }, PlannerStep::Trajectory(&first)];
    let samples = sampled(0.001, &[&steps[..], &[PlannerStep::Trajectory(&second)]].concat());
    assert!((samples.last().unwrap().time_s - 0.37).abs() < 1e-12);
    assert!(samples[..100].iter().all(|sample| sample.position == [0.0; AXES]));
}

#[test]
fn nothing_moves_while_it_waits() {
    let first = line([0.0; AXES], X, 20.0, 1);
    let mut second = line([20.0, 0.0, 0.0, 0.0, 0.0, 0.0], Y, 20.0, 3);
    // Nothing overlaps a rest.
    second.overlap_s = 0.02;
    let wait = PlannerStep::Wait { seconds: 0.5, tag: 2 };
    let samples =
        sampled(0.001, &[PlannerStep::Trajectory(&first), wait, PlannerStep::Trajectory(&second)]);
    let waiting: Vec<&MotionSample> = samples.iter().filter(|sample| sample.tag == 2).collect();
    assert_eq!(waiting.len(), 500);
    for sample in waiting {
        assert_eq!(sample.position, [20.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!((sample.velocity, sample.acceleration), ([0.0; AXES], [0.0; AXES]));
    }
    assert!((samples.last().unwrap().time_s - 1.04).abs() < 1e-12);
    assert_eq!(samples.last().unwrap().position, [20.0, 20.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn a_wait_for_ever_ends_at_the_budget() {
    let mut count = 0;
    let mut sampler = SetpointSampler::new(0.001).at_most(500);
    let line = line([0.0; AXES], X, 20.0, 1);
    sampler.push(PlannerStep::Trajectory(&line), |_| count += 1);
    assert!(!sampler.is_exhausted());
    sampler.push(PlannerStep::Wait { seconds: f64::INFINITY, tag: 2 }, |_| count += 1);
    assert!(sampler.is_exhausted());
    sampler.finish(|_| count += 1);
    assert_eq!(count, 500);
}

#[test]
fn a_budget_that_the_last_setpoint_exceeds_is_reported() {
    // Nothing is emitted before the end, so the number of setpoints shows it.
    let line = line([0.0; AXES], X, 20.0, 1);
    let needed = (line.duration_s() / 0.001).ceil() as u64 + 1;
    for (most, exhausted) in [(needed, false), (needed - 1, true), (10, true)] {
        let mut sampler = SetpointSampler::new(0.001).at_most(most);
        sampler.push(PlannerStep::Trajectory(&line), |_| {});
        assert_eq!(sampler.is_exhausted(), exhausted, "{most} of {needed}");
        let mut last = MotionSample::default();
        let mut count = 0;
        sampler.finish(|sample| {
            last = *sample;
            count += 1;
        });
        assert_eq!(count, most);
        assert_eq!(last.position[0] == 20.0, !exhausted);
    }
}

/// Differences of positions are velocities, and so on, to the order of the period squared.
fn derivatives_agree(samples: &[MotionSample], period_s: f64, jerk: f64) {
    for triple in samples.windows(3) {
        let [before, now, after] = triple else { unreachable!() };
        for axis in 0..AXES {
            let speed = (after.position[axis] - before.position[axis]) / (2.0 * period_s);
            let slack = jerk * period_s * period_s;
            assert!((speed - now.velocity[axis]).abs() <= slack, "axis {axis} at {}", now.time_s);
            let acceleration = (after.velocity[axis] - before.velocity[axis]) / (2.0 * period_s);
            assert!((acceleration - now.acceleration[axis]).abs() <= jerk * period_s);
        }
    }
}

#[test]
fn differences_of_positions_are_the_velocity() {
    let rotary = [0.6, 0.0, 0.8, 0.01, 0.0, -0.02];
    let mut bent = straight([0.0; AXES], X, 30.0, 1);
    bent.start[2][1] = 0.01;
    bent.start[3][1] = -0.001;
    let helix: Curve = Arc::new(Plane::Zx.frame(), 10.0, 5.0, 3.0).into();
    let spiral: Curve = Spiral::new(Plane::Xy.frame(), (4.0, 12.0), -6.0, 1.0).into();
    let mut turned = piece(helix, 1);
    turned.start[0][3] = 1.0;
    turned.start[1][3] = 0.01;
    turned.start[2][3] = 1e-4;
    let turning = straight([5.0; AXES], rotary, 40.0, 1);
    for path in [turning, bent, piece(helix, 1), piece(spiral, 1), turned] {
        let trajectory = LAW.trajectory(vec![path]);
        let samples = sampled(0.0005, &[PlannerStep::Trajectory(&trajectory)]);
        // On the curves their own jerk comes on top: v³/r² with r ≥ 4, and v·a/r.
        derivatives_agree(&samples, 0.0005, LAW.jerk + 1e6 / 16.0 + 3.0 * 100.0 * 2000.0 / 4.0);
    }
}

#[test]
fn a_walk_answers_what_the_piece_answers() {
    let (origin, normal) = (Vec3::new(3.0, -2.0, 1.0), Vec3::new(1.0, 2.0, 0.5));
    let frame = Frame::from_normal(origin, normal, Vec3::Z).unwrap();
    let curves: [Curve; 3] = [
        Arc::new(frame, 25.0, -4.0, 0.0).into(),
        Arc::new(frame, 2.0, 40.0, 3.0).into(),
        Spiral::new(frame, (4.0, 12.0), 6.0, 1.0).into(),
    ];
    for curve in curves {
        let trajectory = Law { speed: 80.0, ..LAW }.trajectory(vec![piece(curve, 1)]);
        let mut cursor = TrajectoryCursor::default();
        let mut phase_from = 0.0;
        for phase in &trajectory.phases {
            for share in [0.0, 0.2, 0.9] {
                let along = phase.at(share * phase.duration_s);
                let walked = cursor.at(&trajectory, phase_from + share * phase.duration_s);
                let jet = trajectory.pieces[0].at(along.sigma.min(trajectory.pieces[0].length));
                let [places, slopes, ..] = jet;
                for (walked, place) in walked.position.iter().zip(places) {
                    assert!((walked - place).abs() < 1e-12);
                }
                for (walked, slope) in walked.velocity.iter().zip(slopes) {
                    assert!((walked - slope * along.speed).abs() < 1e-10);
                }
            }
            phase_from += phase.duration_s;
        }
    }
}

#[test]
fn cuts_in_a_line_change_no_setpoint() {
    let whole = line([0.0; AXES], X, 100.0, 1);
    let pieces = |n: usize| straight([n as f64 * 0.5, 0.0, 0.0, 0.0, 0.0, 0.0], X, 0.5, 1);
    let cut = LAW.trajectory((0..200).map(pieces).collect());
    let (whole, cut) = (PlannerStep::Trajectory(&whole), PlannerStep::Trajectory(&cut));
    for (a, b) in sampled(0.001, &[whole]).iter().zip(sampled(0.001, &[cut])) {
        assert!((a.position[0] - b.position[0]).abs() < 1e-12);
        assert_eq!(a.velocity, b.velocity);
    }
}

#[test]
fn nothing_at_all_is_one_setpoint() {
    let samples = sampled(0.001, &[PlannerStep::Trajectory(&PlannedTrajectory::default())]);
    assert_eq!(samples, [MotionSample::default()]);
}

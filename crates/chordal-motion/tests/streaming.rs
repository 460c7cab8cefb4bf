//! The stream between a planner and a servo loop.

mod support;

use chordal_geometry::AXES;
use chordal_motion::{
    CornerMode, MoveRequest, PathPiece, PlannedTrajectory, PlannerStep, PushOutcome, ServoSetpoint,
    StreamOptions, stream,
};
use support::law::{Law, circle_trajectory, cut_line, piece};
use support::watch::{AXIS_ROUNDING, Watch};
use support::{cut, limits, line};

const LIMITS: (f64, f64, f64) = (200.0, 2000.0, 1e5);

fn machine() -> chordal_motion::KinematicLimits {
    limits(LIMITS.0, LIMITS.1, LIMITS.2)
}

fn ramp(pieces: Vec<PathPiece>, speed: f64, acceleration: f64, jerk: f64) -> PlannedTrajectory {
    Law { speed, acceleration, jerk }.trajectory(pieces)
}

#[test]
fn a_line_is_travelled_as_planned_and_ends_exactly() {
    let planned = ramp(vec![piece(line([0.0; 3], [100.0, 0.0, 0.0]), 7)], 100.0, 1900.0, 9e4);
    let duration_s = planned.duration_s();
    let (mut feeder, mut servo) = stream(machine(), StreamOptions::default(), [0.0; AXES]);
    assert_eq!(feeder.push_step(PlannerStep::Trajectory(&planned)), Ok(PushOutcome::Taken));
    assert!(feeder.finish());
    let mut watch = Watch::default();
    let mut cursor = chordal_motion::TrajectoryCursor::default();
    let mut point = ServoSetpoint::default();
    let mut count = 0;
    while !point.finished {
        point = servo.next();
        count += 1;
        let state = cursor.at(&planned, f64::from(count) * 0.001);
        assert!((point.position[0] - state.position[0]).abs() < 1e-9, "{point:?} {state:?}");
        assert_eq!(point.tag, 7);
        watch.take(&point, 0.001, &machine());
        assert!(count < 5000, "the end is not reached: {point:?}");
    }
    assert_eq!(point.position, [100.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert!((f64::from(count) * 0.001 - duration_s).abs() <= 0.001 + 1e-9);
    assert_eq!(servo.underruns(), 0);
    watch.check(0.001, &machine(), &AXIS_ROUNDING);
}

/// Pulls with commands by the count of the setpoint until the end.
fn run(
    trajectories: &[PlannedTrajectory],
    period_s: f64,
    mut command: impl FnMut(usize, &mut chordal_motion::StreamServo),
) -> Vec<ServoSetpoint> {
    let options = StreamOptions { period_s, ..StreamOptions::default() };
    let (mut feeder, mut servo) = stream(machine(), options, trajectories[0].from());
    let mut left = trajectories.iter();
    let mut next = left.next();
    let mut points = Vec::new();
    let mut watch = Watch::default();
    loop {
        while let Some(trajectory) = next {
            match feeder.push_step(PlannerStep::Trajectory(trajectory)).expect("not finished") {
                PushOutcome::Taken => next = left.next(),
                PushOutcome::Full => break,
            }
        }
        if next.is_none() {
            feeder.finish();
        }
        command(points.len(), &mut servo);
        let point = servo.next();
        watch.take(&point, period_s, &machine());
        points.push(point);
        if point.finished {
            break;
        }
        assert!(points.len() < 400_000, "the end is not reached: {point:?}");
    }
    watch.check(period_s, &machine(), &AXIS_ROUNDING);
    assert_eq!(servo.underruns(), 0);
    points
}

#[test]
fn a_hold_stops_quickly_and_the_motion_goes_on_after_it() {
    for (period_s, at) in [(0.001, 500), (0.00025, 2000), (0.001, 20), (0.001, 1090)] {
        let planned = ramp(vec![piece(line([0.0; 3], [200.0, 0.0, 0.0]), 1)], 190.0, 1940.0, 9.7e4);
        let mut stopped = None;
        let mut count = 0;
        let points = run(&[planned], period_s, |index, servo| {
            count = index;
            if index == at {
                servo.hold();
            }
            if index == 3 * at + 1000 {
                servo.resume();
            }
        });
        for (index, point) in points.iter().enumerate().skip(at) {
            if point.rate == 0.0 && stopped.is_none() {
                stopped = Some(index);
                assert_eq!(point.velocity, [0.0; AXES]);
                assert_eq!(points[index + 10].position, point.position);
            }
        }
        // A hold in the last ramp finds the end of the line.
        let took = (stopped.unwrap_or(points.len()) - at) as f64 * period_s;
        // v/a + a/j of the machine is 0.12 s; a ramp of the plan may have to end before.
        assert!(took <= 0.125, "{took} s");
        assert_eq!(points.last().expect("an end").position[0], 200.0);
        assert!(points.windows(2).all(|pair| pair[1].position[0] >= pair[0].position[0]));
    }
}

#[test]
fn a_circle_holds_its_axes_under_hold_and_override() {
    for radius in [0.5, 2.0, 20.0] {
        let planned = circle_trajectory(radius, 20.0, 3);
        let points = run(std::slice::from_ref(&planned), 0.001, |index, servo| match index % 700 {
            100 => servo.set_override(0.4),
            200 => servo.hold(),
            400 => servo.resume(),
            500 => servo.set_override(2.0),
            690 => servo.set_override(1.0),
            _ => {}
        });
        for point in &points {
            let off = point.position[0].hypot(point.position[1]) - radius;
            assert!(off.abs() < 1e-9, "{off}");
        }
        let fast = points.iter().map(|point| point.rate).fold(0.0, f64::max);
        assert!(fast > 1.2, "an override above 100 % is used: {fast}");
        let end = points.last().expect("an end").position;
        assert!((end[0] - planned.to()[0]).abs() < 1e-9, "{end:?}");
    }
}

#[test]
fn windows_that_do_not_come_are_a_stop_and_later_ones_go_on_in_it() {
    // The second half of a line comes late by more and more.
    for late in [0, 5, 20, 40, 80, 300] {
        let planned = ramp(cut_line([0.0; 3], [150.0, 80.0, 0.0], 500), 150.0, 1900.0, 9e4);
        // Two windows are all there is, so that the pull side runs dry when nothing is pushed.
        let options = StreamOptions { windows: 3, ..StreamOptions::default() };
        let (mut feeder, mut servo) = stream(machine(), options, [0.0; AXES]);
        assert_eq!(feeder.push_step(PlannerStep::Trajectory(&planned)), Ok(PushOutcome::Taken));
        let mut watch = Watch::default();
        let mut point = ServoSetpoint::default();
        let mut last = [0.0; AXES];
        for index in 0.. {
            // Every 400 setpoints the push side is away for a while.
            if index % 400 < 400 - late {
                feeder.finish();
            }
            point = servo.next();
            watch.take(&point, 0.001, &machine());
            assert!(point.position[0] >= last[0]);
            let off = point.position[1] * 150.0 - point.position[0] * 80.0;
            assert!(off.abs() < 1e-9 * 170.0, "{off}");
            last = point.position;
            if point.finished || index > 20_000 {
                break;
            }
        }
        assert!(point.finished);
        assert_eq!(servo.underruns() > 0, late == 300, "{}", servo.underruns());
        assert_eq!(point.position, planned.to());
        watch.check(0.001, &machine(), &AXIS_ROUNDING);
    }
}

#[test]
fn pieces_of_a_nanometre_are_travelled_within_the_limits() {
    let planned = ramp(cut_line([0.0; 3], [0.05, 0.02, 0.0], 50_000), 100.0, 1900.0, 9e4);
    let duration_s = planned.duration_s();
    for pieces in [1000, 16_384] {
        let options = StreamOptions { pieces, ..StreamOptions::default() };
        let (mut feeder, mut servo) = stream(machine(), options, [0.0; AXES]);
        assert_eq!(feeder.push_step(PlannerStep::Trajectory(&planned)), Ok(PushOutcome::Taken));
        let mut watch = Watch::default();
        let mut point = ServoSetpoint::default();
        let mut count = 0;
        while !point.finished && count < 100_000 {
            feeder.finish();
            point = servo.next();
            watch.take(&point, 0.001, &machine());
            count += 1;
        }
        assert!(point.finished, "{pieces} pieces: {point:?}");
        assert!((point.position[0] - 0.05).abs() < 1e-9);
        watch.check(0.001, &machine(), &AXIS_ROUNDING);
        if pieces > 16_000 {
            // Where a window holds enough path, nothing is lost.
            assert!(f64::from(count) * 0.001 < 3.0 * duration_s, "{count} for {duration_s} s");
        }
    }
}

/// A circle of radius 30 as 300 lines, eased within a hundredth: the plan is at its limits of
/// jerk in every corner.
fn polygon() -> Vec<MoveRequest> {
    let at = |corner: u32| {
        let angle = f64::from(corner) / 300.0 * std::f64::consts::TAU;
        [30.0 * angle.cos(), 30.0 * angle.sin(), 0.0]
    };
    let within = CornerMode::Joined { linear_mm: 0.01, rotary_rad: 0.0 };
    let side = |corner| cut(line(at(corner), at(corner + 1)), 150.0, within);
    (0..300).map(|corner| MoveRequest { tag: u64::from(corner), ..side(corner) }).collect()
}

#[test]
fn a_hold_in_eased_corners_stops_in_bounded_time_and_sooner_with_headroom() {
    let mut took = Vec::new();
    for headroom in [0.0, 0.03, 0.1, 0.3] {
        let options = StreamOptions { headroom, ..StreamOptions::default() };
        let moves = polygon();
        let (mut feeder, mut servo) = stream(machine(), options, moves[0].from());
        for motion in &moves {
            assert_eq!(feeder.push(motion), Ok(PushOutcome::Taken));
        }
        feeder.finish();
        let mut watch = Watch::default();
        let mut count = 0;
        loop {
            feeder.finish();
            if count == 500 {
                servo.hold();
            }
            let point = servo.next();
            watch.take(&point, 0.001, &machine());
            if point.rate == 0.0 {
                break;
            }
            count += 1;
            assert!(count < 3000, "no stop: {point:?}");
        }
        watch.check(0.001, &machine(), &AXIS_ROUNDING);
        took.push(f64::from(count - 500) * 0.001);
    }
    assert!(took[1] < 0.5 && took[3] < 0.25, "{took:?}");
}

//! The time that cannot be beaten without limits of jerk, against worked figures.

mod support;

use chordal_motion::{PathPiece, PathRun, PathRunError, time_bound};
use support::figures::{arc, bang_bang, ellipse, near};
use support::law::straight_piece as line;
use support::limits;

#[test]
fn a_line_takes_two_ramps_and_the_distance_between() {
    let pieces = [line([0.0; 3], [100.0, 0.0, 0.0])];
    let limits = limits(500.0, 5000.0, 1e5);
    let run = PathRun::new(&pieces, &[f64::INFINITY], 0.0, &limits).unwrap();
    near(time_bound(&run).time_s, bang_bang(100.0, 500.0, 5000.0), 1e-4);
    let run = PathRun::new(&pieces, &[100.0], 0.0, &limits).unwrap();
    near(time_bound(&run).time_s, bang_bang(100.0, 100.0, 5000.0), 1e-4);
}

#[test]
fn a_lap_of_the_ellipse_takes_0_468_s() {
    let machine = limits(500.0, 5000.0, 1e5);
    let time = |count| {
        let pieces = ellipse(30.0, 10.0, count);
        let speeds = vec![f64::INFINITY; pieces.len()];
        time_bound(&PathRun::new(&pieces, &speeds, 0.0, &machine).unwrap()).time_s
    };
    near(time(400), 0.468, 1e-3);
    // The cut of the path into pieces does not matter.
    near(time(1600), time(400), 1e-4);
}

#[test]
fn a_circle_is_capped_where_an_axis_turns_alone() {
    // Where the tangent of a circle is parallel to an axis, the other axis takes all of v²/R:
    // v ≤ √(AR), and between there is room. A lap at that speed is slower than the bound, one at
    // √2·AR everywhere is faster.
    let machine = limits(200.0, 2000.0, 1e5);
    let pieces = [arc(2.0, 20.0, 0.0)];
    let run = PathRun::new(&pieces, &[f64::INFINITY], 0.0, &machine).unwrap();
    let time = time_bound(&run).time_s;
    let slow = (2000.0f64 * 2.0).sqrt();
    assert!(time < pieces[0].length / slow + slow / 2000.0);
    assert!(time > pieces[0].length / (slow * 2.0f64.sqrt().sqrt()));
}

#[test]
fn the_speed_at_the_start_is_used() {
    let machine = limits(500.0, 5000.0, 1e5);
    let pieces = [line([0.0; 3], [10.0, 0.0, 0.0])];
    let run = PathRun::new(&pieces, &[50.0], 50.0, &machine).unwrap();
    near(time_bound(&run).time_s, (10.0 - 0.25) / 50.0 + 0.01, 1e-4);
}

#[test]
fn hundred_thousand_pieces() {
    let pieces: Vec<PathPiece> = (0..100_000)
        .map(|k| line([0.01 * f64::from(k), 0.0, 0.0], [0.01 * f64::from(k + 1), 0.0, 0.0]))
        .collect();
    let machine = limits(500.0, 5000.0, 1e5);
    let run = PathRun::new(&pieces, &[400.0; 100_000], 0.0, &machine).unwrap();
    near(time_bound(&run).time_s, bang_bang(1000.0, 400.0, 5000.0), 1e-4);
}

#[test]
fn what_is_no_run_is_refused() {
    let machine = limits(500.0, 5000.0, 1e5);
    let one = [line([0.0; 3], [10.0, 0.0, 0.0])];
    let refused = |pieces: &[PathPiece], speeds: &[f64], start: f64| {
        PathRun::new(pieces, speeds, start, &machine).map(|_| ()).unwrap_err()
    };
    assert_eq!(refused(&one, &[], 0.0), PathRunError::Count { pieces: 1, speeds: 0 });
    assert_eq!(refused(&[], &[], 0.0), PathRunError::Empty);
    assert_eq!(refused(&one, &[0.0], 0.0), PathRunError::NotPositive(0));
    assert_eq!(refused(&one, &[f64::NAN], 0.0), PathRunError::NotPositive(0));
    assert_eq!(refused(&one, &[1.0], -1.0), PathRunError::Start(-1.0));
    let mut still = one;
    still[0].length = 0.0;
    assert_eq!(refused(&still, &[1.0], 0.0), PathRunError::Empty);
    still[0].length = f64::NAN;
    assert_eq!(refused(&still, &[1.0], 0.0), PathRunError::NotPositive(0));
}

//! The time that cannot be beaten without limits of jerk, against worked figures.

mod shapes;

use chordal_motion::{Run, bound};
use shapes::{arc, bang_bang, ellipse, limits, line, near};

#[test]
fn a_line_takes_two_ramps_and_the_way_between() {
    let pieces = [line([0.0; 3], [100.0, 0.0, 0.0])];
    let limits = limits(500.0, 5000.0, 1e5);
    let run = Run::new(&pieces, &[f64::INFINITY], 0.0, &limits).unwrap();
    near(bound(&run).time_s, bang_bang(100.0, 500.0, 5000.0), 1e-4);
    let run = Run::new(&pieces, &[100.0], 0.0, &limits).unwrap();
    near(bound(&run).time_s, bang_bang(100.0, 100.0, 5000.0), 1e-4);
}

#[test]
fn an_ellipse_takes_0_468_s() {
    let pieces = ellipse(30.0, 10.0, 400);
    let speeds = vec![f64::INFINITY; pieces.len()];
    let run = Run::new(&pieces, &speeds, 0.0, &limits(500.0, 5000.0, 1e5)).unwrap();
    near(bound(&run).time_s, 0.468, 2e-3);
}

#[test]
fn print() {
    let pieces = [arc(20.0, 1.0, 0.0)];
    let run = Run::new(&pieces, &[100.0], 0.0, &limits(200.0, 2000.0, 1e5)).unwrap();
    let b = bound(&run);
    println!("{} {}", b.time_s, b.sigma.len());
    let pieces = [arc(2.0, 5.0, 0.0)];
    let run = Run::new(&pieces, &[100.0], 0.0, &limits(200.0, 2000.0, 1e5)).unwrap();
    let b = bound(&run);
    println!("{} {}", b.time_s, b.sigma.len());
    let pieces = ellipse(30.0, 10.0, 400);
    let speeds = vec![f64::INFINITY; pieces.len()];
    let run = Run::new(&pieces, &speeds, 0.0, &limits(500.0, 5000.0, 1e5)).unwrap();
    let b = bound(&run);
    println!("{} {}", b.time_s, b.sigma.len());
}

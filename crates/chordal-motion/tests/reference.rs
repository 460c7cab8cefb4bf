//! The least time with limits of jerk, against worked figures.

mod shapes;

use chordal_motion::{Effort, Law, Limits, Piece, Run, best, bound, reference};
use shapes::{arc, ellipse, limits, line, near, seven_phases};

fn solve(pieces: &[Piece], speed: f64, limits: &Limits) -> (f64, Law) {
    let speeds = vec![speed; pieces.len()];
    let run = Run::new(pieces, &speeds, 0.0, limits).unwrap();
    let bound = bound(&run);
    let law = reference(&run, &bound, &Effort::default()).unwrap();
    println!(
        "bound {:.5} reference {:.5} change {:.1e} nodes {}",
        bound.time_s,
        law.time_s,
        law.change_s,
        law.sigma.len()
    );
    println!("best {:?}", best(&run, &law).map(|b| b.time_s));
    (bound.time_s, law)
}

#[test]
fn a_line_takes_its_seven_phases() {
    for (way, speed) in [(100.0, 500.0), (100.0, 100.0), (1.0, 500.0), (0.01, 500.0)] {
        let pieces = [line([0.0; 3], [way, 0.0, 0.0])];
        let (_, law) = solve(&pieces, speed, &limits(500.0, 5000.0, 1e5));
        near(law.time_s, seven_phases(way, speed, 5000.0, 1e5), 2e-3);
    }
}

#[test]
fn print() {
    solve(&ellipse(30.0, 10.0, 400), f64::INFINITY, &limits(500.0, 5000.0, 1e5));
    solve(&[arc(20.0, 1.0, 0.0)], 100.0, &limits(200.0, 2000.0, 1e5));
    solve(&[arc(2.0, 5.0, 0.0)], 100.0, &limits(200.0, 2000.0, 1e5));
    solve(&[arc(10.0, 3.0, 15.0)], 100.0, &limits(200.0, 2000.0, 1e5));
}

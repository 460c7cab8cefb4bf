//! One lap of an ellipse with half axes of 30 and 10 mm, as chords, at the fast level. Published
//! for 500 mm/s, 5000 mm/s² and 1e5 mm/s³ an axis: 0.468 s without jerk, 0.541 s with it, 0.590 s
//! by LinuxCNC with twenty times the jerk.

mod support;

use chordal_motion::{CornerMode, LimitUse, MoveRequest, PlannerLevel, largest_use};
use support::{cut, limits, line, plan, samples, time_of};

/// Chords of equal angle.
fn lap(count: u32, linear_mm: f64) -> Vec<MoveRequest> {
    let at = |i: u32| {
        let angle = f64::from(i % count) / f64::from(count) * std::f64::consts::TAU;
        [30.0 * angle.cos(), 10.0 * angle.sin(), 0.0]
    };
    let within = CornerMode::Joined { linear_mm, rotary_rad: 1e-4 };
    let chord = |i: u32| cut(line(at(i), at(i + 1)), 1e6, within);
    (0..count).map(|i| MoveRequest { tag: u64::from(i), ..chord(i) }).collect()
}

#[test]
fn a_lap_is_near_the_least_time_and_holds_every_limit() {
    let limits = limits(500.0, 5000.0, 1e5);
    for (count, tolerance) in [(1336, 0.01), (600, 0.01), (1336, 0.05)] {
        let moves = lap(count, tolerance);
        let trajectories = plan(&moves, limits, PlannerLevel::Fast);
        let time = time_of(&trajectories);
        println!("{count} chords within {tolerance} mm: {time:.4} s");
        let used = trajectories
            .iter()
            .map(|s| largest_use(s, &limits, 5))
            .fold(LimitUse::default(), LimitUse::or);
        let worst = used.velocity.max(used.acceleration).max(used.jerk);
        assert!(worst <= 1.0 + 1e-6, "{used:?}");
        assert!(time > 0.468, "{time} s is less than the bound");
        for sample in samples(&trajectories, 1e-3) {
            let [x, y, ..] = sample.position;
            // Distance from the ellipse to first order, the sagitta of a chord next to it.
            let gradient = (x * x / 810_000.0 + y * y / 10_000.0).sqrt() * 2.0;
            let off = ((x / 30.0).powi(2) + (y / 10.0).powi(2) - 1.0).abs() / gradient;
            assert!(off <= tolerance + 0.001, "{off} mm off at {} s", sample.time_s);
        }
    }
}

//! The path of a rapid: straight, or with each axis at its own speed.

use chordal_command::{Position, RapidPath};
use chordal_machine::{AXES, Machine, PerAxis};

/// The time of a rapid without acceleration, s. Axes without a known speed take no time.
pub(crate) fn rapid_time_s(machine: &Machine, from: &Position, to: &Position) -> f64 {
    (0..AXES).map(|axis| axis_time_s(machine, axis, from, to)).fold(0.0, f64::max)
}

fn axis_time_s(machine: &Machine, axis: usize, from: &Position, to: &Position) -> f64 {
    let speed = machine.axes[axis].as_ref().and_then(|limits| limits.max_velocity);
    let course = (to[axis] - from[axis]).abs();
    match speed {
        Some(speed) if speed > 0.0 => course / speed,
        _ => 0.0,
    }
}

/// Passes the corners of a rapid after its start to `push`, each with the time from the corner before it, s: one point
/// if it is straight, otherwise one for each time at which an axis arrives.
pub fn rapid_corners(
    machine: &Machine,
    path: RapidPath,
    from: &Position,
    to: &Position,
    mut push: impl FnMut(&Position, f64),
) {
    let total = rapid_time_s(machine, from, to);
    let mut times: PerAxis<f64> = std::array::from_fn(|axis| axis_time_s(machine, axis, from, to));
    if let RapidPath::AtFeed(speed) = path {
        let length = (0..3).map(|axis| (to[axis] - from[axis]).powi(2)).sum::<f64>().sqrt();
        return push(to, total.max(length / speed));
    }
    if path == RapidPath::Straight || total == 0.0 {
        return push(to, total);
    }
    let arrivals = times;
    times.sort_unstable_by(f64::total_cmp);
    let mut before = 0.0;
    for time in times {
        if time <= before {
            continue;
        }
        let mut place = *to;
        for axis in 0..AXES {
            if arrivals[axis] > time {
                place[axis] = from[axis] + (to[axis] - from[axis]) * (time / arrivals[axis]);
            }
        }
        push(&place, time - before);
        before = time;
    }
}

//! Paths and figures that several tests use.

#![allow(dead_code, reason = "each test uses some of them")]

use chordal_geometry::{Arc, Curve, Plane};
use chordal_motion::{AxisLimit, Limits, Piece};
use core::f64::consts::TAU;

/// The same limits on X, Y and Z.
pub fn limits(velocity: f64, acceleration: f64, jerk: f64) -> Limits {
    let axis = Some(AxisLimit { velocity, acceleration, jerk });
    Limits::new([axis, axis, axis, None, None, None]).unwrap()
}

/// A straight piece.
pub fn line(from: [f64; 3], to: [f64; 3]) -> Piece {
    let length = (0..3).map(|i| (to[i] - from[i]).powi(2)).sum::<f64>().sqrt();
    let mut start = [[0.0; 6]; 4];
    for axis in 0..3 {
        start[0][axis] = from[axis];
        start[1][axis] = (to[axis] - from[axis]) / length;
    }
    Piece { length, base: None, start, tag: 0 }
}

/// Turns of a circle or a helix about Z.
pub fn arc(radius: f64, turns: f64, rise: f64) -> Piece {
    let arc = Arc::new(Plane::Xy.frame(), radius, TAU * turns, rise);
    let length = chordal_geometry::ParamCurve::length(&arc);
    Piece { length, base: Some((Curve::Arc(arc), 0.0)), start: [[0.0; 6]; 4], tag: 0 }
}

/// One lap of an ellipse as cubics in arc length, from (a, 0): each piece interpolates position
/// and tangent at its ends (cubic Hermite), so that position and direction are continuous and
/// the curvature steps by no more than O(h²).
pub fn ellipse(a: f64, b: f64, count: usize) -> Vec<Piece> {
    let speed = |u: f64| ((a * u.sin()).powi(2) + (b * u.cos()).powi(2)).sqrt();
    (0..count)
        .map(|index| {
            let (u0, u1) =
                (TAU * index as f64 / count as f64, TAU * (index + 1) as f64 / count as f64);
            // Arc length by Gauss's rule with three nodes.
            let (mid, half) = (0.5 * (u0 + u1), 0.5 * (u1 - u0));
            let off = half * 0.6f64.sqrt();
            let length = half / 9.0
                * (5.0 * speed(mid - off) + 8.0 * speed(mid) + 5.0 * speed(mid + off));
            let at = |u: f64| {
                let v = speed(u);
                ([a * u.cos(), b * u.sin()], [-a * u.sin() / v, b * u.cos() / v])
            };
            let ((p0, t0), (p1, t1)) = (at(u0), at(u1));
            let mut start = [[0.0; 6]; 4];
            for axis in 0..2 {
                let slope = (p1[axis] - p0[axis]) / length;
                start[0][axis] = p0[axis];
                start[1][axis] = t0[axis];
                start[2][axis] = (6.0 * slope - 4.0 * t0[axis] - 2.0 * t1[axis]) / length;
                start[3][axis] = 6.0 * (t0[axis] + t1[axis] - 2.0 * slope) / (length * length);
            }
            Piece { length, base: None, start, tag: index as u64 }
        })
        .collect()
}

/// From rest to rest in one axis without a limit of jerk.
pub fn bang_bang(way: f64, v: f64, a: f64) -> f64 {
    if way >= v * v / a { way / v + v / a } else { 2.0 * (way / a).sqrt() }
}

/// From rest to rest in one axis with a limit of jerk: seven phases, or fewer where the way is
/// short.
pub fn seven_phases(way: f64, v: f64, a: f64, j: f64) -> f64 {
    let ramp = |speed: f64| {
        if speed * j <= a * a { 2.0 * (speed / j).sqrt() } else { speed / a + a / j }
    };
    if way >= v * ramp(v) {
        return way / v + ramp(v);
    }
    let (mut low, mut high) = (0.0, v);
    for _ in 0..200 {
        let mid = 0.5 * (low + high);
        if mid * ramp(mid) <= way { low = mid } else { high = mid }
    }
    2.0 * ramp(low)
}

/// Two numbers agree to a share of the second.
#[track_caller]
pub fn near(value: f64, expected: f64, share: f64) {
    assert!((value - expected).abs() <= share * expected.abs(), "{value}, not {expected}");
}

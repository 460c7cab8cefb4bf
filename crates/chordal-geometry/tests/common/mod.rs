//! Random curves, and slow ways to the same answers that share nothing with the library's.
#![allow(dead_code)] // Each test file uses a part.

use chordal_geometry::{Arc, Curve, Frame, Line, ParamCurve, Plane, Spiral, Transform, Vec3};
use proptest::prelude::*;

pub const TAU: f64 = core::f64::consts::TAU;

/// A coordinate in the range of a machine, mm.
pub fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -200.0..200.0, 1 => Just(0.0)]
}

pub fn point() -> impl Strategy<Value = Vec3> {
    (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

/// Coordinate planes and tilted ones.
pub fn frame() -> impl Strategy<Value = Frame> {
    let tilted = (point(), -1.0..1.0, 0.0..TAU, 0.0..TAU).prop_map(|(origin, z, turn, roll)| {
        let across = f64::sqrt(1.0 - z * z);
        let w = Vec3::new(across * libm::cos(turn), across * libm::sin(turn), z);
        let side = Vec3::new(libm::cos(roll), libm::sin(roll), 0.37);
        Frame::from_normal(origin, w, side).unwrap_or(Frame::IDENTITY)
    });
    let plane = (point(), prop_oneof![Just(Plane::Xy), Just(Plane::Zx), Just(Plane::Yz)])
        .prop_map(|(origin, plane)| Frame { origin, ..plane.frame() });
    prop_oneof![tilted, plane]
}

/// Less than a turn, some turns, or many.
pub fn sweep() -> impl Strategy<Value = f64> {
    let size = prop_oneof![4 => 0.01..TAU, 1 => Just(TAU), 2 => TAU..30.0, 1 => 30.0..300.0];
    (size, any::<bool>()).prop_map(|(s, back)| if back { -s } else { s })
}

pub fn rise() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(0.0), 2 => -50.0..50.0, 1 => -2000.0..2000.0]
}

pub fn radius() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 0.1..100.0, 1 => 0.001..0.1, 1 => 100.0..5000.0]
}

pub fn line() -> impl Strategy<Value = Line> {
    (point(), point()).prop_map(|(a, b)| Line::new(a, b))
}

pub fn arc() -> impl Strategy<Value = Arc> {
    (frame(), radius(), sweep(), rise()).prop_map(|(f, r, sw, h)| Arc::new(f, r, sw, h))
}

pub fn spiral() -> impl Strategy<Value = Spiral> {
    let radii = prop_oneof![
        4 => (radius(), radius()),
        1 => (Just(0.0), radius()),
        1 => (radius(), Just(0.0)),
        // Equal but for what a control forgives.
        2 => (radius(), -1e-4..1e-4).prop_map(|(r, d)| (r, r + d)),
        1 => (radius(), -1e-12..1e-12).prop_map(|(r, d)| (r, r + d)),
    ];
    (frame(), radii, sweep(), rise()).prop_map(|(f, r, sw, h)| Spiral::new(f, r, sw, h))
}

pub fn curve() -> impl Strategy<Value = Curve> {
    prop_oneof![
        1 => line().prop_map(Curve::from),
        3 => arc().prop_map(Curve::from),
        3 => spiral().prop_map(Curve::from),
    ]
}

pub fn transform() -> impl Strategy<Value = Transform> {
    (frame(), point(), any::<bool>(), 0.1..10.0_f64).prop_map(|(f, by, flip, k)| {
        let t = Transform::from_frame(f)
            .then(&Transform::scale(k).unwrap())
            .then(&Transform::translation(by));
        if flip { t.then(&Transform::mirror(Vec3::new(1.0, 2.0, -0.5), by)) } else { t }
    })
}

/// The point at a fraction of the sweep (of the way, on a line), from the defining formula.
pub fn at_fraction(c: &Curve, t: f64) -> Vec3 {
    let turn = |center: Vec3, u: Vec3, w: Vec3, r: f64, sweep: f64, rise: f64| {
        let v = w.cross(u);
        let phi = sweep * t;
        center + u * (r * libm::cos(phi)) + v * (r * libm::sin(phi)) + w * (rise * t)
    };
    match c {
        Curve::Line(l) => l.start + (l.end - l.start) * t,
        Curve::Arc(a) => turn(a.center, a.u, a.w, a.radius, a.sweep, a.rise),
        Curve::Spiral(s) => {
            let r = s.radius_start + (s.radius_end - s.radius_start) * t;
            turn(s.center, s.u, s.w, r, s.sweep, s.rise)
        }
        // Splines have tests of their own (`splines.rs`).
        Curve::Spline(piece) => piece.point_at(t * piece.length()),
    }
}

/// Length of the curve between two fractions, from polylines alone, extrapolated to an infinity of
/// sides (Romberg).
pub fn length_by_polylines(c: &Curve, t0: f64, t1: f64) -> f64 {
    let turns = match c {
        Curve::Line(_) | Curve::Spline(_) => 0.0,
        Curve::Arc(a) => a.sweep.abs() * (t1 - t0),
        Curve::Spiral(s) => s.sweep.abs() * (t1 - t0),
    };
    // Pieces of half a radian, each extrapolated on its own.
    let pieces = (2.0 * turns).ceil().max(1.0);
    let mut total = 0.0;
    for piece in 0..pieces as usize {
        let from = t0 + (t1 - t0) * piece as f64 / pieces;
        let to = t0 + (t1 - t0) * (piece + 1) as f64 / pieces;
        total += romberg(c, from, to);
    }
    total
}

fn romberg(c: &Curve, t0: f64, t1: f64) -> f64 {
    const LEVELS: usize = 7;
    let mut row = [0.0; LEVELS];
    for level in 0..LEVELS {
        let n = 1usize << level;
        let mut sum = 0.0;
        let mut before = at_fraction(c, t0);
        for i in 1..=n {
            let p = at_fraction(c, t0 + (t1 - t0) * i as f64 / n as f64);
            sum += before.distance(p);
            before = p;
        }
        let mut value = sum;
        let mut factor = 4.0;
        for entry in row.iter_mut().take(level) {
            let better = value + (value - *entry) / (factor - 1.0);
            *entry = value;
            value = better;
            factor *= 4.0;
        }
        row[level] = value;
    }
    row[LEVELS - 1]
}

/// The fastest the direction from the axis turns, radians per mm, plus one over the length: what a
/// small step is small against.
pub fn rate_of(c: &Curve) -> f64 {
    let rate = match c {
        Curve::Line(_) | Curve::Spline(_) => 0.0,
        Curve::Arc(a) => a.sweep.abs() / a.length(),
        Curve::Spiral(s) => {
            let around = s.radius_start.min(s.radius_end) * s.sweep;
            let growth = s.radius_end - s.radius_start;
            let speed = (around * around + growth * growth + s.rise * s.rise).sqrt();
            s.sweep.abs() / speed
        }
    };
    rate + 1.0 / c.length()
}

/// A length that says how large the numbers are, for tolerances of rounding.
pub fn scale_of(c: &Curve) -> f64 {
    let reach = c.bounds();
    1.0 + c.length() + reach.min.length() + reach.max.length()
}

/// Distance from `p` to the segment `a`–`b`.
pub fn distance_to_segment(p: Vec3, a: Vec3, b: Vec3) -> f64 {
    let along = b - a;
    let q = along.length_squared();
    let t = if q > 0.0 { ((p - a).dot(along) / q).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(a + along * t)
}

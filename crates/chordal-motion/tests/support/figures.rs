//! Paths of which the least time is known, and such times.

use super::law::piece;
use chordal_geometry::{AXES, Arc, Plane};
use chordal_motion::PathPiece;
use core::f64::consts::TAU;

/// Turns of a circle or a helix about Z.
pub fn arc(radius: f64, turns: f64, rise: f64) -> PathPiece {
    piece(Arc::new(Plane::Xy.frame(), radius, TAU * turns, rise).into(), 0)
}

/// One lap of an ellipse from (a, 0): the periodic cubic spline in arc length through points at
/// even angles, so that curvature is continuous; it is off the ellipse by O(h⁴).
pub fn ellipse(a: f64, b: f64, count: usize) -> Vec<PathPiece> {
    let speed = |u: f64| ((a * u.sin()).powi(2) + (b * u.cos()).powi(2)).sqrt();
    let angle = |index: usize| TAU * (index % count) as f64 / count as f64;
    let point = |index: usize| [a * angle(index).cos(), b * angle(index).sin()];
    let lengths: Vec<f64> = (0..count)
        .map(|index| {
            // Arc length by Gauss's rule with three nodes.
            let half = 0.5 * TAU / count as f64;
            let mid = angle(index) + half;
            let off = half * 0.6f64.sqrt();
            half / 9.0 * (5.0 * speed(mid - off) + 8.0 * speed(mid) + 5.0 * speed(mid + off))
        })
        .collect();
    // Second derivatives at the knots: the usual equations, by Gauss and Seidel.
    let mut second = vec![[0.0; 2]; count];
    for _ in 0..60 {
        for index in 0..count {
            let before = (index + count - 1) % count;
            let (h0, h1) = (lengths[before], lengths[index]);
            for axis in 0..2 {
                let (p0, p1, p2) = (point(before), point(index), point(index + 1));
                let turn = (p2[axis] - p1[axis]) / h1 - (p1[axis] - p0[axis]) / h0;
                let next_to = h0 * second[before][axis] + h1 * second[(index + 1) % count][axis];
                second[index][axis] = (6.0 * turn - next_to) / (2.0 * (h0 + h1));
            }
        }
    }
    (0..count)
        .map(|index| {
            let h = lengths[index];
            let (p0, p1) = (point(index), point(index + 1));
            let mut start = [[0.0; AXES]; 4];
            for axis in 0..2 {
                let (m0, m1) = (second[index][axis], second[(index + 1) % count][axis]);
                start[0][axis] = p0[axis];
                start[1][axis] = (p1[axis] - p0[axis]) / h - h * (2.0 * m0 + m1) / 6.0;
                start[2][axis] = m0;
                start[3][axis] = (m1 - m0) / h;
            }
            PathPiece { length: h, base: None, start, tag: index as u64 }
        })
        .collect()
}

/// Cubic pieces one after the other whose second derivatives are continuous: by piece its
/// length and, by axis, the turn: the second derivative at its end times its length or the next
/// one's, whichever is longer.
pub fn chain(steps: &[(f64, [f64; 4])]) -> Vec<PathPiece> {
    let mut jet = [[0.0; AXES]; 4];
    jet[1][0] = 1.0;
    let mut pieces = Vec::new();
    for (index, (length, turns)) in steps.iter().enumerate() {
        let longer = steps.get(index + 1).map_or(*length, |next| next.0.max(*length));
        for axis in 0..4 {
            jet[3][axis] = (turns[axis] / longer - jet[2][axis]) / length;
        }
        let piece = PathPiece { length: *length, base: None, start: jet, tag: 0 };
        jet = piece.at(*length);
        pieces.push(piece);
    }
    pieces
}

/// The same path from its end to its start.
pub fn reversed(pieces: &[PathPiece]) -> Vec<PathPiece> {
    pieces
        .iter()
        .rev()
        .map(|piece| {
            assert!(piece.base.is_none());
            let mut start = piece.at(piece.length);
            for row in [1, 3] {
                start[row].iter_mut().for_each(|value| *value = -*value);
            }
            PathPiece { start, ..*piece }
        })
        .collect()
}

/// The same path with all lengths `factor` times as long, turns of rotary axes too.
pub fn scaled(pieces: &[PathPiece], factor: f64) -> Vec<PathPiece> {
    pieces
        .iter()
        .map(|piece| {
            let mut start = piece.start;
            for (row, power) in [(0, 1), (2, -1), (3, -2)] {
                start[row].iter_mut().for_each(|value| *value *= factor.powi(power));
            }
            PathPiece { start, length: piece.length * factor, ..*piece }
        })
        .collect()
}

/// From rest to rest in one axis without a limit of jerk.
pub fn bang_bang(distance: f64, v: f64, a: f64) -> f64 {
    if distance >= v * v / a { distance / v + v / a } else { 2.0 * (distance / a).sqrt() }
}

/// Two numbers agree to a share of the second.
#[track_caller]
pub fn near(value: f64, expected: f64, share: f64) {
    assert!((value - expected).abs() <= share * expected.abs(), "{value}, not {expected}");
}

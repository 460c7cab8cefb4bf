//! Nested closed walls: a roughing pass along the finished contour.

use core::f64::consts::PI;

use chordal_geometry::Vec2;

use super::ContourBlock;
use super::shape::{GougeCurve, angle_of, wrapped};

/// If there are more closed walls than this, they are not compared.
const MAX_WALLS: usize = 2000;

/// Areas that differ by less than this fraction of the larger are those of one contour that is repeated.
const EQUAL_AREA_SHARE: f64 = 1e-6;

/// Drops the walls that another wall cuts away. If the tool is inside both of two nested contours, the larger one
/// remains; if it is outside both, the smaller one. An island in a pocket has the tool on the other side, and remains.
pub(super) fn drop_rough_passes(walls: &mut Vec<Vec<usize>>, chain: &[ContourBlock], side: f64) {
    if walls.len() < 2 || walls.len() > MAX_WALLS {
        return;
    }
    let areas: Vec<f64> = walls.iter().map(|wall| area(curves(wall, chain))).collect();
    let rough: Vec<bool> = (0..walls.len())
        .map(|rough| {
            (0..walls.len()).any(|kept| {
                let (inner, outer) = match areas[rough] * side > 0.0 {
                    true => (rough, kept),
                    false => (kept, rough),
                };
                areas[rough] * areas[kept] > 0.0
                    && areas[inner].abs() < areas[outer].abs() * (1.0 - EQUAL_AREA_SHARE)
                    && holds(&walls[outer], &walls[inner], chain)
            })
        })
        .collect();
    let mut rough = rough.into_iter();
    walls.retain(|_| !rough.next().unwrap_or(false));
}

fn curves<'a>(
    wall: &'a [usize],
    chain: &'a [ContourBlock],
) -> impl Iterator<Item = &'a GougeCurve> + Clone {
    wall.iter().map(|at| &chain[*at].curve)
}

/// Whether one closed contour is inside another, decided by the midpoints of its blocks.
fn holds(outer: &[usize], inner: &[usize], chain: &[ContourBlock]) -> bool {
    let (low, high) = corners(curves(outer, chain));
    let middles = || curves(inner, chain).map(|curve| curve.at(0.5));
    let in_box = |p: Vec2| p.a >= low.a && p.b >= low.b && p.a <= high.a && p.b <= high.b;
    middles().all(in_box) && middles().take(3).all(|p| is_inside(p, curves(outer, chain)))
}

fn corners<'a>(curves: impl Iterator<Item = &'a GougeCurve>) -> (Vec2, Vec2) {
    let mut low = Vec2::new(f64::INFINITY, f64::INFINITY);
    let mut high = -low;
    for bounds in curves.map(super::tree::TreeBox::of) {
        low = Vec2::new(low.a.min(bounds.min.a), low.b.min(bounds.min.b));
        high = Vec2::new(high.a.max(bounds.max.a), high.b.max(bounds.max.b));
    }
    (low, high)
}

/// The area of a closed contour, mm², positive if it is counter-clockwise.
fn area<'a>(curves: impl Iterator<Item = &'a GougeCurve>) -> f64 {
    let twice: f64 = curves
        .map(|curve| {
            let chord = curve.from().cross(curve.to());
            match *curve {
                GougeCurve::Line { .. } => chord,
                GougeCurve::Arc { radius, sweep, .. } => {
                    chord + radius * radius * (sweep - libm::sin(sweep))
                }
            }
        })
        .sum();
    0.5 * twice
}

/// Whether a point is inside a closed contour: the angles that its curves subtend at the point add up to a full turn.
fn is_inside<'a>(p: Vec2, curves: impl Iterator<Item = &'a GougeCurve>) -> bool {
    let seen: f64 = curves.map(|curve| subtended_angle(p, curve)).sum();
    seen.abs() > PI
}

fn subtended_angle(p: Vec2, curve: &GougeCurve) -> f64 {
    let chord = |from: Vec2, to: Vec2| wrapped(angle_of(to - p) - angle_of(from - p));
    match *curve {
        GougeCurve::Line { from, to } => chord(from, to),
        GougeCurve::Arc { sweep, .. } => {
            // In pieces of less than a right angle: at a point between chord and arc, the piece subtends the angle of the
            // chord plus a full turn.
            let pieces = libm::ceil(sweep.abs() / 1.5).max(1.0);
            (0..pieces as u32)
                .map(|k| {
                    let piece = curve.piece(f64::from(k) / pieces, f64::from(k + 1) / pieces);
                    let (from, to) = (piece.from(), piece.to());
                    let path = sweep.signum();
                    let beyond_chord = (to - from).cross(p - from) * path < 0.0;
                    let within_circle = piece.left_of(p) * path > 0.0;
                    let seen = chord(from, to);
                    if beyond_chord && within_circle { seen + path * 2.0 * PI } else { seen }
                })
                .sum()
        }
    }
}

//! Distances in the half plane (r, z) of a body of revolution.
//!
//! The distance of a point from a body of revolution about a vertical axis depends only on its height and its
//! distance from the axis. The points of a box, and of a vertical cylinder or tube, take every combination of a range
//! of heights and a range of distances: a rectangle in that half plane. So the distance is exact.

use chordal_geometry::{Aabb, Vec3};

use super::body::Frustum;
use super::cells::HeightSpan;
use super::round::distances;

type OutlinePoint = [f64; 2];

/// The distance between a box and a part of a body with its tip at a point, mm.
pub(super) fn from_box(frustum: &Frustum, tip: Vec3, around: &Aabb) -> f64 {
    let span = |axis: usize| HeightSpan {
        from: around.min.component(axis),
        to: around.max.component(axis),
    };
    let (x, y) = (distances(span(0), tip.x), distances(span(1), tip.y));
    let from = (x.from * x.from + y.from * y.from).sqrt();
    let to = (x.to * x.to + y.to * y.to).sqrt();
    distance(frustum, tip.z, HeightSpan { from, to }, span(2))
}

/// The distance of a part of a body, with its tip at a height, from the points in a range of distances from its axis
/// and a range of heights, mm.
pub(super) fn distance(frustum: &Frustum, tip: f64, radii: HeightSpan, heights: HeightSpan) -> f64 {
    let (low, high) = (tip + frustum.from, tip + frustum.to);
    let body = [[0.0, low], [frustum.lower, low], [frustum.upper, high], [0.0, high]];
    let (near, far) = (radii.from, radii.to);
    let rectangle =
        [[near, heights.from], [far, heights.from], [far, heights.to], [near, heights.to]];
    if !are_separated(&body, &rectangle) {
        return 0.0;
    }
    nearest(&body, &rectangle).min(nearest(&rectangle, &body))
}

/// Whether a side of one of two convex quadrilaterals separates them.
fn are_separated(a: &[OutlinePoint; 4], b: &[OutlinePoint; 4]) -> bool {
    let sides = |figure: &[OutlinePoint; 4]| {
        let figure = *figure;
        [0, 1, 2, 3].map(|at: usize| {
            let (from, to) = (figure[at], figure[(at + 1) % 4]);
            [to[1] - from[1], from[0] - to[0]]
        })
    };
    let separates = |[x, y]: OutlinePoint| {
        let range = |figure: &[OutlinePoint; 4]| {
            let along = figure.map(|point| point[0] * x + point[1] * y);
            let low = along.into_iter().fold(f64::INFINITY, f64::min);
            HeightSpan { from: low, to: along.into_iter().fold(f64::NEG_INFINITY, f64::max) }
        };
        let (of_a, of_b) = (range(a), range(b));
        of_a.to < of_b.from || of_b.to < of_a.from
    };
    sides(a).into_iter().chain(sides(b)).any(separates)
}

/// The least distance of the corners of one quadrilateral from the sides of the other.
fn nearest(corners: &[OutlinePoint; 4], figure: &[OutlinePoint; 4]) -> f64 {
    let mut least = f64::INFINITY;
    for &[x, y] in corners {
        for at in 0..4 {
            let (a, b) = (figure[at], figure[(at + 1) % 4]);
            let along = [b[0] - a[0], b[1] - a[1]];
            let whole = along[0] * along[0] + along[1] * along[1];
            let t = (x - a[0]) * along[0] + (y - a[1]) * along[1];
            let t = if whole > 0.0 { (t / whole).clamp(0.0, 1.0) } else { 0.0 };
            let off = [a[0] + t * along[0] - x, a[1] + t * along[1] - y];
            least = least.min(off[0] * off[0] + off[1] * off[1]);
        }
    }
    least.sqrt()
}

//! Chains of consecutive blocks: how they join, and which of them are walls.

use chordal_geometry::Vec2;

use super::ContourBlock;
use super::shape::{GougeCurve, wrapped};

/// The walls of a chain.
#[derive(Debug, Default)]
pub(super) struct ChainWalls {
    /// The blocks that are walls, in the order of the chain.
    pub(super) blocks: Vec<ContourBlock>,
    /// The walls are closed.
    pub(super) closed: bool,
    /// Arcs that lead to an open wall and away from it.
    pub(super) lead_arcs: Vec<ContourBlock>,
}

/// The turn from the end of one curve to the start of the next, rad, in −π..=π.
pub(super) fn turn(before: &GougeCurve, after: &GougeCurve) -> f64 {
    wrapped(after.tangent_angles().0 - before.tangent_angles().1)
}

/// Whether a chain ends where it begins, within `vertex`, mm; true for an empty one.
pub(super) fn closes(chain: &[ContourBlock], vertex: f64) -> bool {
    match (chain.first(), chain.last()) {
        (Some(first), Some(last)) => first.curve.from().distance(last.curve.to()) <= vertex,
        _ => true,
    }
}

/// Whether two curves lie on one line or circle, within `grain`, mm, and have the same direction.
pub(super) fn same_course(first: &GougeCurve, second: &GougeCurve, grain: f64) -> bool {
    match (first, second) {
        (GougeCurve::Line { from, to }, GougeCurve::Line { from: start, to: end }) => {
            let same_path = (*to - *from).dot(*end - *start) > 0.0;
            let off = |p: Vec2| first.left_of(p).abs();
            same_path && off(*start) <= grain && off(*end) <= grain
        }
        (
            GougeCurve::Arc { center, radius, sweep, .. },
            GougeCurve::Arc { center: about, radius: other, sweep: turned, .. },
        ) => {
            center.distance(*about) <= grain
                && (radius - other).abs() <= grain
                && sweep * turned > 0.0
        }
        _ => false,
    }
}

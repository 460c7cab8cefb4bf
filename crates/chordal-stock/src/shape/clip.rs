//! Clips triangles to strips.

use chordal_geometry::Vec3;

use super::cells::HeightSpan;

/// A triangle clipped to two strips has at most seven corners; the rest is for corners that rounding doubles.
const MAX_CORNERS: usize = 12;

/// A flat polygon in space.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlatPolygon {
    corners: [Vec3; MAX_CORNERS],
    count: usize,
}

impl FlatPolygon {
    pub(super) fn of_triangle([a, b, c]: [Vec3; 3]) -> FlatPolygon {
        let mut polygon = FlatPolygon { corners: [Vec3::ZERO; MAX_CORNERS], count: 3 };
        polygon.corners[..3].copy_from_slice(&[a, b, c]);
        polygon
    }

    pub(super) fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The range of a coordinate: 0 is x, 1 is y, 2 is z.
    pub(super) fn range(&self, axis: usize) -> HeightSpan {
        let nothing = HeightSpan { from: f64::INFINITY, to: f64::NEG_INFINITY };
        self.corners[..self.count].iter().fold(nothing, |range, corner| {
            let value = corner.component(axis);
            HeightSpan { from: range.from.min(value), to: range.to.max(value) }
        })
    }

    /// The part within a strip of x (0) or y (1).
    pub(super) fn within(&self, axis: usize, strip: HeightSpan) -> FlatPolygon {
        self.clipped_at(axis, strip.from, 1.0).clipped_at(axis, strip.to, -1.0)
    }

    /// The part on the higher (1) or lower (−1) side of a coordinate.
    fn clipped_at(&self, axis: usize, limit: f64, side: f64) -> FlatPolygon {
        let mut kept = FlatPolygon { corners: [Vec3::ZERO; MAX_CORNERS], count: 0 };
        let corners = &self.corners[..self.count];
        let mut push = |corner: Vec3| {
            debug_assert!(kept.count < MAX_CORNERS, "a convex polygon has one more for each cut");
            let at = kept.count.min(MAX_CORNERS - 1);
            kept.corners[at] = corner;
            kept.count = at + 1;
        };
        for (at, &a) in corners.iter().enumerate() {
            let b = corners[(at + 1) % corners.len()];
            let [of_a, of_b] = [a, b].map(|corner| (corner.component(axis) - limit) * side);
            if of_a >= 0.0 {
                push(a);
            }
            if (of_a >= 0.0) != (of_b >= 0.0) {
                let t = (of_a / (of_a - of_b)).clamp(0.0, 1.0);
                push(between(a, b, t));
            }
        }
        kept
    }
}

/// The point at a fraction between two points; coordinates that are equal at both are kept exactly.
fn between(a: Vec3, b: Vec3, t: f64) -> Vec3 {
    let at = |a: f64, b: f64| (a + t * (b - a)).clamp(a.min(b), a.max(b));
    Vec3::new(at(a.x, b.x), at(a.y, b.y), at(a.z, b.z))
}

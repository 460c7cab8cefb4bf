//! How far two paths are from each other.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use chordal::geometry::{Curve, ParamCurve, Vec3};
use rstar::{AABB, PointDistance, RTree, RTreeObject};

/// Most places that are asked for their distance; the interval is as narrow as they make it.
const MOST_ASKED: usize = 4_000_000;

/// A curve of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// A rapid, not a cut.
    pub is_rapid: bool,
    /// The exact curve, mm.
    pub curve: Curve,
}

/// An interval that holds a distance, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Within {
    /// It is at least this.
    pub low: f64,
    /// It is at most this.
    pub high: f64,
}

impl Within {
    /// The interval of the larger of two distances.
    #[must_use]
    pub fn or(self, other: Within) -> Within {
        Within { low: self.low.max(other.low), high: self.high.max(other.high) }
    }
}

/// The Hausdorff distance of two paths: how far the point of one that is furthest from the other
/// is from it. Zero for two paths without any piece; nothing where only one has pieces.
///
/// Proved, up to the rounding of doubles: a place of one path is as far from the other as the
/// nearest curve, which is found exactly, so the largest of them is a lower bound. The distance
/// changes no faster than the place, so that half the length of a piece about a place bounds it
/// from above; and from a straight line to a straight line it is largest at an end. Pieces are
/// halved, the one with the highest bound first, until nothing is left above the lower bound by
/// more than the tolerance. Where that takes too many places, the interval stays wider.
///
/// Says nothing about the order or direction in which the points are passed.
pub fn distance(a: &[Piece], b: &[Piece], tolerance_mm: f64) -> Option<Within> {
    if a.is_empty() && b.is_empty() {
        return Some(Within { low: 0.0, high: 0.0 });
    }
    if a.is_empty() || b.is_empty() {
        return None;
    }
    let (head, tail) = common(a, b);
    let there = one_way(&a[head..a.len() - tail], b, tolerance_mm)?;
    Some(there.or(one_way(&b[head..b.len() - tail], a, tolerance_mm)?))
}

/// How many pieces are the same at the beginning, and at the end behind those.
fn common(a: &[Piece], b: &[Piece]) -> (usize, usize) {
    let head = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[head..], &b[head..]);
    let tail = a.iter().rev().zip(b.iter().rev()).take_while(|(a, b)| a == b).count();
    (head, tail)
}

/// A piece in the tree.
struct Leaf(Curve);

impl RTreeObject for Leaf {
    type Envelope = AABB<[f64; 3]>;

    fn envelope(&self) -> AABB<[f64; 3]> {
        let bounds = self.0.bounds();
        AABB::from_corners(bounds.min.to_array(), bounds.max.to_array())
    }
}

impl PointDistance for Leaf {
    fn distance_2(&self, point: &[f64; 3]) -> f64 {
        let distance = self.0.nearest(Vec3::new(point[0], point[1], point[2])).distance;
        distance * distance
    }
}

/// A part of a curve whose distance is at most `high`.
struct Part {
    curve: usize,
    from: f64,
    to: f64,
    high: f64,
}

impl PartialEq for Part {
    fn eq(&self, other: &Part) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Part {}

impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Part) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Part {
    fn cmp(&self, other: &Part) -> Ordering {
        let by_place =
            || (other.curve, other.from.to_bits()).cmp(&(self.curve, self.from.to_bits()));
        self.high.total_cmp(&other.high).then_with(by_place)
    }
}

struct Search<'a> {
    from: &'a [Piece],
    tree: RTree<Leaf>,
    low: f64,
    asked: usize,
}

/// How far the pieces of one path are from another path.
fn one_way(from: &[Piece], to: &[Piece], tolerance_mm: f64) -> Option<Within> {
    let is_finite = |piece: &Piece| {
        let bounds = piece.curve.bounds();
        let corners = [bounds.min.to_array(), bounds.max.to_array()];
        corners.iter().flatten().all(|value| value.is_finite())
    };
    if !from.iter().chain(to).all(is_finite) {
        return None;
    }
    let tree = RTree::bulk_load(to.iter().map(|piece| Leaf(piece.curve)).collect());
    let mut search = Search { from, tree, low: 0.0, asked: 0 };
    let mut parts = BinaryHeap::new();
    for (index, piece) in from.iter().enumerate() {
        search.bound(index, 0.0, piece.curve.length(), tolerance_mm, &mut parts)?;
    }
    while let Some(part) = parts.pop() {
        if part.high <= search.low + tolerance_mm || search.asked >= MOST_ASKED {
            return Some(Within { low: search.low, high: part.high.max(search.low) });
        }
        let middle = part.from + (part.to - part.from) / 2.0;
        search.bound(part.curve, part.from, middle, tolerance_mm, &mut parts)?;
        search.bound(part.curve, middle, part.to, tolerance_mm, &mut parts)?;
    }
    Some(Within { low: search.low, high: search.low })
}

impl Search<'_> {
    /// Asks at the middle of a part, and keeps the part; nothing where a number is none.
    fn bound(
        &mut self,
        index: usize,
        from: f64,
        to: f64,
        tolerance_mm: f64,
        parts: &mut BinaryHeap<Part>,
    ) -> Option<()> {
        let curve = &self.from[index].curve;
        let middle = curve.point_at(from + (to - from) / 2.0);
        self.asked += 1;
        let nearest = self.tree.nearest_neighbor(middle.to_array())?;
        let here = nearest.0.nearest(middle).distance;
        self.low = self.low.max(here);
        let mut high = here + (to - from) / 2.0;
        if high > self.low + tolerance_mm
            && let (Curve::Line(_), Curve::Line(other)) = (curve, &nearest.0)
        {
            // The distance from a line is convex along a line.
            let end = |s: f64| other.nearest(curve.point_at(s)).distance;
            high = high.min(end(from).max(end(to)).max(here));
        }
        parts.push(Part { curve: index, from, to, high });
        high.is_finite().then_some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal::geometry::Line;
    use proptest::prelude::*;

    fn line(a: [f64; 2], b: [f64; 2]) -> Piece {
        let point = |p: [f64; 2]| Vec3::new(p[0], p[1], 0.0);
        let line = Line { start: point(a), end: point(b) };
        Piece { is_rapid: false, curve: line.into() }
    }

    fn chain(points: &[[f64; 2]]) -> Vec<Piece> {
        points.windows(2).map(|ends| line(ends[0], ends[1])).collect()
    }

    #[test]
    fn a_moved_corner() {
        let a = chain(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]]);
        let b = chain(&[[0.0, 0.0], [10.5, 0.0], [10.0, 10.0]]);
        let found = distance(&a, &b, 1e-6).unwrap();
        // The corner at 10.5 is half a millimetre from the corner at 10.
        assert!(found.low <= 0.5 && 0.5 <= found.high, "{found:?}");
        assert!(found.high - found.low <= 1e-6, "{found:?}");
    }

    #[test]
    fn a_line_cut_in_two_is_no_other_path() {
        let a = chain(&[[0.0, 0.0], [100.0, 0.0]]);
        let b = chain(&[[0.0, 0.0], [30.0, 0.0], [100.0, 0.0]]);
        assert_eq!(distance(&a, &b, 1e-9), Some(Within { low: 0.0, high: 0.0 }));
    }

    #[test]
    fn nothing_to_compare_with() {
        let a = chain(&[[0.0, 0.0], [1.0, 0.0]]);
        assert_eq!(distance(&a, &[], 1e-3), None);
        assert_eq!(distance(&[], &[], 1e-3), Some(Within { low: 0.0, high: 0.0 }));
        assert_eq!(distance(&a, &chain(&[[0.0, f64::NAN], [1.0, 0.0]]), 1e-3), None);
    }

    /// The distance of a point from a path by going through all of it.
    fn plainly(point: Vec3, path: &[Piece]) -> f64 {
        path.iter().map(|piece| piece.curve.nearest(point).distance).fold(f64::INFINITY, f64::min)
    }

    proptest! {
        #[test]
        fn the_interval_holds_what_samples_say(
            a in prop::collection::vec([-10.0..10.0f64, -10.0..10.0f64], 2..8),
            b in prop::collection::vec([-10.0..10.0f64, -10.0..10.0f64], 2..8),
        ) {
            let (a, b) = (chain(&a), chain(&b));
            let found = distance(&a, &b, 1e-3).unwrap();
            prop_assert!(found.high - found.low <= 1e-3 + 1e-12, "{found:?}");
            let mut sampled = 0.0f64;
            for (one, other) in [(&a, &b), (&b, &a)] {
                for piece in one {
                    let length = piece.curve.length();
                    for i in 0..=200 {
                        let point = piece.curve.point_at(length * f64::from(i) / 200.0);
                        sampled = sampled.max(plainly(point, other));
                    }
                }
            }
            prop_assert!(sampled <= found.high + 1e-9, "{sampled} beyond {found:?}");
            // Samples of at most 29 mm / 200 are nowhere further than half of that off.
            prop_assert!(sampled + 0.08 >= found.low, "{sampled} below {found:?}");
        }
    }
}

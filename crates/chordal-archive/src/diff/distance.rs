//! The distance between two paths.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use chordal::geometry::{Curve, ParamCurve, Vec3};
use rstar::{AABB, PointDistance, RTree, RTreeObject};

/// The most points whose distance is evaluated, for the running time; with more, the interval stays wider than the
/// tolerance.
const MAX_EVALUATIONS: usize = 4_000_000;

/// A curve of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathCurve {
    /// Whether it is a rapid and not a cut.
    pub is_rapid: bool,
    /// The exact curve, mm.
    pub curve: Curve,
}

/// An interval that contains a distance, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceBounds {
    /// The lower bound.
    pub low: f64,
    /// The upper bound.
    pub high: f64,
}

impl DistanceBounds {
    /// The interval of the larger of two distances.
    #[must_use]
    pub fn or(self, other: DistanceBounds) -> DistanceBounds {
        DistanceBounds { low: self.low.max(other.low), high: self.high.max(other.high) }
    }
}

/// The Hausdorff distance of two paths, mm: the largest distance of a point of either path from the other path. It is
/// zero for two empty paths, and `None` when only one is empty or a coordinate is not finite.
///
/// The interval is proved, up to the rounding of doubles. The distance of a point of one path from the other path is
/// its distance from the nearest curve, which is found exactly, so the largest such distance is a lower bound. The
/// distance changes no faster than the point moves, so on a piece it exceeds the distance at the middle by at most
/// half the length. From a straight line to a straight line it is largest at an end, and on a curve that both paths
/// contain it is zero. Pieces are split, the one with the highest upper bound first, until no upper bound exceeds the
/// lower bound by more than the tolerance. If that takes too many points, the interval stays wider. Distances that
/// rounding alone can cause (see [`rounding`]) count as zero.
///
/// The order and the direction in which the points are passed are not considered.
pub fn distance(a: &[PathCurve], b: &[PathCurve], tolerance_mm: f64) -> Option<DistanceBounds> {
    if a.is_empty() && b.is_empty() {
        return Some(DistanceBounds { low: 0.0, high: 0.0 });
    }
    if a.is_empty() || b.is_empty() {
        return None;
    }
    let rounding = rounding(a.iter().chain(b))?;
    let (head, tail) = common(a, b);
    let there = distance_to(&a[head..a.len() - tail], b, tolerance_mm, rounding)?;
    Some(there.or(distance_to(&b[head..b.len() - tail], a, tolerance_mm, rounding)?))
}

/// The largest distance that rounding can produce between equal straight lines, mm; `None` when a coordinate is not
/// finite.
///
/// Let u = 2^-53 and M be the largest coordinate of both paths; then a line is at most 2√3 M long.
///
/// | step | off by at most |
/// |---|---|
/// | the ends of the lines: inch to mm, and an offset added | 2u √3 M = 4 uM |
/// | a place `a (1 - t) + b t`: two products, a sum and `1 - t`, each coordinate 5 uM | 9 uM |
/// | the foot's `t`: differences 2u √3 M = 4 uM on the way; products, sums and a quotient 7u of 2√3 M | 29 uM |
/// | the foot, as the place | 9 uM |
/// | their difference, squares, sum and root | below 4 uM |
///
/// The sum is below 64 uM. The same value is used for curves; where their rounding errors are larger, they appear as
/// a distance.
fn rounding<'a>(pieces: impl Iterator<Item = &'a PathCurve>) -> Option<f64> {
    let mut largest = 0.0f64;
    for piece in pieces {
        let bounds = piece.curve.bounds();
        for value in bounds.min.to_array().into_iter().chain(bounds.max.to_array()) {
            if !value.is_finite() {
                return None;
            }
            largest = largest.max(value.abs());
        }
    }
    Some(64.0 * (f64::EPSILON / 2.0) * largest)
}

/// The number of equal pieces at the beginning, and at the end of the rest.
fn common(a: &[PathCurve], b: &[PathCurve]) -> (usize, usize) {
    let head = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[head..], &b[head..]);
    let tail = a.iter().rev().zip(b.iter().rev()).take_while(|(a, b)| a == b).count();
    (head, tail)
}

/// A curve in the R-tree.
struct CurveLeaf(Curve);

impl RTreeObject for CurveLeaf {
    type Envelope = AABB<[f64; 3]>;

    fn envelope(&self) -> AABB<[f64; 3]> {
        let bounds = self.0.bounds();
        AABB::from_corners(bounds.min.to_array(), bounds.max.to_array())
    }
}

impl PointDistance for CurveLeaf {
    fn distance_2(&self, point: &[f64; 3]) -> f64 {
        let distance = self.0.nearest(Vec3::new(point[0], point[1], point[2])).distance;
        distance * distance
    }
}

/// A part of a curve whose distance from the other path is at most `high`, mm.
struct CurveInterval {
    curve: usize,
    from: f64,
    to: f64,
    high: f64,
    /// The arc length at which it is split next, mm.
    split: f64,
    /// It results from a split that was not in the middle. The next split is in the middle, so that the parts become
    /// short.
    uneven: bool,
}

impl PartialEq for CurveInterval {
    fn eq(&self, other: &CurveInterval) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for CurveInterval {}

impl PartialOrd for CurveInterval {
    fn partial_cmp(&self, other: &CurveInterval) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for CurveInterval {
    fn cmp(&self, other: &CurveInterval) -> Ordering {
        let by_place =
            || (other.curve, other.from.to_bits()).cmp(&(self.curve, self.from.to_bits()));
        self.high.total_cmp(&other.high).then_with(by_place)
    }
}

struct DistanceSearch<'a> {
    from: &'a [PathCurve],
    tree: RTree<CurveLeaf>,
    tolerance_mm: f64,
    rounding: f64,
    low: f64,
    evaluations: usize,
    parts: BinaryHeap<CurveInterval>,
}

/// The largest distance of the points of one path from another path.
fn distance_to(
    from: &[PathCurve],
    to: &[PathCurve],
    tolerance_mm: f64,
    rounding: f64,
) -> Option<DistanceBounds> {
    let tree = RTree::bulk_load(to.iter().map(|piece| CurveLeaf(piece.curve)).collect());
    let parts = BinaryHeap::new();
    let mut search =
        DistanceSearch { from, tree, tolerance_mm, rounding, low: 0.0, evaluations: 0, parts };
    for (index, piece) in from.iter().enumerate() {
        search.ends(&piece.curve)?;
        search.bound(index, 0.0, piece.curve.length(), false)?;
    }
    while let Some(part) = search.parts.pop() {
        if part.high <= search.low + tolerance_mm || search.evaluations >= MAX_EVALUATIONS {
            return Some(DistanceBounds { low: search.low, high: part.high.max(search.low) });
        }
        let middle = part.from + (part.to - part.from) / 2.0;
        let uneven = !part.uneven && part.split != middle;
        let split = if uneven { part.split } else { middle };
        search.bound(part.curve, part.from, split, uneven)?;
        search.bound(part.curve, split, part.to, uneven)?;
    }
    Some(DistanceBounds { low: search.low, high: search.low })
}

impl DistanceSearch<'_> {
    /// The distance between a point and a curve, mm; zero when rounding may explain it.
    fn distance_of(&self, curve: &Curve, place: Vec3) -> f64 {
        let distance = curve.nearest(place).distance;
        if distance <= self.rounding { 0.0 } else { distance }
    }

    /// Evaluates the distance at the stored ends of a curve, which may deviate from its parameters: the radii at the
    /// ends of an arc may differ slightly.
    fn ends(&mut self, curve: &Curve) -> Option<()> {
        if matches!(curve, Curve::Line(_)) {
            return Some(());
        }
        for end in [curve.start(), curve.end()] {
            self.evaluations += 1;
            let nearest = self.tree.nearest_neighbor(end.to_array())?;
            self.low = self.low.max(self.distance_of(&nearest.0, end));
        }
        Some(())
    }

    /// Evaluates the distance at the middle of a part and adds the part to the queue; `None` when the bound is not
    /// finite.
    fn bound(&mut self, index: usize, from: f64, to: f64, uneven: bool) -> Option<()> {
        let curve = &self.from[index].curve;
        let middle = from + (to - from) / 2.0;
        let place = curve.point_at(middle);
        self.evaluations += 1;
        let nearest = self.tree.nearest_neighbor(place.to_array())?.0;
        let here = self.distance_of(&nearest, place);
        self.low = self.low.max(here);
        let mut part = CurveInterval { curve: index, from, to, high: 0.0, split: middle, uneven };
        if nearest != *curve {
            part.high = here + (to - from) / 2.0;
        }
        if part.high > self.low + self.tolerance_mm
            && let (Curve::Line(_), Curve::Line(_)) = (curve, &nearest)
        {
            // The distance from a line is a convex function along another line.
            let end = |s: f64| self.distance_of(&nearest, curve.point_at(s));
            part.high = part.high.min(end(from).max(end(to)).max(here));
            // Beyond an end of the nearest line, another line is likely to be nearer, so the part is split there.
            let feet = [nearest.start(), nearest.end()].map(|end| curve.nearest(end).s);
            let inside = feet.into_iter().filter(|foot| from < *foot && *foot < to);
            let off = |foot: &f64| (foot - middle).abs();
            part.split = inside.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(middle);
        }
        let is_number = part.high.is_finite();
        self.parts.push(part);
        is_number.then_some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal::geometry::Line;
    use proptest::prelude::*;

    fn line(a: [f64; 2], b: [f64; 2]) -> PathCurve {
        let point = |p: [f64; 2]| Vec3::new(p[0], p[1], 0.0);
        let line = Line { start: point(a), end: point(b) };
        PathCurve { is_rapid: false, curve: line.into() }
    }

    fn chain(points: &[[f64; 2]]) -> Vec<PathCurve> {
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
        assert_eq!(distance(&a, &b, 1e-9), Some(DistanceBounds { low: 0.0, high: 0.0 }));
    }

    /// Cut at places that no double holds, far from the origin and along no axis.
    #[test]
    fn rounding_is_no_distance() {
        for scale in [1e-3, 1.0, 25.4, 1e4] {
            let ends = [[0.1 * scale, 0.7 * scale], [3.3 * scale, -2.9 * scale]];
            let at = |t: f64| [0, 1].map(|axis| ends[0][axis] * (1.0 - t) + ends[1][axis] * t);
            let a = chain(&ends);
            let b = chain(&[at(0.0), at(0.1), at(0.3), at(1.0 / 3.0), at(0.9), at(1.0)]);
            assert_eq!(
                distance(&a, &b, 1e-9),
                Some(DistanceBounds { low: 0.0, high: 0.0 }),
                "{scale}"
            );
        }
    }

    /// A picometre on a part of a metre is more than rounding makes.
    #[test]
    fn a_small_distance_is_not_swallowed() {
        let a = chain(&[[0.0, 0.0], [1000.0, 0.0]]);
        let b = chain(&[[0.0, 0.0], [500.0, 1e-11], [1000.0, 0.0]]);
        let found = distance(&a, &b, 1e-13).unwrap();
        assert!((found.low - 1e-11).abs() < 1e-13, "{found:?}");
    }

    /// The end as it was programmed belongs to the path, too: radii of 10 and 10.05.
    #[test]
    fn an_arc_whose_end_lies_off_the_circle() {
        let arc = |end: Vec3| {
            let fit = chordal::geometry::arc_from_center(
                chordal::geometry::Plane::Xy,
                Vec3::new(10.0, 0.0, 0.0),
                end,
                (0.0, 0.0),
                chordal::geometry::TurnDirection::Ccw,
                0,
                0.1,
            );
            PathCurve { is_rapid: false, curve: fit.curve }
        };
        let a = [arc(Vec3::new(0.0, 10.0, 0.0))];
        let b = [arc(Vec3::new(0.0, 10.05, 0.0))];
        let found = distance(&a, &b, 1e-4).unwrap();
        assert!(found.low <= 0.05 + 1e-9 && 0.05 - 1e-9 <= found.high, "{found:?}");
        assert!(found.high - found.low <= 1e-4, "{found:?}");
    }

    #[test]
    fn nothing_to_compare_with() {
        let a = chain(&[[0.0, 0.0], [1.0, 0.0]]);
        assert_eq!(distance(&a, &[], 1e-3), None);
        assert_eq!(distance(&[], &[], 1e-3), Some(DistanceBounds { low: 0.0, high: 0.0 }));
        assert_eq!(distance(&a, &chain(&[[0.0, f64::NAN], [1.0, 0.0]]), 1e-3), None);
    }

    /// The distance of a point from a path by going through all of it.
    fn plainly(point: Vec3, path: &[PathCurve]) -> f64 {
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

//! Traverses two paths together and bounds their distance.

use chordal::geometry::{Curve, Line, ParamCurve, Vec3};

use crate::bound::{CurveRange, bound};

/// A pair of parts of the two paths, each traversed at constant speed from end to end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PathCoupling {
    /// The indices of the moves in the two paths; the last move when a path has ended and waits.
    pub(crate) moves: [usize; 2],
    /// An upper bound of the distance between the two points, mm.
    pub(crate) max_distance_mm: f64,
    /// The part of each move, as a start and an end fraction.
    pub(crate) parts: [[f64; 2]; 2],
}

/// The whole of both moves.
const WHOLE: [[f64; 2]; 2] = [[0.0, 1.0]; 2];

impl PathCoupling {
    /// Two whole moves.
    pub(crate) fn whole(moves: [usize; 2], separate_mm: f64) -> PathCoupling {
        PathCoupling { moves, max_distance_mm: separate_mm, parts: WHOLE }
    }

    /// Whether both parts are whole moves.
    pub(crate) fn is_whole(&self) -> bool {
        self.parts == WHOLE
    }
}

/// A path and the position reached on it.
struct PathWalker<'a> {
    curves: &'a [&'a Curve],
    /// The position of the path after its end or when it has no curves.
    rest: Curve,
    lengths: Vec<f64>,
    at: usize,
    distance: f64,
}

impl<'a> PathWalker<'a> {
    fn new(curves: &'a [&'a Curve], rest: Vec3) -> PathWalker<'a> {
        let rest = curves.last().map_or(rest, |curve| curve.end());
        let lengths = curves.iter().map(|curve| curve.length()).collect();
        PathWalker {
            curves,
            rest: Line { start: rest, end: rest }.into(),
            lengths,
            at: 0,
            distance: 0.0,
        }
    }

    fn is_done(&self) -> bool {
        self.at == self.curves.len()
    }

    fn curve(&self) -> &Curve {
        self.curves.get(self.at).map_or(&self.rest, |curve| *curve)
    }

    fn length(&self) -> f64 {
        self.lengths.get(self.at).copied().unwrap_or(0.0)
    }

    fn end(&self) -> Vec3 {
        self.curve().end()
    }

    fn range_to(&self, to: f64) -> CurveRange<'_> {
        CurveRange { curve: self.curve(), from: self.distance, to }
    }

    /// The point on the rest of this curve that is nearest to `place`: its arc length on the curve and its distance,
    /// mm.
    fn nearest(&self, place: Vec3) -> (f64, f64) {
        let (course, length) = (self.distance, self.length());
        let rest =
            if course > 0.0 { self.curve().subsegment(course, length) } else { *self.curve() };
        let nearest = rest.nearest(place);
        ((course + nearest.s).min(length), nearest.distance)
    }

    fn walk(&mut self, to: f64) {
        if to < self.length() {
            self.distance = to;
        } else {
            self.at += 1;
            self.distance = 0.0;
        }
    }

    /// The fractions of the current move from here to the arc length `to`; `[1, 1]` when the path has ended.
    fn part(&self, to: f64) -> [f64; 2] {
        if self.is_done() {
            return [1.0; 2];
        }
        let length = self.length();
        let fraction = |course: f64| if length > 0.0 { course / length } else { 1.0 };
        let from = if self.distance > 0.0 { fraction(self.distance) } else { 0.0 };
        [from, if to < length { fraction(to) } else { 1.0 }]
    }

    fn index(&self) -> usize {
        self.at.min(self.curves.len().saturating_sub(1))
    }
}

/// Traverses two paths together, curve by curve. At each end of a curve, the other path advances to the end of its
/// own curve or to the nearest point, whichever keeps the two closer. The effort is linear in the number of curves.
/// The largest distance is an upper bound of the Fréchet distance between the two paths.
///
/// A path without curves waits at `rest`. Bounds are found to `precision_mm`; end points within the tolerance of each
/// other count as equal.
pub(crate) fn couple(
    a: &[&Curve],
    b: &[&Curve],
    rest: [Vec3; 2],
    precision_mm: f64,
    tolerance_mm: f64,
) -> Vec<PathCoupling> {
    let mut walkers = [PathWalker::new(a, rest[0]), PathWalker::new(b, rest[1])];
    let mut couples = Vec::with_capacity(a.len().max(b.len()));
    while !(walkers[0].is_done() && walkers[1].is_done()) {
        let to = together(&walkers, tolerance_mm, precision_mm);
        let moves = [walkers[0].index(), walkers[1].index()];
        let parts = [0, 1].map(|at| walkers[at].part(to[at]));
        let separate_mm =
            bound(walkers[0].range_to(to[0]), walkers[1].range_to(to[1]), precision_mm);
        couples.push(PathCoupling { moves, max_distance_mm: separate_mm, parts });
        for (walker, to) in walkers.iter_mut().zip(to) {
            if !walker.is_done() {
                walker.walk(to);
            }
        }
    }
    couples
}

/// Traverses two paths move by move; `None` when they do not consist of equally many moves of the same kinds.
pub(crate) fn move_by_move(
    a: &[&Curve],
    b: &[&Curve],
    precision_mm: f64,
) -> Option<Vec<PathCoupling>> {
    let is_alike =
        |(a, b): (&&Curve, &&Curve)| std::mem::discriminant(*a) == std::mem::discriminant(*b);
    if a.len() != b.len() || !a.iter().zip(b).all(is_alike) {
        return None;
    }
    let whole = |curve| CurveRange::whole(curve, ParamCurve::length(curve));
    let pairs = a.iter().zip(b).enumerate();
    let couples = pairs.map(|(at, (a, b))| {
        PathCoupling::whole([at, at], bound(whole(*a), whole(*b), precision_mm))
    });
    Some(couples.collect())
}

/// The largest distance in a traversal, mm.
pub(crate) fn most(couples: &[PathCoupling]) -> f64 {
    couples.iter().map(|couple| couple.max_distance_mm).fold(0.0, f64::max)
}

/// The arc lengths to which the two paths advance next; at least one advances to the end of its curve.
fn together(walkers: &[PathWalker<'_>; 2], tolerance_mm: f64, precision_mm: f64) -> [f64; 2] {
    let [a, b] = walkers;
    let ends = [a.length(), b.length()];
    if a.is_done() || b.is_done() {
        return ends;
    }
    let both = (a.end() - b.end()).length();
    if both == 0.0 {
        return ends;
    }
    let (of_b, separate_b) = b.nearest(a.end());
    let (of_a, separate_a) = a.nearest(b.end());
    let least = separate_a.min(separate_b);
    // When the distance is the same up to rounding, whole curves are paired.
    let rounding = 1e-12 * (1.0 + a.end().length().max(b.end().length()));
    if both <= least + rounding {
        return ends;
    }
    // Whole curves are also paired when their ends are within the tolerance, unless a point that lags behind leaves
    // the tolerance before.
    let whole = || bound(a.range_to(ends[0]), b.range_to(ends[1]), precision_mm);
    if both <= tolerance_mm && whole() <= tolerance_mm {
        return ends;
    }
    let choices = [[ends[0], of_b], [of_a, ends[1]]];
    let [first, second] = if walkers.iter().all(|walker| matches!(walker.curve(), Curve::Line(_))) {
        [separate_b, separate_a]
    } else {
        // A curve may pass the same point twice (a circle ends where it begins), so the distance on the way decides.
        choices.map(|to| bound(a.range_to(to[0]), b.range_to(to[1]), precision_mm))
    };
    if first <= second { choices[0] } else { choices[1] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal::geometry::{Plane, TurnDirection, arc_from_center};

    fn line(a: [f64; 2], b: [f64; 2]) -> Curve {
        let place = |p: [f64; 2]| Vec3::new(p[0], p[1], 0.0);
        Line { start: place(a), end: place(b) }.into()
    }

    fn chain(points: &[[f64; 2]]) -> Vec<Curve> {
        points.windows(2).map(|ends| line(ends[0], ends[1])).collect()
    }

    fn most(a: &[Curve], b: &[Curve]) -> f64 {
        let (a, b): (Vec<&Curve>, Vec<&Curve>) = (a.iter().collect(), b.iter().collect());
        super::most(&couple(&a, &b, [Vec3::ZERO; 2], 1e-9, 0.0))
    }

    fn quarter(from: [f64; 2], to: [f64; 2]) -> Curve {
        let place = |p: [f64; 2]| Vec3::new(p[0], p[1], 0.0);
        let center = (0.0, 0.0);
        arc_from_center(Plane::Xy, place(from), place(to), center, TurnDirection::Ccw, 0, 0.1).curve
    }

    #[test]
    fn cut_otherwise() {
        let a = chain(&[[0.0, 0.0], [10.0, 0.0], [10.0, 7.0]]);
        let b = chain(&[[0.0, 0.0], [1.0, 0.0], [9.5, 0.0], [10.0, 0.0], [10.0, 2.0], [10.0, 7.0]]);
        assert!(most(&a, &b) < 1e-12);
        assert!(most(&b, &a) < 1e-12);
    }

    #[test]
    fn an_arc_in_two() {
        let root = 50f64.sqrt();
        let a = [quarter([10.0, 0.0], [0.0, 10.0])];
        let b = [quarter([10.0, 0.0], [root, root]), quarter([root, root], [0.0, 10.0])];
        assert!(most(&a, &b) < 1e-9, "{}", most(&a, &b));
    }

    /// Eight chords of a quarter circle leave it by r(1 − cos(π/32)).
    #[test]
    fn chords_of_an_arc() {
        let a = [quarter([10.0, 0.0], [0.0, 10.0])];
        let points: Vec<[f64; 2]> = (0..=8)
            .map(|i| f64::from(i) * std::f64::consts::FRAC_PI_2 / 8.0)
            .map(|angle| [10.0 * angle.cos(), 10.0 * angle.sin()])
            .collect();
        let sagitta = 10.0 * (1.0 - (std::f64::consts::PI / 32.0).cos());
        let found = most(&a, &chain(&points));
        // At constant speed, the point on the chord is a little further from the arc's than the sagitta.
        assert!(found >= sagitta - 1e-9 && found < sagitta * 1.01, "{found} against {sagitta}");
    }

    /// A circle ends where it begins; it must not wait there for the chords.
    #[test]
    fn chords_of_a_circle() {
        let points: Vec<[f64; 2]> = (0..=64)
            .map(|i| f64::from(i % 64) * std::f64::consts::TAU / 64.0)
            .map(|angle| [10.0 * angle.cos(), 10.0 * angle.sin()])
            .collect();
        let found = most(&[quarter([10.0, 0.0], [10.0, 0.0])], &chain(&points));
        let sagitta = 10.0 * (1.0 - (std::f64::consts::PI / 64.0).cos());
        assert!(found >= sagitta - 1e-9 && found < sagitta * 1.02, "{found} against {sagitta}");
    }

    /// An arc that ends slightly after a chord point, by less than the tolerance, and is nearly as far from the chord
    /// in its middle: pairing their ends would exceed the tolerance in the middle.
    #[test]
    fn a_joint_beside_a_point() {
        let (length, sagitta, tolerance) = (2.0019, 0.0018, 0.002);
        let radius = (length * length / 4.0 + sagitta * sagitta) / (2.0 * sagitta);
        let center = (length / 2.0, sagitta - radius);
        let end = Vec3::new(length, 0.0, 0.0);
        let arc =
            arc_from_center(Plane::Xy, Vec3::ZERO, end, center, TurnDirection::Cw, 0, 0.1).curve;
        let b = [arc, line([length, 0.0], [4.0, 0.0])];
        let a = chain(&[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0]]);
        let (a, b): (Vec<&Curve>, Vec<&Curve>) = (a.iter().collect(), b.iter().collect());
        let found = super::most(&couple(&a, &b, [Vec3::ZERO; 2], 1e-7, tolerance));
        assert!(found >= sagitta - 1e-9 && found <= sagitta * 1.01, "{found}");
    }

    #[test]
    fn a_moved_corner_is_as_far_as_it_was_moved() {
        let a = chain(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]);
        let b = chain(&[[0.0, 0.0], [10.0, -0.25], [10.0, 10.0], [0.0, 10.0]]);
        assert!((most(&a, &b) - 0.25).abs() < 1e-12);
    }

    #[test]
    fn what_only_one_has_is_held_against_where_the_other_waits() {
        let a = chain(&[[0.0, 0.0], [3.0, 4.0], [0.0, 0.0]]);
        assert!((most(&a, &[]) - 5.0).abs() < 1e-12);
    }
}

//! One polynomial span of a spline: control points with weights, evaluated at a parameter from 0 to 1.
//!
//! The curve is A(t)/w(t), where A has the control points times their weights and w the weights. Both are evaluated by
//! de Casteljau's algorithm, which only takes means and is therefore numerically stable.

use crate::{Aabb, Vec3};

/// A control point times its weight, and the weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct WeightedPoint {
    pub point: Vec3,
    pub weight: f64,
}

impl WeightedPoint {
    pub(crate) const ZERO: WeightedPoint = WeightedPoint { point: Vec3::ZERO, weight: 0.0 };

    pub(crate) fn new(point: Vec3, weight: f64) -> WeightedPoint {
        WeightedPoint { point: point * weight, weight }
    }

    pub(crate) fn lerp(self, other: WeightedPoint, t: f64) -> WeightedPoint {
        WeightedPoint {
            point: self.point.lerp(other.point, t),
            weight: self.weight * (1.0 - t) + other.weight * t,
        }
    }

    pub(crate) fn minus(self, other: WeightedPoint) -> WeightedPoint {
        WeightedPoint { point: self.point - other.point, weight: self.weight - other.weight }
    }

    #[inline]
    pub(crate) fn plus(self, other: WeightedPoint) -> WeightedPoint {
        WeightedPoint { point: self.point + other.point, weight: self.weight + other.weight }
    }

    #[inline]
    pub(crate) fn times(self, k: f64) -> WeightedPoint {
        WeightedPoint { point: self.point * k, weight: self.weight * k }
    }

    pub(crate) fn place(self) -> Vec3 {
        self.point / self.weight
    }
}

/// The largest number of control points of a span in a fixed-size array.
pub(crate) const MAX_SPAN_ORDER: usize = 6;

/// A span in a fixed-size array: its control points relative to the first one, and that point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bezier {
    pub points: [WeightedPoint; MAX_SPAN_ORDER],
    pub order: usize,
    pub start: Vec3,
}

impl Bezier {
    /// The point at `t`, mm, and its first three derivatives with respect to `t`.
    pub(crate) fn jet(&self, t: f64) -> [Vec3; 4] {
        let mut points = self.points;
        let mut jet = quotient(jet(&mut points[..self.order], t));
        jet[0] += self.start;
        jet
    }
}

/// The point of a rational curve and its first three derivatives, from those of A and w.
pub(crate) fn quotient(of: [WeightedPoint; 4]) -> [Vec3; 4] {
    let [a, a1, a2, a3] = of.map(|part| part.point);
    let [w, w1, w2, w3] = of.map(|part| part.weight);
    let c = a / w;
    let c1 = (a1 - c * w1) / w;
    let c2 = (a2 - c1 * (2.0 * w1) - c * w2) / w;
    let c3 = (a3 - c2 * (3.0 * w1) - c1 * (3.0 * w2) - c * w3) / w;
    [c, c1, c2, c3]
}

/// One round of de Casteljau's algorithm: the first `count` points become `count - 1`.
fn step(points: &mut [WeightedPoint], count: usize, t: f64) {
    for index in 0..count - 1 {
        points[index] = points[index].lerp(points[index + 1], t);
    }
}

/// A, w and their first three derivatives with respect to t. Overwrites the control points.
pub(crate) fn jet(points: &mut [WeightedPoint], t: f64) -> [WeightedPoint; 4] {
    let degree = points.len() - 1;
    let mut found = [WeightedPoint::ZERO; 4];
    let mut count = points.len();
    loop {
        if count <= 4 {
            let order = count - 1;
            let mut differences = [WeightedPoint::ZERO; 4];
            differences[..count].copy_from_slice(&points[..count]);
            for round in 0..order {
                for index in 0..order - round {
                    differences[index] = differences[index + 1].minus(differences[index]);
                }
            }
            let factor = (0..order).map(|k| (degree - k) as f64).product::<f64>();
            found[order] = differences[0].times(factor);
        }
        if count == 1 {
            return found;
        }
        step(points, count, t);
        count -= 1;
    }
}

/// The first derivative of the curve with respect to t, mm. Overwrites the control points.
pub(crate) fn velocity(points: &mut [WeightedPoint], t: f64) -> Vec3 {
    let degree = points.len() - 1;
    if degree == 0 {
        return Vec3::ZERO;
    }
    for count in (3..=points.len()).rev() {
        step(points, count, t);
    }
    let (first, last) = (points[0], points[1]);
    // A'w − Aw' = degree·(A₁w₀ − A₀w₁) for every t.
    let weight = first.lerp(last, t).weight;
    (last.point * first.weight - first.point * last.weight) * (degree as f64 / (weight * weight))
}

/// Converts control points to the coefficients of powers of x, which is −1 at the first point and 1 at the last:
/// expanding about the middle has the smallest rounding errors.
pub(crate) fn to_powers(points: &mut [WeightedPoint]) {
    let degree = points.len() - 1;
    let mut means = [WeightedPoint::ZERO; MAX_SPAN_ORDER];
    means[..=degree].copy_from_slice(points);
    // The coefficient of power k is the difference of order k of the means at the middle.
    let mut factor = 1.0;
    let mut found = [WeightedPoint::ZERO; MAX_SPAN_ORDER];
    for order in (0..=degree).rev() {
        let mut differences = means;
        for round in 0..order {
            for index in 0..order - round {
                differences[index] = differences[index + 1].minus(differences[index]);
            }
        }
        // The binomial (degree over order), and half the width of x per order.
        found[order] = differences[0].times(factor * 0.5_f64.powi(order as i32));
        factor = factor * order as f64 / (degree - order + 1) as f64;
        step(&mut means, order + 1, 0.5);
    }
    points.copy_from_slice(&found[..=degree]);
}

/// Splits a span at `t`: `points` become the control points of the part before it, `after` those of the part after it.
pub(crate) fn split(points: &mut [WeightedPoint], after: &mut [WeightedPoint], t: f64) {
    let count = points.len();
    // Backwards, so that each round leaves one point of the first part in place.
    for round in 0..count {
        after[count - 1 - round] = points[count - 1];
        for index in (round + 1..count).rev() {
            points[index] = points[index - 1].lerp(points[index], t);
        }
    }
}

/// The box around a curve with the ends `start` and `end`. Parts of the curve are divided as long as their control points
/// are outside the box of the points found so far.
pub(crate) fn bounds(points: &[WeightedPoint], start: Vec3, end: Vec3) -> Aabb {
    const MAX_DIVISIONS: u32 = 48;
    let mut found = Aabb::of_points(start, end);
    let mut open = vec![(points.to_vec(), 0)];
    while let Some((mut part, depth)) = open.pop() {
        let hull = part.iter().fold(Aabb::EMPTY, |hull, point| hull.include(point.place()));
        let (size, far) = (hull.size(), found.size());
        let rounding = 4.0
            * f64::EPSILON
            * [size, far, found.min, found.max]
                .iter()
                .flat_map(|v| v.to_array())
                .fold(0.0_f64, |most, value| most.max(value.abs()));
        let within = found.expand(rounding);
        if depth >= MAX_DIVISIONS || (within.contains(hull.min) && within.contains(hull.max)) {
            continue;
        }
        if !(hull.min.is_finite() && hull.max.is_finite()) {
            continue;
        }
        let mut after = part.clone();
        split(&mut part, &mut after, 0.5);
        found = found.include(after[0].place());
        open.push((part, depth + 1));
        open.push((after, depth + 1));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(of: &[(f64, f64, f64)]) -> Vec<WeightedPoint> {
        of.iter().map(|(x, y, w)| WeightedPoint::new(Vec3::new(*x, *y, 0.0), *w)).collect()
    }

    #[test]
    fn a_quarter_circle_is_a_rational_parabola() {
        let quarter = points(&[(1.0, 0.0, 1.0), (1.0, 1.0, 0.5_f64.sqrt()), (0.0, 1.0, 1.0)]);
        for k in 0..=10 {
            let t = f64::from(k) / 10.0;
            let [p, d1, d2, _] = quotient(jet(&mut quarter.clone(), t));
            assert!((p.length() - 1.0).abs() < 1e-15);
            assert!(velocity(&mut quarter.clone(), t).distance(d1) < 1e-14);
            assert!((d1.cross(d2).z / d1.length().powi(3) - 1.0).abs() < 1e-13);
        }
        let found = bounds(&quarter, Vec3::X, Vec3::Y);
        assert_eq!((found.min, found.max), (Vec3::ZERO, Vec3::new(1.0, 1.0, 0.0)));
    }

    #[test]
    fn parts_are_the_same_curve() {
        let whole = points(&[(0.0, 0.0, 1.0), (1.0, 2.0, 2.0), (4.0, -1.0, 0.5), (5.0, 3.0, 1.5)]);
        let (mut before, mut after) = (whole.clone(), whole.clone());
        split(&mut before, &mut after, 0.3);
        for k in 0..=10 {
            let t = f64::from(k) / 10.0;
            let at = |points: &[WeightedPoint], t| quotient(jet(&mut points.to_vec(), t))[0];
            assert!(at(&before, t).distance(at(&whole, 0.3 * t)) < 1e-14);
            assert!(at(&after, t).distance(at(&whole, 0.3 + 0.7 * t)) < 1e-14);
        }
    }
}

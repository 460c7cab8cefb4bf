//! Rational B-splines of any order with clamped knots.

use crate::bezier::{self, WeightedPoint, quotient};
use crate::quadrature::integral;
use crate::{Aabb, ParamCurve, SplinePiece, Transform, Vec3, math};

/// Why a spline cannot be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SplineError {
    /// The order is below two.
    Order(usize),
    /// Fewer control points than the order.
    TooFew {
        /// The number of control points.
        points: usize,
        /// The order.
        order: usize,
    },
    /// The number of weights differs from the number of control points; this many weights.
    Weights(usize),
    /// A weight is zero, negative or not finite.
    Weight(f64),
    /// A coordinate or a knot is not finite.
    NotFinite,
    /// The number of knots is not that of points plus order, the knots decrease, an inner knot is repeated `order`
    /// times or more, or the first or last `order` knots are not equal.
    Knots,
}

impl core::fmt::Display for SplineError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            SplineError::Order(order) => {
                write!(f, "the order of a spline is 2 or more, not {order}")
            }
            SplineError::TooFew { points, order } => {
                write!(
                    f,
                    "a spline of order {order} needs {order} control points or more, not {points}"
                )
            }
            SplineError::Weights(count) => {
                write!(f, "{count} weights are not one for each control point")
            }
            SplineError::Weight(weight) => write!(f, "a weight of {weight} is not above zero"),
            SplineError::NotFinite => f.write_str("the spline is not finite"),
            SplineError::Knots => f.write_str("the knots are not those of a clamped spline"),
        }
    }
}

impl core::error::Error for SplineError {}

/// A rational B-spline (NURBS) with clamped knots: it begins at its first control point and ends at its last.
/// If it has as many control points as its order, it is one Bezier curve.
///
/// It is evaluated at a parameter. To evaluate it at a length, [`Spline::pieces`] divides it exactly into its polynomial
/// spans.
///
/// ```
/// use chordal_geometry::{Spline, Vec3};
///
/// let points = [(0.0, 0.0), (0.0, 3.0), (1.0, -1.0), (1.0, 1.0)].map(|(x, y)| Vec3::new(x, y, 0.0));
/// let cubic = Spline::bezier(points.to_vec())?;
/// assert_eq!(cubic.point_at(0.5), Vec3::new(0.5, 0.875, 0.0));
/// # Ok::<(), chordal_geometry::SplineError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    order: usize,
    points: Vec<Vec3>,
    weights: Vec<f64>,
    knots: Vec<f64>,
}

impl Spline {
    /// The spline of this order (degree + 1) with these control points (mm), weights and knots.
    ///
    /// # Errors
    /// See [`SplineError`].
    pub fn new(
        order: usize,
        points: Vec<Vec3>,
        weights: Vec<f64>,
        knots: Vec<f64>,
    ) -> Result<Spline, SplineError> {
        check(order, &points, &weights)?;
        if knots.iter().any(|knot| !knot.is_finite()) {
            return Err(SplineError::NotFinite);
        }
        let count = points.len();
        let clamped = knots.len() == count + order
            && knots[..order].iter().all(|knot| *knot == knots[0])
            && knots[count..].iter().all(|knot| *knot == knots[count])
            && knots.windows(2).all(|pair| pair[0] <= pair[1])
            && (1..count).all(|index| knots[index] < knots[index + order - 1] || order == 2)
            && knots[order - 1] < knots[count];
        if !clamped {
            return Err(SplineError::Knots);
        }
        Ok(Spline { order, points, weights, knots })
    }

    /// The spline with equidistant knots 0 … 0, 1, 2, … and clamped ends.
    ///
    /// # Errors
    /// As [`Spline::new`].
    pub fn uniform(
        order: usize,
        points: Vec<Vec3>,
        weights: Vec<f64>,
    ) -> Result<Spline, SplineError> {
        check(order, &points, &weights)?;
        let last = (points.len() + 1 - order) as f64;
        let knots = (0..points.len() + order)
            .map(|index| (index as f64 + 1.0 - order as f64).clamp(0.0, last))
            .collect();
        Spline::new(order, points, weights, knots)
    }

    /// A Bezier curve with equal weights, mm; four control points give the third degree.
    ///
    /// # Errors
    /// As [`Spline::new`].
    pub fn bezier(points: Vec<Vec3>) -> Result<Spline, SplineError> {
        let (order, weights) = (points.len(), vec![1.0; points.len()]);
        Spline::uniform(order, points, weights)
    }

    /// A circular arc in any plane: from `start` about `center`, mm, by `sweep` radians, positive counter-clockwise seen
    /// against `normal` (of any length). It ends at `end`, mm, which may be off the circle only by rounding.
    ///
    /// # Errors
    /// As [`Spline::new`].
    pub fn arc(
        start: Vec3,
        center: Vec3,
        normal: Vec3,
        sweep: f64,
        end: Vec3,
    ) -> Result<Spline, SplineError> {
        let pieces = (sweep.abs() / math::FRAC_PI_2 - 1e-9).ceil().max(1.0);
        let half = sweep / pieces / 2.0;
        let (_, weight) = math::sin_cos(half);
        let turned = |angle: f64| {
            let turn = Transform::rotation_about(center, normal, angle);
            turn.apply_point(start) - center
        };
        let (mut points, mut weights, mut knots) = (vec![start], vec![1.0], vec![0.0; 3]);
        for piece in 1..=pieces as usize {
            let after = 2.0 * piece as f64;
            points.push(center + turned((after - 1.0) * half) * (1.0 / weight));
            points.push(center + turned(after * half));
            weights.extend([weight, 1.0]);
            knots.extend([piece as f64; 2]);
        }
        knots.push(pieces);
        points.pop();
        points.push(end);
        Spline::new(3, points, weights, knots)
    }

    /// Degree + 1.
    #[must_use]
    pub fn order(&self) -> usize {
        self.order
    }

    /// The control points, mm.
    #[must_use]
    pub fn points(&self) -> &[Vec3] {
        &self.points
    }

    /// Their weights, above zero.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The knots: as many as control points and order together.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The first and the last parameter.
    #[must_use]
    pub fn domain(&self) -> (f64, f64) {
        (self.knots[self.order - 1], self.knots[self.points.len()])
    }

    /// The start, mm.
    #[must_use]
    pub fn start(&self) -> Vec3 {
        self.points[0]
    }

    /// The end, mm.
    #[must_use]
    pub fn end(&self) -> Vec3 {
        self.points[self.points.len() - 1]
    }

    /// Unit tangent at the start; zero if all control points coincide.
    #[must_use]
    pub fn start_tangent(&self) -> Vec3 {
        let first = self.points[0];
        let next = self.points[1..].iter().find_map(|point| (*point - first).normalized());
        next.unwrap_or(Vec3::ZERO)
    }

    /// Unit tangent at the end; zero if all control points coincide.
    #[must_use]
    pub fn end_tangent(&self) -> Vec3 {
        let last = self.end();
        let before =
            self.points.iter().rev().skip(1).find_map(|point| (last - *point).normalized());
        before.unwrap_or(Vec3::ZERO)
    }

    /// The point at a parameter, mm; outside of the domain, the nearer end.
    #[must_use]
    pub fn point_at(&self, u: f64) -> Vec3 {
        self.jet_at(u)[0]
    }

    /// The point at a parameter, mm, and its first three derivatives with respect to it.
    #[must_use]
    pub fn jet_at(&self, u: f64) -> [Vec3; 4] {
        let (first, last) = self.domain();
        let span = self.span(u);
        let mut jet = quotient(self.weighted_jet(span, u.clamp(first, last)));
        // The exact ends.
        if u <= first {
            jet[0] = self.start();
        } else if u >= last {
            jet[0] = self.end();
        }
        jet
    }

    /// A, w and their derivatives, by de Boor's algorithm from the control points and their differences.
    fn weighted_jet(&self, span: usize, u: f64) -> [WeightedPoint; 4] {
        let mut found = [WeightedPoint::ZERO; 4];
        let mut points = self.local(span);
        for (derivative, row) in found.iter_mut().enumerate() {
            let degree = points.len() - 1;
            // Each derivative has one control point fewer.
            *row = self.means(points.clone(), span, |_| u);
            if derivative == 3 || degree == 0 {
                break;
            }
            let first = span + 1 - degree;
            points = (0..degree)
                .map(|j| {
                    let over = self.knots[first + j + degree] - self.knots[first + j];
                    points[j + 1].minus(points[j]).times(degree as f64 / over)
                })
                .collect();
        }
        found
    }

    /// The weighted control points that affect a span.
    fn local(&self, span: usize) -> Vec<WeightedPoint> {
        (span + 1 - self.order..=span)
            .map(|index| WeightedPoint::new(self.points[index], self.weights[index]))
            .collect()
    }

    /// De Boor's algorithm over a span with a separate parameter in each round (the blossom).
    fn means(
        &self,
        mut points: Vec<WeightedPoint>,
        span: usize,
        at: impl Fn(usize) -> f64,
    ) -> WeightedPoint {
        let degree = points.len() - 1;
        for round in 1..=degree {
            let u = at(round - 1);
            for index in (round..=degree).rev() {
                let low = self.knots[span - degree + index];
                let high = self.knots[span + 1 + index - round];
                let share = (u - low) / (high - low);
                points[index] = points[index - 1].lerp(points[index], share);
            }
        }
        points[degree]
    }

    /// The index of the last knot at or before a parameter, within the domain.
    fn span(&self, u: f64) -> usize {
        let mut span = self.points.len() - 1;
        while span > self.order - 1
            && (u < self.knots[span] || self.knots[span] == self.knots[span + 1])
        {
            span -= 1;
        }
        span
    }

    /// The spans between different knots, as the index of their first knot.
    fn spans(&self) -> impl Iterator<Item = usize> {
        (self.order - 1..self.points.len()).filter(|span| self.knots[*span] < self.knots[*span + 1])
    }

    /// The control points of a span as a Bezier curve.
    fn bezier_points(&self, span: usize) -> Vec<WeightedPoint> {
        let (from, to) = (self.knots[span], self.knots[span + 1]);
        let degree = self.order - 1;
        let local = self.local(span);
        (0..=degree)
            .map(|k| {
                self.means(local.clone(), span, |round| if round < degree - k { from } else { to })
            })
            .collect()
    }

    /// Its polynomial spans in order, each exact; the end of one equals the start of the next. `None` for an order above
    /// [`SplinePiece::MAX_ORDER`].
    #[must_use]
    pub fn pieces(&self) -> Option<Vec<SplinePiece>> {
        let mut pieces: Vec<SplinePiece> = Vec::new();
        let last = self.spans().last()?;
        for span in self.spans() {
            let start = pieces.last().map_or(self.start(), |piece| piece.end());
            let end = (span == last).then(|| self.end());
            pieces.push(SplinePiece::of_weighted(&self.bezier_points(span), start, end)?);
        }
        Some(pieces)
    }

    /// Length, mm, within `tolerance` mm.
    #[must_use]
    pub fn length(&self, tolerance: f64) -> f64 {
        let (first, last) = self.domain();
        self.length_between(first, last, tolerance)
    }

    /// Length between two parameters, mm, within `tolerance` mm; negative if `to` is below `from`.
    #[must_use]
    pub fn length_between(&self, from: f64, to: f64, tolerance: f64) -> f64 {
        if to < from {
            return -self.length_between(to, from, tolerance);
        }
        let share = tolerance / self.spans().count() as f64;
        self.spans()
            .map(|span| {
                let a = from.max(self.knots[span]);
                let b = to.min(self.knots[span + 1]);
                if a < b { self.length_in(span, a, b, share) } else { 0.0 }
            })
            .sum()
    }

    fn length_in(&self, span: usize, a: f64, b: f64, tolerance: f64) -> f64 {
        let points = self.bezier_points(span);
        let (from, over) = (self.knots[span], self.knots[span + 1] - self.knots[span]);
        let mut speed = |t: f64| bezier::velocity(&mut points.clone(), t).length();
        integral(&mut speed, (a - from) / over, (b - from) / over, tolerance)
    }

    /// The smallest box around the curve, mm.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        self.spans().fold(Aabb::of_points(self.start(), self.end()), |all, span| {
            let points = self.bezier_points(span);
            let [start, end] = [points[0], points[self.order - 1]].map(WeightedPoint::place);
            all.union(bezier::bounds(&points, start, end))
        })
    }

    /// The same curve in the opposite direction.
    #[must_use]
    pub fn reversed(&self) -> Spline {
        let (first, last) = self.domain();
        Spline {
            order: self.order,
            points: self.points.iter().rev().copied().collect(),
            weights: self.weights.iter().rev().copied().collect(),
            knots: self.knots.iter().rev().map(|knot| first + (last - knot)).collect(),
        }
    }

    /// The curve with mapped control points. For an affine map (translation, rotation, mirroring, scaling, shear) it is
    /// the mapped curve.
    #[must_use]
    pub fn mapped(&self, map: impl Fn(Vec3) -> Vec3) -> Spline {
        Spline { points: self.points.iter().copied().map(map).collect(), ..self.clone() }
    }

    /// The parts before and after a parameter; `None` if one of them would be empty.
    #[must_use]
    pub fn split_at(&self, u: f64) -> Option<(Spline, Spline)> {
        let (first, last) = self.domain();
        if !(first < u && u < last) {
            return None;
        }
        let mut whole = self.clone();
        while whole.knots.iter().filter(|knot| **knot == u).count() < self.order - 1 {
            whole = whole.with_knot(u);
        }
        // Then one control point is the point at u.
        let begin = whole.knots.iter().position(|knot| *knot == u)?;
        let middle = begin - 1;
        let part = |points: std::ops::RangeInclusive<usize>, knots: Vec<f64>| Spline {
            order: self.order,
            points: whole.points[points.clone()].to_vec(),
            weights: whole.weights[points].to_vec(),
            knots,
        };
        let before = whole.knots[..begin].iter().copied().chain(vec![u; self.order]).collect();
        let beyond = whole.knots[begin..].iter().copied().filter(|knot| *knot > u);
        let after = vec![u; self.order].into_iter().chain(beyond).collect();
        Some((part(0..=middle, before), part(middle..=whole.points.len() - 1, after)))
    }

    /// The same curve with one more knot.
    fn with_knot(&self, u: f64) -> Spline {
        let (span, degree) = (self.span(u), self.order - 1);
        let weighted = |index: usize| WeightedPoint::new(self.points[index], self.weights[index]);
        let same = self.knots.iter().filter(|knot| **knot == u).count();
        let (mut points, mut weights) = (self.points.clone(), self.weights.clone());
        let changed = span + 1 - degree..=span - same;
        points.insert(span - same, Vec3::ZERO);
        weights.insert(span - same, 0.0);
        for index in changed {
            let share = (u - self.knots[index]) / (self.knots[index + degree] - self.knots[index]);
            let mean = weighted(index - 1).lerp(weighted(index), share);
            (points[index], weights[index]) = (mean.place(), mean.weight);
        }
        let mut knots = self.knots.clone();
        knots.insert(span + 1, u);
        Spline { order: self.order, points, weights, knots }
    }
}

fn check(order: usize, points: &[Vec3], weights: &[f64]) -> Result<(), SplineError> {
    if order < 2 {
        return Err(SplineError::Order(order));
    }
    if points.len() < order {
        return Err(SplineError::TooFew { points: points.len(), order });
    }
    if weights.len() != points.len() {
        return Err(SplineError::Weights(weights.len()));
    }
    if let Some(weight) = weights.iter().find(|weight| !(**weight > 0.0 && weight.is_finite())) {
        return Err(SplineError::Weight(*weight));
    }
    if points.iter().all(|point| point.is_finite()) { Ok(()) } else { Err(SplineError::NotFinite) }
}

//! One polynomial span of a spline as a separate curve: a rational Bezier curve.

use crate::bezier::{self, Bezier, MAX_SPAN_ORDER, WeightedPoint};
use crate::quadrature::integral;
use crate::{Aabb, ChordError, Chords, Line, Nearest, ParamCurve, Placement, Transform, Vec3};

/// The relative error of a length, from rounding.
pub(crate) const OFF: f64 = 1e-13;

/// One exact polynomial span of a [`Spline`](crate::Spline): a rational Bezier curve of order 2 to
/// [`SplinePiece::MAX_ORDER`]. It is made by [`Spline::pieces`](crate::Spline::pieces).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplinePiece {
    points: [Vec3; MAX_SPAN_ORDER],
    weights: [f64; MAX_SPAN_ORDER],
    order: usize,
    length: f64,
}

impl SplinePiece {
    /// The highest order (degree + 1).
    pub const MAX_ORDER: usize = MAX_SPAN_ORDER;

    /// The Bezier curve with these control points (mm) and weights. `None` if their numbers differ, there are fewer
    /// than two or more than [`SplinePiece::MAX_ORDER`], or a weight is not above zero.
    #[must_use]
    pub fn new(points: &[Vec3], weights: &[f64]) -> Option<SplinePiece> {
        let above_zero = weights.iter().all(|weight| *weight > 0.0);
        if !(2..=MAX_SPAN_ORDER).contains(&points.len())
            || weights.len() != points.len()
            || !above_zero
        {
            return None;
        }
        let (mut own, mut of_points) = ([Vec3::ZERO; MAX_SPAN_ORDER], [0.0; MAX_SPAN_ORDER]);
        own[..points.len()].copy_from_slice(points);
        of_points[..points.len()].copy_from_slice(weights);
        let order = points.len();
        Some(SplinePiece { points: own, weights: of_points, order, length: 0.0 }.measured())
    }

    /// The curve of weighted points, with the exact ends.
    pub(crate) fn of_weighted(
        of: &[WeightedPoint],
        start: Vec3,
        end: Option<Vec3>,
    ) -> Option<SplinePiece> {
        let mut points: Vec<Vec3> = of.iter().map(|point| point.place()).collect();
        let weights: Vec<f64> = of.iter().map(|point| point.weight).collect();
        *points.first_mut()? = start;
        if let Some(end) = end {
            *points.last_mut()? = end;
        }
        SplinePiece::new(&points, &weights)
    }

    /// Degree + 1.
    #[must_use]
    pub fn order(&self) -> usize {
        self.order
    }

    /// The control points, mm.
    #[must_use]
    pub fn points(&self) -> &[Vec3] {
        &self.points[..self.order]
    }

    /// Their weights.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights[..self.order]
    }

    fn measured(mut self) -> SplinePiece {
        self.length = self.length_to(1.0);
        self
    }

    fn weighted(&self) -> [WeightedPoint; MAX_SPAN_ORDER] {
        std::array::from_fn(|index| WeightedPoint::new(self.points[index], self.weights[index]))
    }

    /// The weighted control points relative to the start, so that a small curve far from the origin loses no digits.
    fn about_start(&self) -> [WeightedPoint; MAX_SPAN_ORDER] {
        let start = self.points[0];
        std::array::from_fn(|index| {
            WeightedPoint::new(self.points[index] - start, self.weights[index])
        })
    }

    fn bezier(&self) -> Bezier {
        Bezier { points: self.about_start(), order: self.order, start: self.points[0] }
    }

    /// The point at parameter `t` from 0 to 1, mm, and its first three derivatives with respect to `t`.
    #[must_use]
    pub fn jet_at_parameter(&self, t: f64) -> [Vec3; 4] {
        let mut jet = self.bezier().jet(t);
        if t <= 0.0 {
            jet[0] = self.points[0];
        } else if t >= 1.0 {
            jet[0] = self.points[self.order - 1];
        }
        jet
    }

    fn speed(&self, t: f64) -> f64 {
        bezier::velocity(&mut self.about_start()[..self.order], t).length()
    }

    /// Length of the control polygon, mm, which is at least that of the curve.
    pub(crate) fn hull_length(&self) -> f64 {
        self.points().windows(2).map(|pair| pair[0].distance(pair[1])).sum()
    }

    /// Length from the start to parameter `t`, mm.
    fn length_to(&self, t: f64) -> f64 {
        self.length_between(0.0, t)
    }

    fn length_between(&self, from: f64, to: f64) -> f64 {
        integral(&mut |t| self.speed(t), from, to, OFF * self.hull_length())
    }

    /// The parameter at `s` mm from the start, 0 to 1; NaN if `s` is NaN.
    #[must_use]
    pub fn parameter_at(&self, s: f64) -> f64 {
        if s <= 0.0 {
            return 0.0;
        }
        if s >= self.length {
            return 1.0;
        }
        self.parameter_between((0.0, 0.0), (1.0, self.length), s)
    }

    /// The parameter at `s`, mm, between two parameters whose lengths are known, by Newton's method, with bisection
    /// where it would leave the interval.
    pub(crate) fn parameter_between(&self, low: (f64, f64), high: (f64, f64), s: f64) -> f64 {
        const MAX_STEPS: u32 = 60;
        let (mut low, mut high) = (low, high);
        let share = (s - low.1) / (high.1 - low.1);
        if share.is_nan() {
            return share;
        }
        let mut t = low.0 + (high.0 - low.0) * share.clamp(0.0, 1.0);
        for _ in 0..MAX_STEPS {
            // From the nearer end, so that the integral is short.
            let length = if t - low.0 <= high.0 - t {
                low.1 + self.length_between(low.0, t)
            } else {
                high.1 - self.length_between(t, high.0)
            };
            if length > s {
                high = (t, length);
            } else {
                low = (t, length);
            }
            let off = length - s;
            if off.abs() <= OFF * self.length || !length.is_finite() {
                return t;
            }
            let next = t - off / self.speed(t);
            let last = t;
            t = if low.0 < next && next < high.0 { next } else { 0.5 * (low.0 + high.0) };
            if (t - last).abs() <= f64::EPSILON * t {
                return t;
            }
        }
        t
    }

    /// The point at a parameter, mm, and its derivatives with respect to length.
    pub(crate) fn by_length(&self, t: f64) -> [Vec3; 4] {
        // A speed below this fraction of the control polygon counts as zero: the direction is that of the curve after it.
        const STILL: f64 = 1e-9;
        let [point, d1, d2, d3] = self.jet_at_parameter(t);
        let speed = d1.length();
        let hull = self.hull_length();
        if speed <= STILL * hull {
            let toward = if t < 0.5 { d2 } else { -d2 };
            let tangent = if toward.length() > STILL * hull { toward } else { d3 };
            let tangent = tangent.normalized().unwrap_or(Vec3::ZERO);
            return [point, tangent, Vec3::ZERO, Vec3::ZERO];
        }
        // With g = |p'|: g' = p'·p''/g, and d/ds = (d/dt)/g.
        let tangent = d1 / speed;
        let g1 = d2.dot(tangent);
        let across = d2 - tangent * g1;
        let square = speed * speed;
        let curvature = across / square;
        let tangent1 = across / speed;
        let g2 = d3.dot(tangent) + d2.dot(tangent1);
        let across1 = d3 - tangent1 * g1 - tangent * g2;
        let curvature1 = (across1 - curvature * (2.0 * speed * g1)) / (square * speed);
        [point, tangent, curvature, curvature1]
    }

    /// The parts before and after a parameter. The end of the first equals the start of the second.
    #[must_use]
    pub fn split_at_parameter(&self, t: f64) -> (SplinePiece, SplinePiece) {
        let mut before = self.about_start();
        let mut after = before;
        let start = self.points[0];
        bezier::split(&mut before[..self.order], &mut after[..self.order], t);
        let part = |of: &[WeightedPoint; MAX_SPAN_ORDER]| SplinePiece {
            points: std::array::from_fn(|k| {
                if k < self.order { start + of[k].place() } else { Vec3::ZERO }
            }),
            weights: std::array::from_fn(|k| if k < self.order { of[k].weight } else { 0.0 }),
            ..*self
        };
        let (mut first, mut second) = (part(&before), part(&after));
        first.points[0] = self.points[0];
        second.points[self.order - 1] = self.points[self.order - 1];
        second.points[0] = first.points[self.order - 1];
        (first.measured(), second.measured())
    }

    fn part(&self, t0: f64, t1: f64) -> SplinePiece {
        let (rest, _) = self.split_at_parameter(t1);
        if t0 <= 0.0 {
            return rest;
        }
        let share = if t1 > 0.0 { t0 / t1 } else { 1.0 };
        rest.split_at_parameter(share).1
    }

    /// Passes the curve to `push` in even parts: each turns by at most a quarter radian, and its parametric speed
    /// varies by at most a factor of two, so that few points are enough to find its curvature. Where no part is this
    /// even (at a cusp, or at a start without speed), a part that deviates from a straight line by at most `tolerance`
    /// mm and is at most ten times as long becomes that line.
    pub fn even_parts(&self, tolerance: f64, push: &mut impl FnMut(EvenPart)) {
        const MAX_NEWTON_DIVISIONS: u32 = 60;
        let mut open = vec![(*self, 0)];
        while let Some((part, depth)) = open.pop() {
            let (start, end) = (part.start(), part.end());
            let short = part.hull_length() <= 10.0 * tolerance && part.flatness() <= tolerance;
            if part.is_straight() || short || depth >= MAX_NEWTON_DIVISIONS {
                push(EvenPart::Line(Line { start, end }));
            } else if part.is_even() {
                push(EvenPart::Bent(part));
            } else {
                let (before, after) = part.split_at_parameter(0.5);
                open.push((after, depth + 1));
                open.push((before, depth + 1));
            }
        }
    }

    /// Whether it is the straight line between its ends within rounding, without reversals.
    fn is_straight(&self) -> bool {
        let chord = self.end() - self.start();
        let size = self.points().iter().fold(0.0_f64, |size, point| size.max(point.length()));
        let forward = self.points().windows(2).all(|pair| (pair[1] - pair[0]).dot(chord) >= 0.0);
        forward && self.flatness() <= 4.0 * f64::EPSILON * size
    }

    /// The largest distance of a control point from the line between the ends, mm: a bound for that of the curve.
    fn flatness(&self) -> f64 {
        let line = Line { start: self.start(), end: self.end() };
        self.points().iter().fold(0.0, |most, point| most.max(line.nearest(*point).distance))
    }

    fn is_even(&self) -> bool {
        // The tangent of the largest angle between the legs of the control polygon.
        const TURN: f64 = 0.25;
        const RATIO: f64 = 2.0;
        let legs = self.points().windows(2).map(|pair| pair[1] - pair[0]);
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        let mut turn = 0.0;
        let mut last: Option<Vec3> = None;
        for leg in legs {
            let length = leg.length();
            (least, most) = (least.min(length), most.max(length));
            if let Some(before) = last {
                let along = before.dot(leg);
                if along <= 0.0 {
                    return false;
                }
                turn += before.cross(leg).length() / along;
            }
            last = Some(leg);
        }
        let weights = self.weights().iter();
        let (light, heavy) =
            weights.fold((f64::INFINITY, 0.0_f64), |(a, b), w| (a.min(*w), b.max(*w)));
        most <= RATIO * least && heavy <= RATIO * light && turn <= TURN
    }
}

/// A part of a spline from [`SplinePiece::even_parts`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "handed on at once, never kept in numbers")]
pub enum EvenPart {
    /// A straight part.
    Line(Line),
    /// A curved part.
    Bent(SplinePiece),
}

impl ParamCurve for SplinePiece {
    fn start(&self) -> Vec3 {
        self.points[0]
    }

    fn end(&self) -> Vec3 {
        self.points[self.order - 1]
    }

    fn length(&self) -> f64 {
        self.length
    }

    fn point_at(&self, s: f64) -> Vec3 {
        self.jet_at_parameter(self.parameter_at(s))[0]
    }

    fn tangent_at(&self, s: f64) -> Vec3 {
        self.by_length(self.parameter_at(s))[1]
    }

    fn curvature_at(&self, s: f64) -> Vec3 {
        self.by_length(self.parameter_at(s))[2]
    }

    fn curvature_derivative_at(&self, s: f64) -> Vec3 {
        self.by_length(self.parameter_at(s))[3]
    }

    fn jet_at(&self, s: f64) -> [Vec3; 4] {
        self.by_length(self.parameter_at(s))
    }

    fn bounds(&self) -> Aabb {
        bezier::bounds(&self.weighted()[..self.order], self.start(), self.end())
    }

    fn reversed(&self) -> Self {
        let mut turned = *self;
        turned.points[..self.order].reverse();
        turned.weights[..self.order].reverse();
        turned
    }

    fn split_at(&self, s: f64) -> (Self, Self) {
        self.split_at_parameter(self.parameter_at(s))
    }

    fn subsegment(&self, s0: f64, s1: f64) -> Self {
        let (t0, t1) = (self.parameter_at(s0), self.parameter_at(s1));
        if t1 < t0 { self.part(t1, t0).reversed() } else { self.part(t0, t1) }
    }

    fn transformed(&self, transform: &Transform) -> Self {
        let mut moved = *self;
        for point in &mut moved.points[..self.order] {
            *point = transform.apply_point(*point);
        }
        moved.length = self.length * transform.scale_factor();
        moved
    }

    /// Divides parts as long as one of their points may be nearer than the nearest one found.
    fn nearest(&self, p: Vec3) -> Nearest {
        const MAX_SEARCH_DIVISIONS: u32 = 50;
        // A relative improvement below this is ignored: all points of a circle are equally near to its centre.
        const SEARCH_TOLERANCE: f64 = 1e-10;
        let size = self.hull_length();
        let mut best = (0.0, self.start().distance(p));
        let see = |t: f64, best: &mut (f64, f64)| {
            let distance = self.jet_at_parameter(t)[0].distance(p);
            if distance < best.1 {
                *best = (t, distance);
            }
        };
        see(1.0, &mut best);
        let mut open = vec![(self.weighted(), 0.0, 1.0, 0)];
        while let Some((mut part, from, to, depth)) = open.pop() {
            let points = part[..self.order].iter().map(|point| point.place());
            let line = Line { start: part[0].place(), end: part[self.order - 1].place() };
            let flatness = points.fold(0.0_f64, |far, q| far.max(line.nearest(q).distance));
            let least = line.nearest(p).distance - flatness;
            let enough = SEARCH_TOLERANCE * (best.1 + size);
            if depth >= MAX_SEARCH_DIVISIONS || least.is_nan() || least >= best.1 - enough {
                continue;
            }
            let mut after = part;
            bezier::split(&mut part[..self.order], &mut after[..self.order], 0.5);
            let middle = 0.5 * (from + to);
            see(middle, &mut best);
            // The nearer half last, so that it is searched first.
            let halves = [(part, from, middle, depth + 1), (after, middle, to, depth + 1)];
            let near = |half: &([WeightedPoint; MAX_SPAN_ORDER], f64, f64, u32)| {
                half.0[0].place().distance(p)
            };
            let end = self.jet_at_parameter(to)[0].distance(p);
            if near(&halves[0]) < end {
                open.extend(halves.into_iter().rev());
            } else {
                open.extend(halves);
            }
        }
        // Continues with Newton's method as long as the distance decreases.
        for _ in 0..8 {
            let [q, d1, d2, _] = self.jet_at_parameter(best.0);
            let by = (q - p).dot(d1) / (d1.length_squared() + (q - p).dot(d2));
            let t = (best.0 - by).clamp(0.0, 1.0);
            let before = best;
            if t.is_nan() {
                break;
            }
            see(t, &mut best);
            if best == before {
                break;
            }
        }
        let t = best.0;
        let point = self.jet_at_parameter(t)[0];
        Nearest { s: self.length_to(t), point, distance: point.distance(p) }
    }

    /// The largest curvature at many points, refined around the largest of them.
    fn max_curvature(&self) -> f64 {
        const PLACES: u32 = 64;
        let at = |t: f64| self.by_length(t)[2].length();
        let place = |k: u32| f64::from(k) / f64::from(PLACES);
        let (mut best, mut most) = (0, at(0.0));
        for k in 1..=PLACES {
            let found = at(place(k));
            if found > most {
                (best, most) = (k, found);
            }
        }
        let (mut low, mut high) = (place(best.saturating_sub(1)), place((best + 1).min(PLACES)));
        for _ in 0..80 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            let (of_a, of_b) = (at(a), at(b));
            most = most.max(of_a).max(of_b);
            if of_a < of_b {
                low = a;
            } else {
                high = b;
            }
        }
        most
    }

    fn chords(&self, tolerance: f64, _placement: Placement) -> Result<Chords, ChordError> {
        let steps = self.steps_within(tolerance);
        Chords::along(self.bezier(), self.end(), steps, tolerance)
    }
}

impl SplinePiece {
    /// The number of steps of equal parameter whose chords are within `tolerance`, mm.
    ///
    /// If A and w are replaced by their linear interpolation over a step, the curve becomes the chord. The
    /// interpolation errors are at most step²/8 of their second derivatives, so the curve deviates from the chord by at
    /// most step²/8·(max|A''| + max|C|·max|w''|)/min w. The control points bound all of these values.
    fn steps_within(&self, tolerance: f64) -> f64 {
        let hull = self.points().iter().fold(Aabb::EMPTY, |hull, point| hull.include(*point));
        let middle = hull.center();
        let weighted: [WeightedPoint; MAX_SPAN_ORDER] =
            std::array::from_fn(|k| WeightedPoint::new(self.points[k] - middle, self.weights[k]));
        let mut bends = (0.0_f64, 0.0_f64);
        for three in weighted[..self.order].windows(3) {
            let bend = three[2].minus(three[1]).minus(three[1].minus(three[0]));
            bends = (bends.0.max(bend.point.length()), bends.1.max(bend.weight.abs()));
        }
        let far = self.points().iter().fold(0.0_f64, |far, point| far.max(point.distance(middle)));
        let least = self.weights().iter().fold(f64::INFINITY, |least, weight| least.min(*weight));
        let degree = (self.order - 1) as f64;
        let most = degree * (degree - 1.0) * (bends.0 + far * bends.1) / least;
        (most / (8.0 * tolerance)).sqrt()
    }
}

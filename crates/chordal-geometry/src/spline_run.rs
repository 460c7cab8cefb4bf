//! A span of a spline evaluated at many points.
//!
//! Neither the length of a spline nor the parameter at a length has a closed form. The points are therefore approximated
//! by polynomials in the length, in cells: by polynomials of the ninth degree with the point and four derivatives of the
//! curve at both ends. With x from −1 to 1 the error of such a polynomial is (1 − x²)⁵·E(x), where E is the tenth
//! derivative divided by 10!. E and its change are determined at the middle of the parameter interval, by comparison with
//! the exact curve and its length by quadrature. If the error bound is too large, the parameter interval is halved.
//!
//! The cells depend only on the curve, so the result does not depend on earlier evaluations.

use crate::bezier::{self, MAX_SPAN_ORDER, WeightedPoint};
use crate::quadrature::{gauss, integral};
use crate::spline_piece::OFF;
use crate::{ParamCurve, SplinePiece, Vec3};

/// The error bound of a cell, mm, and also as a fraction of its length: a hundredth of the resolution of the finest
/// scales. For a cell that is passed in a millisecond, the jerk is then accurate to a hundred-thousandth of that of the
/// axes.
const OFF_MM: f64 = 1e-9;
const OFF_SHARE: f64 = 1e-10;
/// The error bound as a fraction of the whole length, if that is larger: ten times the relative error of the length.
const OFF_WHOLE: f64 = 10.0 * OFF;

/// The error of a cell is estimated from E and its first two derivatives at the middle; this factor allows for the higher
/// ones.
const ERROR_MARGIN: f64 = 2.0;
/// The largest of (1 − x²)⁵·|x|, at x² = 1/11, and of (1 − x²)⁵·x²/2, at x² = 1/6.
const AT_SLOPE: f64 = 0.1873;
const AT_BEND: f64 = 0.0335;

/// A cell as narrow as this fraction of the parameter is not halved again: at a cusp no polynomial approximates the
/// curve.
const NARROWEST: f64 = 1.0 / 32_768.0;

/// A speed below this fraction of the control polygon counts as zero.
const STILL: f64 = 1e-9;

/// The number of Taylor coefficients at a point: the point, and four derivatives divided by their factorials.
const KNOWN: usize = 5;
/// The number of coefficients of a polynomial that is determined by these at both ends.
const TERMS: usize = 2 * KNOWN;

/// The contributions of the means of the even derivatives at both ends, and half the differences of the odd ones (divided
/// by their factorials) to the coefficients of the even powers of x: a row for each derivative, times 128.
const EVEN_DERIVATIVE_WEIGHTS: [[f64; KNOWN]; KNOWN] = [
    [128.0, 0.0, 0.0, 0.0, 0.0],
    [-93.0, 140.0, -70.0, 28.0, -5.0],
    [58.0, -152.0, 140.0, -56.0, 10.0],
    [-28.0, 96.0, -120.0, 64.0, -12.0],
    [8.0, -32.0, 48.0, -32.0, 8.0],
];
/// The same for the odd powers, from half the differences of the even derivatives and the means of the odd ones.
const ODD: [[f64; KNOWN]; KNOWN] = [
    [315.0, -420.0, 378.0, -180.0, 35.0],
    [-187.0, 420.0, -378.0, 180.0, -35.0],
    [94.0, -280.0, 308.0, -152.0, 30.0],
    [-36.0, 128.0, -168.0, 96.0, -20.0],
    [8.0, -32.0, 48.0, -32.0, 8.0],
];

/// X, Y, Z and zero, so that a processor can compute with pairs.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
struct SplineRow([f64; 4]);

impl SplineRow {
    const ZERO: SplineRow = SplineRow([0.0; 4]);

    #[inline(always)]
    fn of(point: Vec3) -> SplineRow {
        SplineRow([point.x, point.y, point.z, 0.0])
    }

    #[inline(always)]
    fn vec(self) -> Vec3 {
        Vec3::new(self.0[0], self.0[1], self.0[2])
    }

    #[inline(always)]
    fn times(self, k: f64) -> SplineRow {
        SplineRow(self.0.map(|value| value * k))
    }

    #[inline(always)]
    fn plus(self, other: SplineRow) -> SplineRow {
        let SplineRow([a, b, c, d]) = self;
        let SplineRow([e, f, g, h]) = other;
        SplineRow([a + e, b + f, c + g, d + h])
    }
}

/// A piece and the cell of it that was used last.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SplineReader {
    piece: SplinePiece,
    powers: PowerSeries,
    cell: PolynomialCell,
    /// The half after the cell, if the cell is the half before: the next search begins there.
    next: Option<(KnownLength, KnownLength)>,
}

/// A part of the curve that is approximated by a polynomial.
#[derive(Clone, Copy, Debug)]
struct PolynomialCell {
    /// Its start and its end, mm from the start of the curve.
    from: f64,
    to: f64,
    /// Its middle, mm from the start of the curve, and the inverse of half its length, 1/mm.
    middle: f64,
    per_half: f64,
    /// The coefficients of the powers of x, mm; x is −1 at its start and 1 at its end.
    terms: [SplineRow; TERMS],
    /// The parameters at its ends, if no polynomial approximates the curve here, so that it is evaluated exactly.
    exactly: Option<(f64, f64)>,
}

/// A point whose length from the start is known.
#[derive(Clone, Copy, Debug)]
struct KnownLength {
    /// Its parameter, from −1 at the start of the curve to 1 at its end.
    x: f64,
    /// Its length from the start, mm.
    s: f64,
    /// The point relative to the start, mm, and its derivatives with respect to length, divided by their factorials.
    series: [Vec3; KNOWN],
}

impl SplineReader {
    pub(crate) fn new(piece: &SplinePiece) -> SplineReader {
        SplineReader {
            piece: *piece,
            powers: PowerSeries::new(piece),
            cell: PolynomialCell::NONE,
            next: None,
        }
    }

    /// The point at `s` mm from the start and its derivatives with respect to time, if those of `s` are `by_time`.
    #[inline(always)]
    pub(crate) fn motion_at(&mut self, s: f64, by_time: [f64; 3]) -> [Vec3; 4] {
        if !(s >= self.cell.from && s < self.cell.to) {
            self.find(s);
        }
        if self.cell.exactly.is_some() {
            return self.exact_motion_at(s, by_time);
        }
        self.cell.motion_at(s, by_time)
    }

    #[cold]
    #[inline(never)]
    fn exact_motion_at(&self, s: f64, [v, a, j]: [f64; 3]) -> [Vec3; 4] {
        let PolynomialCell { from, to, exactly, .. } = self.cell;
        let (low, high) = exactly.unwrap_or((0.0, 1.0));
        let t = self.piece.parameter_between((low, from), (high, to), s);
        let [point, d1, d2, d3] = self.piece.by_length(t);
        [point, d1 * v, d1 * a + d2 * (v * v), d1 * j + d2 * (3.0 * v * a) + d3 * (v * v * v)]
    }

    /// Finds the cell that contains `s`, mm, by bisection of the parameter.
    #[cold]
    #[inline(never)]
    fn find(&mut self, s: f64) {
        let SplineReader { piece, powers, .. } = self;
        let (start, whole, hull) = (piece.start(), piece.length(), piece.hull_length());
        let known =
            |x: f64, s: f64| KnownLength { x, s, series: by_length(&powers.series(x), hull) };
        let next = self.next.take().filter(|(low, high)| s >= low.s && s < high.s);
        let (mut low, mut high) = next.unwrap_or_else(|| (known(-1.0, 0.0), known(1.0, whole)));
        while high.x - low.x > NARROWEST {
            let cell = PolynomialCell::between(&low, &high);
            let length = high.s - low.s;
            let x = 0.5 * (low.x + high.x);
            let mut speed = |x: f64| powers.speed(x);
            let mut before = gauss(&mut speed, low.x, x);
            let measured = before + gauss(&mut speed, x, high.x);
            let even = (measured - length).abs() <= 4.0 * OFF * whole;
            if !even {
                before = integral(&mut speed, low.x, x, OFF * hull);
            }
            let middle = known(x, low.s + before);
            let allowed = OFF_MM.min(OFF_SHARE * length).max(OFF_WHOLE * whole);
            if even && cell.is_off_at(&middle) <= allowed {
                self.cell = cell.seen_from(start);
                return;
            }
            if s < middle.s {
                self.next = Some((middle, high));
                high = middle;
            } else {
                low = middle;
            }
        }
        let parameter = |x: f64| 0.5 * (1.0 + x);
        let exactly = Some((parameter(low.x), parameter(high.x)));
        self.cell = PolynomialCell { exactly, ..PolynomialCell::between(&low, &high) };
    }
}

impl PolynomialCell {
    const NONE: PolynomialCell = PolynomialCell {
        from: 0.0,
        to: 0.0,
        middle: 0.0,
        per_half: 0.0,
        terms: [SplineRow::ZERO; TERMS],
        exactly: None,
    };

    /// The polynomial that agrees with the curve at two points, relative to the start of the curve.
    fn between(low: &KnownLength, high: &KnownLength) -> PolynomialCell {
        let half = 0.5 * (high.s - low.s);
        let per_half = if half > 0.0 { 1.0 / half } else { 0.0 };
        let mut terms = [SplineRow::ZERO; TERMS];
        let mut scale = 0.5 / 128.0;
        for order in 0..KNOWN {
            let (one, two) = (SplineRow::of(low.series[order]), SplineRow::of(high.series[order]));
            let (sum, step) = (two.plus(one).times(scale), two.plus(one.times(-1.0)).times(scale));
            let (for_even, for_odd) = if order % 2 == 0 { (sum, step) } else { (step, sum) };
            for power in 0..KNOWN {
                let (even, odd) = (EVEN_DERIVATIVE_WEIGHTS[order][power], ODD[order][power]);
                terms[2 * power] = terms[2 * power].plus(for_even.times(even));
                terms[2 * power + 1] = terms[2 * power + 1].plus(for_odd.times(odd));
            }
            scale *= half;
        }
        let middle = 0.5 * (low.s + high.s);
        PolynomialCell { from: low.s, to: high.s, middle, per_half, terms, exactly: None }
    }

    /// The same polynomial in absolute coordinates, from the start of the curve.
    fn seen_from(mut self, start: Vec3) -> PolynomialCell {
        self.terms[0] = self.terms[0].plus(SplineRow::of(start));
        self
    }

    /// The error bound of the polynomial, mm, from a point near its middle.
    fn is_off_at(&self, place: &KnownLength) -> f64 {
        let x = (place.s - self.middle) * self.per_half;
        let half = 0.5 * (self.to - self.from);
        let [point, d1, d2, ..] = place.series;
        // With respect to x, which is linear in the length.
        let [q, q1, q2, _] = self.motion_at(place.s, [half, 0.0, 0.0]);
        let off = q - point;
        let off1 = q1 - d1 * half;
        let off2 = q2 - d2 * (2.0 * half * half);
        // f = (1 − x²)⁵ and its derivatives; the error is f·E.
        let u = 1.0 - x * x;
        let cube = u * u * u;
        let (f, f1, f2) = (cube * u * u, -10.0 * x * cube * u, cube * (90.0 * x * x - 10.0));
        let e = off / f;
        let e1 = (off1 - e * f1) / f;
        let e2 = (off2 - e * f2 - e1 * (2.0 * f1)) / f;
        ERROR_MARGIN * (e.length() + AT_SLOPE * e1.length() + AT_BEND * e2.length())
    }

    #[inline(always)]
    fn motion_at(&self, s: f64, [speed, acceleration, jerk]: [f64; 3]) -> [Vec3; 4] {
        let x = (s - self.middle) * self.per_half;
        // Horner's scheme: the value, the first derivative, half of the second, a sixth of the third.
        let [t0, t1, t2, t3, t4, t5, t6, t7, t8, t9] = &self.terms;
        let step = |of: SplineRow, add: &SplineRow| of.times(x).plus(*add);
        let (first, value) = (*t9, step(*t9, t8));
        let (second, first, value) = (first, step(first, &value), step(value, t7));
        let mut third = second;
        let (mut second, mut first, mut value) =
            (step(second, &first), step(first, &value), step(value, t6));
        for term in [t5, t4, t3, t2, t1, t0] {
            third = step(third, &second);
            second = step(second, &first);
            first = step(first, &value);
            value = step(value, term);
        }
        // The derivatives of x with respect to time.
        let [x1, x2, x3] = [speed, acceleration, jerk].map(|of| of * self.per_half);
        let square = x1 * x1;
        let velocity = first.times(x1);
        let acceleration = first.times(x2).plus(second.times(2.0 * square));
        let jerk = first.times(x3).plus(second.times(6.0 * x1 * x2));
        let jerk = jerk.plus(third.times(6.0 * square * x1));
        [value, velocity, acceleration, jerk].map(SplineRow::vec)
    }
}

/// A piece as a polynomial in x, which is −1 at its start and 1 at its end: points relative to the start, times their
/// weights.
#[derive(Clone, Copy, Debug)]
struct PowerSeries {
    terms: [WeightedPoint; MAX_SPAN_ORDER],
    degree: usize,
    /// Whether the weights differ; if not, they are 1 here.
    rational: bool,
}

impl PowerSeries {
    fn new(piece: &SplinePiece) -> PowerSeries {
        let (points, weights) = (piece.points(), piece.weights());
        let rational = weights.iter().any(|weight| *weight != weights[0]);
        let mut terms = [WeightedPoint::ZERO; MAX_SPAN_ORDER];
        for (index, term) in terms[..points.len()].iter_mut().enumerate() {
            let weight = if rational { weights[index] } else { 1.0 };
            *term = WeightedPoint::new(points[index] - points[0], weight);
        }
        bezier::to_powers(&mut terms[..points.len()]);
        PowerSeries { terms, degree: points.len() - 1, rational }
    }

    /// The point and its derivatives with respect to x, divided by their factorials.
    fn series(&self, x: f64) -> [Vec3; KNOWN] {
        let mut series = [WeightedPoint::ZERO; KNOWN];
        for term in self.terms[..=self.degree].iter().rev() {
            for order in (1..KNOWN).rev() {
                series[order] = series[order].times(x).plus(series[order - 1]);
            }
            series[0] = series[0].times(x).plus(*term);
        }
        let mut points = series.map(|part| part.point);
        if self.rational {
            // Solves w·c = A, power by power.
            let per_weight = 1.0 / series[0].weight;
            for order in 0..KNOWN {
                let mut point = points[order];
                for low in 0..order {
                    point -= points[low] * series[order - low].weight;
                }
                points[order] = point * per_weight;
            }
        }
        points
    }

    /// The parametric speed |dp/dx|, mm.
    #[inline]
    fn speed(&self, x: f64) -> f64 {
        if !self.rational {
            let mut slope = Vec3::ZERO;
            for (order, term) in self.terms[..=self.degree].iter().enumerate().skip(1).rev() {
                slope = slope * x + term.point * order as f64;
            }
            return slope.length();
        }
        let (mut value, mut first) = (WeightedPoint::ZERO, WeightedPoint::ZERO);
        for term in self.terms[..=self.degree].iter().rev() {
            first = first.times(x).plus(value);
            value = value.times(x).plus(*term);
        }
        let weight = value.weight;
        (first.point * weight - value.point * first.weight).length() / (weight * weight)
    }
}

/// A point and its derivatives with respect to length, from those with respect to a parameter, all divided by their
/// factorials. They are zero if the speed is negligible relative to `hull`, the length of the control polygon, mm.
fn by_length([c0, c1, c2, c3, c4]: &[Vec3; KNOWN], hull: f64) -> [Vec3; KNOWN] {
    let (c0, c1, c2, c3, c4) = (*c0, *c1, *c2, *c3, *c4);
    let speed = c1.length();
    if speed <= STILL * hull {
        return [c0, Vec3::ZERO, Vec3::ZERO, Vec3::ZERO, Vec3::ZERO];
    }
    // The square of the speed, the speed, and from it the length, as power series in the parameter.
    let square1 = 4.0 * c1.dot(c2);
    let square2 = 4.0 * c2.dot(c2) + 6.0 * c1.dot(c3);
    let square3 = 12.0 * c2.dot(c3) + 8.0 * c1.dot(c4);
    let per_twice = 0.5 / speed;
    let g1 = square1 * per_twice;
    let g2 = (square2 - g1 * g1) * per_twice;
    let g3 = (square3 - 2.0 * g1 * g2) * per_twice;
    // Scaled by the first term: the parameter is b·(s − …), by reversion of the series.
    let b = 1.0 / speed;
    let (l2, l3, l4) = (g1 * b / 2.0, g2 * b / 3.0, g3 * b / 4.0);
    let m2 = -l2;
    let m3 = 2.0 * l2 * l2 - l3;
    let m4 = 5.0 * l2 * (l3 - l2 * l2) - l4;
    // The parameter is y + m2·y² + m3·y³ + m4·y⁴ with y = b·s.
    let b2 = b * b;
    [
        c0,
        c1 * b,
        (c2 + c1 * m2) * b2,
        (c3 + c2 * (2.0 * m2) + c1 * m3) * (b2 * b),
        (c4 + c3 * (3.0 * m2) + c2 * (2.0 * m3 + m2 * m2) + c1 * m4) * (b2 * b2),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::EvenPart;

    /// Numbers from −1 to 1 by a simple generator.
    struct Dice(u64);

    impl Dice {
        fn next(&mut self) -> f64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        }
    }

    /// A span with up to six control points in a box of 0.02 to 200 mm, every third with weights.
    fn random_piece(dice: &mut Dice, seed: u64) -> SplinePiece {
        let count = 3 + (seed % 4) as usize;
        let size = 10f64.powf(2.0 * dice.next());
        let far = Vec3::new(dice.next(), dice.next(), dice.next()) * 500.0;
        let points: Vec<Vec3> = (0..count)
            .map(|_| far + Vec3::new(dice.next(), dice.next(), dice.next()) * size)
            .collect();
        let weights: Vec<f64> = (0..count)
            .map(|_| if seed.is_multiple_of(3) { 3f64.powf(dice.next()) } else { 1.0 })
            .collect();
        SplinePiece::new(&points, &weights).expect("a piece")
    }

    /// Calls for the even parts of so many random pieces, or of as many as the environment says:
    /// `CHORDAL_ROUNDS=30000 cargo test --release -p chordal-geometry --lib spline_run`.
    fn for_even_parts(mut see: impl FnMut(&SplinePiece)) {
        let rounds = option_env!("CHORDAL_ROUNDS").and_then(|rounds| rounds.parse().ok());
        let mut dice = Dice(0x9e37_79b9_7f4a_7c15);
        for seed in 0..rounds.unwrap_or(60) {
            random_piece(&mut dice, seed).even_parts(1e-6, &mut |part| {
                if let EvenPart::Bent(bent) = part {
                    see(&bent);
                }
            });
        }
    }

    #[test]
    fn even_parts_are_polynomials_within_what_is_allowed() {
        // Coordinates are up to 700 mm from their origin.
        const ROUNDING: f64 = 1e-12;
        // What the derivatives of (1 − x²)⁵ are at most, and so much more for those of E.
        const BY_X: [f64; 4] = [1.0, 2.0, 10.0, 50.0];
        let (mut parts, mut cells, mut worst) = (0, 0, [0.0_f64; 4]);
        for_even_parts(|bent| {
            let mut run = SplineReader::new(bent);
            let length = bent.length();
            parts += 1;
            while run.cell.to < length {
                run.find(run.cell.to);
                cells += 1;
                let PolynomialCell { from, to, per_half, exactly, .. } = run.cell;
                assert_eq!(exactly, None, "{bent:?}");
                let allowed = OFF_MM.min(OFF_SHARE * (to - from)).max(OFF_WHOLE * length);
                for k in 0..24 {
                    let at = from + (to - from) * (f64::from(k) + 0.5) / 24.0;
                    let laid = run.cell.motion_at(at, [1.0, 0.0, 0.0]);
                    let exact = bent.jet_at(at);
                    for order in 0..4 {
                        let off = laid[order].distance(exact[order]);
                        let rounding = if order == 0 { ROUNDING } else { 0.0 };
                        let most = allowed * BY_X[order] * per_half.powi(order as i32) + rounding;
                        assert!(off <= most, "{order}: {off:e} off, {most:e} allowed: {bent:?}");
                        worst[order] = worst[order].max(off / most);
                    }
                }
            }
        });
        println!("{parts} parts, {cells} cells, up to {worst:.2?} of what is allowed");
        assert!(parts > 1000 && cells < 3 * parts);
    }

    #[test]
    fn no_answer_depends_on_what_was_asked_before() {
        let mut dice = Dice(77);
        for_even_parts(|bent| {
            let mut asked = SplineReader::new(bent);
            for _ in 0..20 {
                let s = bent.length() * 0.5 * (1.0 + dice.next());
                let by_time = [30.0, -2.0, 1e3];
                let fresh = SplineReader::new(bent).motion_at(s, by_time);
                assert_eq!(asked.motion_at(s, by_time), fresh, "to the bit, at {s} mm of {bent:?}");
            }
        });
    }

    #[test]
    fn a_cusp_is_asked_exactly() {
        let points = [Vec3::ZERO, Vec3::ZERO, Vec3::new(2.0, 5.0, 1.0), Vec3::new(4.0, 0.0, 0.0)];
        let piece = SplinePiece::new(&points, &[1.0; 4]).expect("a piece");
        let mut run = SplineReader::new(&piece);
        let mut exact = 0;
        for k in 1..200 {
            // Nearer and nearer to the start.
            let s = piece.length() * 0.85_f64.powi(k);
            assert!(run.motion_at(s, [1.0, 0.0, 0.0])[0].distance(piece.point_at(s)) < 1e-10);
            exact += usize::from(run.cell.exactly.is_some());
        }
        assert!((20..150).contains(&exact), "{exact}");
    }
}

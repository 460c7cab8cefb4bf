//! An upper bound of the distance between two curves that are traversed at constant speed.

use chordal::geometry::{Arc, Curve, Frame, Line, ParamCurve, Spiral, Vec3};

/// The most pairs of points that are evaluated; beyond this the bound stays wider than the precision.
const MAX_EVALUATIONS: usize = 1 << 16;

/// A part of a curve, between two arc lengths from its start, mm.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CurveRange<'a> {
    pub(crate) curve: &'a Curve,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

impl<'a> CurveRange<'a> {
    /// A whole curve of this length, mm.
    pub(crate) fn whole(curve: &'a Curve, length_mm: f64) -> CurveRange<'a> {
        CurveRange { curve, from: 0.0, to: length_mm }
    }

    fn at(&self, fraction: f64) -> Vec3 {
        // The ends are taken from the curve itself, so that those of a whole curve are exact.
        if fraction <= 0.0 {
            self.curve.point_at(self.from)
        } else if fraction >= 1.0 {
            self.curve.point_at(self.to)
        } else {
            self.curve.point_at(self.from + (self.to - self.from) * fraction)
        }
    }

    /// The largest second derivative with respect to the fraction of the part, mm.
    fn bend(&self) -> f64 {
        let length = self.to - self.from;
        self.curve.max_curvature() * length * length
    }
}

/// An upper bound of the distance between two points that traverse the parts at constant speed and arrive together,
/// mm. It exceeds the largest such distance by at most `precision_mm`, unless that takes too many evaluations. It is
/// never below the Fréchet distance of the parts, up to rounding.
///
/// Between straight lines the distance is largest at an end. Two arcs or spirals about parallel axes are first
/// compared by their parameters, which finds equality without sampling. Otherwise intervals are bisected: over an
/// interval of width Δ, the difference D of the two points as a function of the fraction deviates from its chord by
/// at most Δ²/8·max|D''| (the remainder of linear interpolation), and the norm along a chord is largest at one of its
/// ends.
pub(crate) fn bound(a: CurveRange<'_>, b: CurveRange<'_>, precision_mm: f64) -> f64 {
    let ends = (a.at(0.0) - b.at(0.0)).length().max((a.at(1.0) - b.at(1.0)).length());
    if let (Curve::Line(_), Curve::Line(_)) = (a.curve, b.curve) {
        return ends;
    }
    if let Some(same) = of_splines(&a, &b).filter(|same| *same <= precision_mm) {
        return ends.max(same);
    }
    // The stored end points may deviate slightly from the curve that its parameters describe (radii that differ a
    // little), so end points and curves are compared separately.
    let curves = (formal(a.curve), formal(b.curve));
    let (a, b) = (CurveRange { curve: &curves.0, ..a }, CurveRange { curve: &curves.1, ..b });
    let by_numbers =
        RotatingCurve::of(&a).zip(RotatingCurve::of(&b)).and_then(|(a, b)| a.bound(&b));
    match by_numbers {
        Some(numbers) if numbers <= precision_mm => ends.max(numbers),
        Some(numbers) => ends.max(numbers.min(by_halving(a, b, precision_mm))),
        None => ends.max(by_halving(a, b, precision_mm)),
    }
}

/// A bound for two whole spline spans with equal weights: at equal parameters they are at most as far apart as their
/// control points, mm. `None` for other curves.
fn of_splines(a: &CurveRange<'_>, b: &CurveRange<'_>) -> Option<f64> {
    let (Curve::Spline(one), Curve::Spline(two)) = (a.curve, b.curve) else { return None };
    if one == two && (a.from, a.to) == (b.from, b.to) {
        return Some(0.0);
    }
    let whole = |range: &CurveRange<'_>| range.from == 0.0 && range.to == range.curve.length();
    let alike = one.weights() == two.weights() && whole(a) && whole(b);
    let pairs = one.points().iter().zip(two.points());
    alike.then(|| pairs.fold(0.0, |far: f64, (p, q)| far.max((*p - *q).length())))
}

/// The curve with its ends computed from its parameters.
fn formal(curve: &Curve) -> Curve {
    match curve {
        Curve::Line(_) | Curve::Spline(_) => *curve,
        Curve::Arc(arc) => {
            let frame = frame(arc.center, arc.u, arc.w);
            Arc::new(frame, arc.radius, arc.sweep, arc.rise).into()
        }
        // A spiral without sweep is the line between its ends.
        Curve::Spiral(spiral) if spiral.sweep == 0.0 => {
            Line { start: spiral.start, end: spiral.end }.into()
        }
        Curve::Spiral(spiral) => {
            let radii = (spiral.radius_start, spiral.radius_end);
            let frame = frame(spiral.center, spiral.u, spiral.w);
            Spiral::new(frame, radii, spiral.sweep, spiral.rise).into()
        }
    }
}

fn frame(origin: Vec3, u: Vec3, w: Vec3) -> Frame {
    Frame { origin, u, v: w.cross(u), w }
}

fn by_halving(a: CurveRange<'_>, b: CurveRange<'_>, precision_mm: f64) -> f64 {
    let bend = a.bend() + b.bend();
    let separate = |fraction: f64| (a.at(fraction) - b.at(fraction)).length();
    let ends = [separate(0.0), separate(1.0)];
    let mut low = ends[0].max(ends[1]);
    let mut high = low;
    let mut evaluations = 2;
    let mut width = 1.0;
    let mut open = vec![(0.0, ends)];
    while !open.is_empty() {
        let excess = width * width / 8.0 * bend;
        let bound = |ends: [f64; 2]| ends[0].max(ends[1]) + excess;
        // An interval whose bound is within the precision of a distance found needs no bisection.
        open.retain(|(_, ends)| {
            let is_open = bound(*ends) > low + precision_mm;
            if !is_open {
                high = high.max(bound(*ends));
            }
            is_open
        });
        if evaluations + open.len() > MAX_EVALUATIONS || excess.is_nan() {
            return open.iter().map(|(_, ends)| bound(*ends)).fold(high, f64::max);
        }
        width /= 2.0;
        evaluations += open.len();
        let mut halves = Vec::with_capacity(2 * open.len());
        for (from, ends) in open {
            let middle = separate(from + width);
            low = low.max(middle);
            halves.push((from, [ends[0], middle]));
            halves.push((from + width, [middle, ends[1]]));
        }
        open = halves;
    }
    high.max(low)
}

/// An arc or a spiral by its parameters: point = center + radius·(rotated u) + height·w, where the angle, radius and
/// height are linear in the fraction.
struct RotatingCurve {
    center: Vec3,
    u: Vec3,
    w: Vec3,
    angles: [f64; 2],
    radii: [f64; 2],
    heights: [f64; 2],
}

impl RotatingCurve {
    fn of(range: &CurveRange<'_>) -> Option<RotatingCurve> {
        let (center, u, w, radii, sweep, rise, angles) = match range.curve {
            Curve::Line(_) | Curve::Spline(_) => return None,
            Curve::Arc(arc) => {
                let angles = [range.from, range.to].map(|s| arc.angle_at(s));
                (arc.center, arc.u, arc.w, [arc.radius; 2], arc.sweep, arc.rise, angles)
            }
            Curve::Spiral(spiral) => {
                let angles = [range.from, range.to].map(|s| spiral.angle_at(s));
                let radii = [spiral.radius_start, spiral.radius_end];
                (spiral.center, spiral.u, spiral.w, radii, spiral.sweep, spiral.rise, angles)
            }
        };
        if sweep == 0.0 {
            return None;
        }
        let fractions = angles.map(|angle| angle / sweep);
        let radii = fractions.map(|at| radii[0] + (radii[1] - radii[0]) * at);
        let heights = fractions.map(|at| rise * at);
        Some(RotatingCurve { center, u, w, angles, radii, heights })
    }

    /// A bound of the distance when both turn uniformly, mm; `None` when the axes are not parallel.
    fn bound(&self, other: &RotatingCurve) -> Option<f64> {
        let along = self.w.dot(other.w);
        if (self.w.cross(other.w)).length() > 1e-15 {
            return None;
        }
        // About an opposite axis, the same rotation has the opposite sign.
        let sign = along.signum();
        let between = {
            let v = self.w.cross(self.u);
            libm::atan2(other.u.dot(v), other.u.dot(self.u))
        };
        let angles = other.angles.map(|angle| sign * angle + between);
        let turn = std::f64::consts::TAU;
        let whole = ((self.angles[0] - angles[0]) / turn).round() * turn;
        let most = |difference: [f64; 2]| difference[0].abs().max(difference[1].abs());
        let at = [0, 1];
        let angle = most(at.map(|end: usize| self.angles[end] - angles[end] - whole));
        let radius = most(at.map(|end: usize| self.radii[end] - other.radii[end]));
        let path = self.center - other.center;
        let aside = (path - self.w * path.dot(self.w)).length();
        let height = path.dot(self.w);
        let height =
            most(at.map(|end: usize| height + self.heights[end] - sign * other.heights[end]));
        let largest = other.radii[0].max(other.radii[1]);
        Some(libm::hypot(aside + radius + largest * angle, height))
    }
}

//! How far two curves are from each other when both are travelled evenly.

use chordal::geometry::{Arc, Curve, Frame, Line, ParamCurve, Spiral, Vec3};

/// Most places at which two curves are asked; beyond, the bound stays wider than the precision.
const MAX_EVALUATIONS: usize = 1 << 16;

/// A stretch of a curve, by the way from its start, mm.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CurveRange<'a> {
    pub(crate) curve: &'a Curve,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

impl<'a> CurveRange<'a> {
    /// All of a curve, which is so long, mm.
    pub(crate) fn whole(curve: &'a Curve, length_mm: f64) -> CurveRange<'a> {
        CurveRange { curve, from: 0.0, to: length_mm }
    }

    fn at(&self, fraction: f64) -> Vec3 {
        // The ends as they are: whole curves have their ends as given.
        if fraction <= 0.0 {
            self.curve.point_at(self.from)
        } else if fraction >= 1.0 {
            self.curve.point_at(self.to)
        } else {
            self.curve.point_at(self.from + (self.to - self.from) * fraction)
        }
    }

    /// Largest second derivative by the fraction of the stretch, mm.
    fn bend(&self) -> f64 {
        let length = self.to - self.from;
        self.curve.max_curvature() * length * length
    }
}

/// An upper bound of the distance of two places that go along the stretches evenly and arrive
/// together, mm: not above the largest such distance by more than `precision_mm`, unless that takes
/// too many places. Never below the Fréchet distance of the stretches, up to rounding.
///
/// Between straight lines the distance is largest at an end. Two arcs or spirals about parallel axes
/// are first compared with each other by their numbers, which finds equality without sampling. Else
/// the difference D of the places, as a function of the fraction of the way, leaves the straight line
/// between two of its places by at most Δ²/8·max|D''| (the remainder of linear interpolation), and a
/// norm is largest at an end of a straight line; intervals are halved, the widest first.
pub(crate) fn bound(a: CurveRange<'_>, b: CurveRange<'_>, precision_mm: f64) -> f64 {
    let ends = (a.at(0.0) - b.at(0.0)).length().max((a.at(1.0) - b.at(1.0)).length());
    if let (Curve::Line(_), Curve::Line(_)) = (a.curve, b.curve) {
        return ends;
    }
    if let Some(same) = of_splines(&a, &b).filter(|same| *same <= precision_mm) {
        return ends.max(same);
    }
    // The ends as given need not lie where the rest of the curve leads (radii that differ a
    // little): ends against ends, the curve proper against the other.
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

/// Of two whole spans of splines with like weights: they are as far apart as their control points at most where
/// both go by their parameter. Nothing for others.
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

/// The curve with its ends where its numbers lead.
fn formal(curve: &Curve) -> Curve {
    match curve {
        Curve::Line(_) | Curve::Spline(_) => *curve,
        Curve::Arc(arc) => {
            let frame = frame(arc.center, arc.u, arc.w);
            Arc::new(frame, arc.radius, arc.sweep, arc.rise).into()
        }
        // Without a sweep it is the line between its ends.
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
    let mut requested = 2;
    let mut width = 1.0;
    let mut open = vec![(0.0, ends)];
    while !open.is_empty() {
        let excess = width * width / 8.0 * bend;
        let bound = |ends: [f64; 2]| ends[0].max(ends[1]) + excess;
        // What is hardly above a distance that was found needs no halving.
        open.retain(|(_, ends)| {
            let is_open = bound(*ends) > low + precision_mm;
            if !is_open {
                high = high.max(bound(*ends));
            }
            is_open
        });
        if requested + open.len() > MAX_EVALUATIONS || excess.is_nan() {
            return open.iter().map(|(_, ends)| bound(*ends)).fold(high, f64::max);
        }
        width /= 2.0;
        requested += open.len();
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

/// An arc or a spiral by numbers: place = axis + radius·(turned u) + height·w, all linear in the
/// angle travelled.
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

    /// The largest distance when both turn evenly; nothing where the axes are not parallel.
    fn bound(&self, other: &RotatingCurve) -> Option<f64> {
        let along = self.w.dot(other.w);
        if (self.w.cross(other.w)).length() > 1e-15 {
            return None;
        }
        // About the opposite axis the same turn has the opposite sign.
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

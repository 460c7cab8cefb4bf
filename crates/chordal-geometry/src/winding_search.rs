//! Global extremes of a winding: its box, and the point nearest to another one.
//!
//! Both need every root of a derivative. Differentiating once or twice more leads to a function whose roots can be
//! listed, because its phase is monotone. Between these roots the function before it is monotone and has at most one
//! root. So no root is missed.

use crate::math::{self, PI, TAU};
use crate::solve::{KnotList, bracketed_root};
use crate::winding::Winding;
use crate::{Aabb, Vec3};

impl Winding {
    /// The ends of `lo..=hi` and, between them, the points where the phase Θt − φ − atan2(j·dr, Θr(t)) is `offset` +
    /// kπ. The phase never decreases: its derivative is Θ(1 + j·dr²/(Θ²r² + j²dr²)).
    fn phase_knots(&self, j: f64, phi: f64, offset: f64, lo: f64, hi: f64) -> KnotList {
        let lead = |t: f64| (j * self.dr, self.theta * self.radius(t));
        let phase = |t: f64| {
            let (y, x) = lead(t);
            self.theta * t - phi - math::atan2(y, x) - offset
        };
        let mut knots = KnotList::new();
        knots.push(lo);
        let first = (phase(lo) / PI).ceil();
        let last = (phase(hi) / PI).floor();
        let mut k = first;
        // The list is short by construction; the limit is for large values, where k + 1 is rounded to k.
        for _ in 0..20 {
            if k > last || k.is_nan() || last.is_nan() {
                break;
            }
            let target = k * PI;
            let root = bracketed_root(
                |t| {
                    let (y, x) = lead(t);
                    let bend = j * self.dr * self.dr / (x * x + y * y);
                    let bend = if bend.is_finite() { bend } else { 0.0 };
                    (phase(t) - target, self.theta * (1.0 + bend))
                },
                lo,
                hi,
            );
            knots.push(root);
            k += 1.0;
        }
        knots.push(hi);
        knots
    }

    /// The smallest box around the points at fractions 0 to 1, without the ends.
    pub(crate) fn interior_bounds(&self) -> Aabb {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for axis in 0..3 {
            let mut see = |x: f64| {
                low[axis] = low[axis].min(x);
                high[axis] = high[axis].max(x);
            };
            if self.dr == 0.0 {
                self.helix_extremes(axis, &mut see);
            } else {
                self.spiral_extremes(axis, &mut see);
            }
        }
        Aabb { min: Vec3::from_array(low), max: Vec3::from_array(high) }
    }

    /// Half the length of the projection of the unit circle on a coordinate axis.
    fn projected_size(&self, axis: usize) -> f64 {
        let (ui, vi, wi) = (self.u.component(axis), self.v.component(axis), self.w.component(axis));
        // Exactly 1 if the axis is in the plane, so that boxes are exact.
        if wi == 0.0 { 1.0 } else { (ui * ui + vi * vi).sqrt() }
    }

    /// The angle at which that projection is largest, rad.
    fn projected_phase(&self, axis: usize) -> f64 {
        math::atan2(self.v.component(axis), self.u.component(axis))
    }

    /// x = A r cos(χ) + k·(χ + φ) with χ = Θt − φ: stationary where sin χ = k/(A r).
    fn helix_extremes(&self, axis: usize, see: &mut impl FnMut(f64)) {
        let across = self.projected_size(axis) * self.r0;
        let along = self.rise * self.w.component(axis);
        let ratio = along / (across * self.theta);
        if ratio.is_nan() || ratio.abs() > 1.0 {
            return;
        }
        let phi = self.projected_phase(axis);
        // The extremes of a plane arc, the usual case, are on the axis through its centre.
        let (tilt, cos) = match ratio == 0.0 {
            true => (0.0, 1.0),
            false => (math::asin(ratio), ((1.0 - ratio) * (1.0 + ratio)).sqrt()),
        };
        let base = self.center.component(axis);
        for (chi, sign) in [(tilt, 1.0), (PI - tilt, -1.0)] {
            // These extremes change linearly from turn to turn, so the first and the last are enough.
            let first = ((-phi - chi) / TAU).ceil();
            let last = ((self.theta - phi - chi) / TAU).floor();
            if first > last {
                continue;
            }
            for turn in [first, last] {
                let t = (phi + chi + turn * TAU) / self.theta;
                see(base + sign * cos * across + along * t);
            }
        }
    }

    fn spiral_extremes(&self, axis: usize, see: &mut impl FnMut(f64)) {
        let size = self.projected_size(axis);
        if size == 0.0 {
            return;
        }
        let phi = self.projected_phase(axis);
        let along = self.rise * self.w.component(axis);
        let base = self.center.component(axis);
        let (th, dr) = (self.theta, self.dr);
        let place = |t: f64| {
            let (_, cos) = math::sin_cos(th * t - phi);
            base + size * self.radius(t) * cos + along * t
        };
        let slope = |t: f64| {
            let (sin, cos) = math::sin_cos(th * t - phi);
            let r = self.radius(t);
            (size * (dr * cos - th * r * sin) + along, -size * th * (2.0 * dr * sin + th * r * cos))
        };
        // At a fixed phase the coordinate changes linearly from turn to turn, so the extremes are in the first or in
        // the last turn.
        let turn = TAU / th;
        let windows = if turn < 0.5 { [(0.0, turn), (1.0 - turn, 1.0)] } else { [(0.0, 1.0); 2] };
        let windows = if turn < 0.5 { &windows[..] } else { &windows[..1] };
        for &(lo, hi) in windows {
            // slope' = −A Θ (2 dr sin χ + Θ r cos χ) is zero if the phase is π/2 + kπ.
            let knots = self.phase_knots(2.0, phi, math::FRAC_PI_2, lo, hi).refine(slope);
            for &t in knots.as_slice() {
                see(place(t));
            }
        }
    }

    /// The fraction at which the curve is nearest to `p`, and the distance there, mm.
    pub(crate) fn nearest_fraction(&self, p: Vec3) -> (f64, f64) {
        let d = p - self.center;
        let (x, y, z) = (d.dot(self.u), d.dot(self.v), d.dot(self.w));
        let rho = (x * x + y * y).sqrt();
        let alpha = math::atan2(y, x);
        let mut best = (0.0, self.point(0.0).distance(p));
        let mut consider = |t: f64| {
            let distance = self.point(t).distance(p);
            if distance < best.1 {
                best = (t, distance);
            }
        };
        consider(1.0);
        // Tests the squares, because the general case would divide by their sum.
        if self.dr * self.dr + self.rise * self.rise == 0.0 {
            let angle = if alpha < 0.0 { alpha + TAU } else { alpha };
            if angle < self.theta {
                consider(angle / self.theta);
            }
            return best;
        }
        let (lo, hi) = self.nearest_window(rho, alpha, z);
        let (th, dr, rise) = (self.theta, self.dr, self.rise);
        // Derivatives of half the squared distance: `first` returns the first and second, `second` the second and
        // third. The third is zero at the phase knots.
        let first = |t: f64| {
            let (sin, cos) = math::sin_cos(th * t - alpha);
            let r = self.radius(t);
            (
                dr * (r - rho * cos) + th * rho * r * sin + rise * (rise * t - z),
                dr * dr + rise * rise + th * rho * (2.0 * dr * sin + th * r * cos),
            )
        };
        let second = |t: f64| {
            let (sin, cos) = math::sin_cos(th * t - alpha);
            let r = self.radius(t);
            (
                dr * dr + rise * rise + th * rho * (2.0 * dr * sin + th * r * cos),
                th * th * rho * (3.0 * dr * cos - th * r * sin),
            )
        };
        let knots = self.phase_knots(3.0, alpha, 0.0, lo, hi).refine(second).refine(first);
        for &t in knots.as_slice() {
            consider(t);
        }
        best
    }

    /// An interval of at most two turns that contains the nearest point.
    ///
    /// The distance is never below that from p, rotated about the axis, to the generating line (r(t), rise·t), whose
    /// square is a parabola in t about `vertex`. Where the radius points towards p the two distances are equal, so no
    /// point farther from the vertex than such a point can be nearer.
    fn nearest_window(&self, rho: f64, alpha: f64, z: f64) -> (f64, f64) {
        let vertex = (self.rise * z - self.dr * (self.r0 - rho))
            / (self.dr * self.dr + self.rise * self.rise);
        if !vertex.is_finite() {
            return (0.0, 1.0);
        }
        let turn = TAU / self.theta;
        let base = alpha / self.theta;
        let inside = vertex.clamp(0.0, 1.0);
        let near = ((inside - base) / turn).round();
        let mut reach = f64::INFINITY;
        for k in [near - 1.0, near, near + 1.0] {
            let t = base + k * turn;
            if (0.0..=1.0).contains(&t) {
                reach = reach.min((t - vertex).abs());
            }
        }
        // Slightly wider than proved, because a vertex far away has a rounding error.
        let reach = reach + f64::EPSILON * 4.0 * vertex.abs();
        ((vertex - reach).clamp(0.0, 1.0), (vertex + reach).clamp(0.0, 1.0))
    }
}

//! The common formula of arcs, helices, spirals and cones: a radius that turns about an axis, grows linearly with the
//! angle and moves along the axis linearly with the angle.
//!
//! Everything is a function of t in 0..=1, the fraction of the sweep:
//!
//! ```text
//! p(t) = centre + r(t)·e(t) + t·rise·w      r(t) = r0 + t·dr      e(t) = u cos Θt + v sin Θt
//! ```
//!
//! The variable is the fraction and not the angle, because then nothing is divided by the sweep, and a sweep of zero
//! gives a straight line.

use crate::{Vec3, math};

/// A curve by this formula. `v` includes the direction of rotation, so `theta >= 0`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Winding {
    pub center: Vec3,
    pub u: Vec3,
    pub v: Vec3,
    pub w: Vec3,
    /// Radius at the start, mm.
    pub r0: f64,
    /// Growth of the radius over the whole sweep, mm.
    pub dr: f64,
    /// Size of the sweep, radians.
    pub theta: f64,
    /// Movement along `w` over the whole sweep, mm.
    pub rise: f64,
}

/// Derivatives of the position with respect to arc length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IntrinsicDerivatives {
    pub tangent: Vec3,
    pub curvature: Vec3,
    pub curvature_derivative: Vec3,
}

impl IntrinsicDerivatives {
    /// The point followed by these derivatives.
    pub(crate) fn derivatives_after(self, point: Vec3) -> [Vec3; 4] {
        [point, self.tangent, self.curvature, self.curvature_derivative]
    }
}

impl Winding {
    pub(crate) fn new(
        center: Vec3,
        u: Vec3,
        w: Vec3,
        radii: (f64, f64),
        sweep: f64,
        rise: f64,
    ) -> Self {
        let v = w.cross(u);
        let v = if sweep < 0.0 { -v } else { v };
        Self { center, u, v, w, r0: radii.0, dr: radii.1 - radii.0, theta: sweep.abs(), rise }
    }

    pub(crate) fn radius(&self, t: f64) -> f64 {
        self.r0 + self.dr * t
    }

    /// Unit vectors outward and in the direction of rotation.
    pub(crate) fn radial(&self, t: f64) -> (Vec3, Vec3) {
        let (sin, cos) = math::sin_cos(self.theta * t);
        (self.u * cos + self.v * sin, self.v * cos - self.u * sin)
    }

    pub(crate) fn point(&self, t: f64) -> Vec3 {
        self.point_outside(t, 0.0)
    }

    /// The point `outward` mm farther from the axis than the curve.
    pub(crate) fn point_outside(&self, t: f64, outward: f64) -> Vec3 {
        let (sin, cos) = math::sin_cos(self.theta * t);
        let r = self.radius(t) + outward;
        self.center + self.u * (r * cos) + self.v * (r * sin) + self.w * (self.rise * t)
    }

    /// Square of the part of the speed |dp/dt| that does not depend on the radius.
    pub(crate) fn straight_squared(&self) -> f64 {
        self.dr * self.dr + self.rise * self.rise
    }

    /// Square of |dp/dt|, mm².
    pub(crate) fn speed_squared(&self, t: f64) -> f64 {
        let around = self.radius(t) * self.theta;
        around * around + self.straight_squared()
    }

    /// |dp/dt|, mm.
    fn speed(&self, t: f64) -> f64 {
        self.speed_squared(t).sqrt()
    }

    /// The speed g and g'/g.
    fn speed_and_bend(&self, t: f64) -> (f64, f64) {
        let around = self.radius(t) * self.theta;
        let squared = around * around + self.straight_squared();
        (squared.sqrt(), around * self.theta * self.dr / squared)
    }

    /// Length from 0 to `t`, mm.
    pub(crate) fn length_to(&self, t: f64) -> f64 {
        let r0 = self.r0 * self.theta;
        let growth = self.dr * self.theta * t;
        t * mean_speed(r0, growth, self.straight_squared())
    }

    pub(crate) fn length(&self) -> f64 {
        self.length_to(1.0)
    }

    /// The fraction of the sweep at which the length from the start is `s` mm, clamped to 0..=1;
    /// NaN if `s` is NaN.
    pub(crate) fn fraction_at(&self, s: f64) -> f64 {
        let total = self.length();
        if s <= 0.0 {
            return 0.0;
        }
        if s >= total {
            return 1.0;
        }
        let even = s / total;
        if self.dr == 0.0 || self.theta == 0.0 || !even.is_finite() {
            return even;
        }
        // With a speed that is linear between its end values, t is the root of a quadratic; it is scaled to give the
        // whole length at t = 1.
        let (g0, g1) = (self.speed(0.0), self.speed(1.0));
        let target = even * 0.5 * (g0 + g1);
        let mut t = 2.0 * target / (g0 + (g0 * g0 + 2.0 * (g1 - g0) * target).max(0.0).sqrt());
        let (mut lo, mut hi) = (0.0, 1.0);
        if !(t > lo && t < hi) {
            t = even;
        }
        // Halley's method usually takes two steps; the bracket and the limit are for unusual input.
        for _ in 0..60 {
            let miss = self.length_to(t) - s;
            if miss < 0.0 {
                lo = t
            } else {
                hi = t
            }
            let (g, bend) = self.speed_and_bend(t);
            let newton = miss / g;
            let halley = t - newton / (1.0 - 0.5 * newton * bend);
            let next = if halley >= lo && halley <= hi { halley } else { 0.5 * (lo + hi) };
            let step = (next - t).abs();
            t = next;
            // The derivatives of the speed are below Θ and Θ² times it, so the next error is below Θ²·step³.
            if step * self.theta.max(1.0) <= 2e-6 * t {
                break;
            }
        }
        t
    }

    /// Derivatives with respect to arc length at `t`; all zero on a curve without length.
    pub(crate) fn intrinsic(&self, t: f64) -> IntrinsicDerivatives {
        let (e, n) = self.radial(t);
        self.intrinsic_along(t, e, n)
    }

    /// The point at `t` and its derivatives with respect to arc length, with only one sine and cosine.
    #[inline]
    pub(crate) fn jet(&self, t: f64) -> (Vec3, IntrinsicDerivatives) {
        let (sin, cos) = math::sin_cos(self.theta * t);
        let r = self.radius(t);
        let point =
            self.center + self.u * (r * cos) + self.v * (r * sin) + self.w * (self.rise * t);
        let (e, n) = (self.u * cos + self.v * sin, self.v * cos - self.u * sin);
        (point, self.intrinsic_along(t, e, n))
    }

    /// Derivatives with respect to arc length at `t`, where `e` is the unit vector outward and `n` that in the
    /// direction of rotation.
    #[inline]
    fn intrinsic_along(&self, t: f64, e: Vec3, n: Vec3) -> IntrinsicDerivatives {
        let r = self.radius(t);
        let (th, dr) = (self.theta, self.dr);
        let around = r * th;
        let g = self.speed(t);
        if g == 0.0 {
            let none = Vec3::ZERO;
            return IntrinsicDerivatives {
                tangent: none,
                curvature: none,
                curvature_derivative: none,
            };
        }
        let k = 1.0 / g;
        if dr == 0.0 {
            // The terms below if the radius does not grow.
            return IntrinsicDerivatives {
                tangent: (n * around + self.w * self.rise) / g,
                curvature: e * -(around * th) * (k * k),
                curvature_derivative: n * -(around * th * th) * (k * k * k),
            };
        }
        let p1 = e * dr + n * around + self.w * self.rise;
        let p2 = n * (2.0 * dr * th) - e * (around * th);
        let p3 = (e * (3.0 * dr * th) + n * (around * th)) * -th;
        // g' and g'' relative to g.
        let g1 = around * th * dr * k * k;
        let g2 = dr * dr * th * th * k * k - g1 * g1;
        IntrinsicDerivatives {
            tangent: p1 / g,
            curvature: (p2 - p1 * g1) * (k * k),
            curvature_derivative: (p3 - p2 * (3.0 * g1) + p1 * (3.0 * g1 * g1 - g2)) * (k * k * k),
        }
    }

    /// Size of the curvature at radius `r`, 1/mm.
    fn curvature_at_radius(&self, r: f64) -> f64 {
        let (th, dr, c) = (self.theta, self.dr, self.rise);
        let around = r * th;
        let g2 = around * around + self.straight_squared();
        if g2 == 0.0 {
            return 0.0;
        }
        // |p' × p''|² with every term a sum of squares.
        let plane = around * around + 2.0 * dr * dr;
        let cross = plane * plane + c * c * (around * around + 4.0 * dr * dr);
        th * cross.sqrt() / (g2 * g2.sqrt())
    }

    pub(crate) fn max_curvature(&self) -> f64 {
        let r1 = self.r0 + self.dr;
        let mut best = self.curvature_at_radius(self.r0).max(self.curvature_at_radius(r1));
        if self.theta > 0.0 && self.dr != 0.0 {
            // Between the ends the square of the curvature, a rational function of q = r², is
            // stationary where q² + 6Bq + 8B² + 7BC − C² = 0 with B = (dr/Θ)², C = (rise/Θ)².
            let b = (self.dr / self.theta) * (self.dr / self.theta);
            let c = (self.rise / self.theta) * (self.rise / self.theta);
            let under_root = b * b - 7.0 * b * c + c * c;
            if under_root >= 0.0 {
                let q = under_root.sqrt() - 3.0 * b;
                let r = q.max(0.0).sqrt();
                if q > 0.0 && r > self.r0.min(r1) && r < self.r0.max(r1) {
                    best = best.max(self.curvature_at_radius(r));
                }
            }
        }
        best
    }

    /// The part between two fractions, `t0 <= t1`.
    pub(crate) fn part(&self, t0: f64, t1: f64) -> Winding {
        let (u, v) = self.radial(t0);
        let share = t1 - t0;
        Winding {
            center: self.center + self.w * (self.rise * t0),
            u,
            v,
            w: self.w,
            r0: self.radius(t0),
            dr: self.dr * share,
            theta: self.theta * share,
            rise: self.rise * share,
        }
    }
}

/// Mean of √(r² + m²) over r from `r0` to `r0 + growth`.
///
/// The textbook form, [r√(r²+m²) + m² asinh(r/m)] / 2·growth between the ends, loses all digits if `growth` is small.
/// Here both differences are transformed so that only sums of positive terms remain, for any growth and also for m = 0.
fn mean_speed(r0: f64, growth: f64, m2: f64) -> f64 {
    let r1 = r0 + growth;
    let h0 = (r0 * r0 + m2).sqrt();
    let h1 = (r1 * r1 + m2).sqrt();
    let hs = h0 + h1;
    if hs == 0.0 {
        return 0.0;
    }
    let rs = r0 + r1;
    let by_root = 0.5 * hs + 0.5 * rs * (rs / hs);
    if m2 == 0.0 {
        return 0.5 * by_root;
    }
    let per_growth = (1.0 + (r0 * r0 + r1 * r1 + m2) / (h0 * h1 + r0 * r1)) / hs;
    0.5 * (by_root + m2 * per_growth * math::asinh_ratio(growth * per_growth))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_speed_joins_the_constant_case() {
        // √(3² + 4²) = 5 whatever the growth, as the growth goes to zero.
        for growth in [0.0, 1e-300, 1e-16, 1e-9] {
            assert!((mean_speed(3.0, growth, 16.0) - 5.0).abs() < 1e-9);
        }
        assert_eq!(mean_speed(3.0, 0.0, 16.0), 5.0);
        // m = 0: the mean of r itself.
        assert_eq!(mean_speed(1.0, 2.0, 0.0), 2.0);
        assert_eq!(mean_speed(0.0, 0.0, 0.0), 0.0);
        // Unit parabola: ∫₀¹√(r²+1) = (√2 + asinh 1)/2.
        let by_hand = 1.147_793_574_696_319;
        assert!((mean_speed(0.0, 1.0, 1.0) - by_hand).abs() < 1e-15);
    }
}

//! A spiral evaluated at many points.
//!
//! The length of a spiral as a function of its angle has a closed form with an inverse hyperbolic sine; the angle as a
//! function of the length has none. Around a point it has a power series, which follows term by term from its
//! differential equation g·dt/ds = 1 with g² = (Θr)² + dr² + rise².
//!
//! The spiral is divided into parts with one series each, by equal steps of z, where Θr = √(dr² + rise²)·sinh z: then the
//! length of each part is the same fraction of the radius of convergence of its series. The parts depend only on the
//! spiral, so the result does not depend on earlier evaluations.

use crate::winding::Winding;
use crate::{Vec3, math};

/// The number of terms of the series after its constant.
const TERMS: usize = 12;

/// The error bound of the series, mm, and also as a fraction of the radius: far below the resolution of a machine.
const OFF_MM: f64 = 1e-13;
const OFF_SHARE: f64 = 1e-15;

/// No spiral with finite values needs this many parts; if more are computed, one part is used.
const MAX_PARTS: f64 = 1e9;

/// A part of a spiral with the fraction of the sweep as a power series of the length.
#[derive(Clone, Copy, Debug)]
struct SpiralPart {
    /// Its index among the parts.
    number: usize,
    /// Its start and its end, mm from the start of the spiral.
    from: f64,
    to: f64,
    /// Its middle, mm from the start of the spiral.
    s: f64,
    /// The inverse of the length by which the variable of the series is scaled, 1/mm.
    per_reach: f64,
    /// Fraction of the sweep in the middle.
    t: f64,
    /// The coefficients of the first power and above.
    terms: [f64; TERMS],
}

/// A spiral and the part of it that was used last.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpiralReader {
    winding: Winding,
    /// The whole sweep in quarter turns.
    quarters: f64,
    /// Θ·dr.
    bend: f64,
    /// dr² + rise².
    straight: f64,
    grid: SpiralGrid,
    part: SpiralPart,
}

/// The parts of a spiral.
#[derive(Clone, Copy, Debug)]
struct SpiralGrid {
    winding: Winding,
    length: f64,
    count: usize,
    /// z at the start, and its step per part.
    from: f64,
    step: f64,
}

impl SpiralPart {
    #[inline]
    fn holds(&self, s: f64) -> bool {
        s >= self.from && s < self.to
    }

    /// The difference of the fraction of the sweep from that in the middle.
    #[inline]
    fn beyond(&self, s: f64) -> f64 {
        let x = (s - self.s) * self.per_reach;
        x * math::polynomial(x, &self.terms)
    }
}

impl SpiralReader {
    pub(crate) fn new(winding: Winding, length: f64) -> SpiralReader {
        let grid = SpiralGrid::new(winding, length);
        SpiralReader {
            winding,
            quarters: winding.theta / math::FRAC_PI_2,
            bend: winding.theta * winding.dr,
            straight: winding.straight_squared(),
            grid,
            part: grid.part(0),
        }
    }

    /// The point at `s` mm from the start, within the spiral, and its derivatives with respect to time, if those of `s`
    /// are `by_time`.
    #[inline(always)]
    pub(crate) fn motion_at(&mut self, s: f64, by_time: [f64; 3]) -> [Vec3; 4] {
        if !self.part.holds(s) {
            self.part = self.grid.part_for(s, self.part.number);
        }
        let t = self.part.t + self.part.beyond(s);
        self.motion(t, math::sin_cos_of_quarters(self.quarters * t), by_time)
    }

    /// The point at `t` and its derivatives with respect to time, from the sine and cosine of the angle there.
    #[inline(always)]
    fn motion(
        &self,
        t: f64,
        (sin, cos): (f64, f64),
        [speed, acceleration, jerk]: [f64; 3],
    ) -> [Vec3; 4] {
        let Winding { center, u, v, w, r0, dr, theta, rise } = self.winding;
        let r = r0 + dr * t;
        let around = r * theta;
        let k2 = 1.0 / (around * around + self.straight);
        let k = k2.sqrt();
        // g' and g'' relative to g, and the derivatives of t with respect to time.
        let bend = around * self.bend * k2;
        let second = self.bend * self.bend * k2 - bend * bend;
        let t1 = speed * k;
        let square = t1 * t1;
        let t2 = acceleration * k - bend * square;
        let t3 = jerk * k - t1 * (3.0 * bend * t2 + second * square);
        // The derivatives of the angle and the radius with respect to time; the frame turns with the angle.
        let (w1, w2, w3) = (theta * t1, theta * t2, theta * t3);
        let (r1, r2, r3) = (dr * t1, dr * t2, dr * t3);
        let (e, n) = (u * cos + v * sin, v * cos - u * sin);
        let square = w1 * w1;
        let (out2, along2) = (r2 - r * square, 2.0 * r1 * w1 + r * w2);
        let out3 = r3 - 3.0 * (r1 * square + r * w1 * w2);
        let along3 = 3.0 * (r2 * w1 + r1 * w2) + r * (w3 - w1 * square);
        // Written out, because a separate function would not be inlined and would compute unused values.
        [
            center + e * r + w * (rise * t),
            e * r1 + n * (r * w1) + w * (rise * t1),
            e * out2 + n * along2 + w * (rise * t2),
            e * out3 + n * along3 + w * (rise * t3),
        ]
    }
}

impl SpiralGrid {
    fn new(winding: Winding, length: f64) -> SpiralGrid {
        let Winding { theta, r0, dr, .. } = winding;
        let straight = winding.straight_squared().sqrt();
        let z = |radius: f64| math::asinh(theta * radius / straight);
        let (from, to) = (z(r0), z(r0 + dr));
        // The radius of convergence is where g would be zero, at g²/2Θdr or farther. The truncation error is below
        // r·g/dr times the power TERMS + 1 of the fraction of that radius. The twelfth power is used here, which gives
        // a smaller fraction, at the largest radius, where the fraction is smallest. Twice that fraction of g²/2Θdr is
        // the same step of z.
        let largest = r0.abs().max((r0 + dr).abs());
        let off = OFF_MM + OFF_SHARE * largest;
        let around = theta * largest;
        let square = around * around + straight * straight;
        let share = math::twelfth_root(off * (theta * dr).abs() / square);
        // One part is enough without growth or with almost none, and is also used if the number is NaN.
        let parts = ((to - from).abs() / share).ceil();
        let count = if parts > 1.0 && parts < MAX_PARTS { parts } else { 1.0 };
        SpiralGrid { winding, length, count: count as usize, from, step: (to - from) / count }
    }

    /// The part that contains `s`, mm; usually close to the part `near`.
    #[cold]
    fn part_for(&self, s: f64, near: usize) -> SpiralPart {
        let mut number = near;
        let next = if s < self.begin(near) { near.saturating_sub(1) } else { near + 1 };
        if next < self.count && s >= self.begin(next) && s < self.begin(next + 1) {
            number = next;
        } else if self.count > 1 {
            let Winding { theta, .. } = self.winding;
            let radius = self.winding.radius(self.winding.fraction_at(s));
            let z = math::asinh(theta * radius / self.winding.straight_squared().sqrt());
            // NaN is converted to 0.
            number = (((z - self.from) / self.step) as usize).min(self.count - 1);
            // Because of rounding it may be the part before or after.
            while number > 0 && s < self.begin(number) {
                number -= 1;
            }
            while number + 1 < self.count && s >= self.begin(number + 1) {
                number += 1;
            }
        }
        self.part(number)
    }

    /// Fraction of the sweep at which a part begins.
    fn fraction(&self, number: usize) -> f64 {
        if number == 0 {
            return 0.0;
        }
        if number >= self.count {
            return 1.0;
        }
        let Winding { theta, r0, dr, .. } = self.winding;
        let z = self.from + self.step * number as f64;
        let around = self.winding.straight_squared().sqrt() * math::sinh(z);
        ((around / theta - r0) / dr).clamp(0.0, 1.0)
    }

    /// The start of a part, mm from the start of the spiral.
    fn begin(&self, number: usize) -> f64 {
        if number >= self.count {
            self.length
        } else {
            self.winding.length_to(self.fraction(number))
        }
    }

    fn part(&self, number: usize) -> SpiralPart {
        let t = 0.5 * (self.fraction(number) + self.fraction(number + 1));
        let (from, to) = (self.begin(number), self.begin(number + 1));
        let s = self.winding.length_to(t);
        let reach = (s - from).max(to - s);
        let per_reach = if reach > 0.0 { 1.0 / reach } else { 0.0 };
        SpiralPart { number, from, to, s, per_reach, t, terms: self.series(t, reach) }
    }

    /// The coefficients of the fraction about `t`, for powers of the length divided by `reach`.
    fn series(&self, t: f64, reach: f64) -> [f64; TERMS] {
        let Winding { theta, dr, .. } = self.winding;
        // Powers of Θr and of g.
        let (mut around, mut speed) = ([0.0; TERMS + 1], [0.0; TERMS + 1]);
        let mut terms = [0.0; TERMS];
        around[0] = theta * self.winding.radius(t);
        speed[0] = self.winding.speed_squared(t).sqrt();
        for n in 0..TERMS {
            // g·t' = reach, its power n.
            let mut sum = if n == 0 { reach } else { 0.0 };
            for k in 0..n {
                sum -= speed[n - k] * terms[k] * (k + 1) as f64;
            }
            terms[n] = sum / (speed[0] * (n + 1) as f64);
            around[n + 1] = theta * dr * terms[n];
            // g² = (Θr)² + …, its power n + 1.
            let mut sum = 2.0 * around[0] * around[n + 1];
            for k in 1..=n {
                sum += around[k] * around[n + 1 - k] - speed[k] * speed[n + 1 - k];
            }
            speed[n + 1] = sum / (2.0 * speed[0]);
        }
        terms
    }
}

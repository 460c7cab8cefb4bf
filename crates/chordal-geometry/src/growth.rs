//! A spiral asked at places near each other.
//!
//! The way of a spiral as a function of its angle has a closed form with an inverse hyperbolic
//! sine; the angle as a function of the way has none. Around a place it has a power series, which
//! follows from its differential equation g·dt/ds = 1 with g² = (Θr)² + dr² + rise² term by term.

use crate::winding::Winding;
use crate::{Vec3, math};

/// Terms of the series after its constant.
const TERMS: usize = 12;

/// What the series may be off, mm, and as a share of the radius: far below rounding of a place
/// in a machine.
const OFF_MM: f64 = 1e-13;
const OFF_SHARE: f64 = 1e-15;

/// A part of a spiral with the fraction of the sweep as a power series of the way.
#[derive(Clone, Copy, Debug)]
struct Near {
    /// Its middle, mm from the start of the spiral.
    s: f64,
    /// To either side, mm; what all the powers are shares of; and its inverse.
    reach: f64,
    per_reach: f64,
    /// Fraction of the sweep in the middle.
    t: f64,
    /// Factors of the first power and above.
    terms: [f64; TERMS],
}

/// A spiral and the part of it that was asked last.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Growth {
    winding: Winding,
    length: f64,
    /// Quarter turns of the whole sweep.
    quarters: f64,
    near: Option<Near>,
}

impl Near {
    #[inline]
    fn holds(&self, s: f64) -> bool {
        (s - self.s).abs() <= self.reach
    }

    /// How far the fraction of the sweep is from that in the middle.
    #[inline]
    fn beyond(&self, s: f64) -> f64 {
        let x = (s - self.s) * self.per_reach;
        x * math::polynomial(x, &self.terms)
    }
}

impl Growth {
    pub(crate) fn new(winding: Winding, length: f64) -> Growth {
        Growth { winding, length, quarters: winding.theta / math::FRAC_PI_2, near: None }
    }

    /// The point at `s` mm from the start, within the spiral, and its derivatives by time where
    /// those of `s` are `by_time`.
    #[inline(always)]
    pub(crate) fn motion_at(&mut self, s: f64, by_time: [f64; 3]) -> [Vec3; 4] {
        let near = match &self.near {
            Some(near) if near.holds(s) => near,
            _ => {
                let near = self.part_for(s);
                self.near.insert(near)
            }
        };
        let t = near.t + near.beyond(s);
        self.winding.motion(t, math::sin_cos_of_quarters(self.quarters * t), by_time)
    }

    /// The part that holds `s`, mostly the one next to the last.
    #[cold]
    fn part_for(&self, s: f64) -> Near {
        if let Some(next) = self.near.as_ref().and_then(|last| self.next_to(last, s)) {
            return next;
        }
        self.about(s)
    }

    /// The part that joins another where it was left for `s`, if it holds that.
    fn next_to(&self, last: &Near, s: f64) -> Option<Near> {
        // So that the new one reaches back to the old one though it is a little smaller.
        const SHARE: f64 = 0.8;
        let way = last.reach.copysign(s - last.s);
        let edge = last.s + way;
        let reach = self.reach_at(last.t + last.beyond(edge));
        // Not `clamp`, which panics at a length that is none.
        let middle = (edge + SHARE * reach.copysign(way)).max(0.0).min(self.length);
        let near = ((s - edge).abs() <= reach).then(|| self.about(middle))?;
        near.holds(s).then_some(near)
    }

    fn about(&self, s: f64) -> Near {
        let t = self.winding.fraction_at(s);
        let reach = self.reach_at(t);
        Near { s, reach, per_reach: 1.0 / reach, t, terms: self.series(t, reach) }
    }

    /// How far from a place its series holds, mm.
    fn reach_at(&self, t: f64) -> f64 {
        let Winding { theta, dr, .. } = self.winding;
        let bend = (theta * dr).abs();
        let square = self.winding.speed_squared(t);
        let off = OFF_MM + OFF_SHARE * self.winding.radius(t).abs();
        // The series ends where g would be zero, at g²/2Θdr or farther; what is left out of it
        // is below r·g/dr times the share of that to the power TERMS + 1. Below the share of a
        // twelfth power is taken, which is smaller.
        let share = math::twelfth_root(off * bend / square);
        let reach = share * square / (2.0 * bend);
        // Without growth, or with next to none, it is right everywhere.
        if reach < self.length { reach } else { self.length }
    }

    /// The terms of the fraction about `t`, for powers of shares of `reach`.
    fn series(&self, t: f64, reach: f64) -> [f64; TERMS] {
        let Winding { theta, dr, .. } = self.winding;
        // Powers of Θr and of g.
        let (mut around, mut speed) = ([0.0; TERMS + 1], [0.0; TERMS + 1]);
        let mut terms = [0.0; TERMS];
        around[0] = theta * self.winding.radius(t);
        speed[0] = self.winding.speed_squared(t).sqrt();
        for n in 0..TERMS {
            // g·t' = reach, the power n of it.
            let mut sum = if n == 0 { reach } else { 0.0 };
            for k in 0..n {
                sum -= speed[n - k] * terms[k] * (k + 1) as f64;
            }
            terms[n] = sum / (speed[0] * (n + 1) as f64);
            around[n + 1] = theta * dr * terms[n];
            // g² = (Θr)² + …, the power n + 1 of it.
            let mut sum = 2.0 * around[0] * around[n + 1];
            for k in 1..=n {
                sum += around[k] * around[n + 1 - k] - speed[k] * speed[n + 1 - k];
            }
            speed[n + 1] = sum / (2.0 * speed[0]);
        }
        terms
    }
}

//! Turns the limits of the axes into limits of the velocity profile along a piece of path, which
//! hold together anywhere on the piece.

use chordal_geometry::AXES;

use crate::AxisValues;
use crate::cube_root::cbrt;
use crate::limits::KinematicLimits;
use crate::ramp_profile::{AccelJerk, LimitInterval, SpeedDependentLimits, least};

/// The limits of the axes as arrays; infinite for an axis that the machine does not have.
#[derive(Clone, Copy, Debug)]
pub struct AxisArrays {
    /// The number of axes up to the last one that the machine has; those beyond do not move.
    pub count: usize,
    pub velocity: AxisValues,
    pub acceleration: AxisValues,
    pub jerk: AxisValues,
}

impl AxisArrays {
    pub fn new(limits: &KinematicLimits) -> AxisArrays {
        let count =
            (0..AXES).rev().find(|axis| limits.axis(*axis).is_some()).map_or(0, |last| last + 1);
        AxisArrays {
            count,
            velocity: limits.velocity(),
            acceleration: limits.acceleration(),
            jerk: limits.jerk(),
        }
    }
}

/// The curved part of a path: an arc, or a spiral between two of its points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathTurning {
    /// The largest component of the curved part on X, Y and Z, as a fraction of it, from 0 to 1.
    pub share: [f64; 3],
    /// Largest |q''|, 1/mm.
    pub curvature: f64,
    /// Largest change of the curvature by σ, 1/mm².
    pub twist: f64,
}

/// Bounds of the derivatives of the axes by σ on a piece.
#[derive(Clone, Copy, Debug)]
pub struct DerivativeBounds {
    /// Largest |q'|, |q''| and |q'''| of the polynomials, without the curved part.
    pub even: [AxisValues; 3],
    /// The number of axes up to the last one that moves.
    pub axes: usize,
    /// The curved part; `None` where there is none.
    pub turning: Option<PathTurning>,
    /// Largest |q'| of the tool; 1 where the feed is that of a tip which the axes follow.
    pub rate: f64,
}

impl DerivativeBounds {
    /// Makes the bounds hold for `other`, too.
    pub fn widen(&mut self, other: &DerivativeBounds) {
        for (rows, more) in self.even.iter_mut().zip(&other.even) {
            for (value, more) in rows.iter_mut().zip(more) {
                *value = value.max(*more);
            }
        }
        self.axes = self.axes.max(other.axes);
        self.rate = self.rate.max(other.rate);
    }

    /// Fraction of the curved part on each axis, curvature and twist; zero where nothing is curved.
    fn turn(&self) -> (AxisValues, f64, f64) {
        let mut shares = [0.0; AXES];
        let Some(turning) = &self.turning else { return (shares, 0.0, 0.0) };
        shares[..3].copy_from_slice(&turning.share);
        (shares, turning.curvature, turning.twist)
    }

    /// Acceleration and jerk along the path that are left at any speed up to `v`.
    fn effort_at(&self, v: f64, limits: &AxisArrays) -> AccelJerk {
        if self.turning.is_some() {
            self.turning_effort_at(v, limits)
        } else {
            self.even_effort_at(v, limits)
        }
    }
}

/// The fraction of an acceleration that a curve may use at constant speed; the rest is for changing the speed.
pub const CURVE_ACCELERATION_SHARE: f64 = 0.96;
/// The fraction of a jerk that a curve may use at constant speed. It is smaller, since a change of speed on a curve needs jerk
/// along the path and across it.
pub const CURVE_JERK_SHARE: f64 = 0.7;
/// Fractions of the largest speed of a curve below which more of the limits is left for changing the speed: ramps from and to
/// rest use the larger limits there.
const KNEE_SPEED_SHARES: [f64; 2] = [0.4, 0.8];
/// The fraction of the remaining jerk that may be needed across the path while the speed changes.
const TURNING_JERK_SHARE: f64 = 0.6;
/// The fraction of the remaining jerk along the path that is kept for changing the speed.
const PATH_JERK_SHARE: f64 = 0.6;

/// The limits along the path that hold anywhere on a piece: its largest speed, and the acceleration and jerk that are left for
/// changing it.
pub fn limit_interval(
    length: f64,
    bounds: &DerivativeBounds,
    feed: f64,
    limits: &AxisArrays,
) -> LimitInterval {
    // Where blending shortens the path the tool moves a little below its feed: to move faster by as
    // much would be a change of speed at every piece.
    let mut speed = feed / bounds.rate.max(1.0);
    let (axes, [x1, x2, x3]) = (bounds.axes, &bounds.even);
    let (turn, k, twist) = bounds.turn();
    let (mut by_speed, mut by_square, mut by_cube) = (0.0_f64, 0.0_f64, 0.0_f64);
    for axis in 0..axes {
        let c = turn[axis];
        by_speed = by_speed.max((x1[axis] + c) / limits.velocity[axis]);
        by_square = by_square.max((x2[axis] + c * k) / limits.acceleration[axis]);
        by_cube = by_cube.max((x3[axis] + c * (k * k + twist)) / limits.jerk[axis]);
    }
    if by_speed * speed > 1.0 {
        speed = 1.0 / by_speed;
    }
    if by_square * speed * speed > CURVE_ACCELERATION_SHARE {
        speed = (CURVE_ACCELERATION_SHARE / by_square).sqrt();
    }
    if by_cube * speed * speed * speed > CURVE_JERK_SHARE {
        speed = cbrt(CURVE_JERK_SHARE / by_cube);
    }

    let high = bounds.effort_at(speed, limits);
    let bends = bounds.turning.is_some() || bounds.even[1] != [0.0; AXES];
    let ability = if bends {
        let knees = [KNEE_SPEED_SHARES[0] * speed, KNEE_SPEED_SHARES[1] * speed];
        let low = bounds.effort_at(knees[0], limits);
        let middle = bounds.effort_at(knees[1], limits);
        SpeedDependentLimits { knees, efforts: [low, middle, high] }
    } else {
        SpeedDependentLimits::even(high)
    };
    LimitInterval { length, speed, ability, pieces: 1, ends_at_rest: false }
}

impl DerivativeBounds {
    /// The same without a curved part: each axis has its own second and third derivative.
    fn even_effort_at(&self, v: f64, limits: &AxisArrays) -> AccelJerk {
        let (axes, [x1, x2, x3]) = (self.axes, &self.even);
        let (square, cube) = (v * v, v * v * v);
        let mut acceleration = f64::INFINITY;
        for axis in 0..axes {
            if x1[axis] > 0.0 {
                let left = limits.acceleration[axis] - x2[axis] * square;
                acceleration = least(acceleration, left / x1[axis]);
            }
            // Following the curve while the speed changes uses a part of the remaining jerk.
            let turning = 3.0 * v * x2[axis];
            if turning > 0.0 {
                let left = (limits.jerk[axis] - x3[axis] * cube).max(0.0);
                acceleration = least(acceleration, TURNING_JERK_SHARE * left / turning);
            }
        }
        let mut jerk = f64::INFINITY;
        for axis in 0..axes {
            if x1[axis] > 0.0 {
                let used = 3.0 * x2[axis] * v * acceleration + x3[axis] * cube;
                jerk = least(jerk, (limits.jerk[axis] - used) / x1[axis]);
            }
        }
        AccelJerk { acceleration, jerk }
    }

    fn turning_effort_at(&self, v: f64, limits: &AxisArrays) -> AccelJerk {
        let (axes, [x1, x2, x3]) = (self.axes, &self.even);
        let (turn, k, twist) = self.turn();
        let q = k * v * v;
        let along = k * k * v * v * v;
        let mut acceleration = f64::INFINITY;
        for axis in 0..axes {
            let c = turn[axis];
            let left = limits.acceleration[axis] - x2[axis] * v * v;
            acceleration = acceleration.min(largest(c, q, x1[axis], left));
            // Following the curve while the speed changes needs jerk: on an axis that is not curved it is
            // subtracted from the rest, on curved axes it is at right angles to the change of speed.
            let left = limits.jerk[axis] - x3[axis] * v * v * v;
            let mut share = 3.0 * v * x2[axis] / (TURNING_JERK_SHARE * (left - c * along)).max(0.0);
            if c > 0.0 {
                let whole = left / c;
                let reserved = along + PATH_JERK_SHARE * (whole - along).max(0.0);
                let across =
                    (whole * whole - reserved * reserved).max(0.0).sqrt() - twist * v * v * v;
                share += 3.0 * v * k / across.max(0.0);
            }
            if share > 0.0 {
                acceleration = acceleration.min(1.0 / share);
            }
        }
        let jerk_left = |acceleration: f64| {
            let normal = 3.0 * k * v * acceleration + twist * v * v * v;
            (0..axes).fold(f64::INFINITY, |jerk, axis| {
                let c = turn[axis];
                let used = 3.0 * x2[axis] * v * acceleration + x3[axis] * v * v * v;
                let left = limits.jerk[axis] - used + x1[axis] * along;
                jerk.min(largest(c, normal, x1[axis], left) - along)
            })
        };
        // Where the curvature changes fast, following the curve needs more jerk than was kept for it: then
        // less of the acceleration may be used. With none of it the largest speed leaves some jerk.
        let mut jerk = jerk_left(acceleration);
        while jerk <= 0.0 && acceleration > 0.0 {
            acceleration *= 0.5;
            jerk = jerk_left(acceleration);
        }
        AccelJerk { acceleration, jerk: jerk.max(0.0) }
    }
}

/// The largest a that satisfies c·√(a² + q²) + x·a ≤ b, for c, q, x ≥ 0.
#[inline]
fn largest(c: f64, q: f64, x: f64, b: f64) -> f64 {
    if c == 0.0 {
        return if x > 0.0 { b / x } else { f64::INFINITY };
    }
    if x == 0.0 {
        return ((b / c).powi(2) - q * q).max(0.0).sqrt();
    }
    // c²(a² + q²) = (b − x·a)², the root below b/x.
    let (p, r) = (c * c - x * x, b * b - c * c * q * q);
    let root = (x * x * b * b + p * r).max(0.0).sqrt();
    r / (x * b + root)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn largest_meets_the_limit() {
        for (c, q, x, b) in
            [(1.0, 3.0, 0.0, 5.0), (0.6, 2.0, 0.8, 4.0), (0.8, 2.0, 0.6, 4.0), (0.7, 1.0, 0.7, 9.0)]
        {
            let a = largest(c, q, x, b);
            let sum = c * (a * a + q * q).sqrt() + x * a;
            assert!((sum - b).abs() < 1e-12, "{c} {q} {x} {b}: {a} {sum}");
        }
    }
}

//! What the axes do in a short block of time, and the room that is left for changing the rate.

use chordal_geometry::AXES;

use crate::AxisValues;
use crate::limits::KinematicLimits;

/// The least and the largest of velocity, acceleration and jerk of each axis in some time.
#[derive(Clone, Copy, Debug)]
pub(super) struct MotionBlock {
    /// When it ends, s from the start of the window; it begins where the one before ends.
    pub end_s: f64,
    pub low: [AxisValues; 3],
    pub high: [AxisValues; 3],
}

/// What the rate of time does in a while: its value and its slope, each between two bounds, and
/// its second derivative.
#[derive(Clone, Copy, Debug)]
pub(super) struct RateRange {
    pub rate: (f64, f64),
    pub slope: (f64, f64),
    pub bend: f64,
}

/// The limits as the checks use them, with a relative slack far below what is promised.
#[derive(Clone, Copy, Debug)]
pub(super) struct StreamLimits {
    velocity: AxisValues,
    acceleration: AxisValues,
    jerk: AxisValues,
}

impl StreamLimits {
    pub fn new(limits: &KinematicLimits) -> StreamLimits {
        let slack = |axes: AxisValues| axes.map(|value| value * (1.0 + 2e-7));
        StreamLimits {
            velocity: slack(limits.velocity()),
            acceleration: slack(limits.acceleration()),
            jerk: slack(limits.jerk()),
        }
    }

    /// The steepest slope and bend of the rate with which an axis at its `fastest` keeps its
    /// limits where the plan itself takes nothing of them.
    pub fn steepest(&self, fastest: &AxisValues) -> (f64, f64) {
        let mut steepest = (1e3_f64, 1e6_f64);
        for (axis, fastest) in fastest.iter().enumerate().filter(|(_, fastest)| **fastest > 0.0) {
            steepest.0 = steepest.0.min(self.acceleration[axis] / fastest);
            steepest.1 = steepest.1.min(self.jerk[axis] / fastest);
        }
        steepest
    }
}

impl MotionBlock {
    /// Nothing moves in it.
    pub fn empty(end_s: f64) -> MotionBlock {
        MotionBlock { end_s, low: [[0.0; AXES]; 3], high: [[0.0; AXES]; 3] }
    }

    /// Whether every axis keeps its limits anywhere in the block with any of these rates:
    /// v → vφ, a → aφ² + vφ̇, j → jφ³ + 3aφφ̇ + vφ̈.
    #[inline]
    pub fn allows(&self, rates: &RateRange, room: &StreamLimits) -> bool {
        let RateRange { rate: (slow, fast), slope, bend } = *rates;
        let squares = (slow * slow, fast * fast);
        let cubes = (squares.0 * slow, squares.1 * fast);
        let mixed = times((slow, fast), slope);
        let mixed = (3.0 * mixed.0, 3.0 * mixed.1);
        let mut is_within = true;
        for axis in 0..AXES {
            let of = |row: usize| (self.low[row][axis], self.high[row][axis]);
            let (v, a, j) = (of(0), of(1), of(2));
            // What does not move needs no check.
            if v.0 == 0.0 && v.1 == 0.0 {
                continue;
            }
            is_within &= fast * v.1.max(-v.0) <= room.velocity[axis];
            let acceleration = plus(times(a, squares), times(v, slope));
            is_within &= acceleration.1.max(-acceleration.0) <= room.acceleration[axis];
            let own = plus(times(j, cubes), times(a, mixed));
            let jerk = plus(own, times(v, (bend, bend)));
            is_within &= jerk.1.max(-jerk.0) <= room.jerk[axis];
        }
        is_within
    }
}

type ValueRange = (f64, f64);

#[inline]
fn times(a: ValueRange, b: ValueRange) -> ValueRange {
    let (p, q, r, s) = (a.0 * b.0, a.0 * b.1, a.1 * b.0, a.1 * b.1);
    (p.min(q).min(r.min(s)), p.max(q).max(r.max(s)))
}

#[inline]
fn plus(a: ValueRange, b: ValueRange) -> ValueRange {
    (a.0 + b.0, a.1 + b.1)
}

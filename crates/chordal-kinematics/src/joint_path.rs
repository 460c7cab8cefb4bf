//! The paths of the axes while the tip follows a curve and the rotary axes turn evenly.

use chordal_geometry::{PerAxis, Vec3};

use crate::chain::KinematicChain;
use crate::extreme::{SMALLEST_TOLERANCE, chord_excess, upper_bound};
use crate::inverse::AxisPositions;
use crate::jet::{AngleJet, AxisJet, TipJet};
use crate::joint::{JointAngles, RotaryJoint};
use crate::math;

/// What rounding adds to a bound, in parts of the distances that go into it: some sixteen operations.
const BOUND_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The path of the tip of a tool in part coordinates, by a parameter σ.
pub trait TipMotion {
    /// The point at σ with its derivatives.
    fn tip(&self, sigma: f64) -> TipJet;

    /// The point at σ alone, part coordinates, mm.
    fn point(&self, sigma: f64) -> Vec3 {
        self.tip(sigma).point
    }

    /// Upper bounds of the lengths of the first and the second derivative between two values of σ, mm.
    fn derivative_bounds(&self, from: f64, to: f64) -> (f64, f64);
}

/// A straight line of the tip, by σ from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipLine {
    /// Its start, part coordinates, mm.
    pub from: Vec3,
    /// Its end, part coordinates, mm.
    pub to: Vec3,
}

impl TipMotion for TipLine {
    fn tip(&self, sigma: f64) -> TipJet {
        let (point, first) = (self.from.lerp(self.to, sigma), self.to - self.from);
        TipJet { point, first, second: Vec3::ZERO }
    }

    fn derivative_bounds(&self, _from: f64, _to: f64) -> (f64, f64) {
        ((self.to - self.from).length(), 0.0)
    }
}

/// A move with tool centre point control: the tip follows a path, and the rotary axes turn evenly by its parameter σ
/// from 0 to 1 (Mitsubishi M700 programming manual p.482).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointPath<P> {
    /// The rotary axes.
    pub chain: KinematicChain,
    /// The path of the tip.
    pub tip: P,
    /// The angles at σ = 0, rad.
    pub from: JointAngles,
    /// The angles at σ = 1, rad.
    pub to: JointAngles,
    /// The vector from the gauge point to the tip with the heads at zero, mm.
    pub tool: Vec3,
}

/// Bounds of a point that moves and turns on a part of a path.
#[derive(Clone, Copy)]
pub(crate) struct MotionBound {
    /// The point in the middle of the part, mm.
    pub(crate) middle: Vec3,
    /// Upper bounds of the lengths of the first and the second derivative, mm.
    pub(crate) first: f64,
    pub(crate) second: f64,
    /// Half of the width of the part.
    pub(crate) half: f64,
    /// The sum of the distances that rounding depends on, mm.
    pub(crate) size: f64,
}

impl MotionBound {
    /// The bounds after an axis has turned the point by `angle` in the middle, at `rate` per σ.
    #[inline]
    pub(crate) fn turned(self, joint: &RotaryJoint, angle: f64, rate: f64) -> MotionBound {
        let rate = rate.abs();
        // Only the distance from the line of the axis counts; its point may lie far along it.
        let arm = self.middle - joint.point;
        let across = arm - joint.direction * arm.dot(joint.direction);
        let distance = across.length() + self.half * self.first;
        MotionBound {
            middle: joint.turned_point(self.middle, angle),
            first: self.first + rate * distance,
            second: self.second + 2.0 * rate * self.first + rate * rate * distance,
            half: self.half,
            size: self.size + arm.length() + distance + joint.point.length(),
        }
    }
}

impl<P: TipMotion> JointPath<P> {
    /// The angles at σ with their derivatives.
    #[must_use]
    pub fn angles(&self, sigma: f64) -> AngleJet {
        let each = |value: &dyn Fn(f64, f64) -> f64| -> JointAngles {
            core::array::from_fn(|index| value(self.from[index], self.to[index]))
        };
        AngleJet {
            angles: each(&|from, to| from * (1.0 - sigma) + to * sigma),
            first: each(&|from, to| to - from),
            second: [0.0; 3],
        }
    }

    /// The positions of the axes at σ with their derivatives, exactly.
    #[must_use]
    pub fn at(&self, sigma: f64) -> AxisJet {
        self.chain.axis_jet(&self.tip.tip(sigma), &self.angles(sigma), self.tool)
    }

    /// The positions of the axes at σ.
    #[must_use]
    pub fn positions(&self, sigma: f64) -> AxisPositions {
        let angles = self.angles(sigma).angles;
        let gauge_point = self.chain.gauge_point(self.tip.point(sigma), &angles, self.tool);
        AxisPositions { gauge_point, angles }
    }

    /// An upper bound of the length of the second derivative of the gauge point between two values of σ, mm.
    #[must_use]
    pub fn second_derivative_bound(&self, from: f64, to: f64) -> f64 {
        self.motion_bound(from, to).second
    }

    fn motion_bound(&self, from: f64, to: f64) -> MotionBound {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from).abs());
        let angles = self.angles(middle);
        let point = self.tip.point(middle);
        let (first, second) = self.tip.derivative_bounds(from, to);
        let start = MotionBound { middle: point, first, second, half, size: point.length() };
        let turn = |joint: &RotaryJoint| {
            (joint.right_hand_angle(&angles.angles), angles.first[joint.letter.index()])
        };
        let part = self.chain.tables().fold(start, |bound, joint| {
            let (angle, rate) = turn(joint);
            bound.turned(joint, -angle, rate)
        });
        let tool = self.tool;
        let still =
            MotionBound { middle: tool, first: 0.0, second: 0.0, half, size: tool.length() };
        let tool = self.chain.heads().rev().fold(still, |bound, joint| {
            let (angle, rate) = turn(joint);
            bound.turned(joint, angle, rate)
        });
        MotionBound {
            middle: part.middle - tool.middle,
            first: part.first + tool.first,
            second: part.second + tool.second,
            half,
            size: part.size + tool.size,
        }
    }

    /// The lowest and the highest position of each axis between two values of σ, mm or rad, at most `tolerance_mm`
    /// outside of the true ones and never inside of them. A tolerance below 1e-9 mm is read as 1e-9 mm.
    #[must_use]
    pub fn bounds(&self, from: f64, to: f64, tolerance_mm: f64) -> PerAxis<(f64, f64)> {
        let rounding = BOUND_ROUNDING * self.motion_bound(from, to).size;
        let tolerance = (tolerance_mm - rounding).max(SMALLEST_TOLERANCE);
        let excess =
            |from: f64, to: f64| chord_excess(self.second_derivative_bound(from, to), to - from);
        let highest = |axis: usize, sign: f64| {
            let value = |sigma: f64| sign * self.positions(sigma).gauge_point.component(axis);
            upper_bound((from, to), tolerance, value, excess) + rounding
        };
        let ends = [self.angles(from).angles, self.angles(to).angles];
        core::array::from_fn(|axis| match axis {
            0..3 => (-highest(axis, -1.0), highest(axis, 1.0)),
            _ => {
                let [start, end] = ends.map(|angles| angles[axis - 3]);
                let rounding = BOUND_ROUNDING * start.abs().max(end.abs());
                (start.min(end) - rounding, start.max(end) + rounding)
            }
        })
    }

    /// The number of equal parts of σ between two values in which straight motions of the axes keep the tip within
    /// `tolerance_mm` of its path; at least 1. The tables and heads turn exactly as on the path, so that the tip is as far
    /// off as the gauge point is from its chord.
    #[must_use]
    pub fn chord_count(&self, from: f64, to: f64, tolerance_mm: f64) -> u32 {
        let whole = chord_excess(self.second_derivative_bound(from, to), to - from);
        let tolerance = tolerance_mm.max(SMALLEST_TOLERANCE);
        // A whole number, and what does not fit becomes the largest one.
        math::ceil((whole / tolerance).sqrt()).max(1.0) as u32
    }
}

//! Moves whose axes all run straight, as without tool centre point control.

use chordal_geometry::Vec3;

use crate::chain::KinematicChain;
use crate::extreme::{chord_excess, upper_bound};
use crate::inverse::AxisPositions;
use crate::joint::RotaryJoint;
use crate::joint_path::MotionBound;

/// The distance from a point to the segment between two others, mm.
fn distance_to_segment(point: Vec3, from: Vec3, to: Vec3) -> f64 {
    let along = to - from;
    let square = along.length_squared();
    let fraction = if square > 0.0 { (point - from).dot(along) / square } else { 0.0 };
    point.distance(from.lerp(to, fraction.clamp(0.0, 1.0)))
}

impl KinematicChain {
    /// The largest distance of the tip from the straight line between its two ends while every axis runs straight from
    /// one position to another one, mm: a bound that is at most `tolerance_mm` too large, and never too small. `tool` is
    /// the vector from the gauge point to the tip with the heads at zero. A tolerance below 1e-9 mm is read as 1e-9 mm.
    #[must_use]
    pub fn straight_deviation(
        &self,
        from: &AxisPositions,
        to: &AxisPositions,
        tool: Vec3,
        tolerance_mm: f64,
    ) -> f64 {
        let at = |sigma: f64| AxisPositions {
            gauge_point: from.gauge_point.lerp(to.gauge_point, sigma),
            angles: core::array::from_fn(|index| {
                from.angles[index] * (1.0 - sigma) + to.angles[index] * sigma
            }),
        };
        let tip = |sigma: f64| {
            let axes = at(sigma);
            self.pose(axes.gauge_point, &axes.angles, tool).tip
        };
        let (start, end) = (tip(0.0), tip(1.0));
        let rate = |joint: &RotaryJoint| {
            to.angles[joint.letter.index()] - from.angles[joint.letter.index()]
        };
        let speed = from.gauge_point.distance(to.gauge_point);
        let excess = |low: f64, high: f64| {
            let axes = at(0.5 * (low + high));
            let half = 0.5 * (high - low);
            let still = MotionBound { middle: tool, first: 0.0, second: 0.0, half, size: 0.0 };
            let heads = self.heads().rev().fold(still, |bound, joint| {
                bound.turned(joint, joint.right_hand_angle(&axes.angles), rate(joint))
            });
            let moved = MotionBound {
                middle: axes.gauge_point + heads.middle,
                first: speed + heads.first,
                ..heads
            };
            let tables = self.tables().rev().fold(moved, |bound, joint| {
                bound.turned(joint, joint.right_hand_angle(&axes.angles), rate(joint))
            });
            chord_excess(tables.second, high - low)
        };
        // The distance to a segment is convex, so that it exceeds that of the ends of a chord by no more than the curve
        // leaves the chord.
        let distance = |sigma: f64| distance_to_segment(tip(sigma), start, end);
        upper_bound((0.0, 1.0), tolerance_mm, distance, excess)
    }
}

//! Finds whether a body whose direction turns while it moves keeps clear of a shape.

use chordal_geometry::{Curve, Vec3};

use super::body::{Frustum, RoundBody};
use super::convex::{self, ConvexBody, DistanceInterval};
use super::passage::PassageAnswer;
use super::{ShapeKind, SolidShape};
use crate::oblique::{ElementMotion, ToolTurn};

/// A frustum whose axis has any direction, moved straight.
struct TiltedFrustum {
    frustum: Frustum,
    axis: Vec3,
    tips: [Vec3; 2],
}

impl ConvexBody for TiltedFrustum {
    fn furthest(&self, path: Vec3) -> Vec3 {
        let Frustum { from, to, lower, upper } = self.frustum;
        let along = path.dot(self.axis);
        let across = path - self.axis * along;
        let plan = across.length();
        let higher = upper * plan + to * along > lower * plan + from * along;
        let (radius, height) = if higher { (upper, to) } else { (lower, from) };
        let [start, end] = self.tips;
        let tip = if (end - start).dot(path) > 0.0 { end } else { start };
        let out = if plan > 0.0 { radius / plan } else { 0.0 };
        tip + self.axis * height + across * out
    }
}

impl SolidShape {
    /// Whether a body keeps a clearance (mm, may be zero) while its tip follows a curve and its direction turns. A hit
    /// is where the distance is certainly not above clearance plus tolerance (mm, must be above zero). Of shapes other
    /// than boxes, only their boxes are known here: near these it is not decided.
    pub fn turning_passage(
        &self,
        body: &RoundBody,
        curve: &Curve,
        turn: &ToolTurn,
        [clearance, tolerance]: [f64; 2],
        steps: usize,
    ) -> PassageAnswer {
        let motion = ElementMotion::new(curve, turn);
        let bounds = self.bounds();
        let is_box = matches!(self.0, ShapeKind::Cuboid(_));
        let resolution = tolerance / 4.0;
        let ends = body.frustums().iter().map(|part| part.to.abs().max(part.from.abs()));
        let reach = libm::hypot(ends.fold(0.0, f64::max), body.radius());
        let far = |axis: Vec3, tips: [Vec3; 2]| {
            let of = |frustum: &Frustum| {
                let tilted = TiltedFrustum { frustum: *frustum, axis, tips };
                convex::distance(&tilted, &bounds, resolution, f64::INFINITY)
            };
            body.frustums().iter().map(of).fold(DistanceInterval::ENDLESS, DistanceInterval::or)
        };
        let mut nearest = f64::INFINITY;
        let mut open = vec![[0.0, 1.0]];
        let mut left = steps;
        while let Some([from, to]) = open.pop() {
            let middle = 0.5 * (from + to);
            let axis = turn.direction(middle);
            let tips = [from, to].map(|share| motion.point(share, 0.0));
            let deviation = motion.deviation_within(0.0, reach, to - from);
            let lower = far(axis, tips).lower - deviation;
            if lower >= clearance {
                nearest = nearest.min(lower);
                continue;
            }
            let tip = motion.point(middle, 0.0);
            let own = far(axis, [tip; 2]);
            if is_box && own.upper <= clearance + tolerance {
                return PassageAnswer::Hit { fraction: middle, distance: own };
            }
            left = left.saturating_sub(1);
            let is_fine = deviation + 0.5 * tips[0].distance(tips[1]) <= resolution;
            if left == 0 || is_fine {
                let distance = DistanceInterval {
                    lower: lower.max(0.0),
                    upper: if is_box { own.upper } else { f64::INFINITY },
                };
                return PassageAnswer::Undecided { fraction: from, distance };
            }
            open.extend([[middle, to], [from, middle]]);
        }
        PassageAnswer::Clean { nearest }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use chordal_geometry::Line;

    use super::*;
    use crate::oblique::AxisTurn;

    #[test]
    fn a_tool_that_leans_over_a_jaw() {
        // A rod of 1 mm and 20 mm above the tip at zero leans from upright to level, along X.
        let rod = Frustum { from: 0.0, to: 20.0, lower: 1.0, upper: 1.0 };
        let rod = RoundBody::new(vec![rod]).unwrap();
        let about = AxisTurn { about: Vec3::Y, from: 0.0, to: FRAC_PI_2 };
        let turn = ToolTurn::new(Vec3::Z, &[about]).unwrap();
        let path = Curve::Line(Line { start: Vec3::ZERO, end: Vec3::ZERO });
        let jaw = |z: f64| {
            let (min, max) = (Vec3::new(10.0, -5.0, -10.0), Vec3::new(12.0, 5.0, z));
            SolidShape::cuboid(min, max).unwrap()
        };
        let passed = |z: f64| jaw(z).turning_passage(&rod, &path, &turn, [0.0, 0.01], 10_000);
        assert!(matches!(passed(-0.9), PassageAnswer::Hit { .. }), "{:?}", passed(-0.9));
        let PassageAnswer::Clean { nearest } = passed(-1.5) else { panic!("{:?}", passed(-1.5)) };
        assert!((0.0..=0.5).contains(&nearest), "{nearest}");
    }
}

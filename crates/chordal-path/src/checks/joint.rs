//! Joints between a line and an arc, or between arcs, that are almost tangent.

use chordal_command::{Move, Origin, number_text};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::{Curve, ParamCurve, Plane, Vec3};

use super::RunChecks;
use crate::segment::point;

/// Joints that turn by less are tangent within rounding of coordinates, rad (0.1°).
const TANGENT_RAD: f64 = 0.001_745;

/// Joints that turn by more are intended corners, rad (2°).
const CORNER_RAD: f64 = 0.034_9;

impl RunChecks<'_> {
    pub(super) fn joint_of_line(
        &mut self,
        motion: &Move,
        origin: Origin,
        report: &mut impl FnMut(Diagnostic),
    ) {
        let (from, to) = (point(&motion.from), point(&motion.to));
        let course = to - from;
        if let Some((before, place, Some(plane))) = self.now.last
            && place == from
        {
            self.joint(plane, before, course, origin, report);
        }
        // The direction is needed only when an arc follows, so it is not normalized here.
        if course != Vec3::ZERO {
            self.now.last = Some((course, to, None));
        }
    }

    pub(super) fn joint_of_arc(
        &mut self,
        curve: &Curve,
        plane: Plane,
        origin: Origin,
        report: &mut impl FnMut(Diagnostic),
    ) {
        if let Some((before, place, _)) = self.now.last
            && place == curve.start()
        {
            self.joint(plane, before, curve.tangent_at(0.0), origin, report);
        }
        self.now.last = Some((curve.tangent_at(curve.length()), curve.end(), Some(plane)));
    }

    /// Checks a joint, in the plane of the arc: the slope of a helix is intended.
    fn joint(
        &self,
        plane: Plane,
        before: Vec3,
        after: Vec3,
        origin: Origin,
        report: &mut impl FnMut(Diagnostic),
    ) {
        // The control makes the joints within a cycle.
        if origin.cycle {
            return;
        }
        let flat = |direction: Vec3| {
            let normal = plane.normal();
            direction - normal * direction.dot(normal)
        };
        let (before, after) = (flat(before), flat(after));
        // Compares the square of the sine, so that most joints need no square root.
        let across = before.cross(after).length_squared();
        let whole = before.length_squared() * after.length_squared();
        let turns =
            (TANGENT_RAD * TANGENT_RAD * whole..CORNER_RAD * CORNER_RAD * whole).contains(&across);
        if !turns || before.dot(after) <= 0.0 {
            return;
        }
        let sine = (across / whole).sqrt();
        let degrees = sine.asin_degrees();
        report(
            Diagnostic::new(
                Code::NearlyTangent,
                origin.span,
                format!(
                    "the path turns by {} degrees where this block begins",
                    number_text(degrees, 2)
                ),
            )
            .label("almost tangent to the block before")
            .help("if the joint is meant to be smooth, compute the coordinates with more decimals"),
        );
    }
}

trait ArcsineInDegrees {
    fn asin_degrees(self) -> f64;
}

impl ArcsineInDegrees for f64 {
    /// The arcsine of a small value, in degrees: a series that is exact to 1e-9 at two degrees and gives the same result
    /// on every platform.
    fn asin_degrees(self) -> f64 {
        let s = self;
        (s + s * s * s / 6.0 + 3.0 * s.powi(5) / 40.0).to_degrees()
    }
}

//! The direction of the tool with two rotary axes, as a triangle on the unit sphere.
//!
//! The second axis turns the direction `k` of the tool at zero to `z`, and the first one turns `z` to `t`. So `z` is as
//! far from the second axis as `k` is, and as far from the first one as `t` is: with the two axes it makes a triangle of
//! which all three sides are known. It lies on either side of the plane of the axes, which gives the two solutions.
//! Half-angle formulas keep every digit where the triangle is flat: near poles and at the limits of the reach.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal_geometry::Vec3;

use crate::chain::KinematicChain;
use crate::math;

/// The sine of an angle to a pole below which a direction is on the pole.
pub(crate) const POLE_SINE: f64 = 1e-9;

/// How far outside of the reach a direction may be by the rounding of its three numbers, rad.
pub(crate) const REACH_ROUNDING_RAD: f64 = 1e-12;

/// The two axes and the direction of the tool, whatever the angles are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisTriangle {
    /// The direction of the first axis.
    first: Vec3,
    /// In the plane of the axes, square to the first axis, toward the second one.
    first_in_plane: Vec3,
    /// Square to the plane of the axes.
    normal: Vec3,
    /// The angle between the axes, rad, `0..=π`.
    between_axes: f64,
    /// The angle between the second axis and the direction of the tool, rad, `0..=π`.
    to_tool: f64,
    /// The angle about the second axis from the first axis to the direction of the tool at zero, rad.
    tool_azimuth: f64,
}

/// On which side of the plane of the axes `z` lies: +1 or −1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TriangleSide {
    Left,
    Right,
}

impl TriangleSide {
    pub(crate) const fn sign(self) -> f64 {
        match self {
            TriangleSide::Left => 1.0,
            TriangleSide::Right => -1.0,
        }
    }

    pub(crate) const fn other(self) -> TriangleSide {
        match self {
            TriangleSide::Left => TriangleSide::Right,
            TriangleSide::Right => TriangleSide::Left,
        }
    }
}

/// How far a direction is outside of the reach, rad: zero inside.
fn outside(low: f64, value: f64, high: f64) -> f64 {
    (low - value).max(value - high).max(0.0)
}

impl AxisTriangle {
    /// The triangle of a chain of two axes; `None` if it has others, or if they are parallel.
    pub(crate) fn of(chain: &KinematicChain) -> Option<Self> {
        let [first, second] = chain.joints() else { return None };
        let (first, second) = (first.direction, second.direction);
        let cross = first.cross(second);
        if cross.length() < POLE_SINE {
            return None;
        }
        let normal = cross.normalized()?;
        let (first_in_plane, second_in_plane) = (normal.cross(first), second.cross(normal));
        let tool = chain.tool_direction();
        // Square to the second axis: in the plane toward the first one, and along −normal.
        let tool_azimuth = math::atan2(-tool.dot(normal), tool.dot(second_in_plane));
        Some(Self {
            first,
            first_in_plane,
            normal,
            between_axes: math::angle_between(first, second),
            to_tool: math::angle_between(second, tool),
            tool_azimuth,
        })
    }

    /// The angle between the first axis and a unit vector, rad, `0..=π`.
    pub(crate) fn polar_angle(&self, direction: Vec3) -> f64 {
        math::angle_between(self.first, direction)
    }

    /// The angle about the first axis from the plane of the axes to a direction, rad, `-π..=π`.
    pub(crate) fn azimuth(&self, direction: Vec3) -> f64 {
        math::atan2(direction.dot(self.normal), direction.dot(self.first_in_plane))
    }

    /// The direction of the first axis.
    pub(crate) const fn first(&self) -> Vec3 {
        self.first
    }

    /// The least and the largest angle from the first axis that the tool reaches, rad.
    pub(crate) fn reach(&self) -> (f64, f64) {
        let sum = self.between_axes + self.to_tool;
        ((self.between_axes - self.to_tool).abs(), sum.min(TAU - sum))
    }

    /// How far a direction at this angle from the first axis is outside of the reach, rad; zero inside.
    pub(crate) fn beyond_reach(&self, polar: f64) -> f64 {
        let (low, high) = self.reach();
        let beyond = outside(low, polar, high);
        if beyond <= REACH_ROUNDING_RAD { 0.0 } else { beyond }
    }

    /// Whether the second axis does not change the direction of the tool, which is parallel to it.
    pub(crate) fn second_is_free(&self) -> bool {
        Self::is_pole(self.to_tool)
    }

    /// Whether a direction at this angle from the first axis is parallel to it, so that the first axis may be anywhere.
    pub(crate) fn is_pole(polar: f64) -> bool {
        // So small an angle is its sine.
        polar.min(PI - polar) < POLE_SINE
    }

    /// The angle of the second axis (rad, right-hand rule) that brings the tool parallel to the first axis, on the side on
    /// which a direction with this angle from it is; `None` if the machine does not reach that.
    pub(crate) fn pole_angle(&self, polar: f64) -> Option<f64> {
        let (low, high) = self.reach();
        if polar < FRAC_PI_2 {
            (low < POLE_SINE).then_some(-self.tool_azimuth)
        } else {
            (PI - high < POLE_SINE).then_some(PI - self.tool_azimuth)
        }
    }

    /// The corners of the triangle at the first and the second axis, rad, `0..=π`.
    pub(crate) fn corners(&self, polar: f64) -> (f64, f64) {
        if Self::is_pole(polar) {
            // The limits: the triangle is a lune.
            return (FRAC_PI_2, if polar < FRAC_PI_2 { 0.0 } else { PI });
        }
        let (axes, tool) = (self.between_axes, self.to_tool);
        let sine = |twice: f64| math::sin(0.5 * twice).max(0.0);
        // Differences of sides first: those of equal sides are exactly zero.
        let whole = sine(axes + tool + polar);
        let less_axes = sine(polar - (axes - tool));
        let less_tool = sine(polar + (axes - tool));
        let less_polar = sine(axes + tool - polar);
        let at_first =
            2.0 * math::atan2((less_axes * less_polar).sqrt(), (whole * less_tool).sqrt());
        let at_second =
            2.0 * math::atan2((less_axes * less_tool).sqrt(), (whole * less_polar).sqrt());
        (at_first, at_second)
    }

    /// The angles of the first and the second axis (rad, right-hand rule) for a direction with this angle from the first
    /// axis and this azimuth about it. They change without a jump as long as the side is the same and the azimuth does.
    pub(crate) fn angles(&self, polar: f64, azimuth: f64, side: TriangleSide) -> (f64, f64) {
        self.angles_of_corners(self.corners(polar), azimuth, side)
    }

    /// The same from the corners of the triangle.
    pub(crate) fn angles_of_corners(
        &self,
        (at_first, at_second): (f64, f64),
        azimuth: f64,
        side: TriangleSide,
    ) -> (f64, f64) {
        let sign = side.sign();
        (azimuth - sign * at_first, -sign * at_second - self.tool_azimuth)
    }

    /// The side on which the second axis is at an angle (rad, right-hand rule).
    pub(crate) fn side_of(&self, second_angle: f64) -> TriangleSide {
        match math::within_half_turn(second_angle + self.tool_azimuth) <= 0.0 {
            true => TriangleSide::Left,
            false => TriangleSide::Right,
        }
    }
}

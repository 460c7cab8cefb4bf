//! Values with their first and second derivatives.

use chordal_geometry::{PerAxis, Vec3};

use crate::chain::KinematicChain;
use crate::joint::{JointAngles, RotaryJoint};
use crate::math;

/// A point of a path with its derivatives by the parameter of the path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TipJet {
    /// The point, mm.
    pub point: Vec3,
    /// The first derivative, mm.
    pub first: Vec3,
    /// The second derivative, mm.
    pub second: Vec3,
}

/// The angles of A, B and C with their derivatives by the parameter of a path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AngleJet {
    /// The angles, rad.
    pub angles: JointAngles,
    /// The first derivatives, rad.
    pub first: JointAngles,
    /// The second derivatives, rad.
    pub second: JointAngles,
}

/// The positions of the axes X, Y, Z, A, B and C with their derivatives by the parameter of a path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisJet {
    /// The positions, mm or rad.
    pub position: PerAxis<f64>,
    /// The first derivatives, mm or rad.
    pub first: PerAxis<f64>,
    /// The second derivatives, mm or rad.
    pub second: PerAxis<f64>,
}

/// An angle with its derivatives, by the right-hand rule about the direction of an axis.
#[derive(Clone, Copy)]
struct Turning {
    angle: f64,
    first: f64,
    second: f64,
}

impl Turning {
    fn of(joint: &RotaryJoint, angles: &AngleJet) -> Turning {
        let (index, sign) = (joint.letter.index(), joint.sign());
        Turning {
            angle: sign * angles.angles[index],
            first: sign * angles.first[index],
            second: sign * angles.second[index],
        }
    }

    fn inverse(self) -> Turning {
        Turning { angle: -self.angle, first: -self.first, second: -self.second }
    }
}

/// The jet of a point that turns about an axis while it moves.
///
/// With `r` from the axis to the point and `x` its position, `R' = ω u × R` and `u × R v = R (u × v)` give
/// `R (x' + ω u × r)` and `R (x'' + 2 ω u × x' + α u × r + ω² u × (u × r))`.
fn turned(jet: &TipJet, joint: &RotaryJoint, turning: Turning) -> TipJet {
    let about = joint.direction;
    let (omega, alpha) = (turning.first, turning.second);
    let across = about.cross(jet.point - joint.point);
    let first = jet.first + across * omega;
    let second = jet.second
        + about.cross(jet.first) * (2.0 * omega)
        + across * alpha
        + about.cross(across) * (omega * omega);
    TipJet {
        point: joint.turned_point(jet.point, turning.angle),
        first: math::rotated(first, about, turning.angle),
        second: math::rotated(second, about, turning.angle),
    }
}

impl KinematicChain {
    /// The positions of the axes, with their derivatives, that move the tip along a path in part coordinates while the
    /// rotary axes turn. `tool` is the vector from the gauge point to the tip with the heads at zero.
    #[must_use]
    pub fn axis_jet(&self, tip: &TipJet, angles: &AngleJet, tool: Vec3) -> AxisJet {
        let on_machine = self
            .tables()
            .fold(*tip, |jet, joint| turned(&jet, joint, Turning::of(joint, angles).inverse()));
        let tool = self.tool_jet(angles, tool);
        let position = (on_machine.point - tool.point).to_array();
        let first = (on_machine.first - tool.first).to_array();
        let second = (on_machine.second - tool.second).to_array();
        let joined = |linear: [f64; 3], rotary: JointAngles| {
            let ([x, y, z], [a, b, c]) = (linear, rotary);
            [x, y, z, a, b, c]
        };
        AxisJet {
            position: joined(position, angles.angles),
            first: joined(first, angles.first),
            second: joined(second, angles.second),
        }
    }

    /// The vector from the gauge point to the tip with its derivatives, machine coordinates.
    fn tool_jet(&self, angles: &AngleJet, tool: Vec3) -> TipJet {
        let tool = TipJet { point: tool, ..TipJet::default() };
        self.heads().rev().fold(tool, |jet, joint| turned(&jet, joint, Turning::of(joint, angles)))
    }
}

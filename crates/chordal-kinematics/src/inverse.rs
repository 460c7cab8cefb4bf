//! From the tool to the axes.

use core::fmt;

use chordal_geometry::Vec3;

use crate::chain::{KinematicChain, ToolPose};
use crate::joint::{JointAngles, RotaryJoint, RotaryLetter};
use crate::math;
use crate::triangle::{AxisTriangle, POLE_SINE, REACH_ROUNDING_RAD, TriangleSide};

/// Angles of the rotary axes for a direction of the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointSolution {
    /// The angles, rad, each in `-π..=π`; zero for a free axis and for axes that the chain does not have.
    pub angles: JointAngles,
    /// The axis whose angle does not change the direction of the tool; `None`: every angle is determined.
    pub free: Option<RotaryLetter>,
}

/// The solutions for a direction: at least one and at most two, to each of which whole turns may be added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointSolutions {
    solutions: [JointSolution; 2],
    count: usize,
}

impl JointSolutions {
    fn one(solution: JointSolution) -> Self {
        Self { solutions: [solution; 2], count: 1 }
    }

    /// The solutions.
    #[must_use]
    pub fn as_slice(&self) -> &[JointSolution] {
        &self.solutions[..self.count]
    }
}

/// Why no angles give a direction of the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DirectionError {
    /// The direction is zero or not finite.
    NoDirection,
    /// The two rotary axes are parallel: their angles are not determined.
    ParallelAxes,
    /// No angles give this direction.
    Unreachable {
        /// How far it is from the nearest direction that the machine reaches, rad.
        beyond_rad: f64,
    },
}

impl fmt::Display for DirectionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DirectionError::NoDirection => {
                write!(f, "the direction of the tool is zero or not finite")
            }
            DirectionError::ParallelAxes => write!(
                f,
                "the two rotary axes are parallel, so that their angles are not determined"
            ),
            DirectionError::Unreachable { beyond_rad } => write!(
                f,
                "the rotary axes do not reach the direction: it is {} deg outside",
                math::degrees_text(*beyond_rad)
            ),
        }
    }
}

impl core::error::Error for DirectionError {}

/// The positions of all axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisPositions {
    /// The gauge point, machine coordinates, mm.
    pub gauge_point: Vec3,
    /// The angles of A, B and C, rad.
    pub angles: JointAngles,
}

impl KinematicChain {
    /// Every solution for a direction of the tool in part coordinates, from its tip to its holder, of any length.
    ///
    /// A direction whose sine to the first axis is below 1e-9 is on the pole: then that axis is free, and the other one
    /// brings the tool exactly parallel to it. There is no other tolerance than for the rounding of the direction itself
    /// (1e-12 rad) at the limit of the reach.
    ///
    /// # Errors
    /// See [`DirectionError`].
    pub fn joint_solutions(&self, direction: Vec3) -> Result<JointSolutions, DirectionError> {
        let direction = direction.normalized().ok_or(DirectionError::NoDirection)?;
        match self.joints() {
            [] => self.without_joints(direction),
            [joint] => self.with_one_joint(joint, direction),
            [first, second, ..] => {
                let triangle = AxisTriangle::of(self).ok_or(DirectionError::ParallelAxes)?;
                with_two_joints(&triangle, [first, second], direction)
            }
        }
    }

    /// Every solution for a tool in part coordinates, with a free axis at zero. `tool` is the vector from the gauge point
    /// to the tip with the heads at zero.
    ///
    /// # Errors
    /// See [`DirectionError`].
    pub fn axis_positions(
        &self,
        pose: &ToolPose,
        tool: Vec3,
    ) -> Result<impl Iterator<Item = AxisPositions> + use<>, DirectionError> {
        let found = self.joint_solutions(pose.direction)?;
        let count = found.count;
        let (tip, chain) = (pose.tip, *self);
        Ok(found.solutions.into_iter().take(count).map(move |solution| {
            let angles = solution.angles;
            AxisPositions { gauge_point: chain.gauge_point(tip, &angles, tool), angles }
        }))
    }

    fn without_joints(&self, direction: Vec3) -> Result<JointSolutions, DirectionError> {
        let beyond_rad = math::angle_between(self.tool_direction(), direction);
        if beyond_rad > REACH_ROUNDING_RAD {
            return Err(DirectionError::Unreachable { beyond_rad });
        }
        Ok(JointSolutions::one(JointSolution { angles: [0.0; 3], free: None }))
    }

    fn with_one_joint(
        &self,
        joint: &RotaryJoint,
        direction: Vec3,
    ) -> Result<JointSolutions, DirectionError> {
        let (axis, tool) = (joint.direction, self.tool_direction());
        let to_tool = math::angle_between(axis, tool);
        let beyond_rad = (math::angle_between(axis, direction) - to_tool).abs();
        let is_free = math::sin(to_tool) < POLE_SINE;
        let limit = if is_free { POLE_SINE } else { REACH_ROUNDING_RAD };
        if beyond_rad > limit {
            return Err(DirectionError::Unreachable { beyond_rad });
        }
        if is_free {
            let free = Some(joint.letter);
            return Ok(JointSolutions::one(JointSolution { angles: [0.0; 3], free }));
        }
        let square = |v: Vec3| v - axis * v.dot(axis);
        let (from, to) = (square(tool), square(direction));
        let angle = math::atan2(axis.dot(from.cross(to)), from.dot(to));
        let mut angles = [0.0; 3];
        angles[joint.letter.index()] = joint.sign() * angle;
        Ok(JointSolutions::one(JointSolution { angles, free: None }))
    }
}

fn with_two_joints(
    triangle: &AxisTriangle,
    joints: [&RotaryJoint; 2],
    direction: Vec3,
) -> Result<JointSolutions, DirectionError> {
    let polar = triangle.polar_angle(direction);
    let beyond_rad = triangle.beyond_reach(polar);
    let is_pole = AxisTriangle::is_pole(polar);
    if beyond_rad > if is_pole { POLE_SINE } else { 0.0 } {
        return Err(DirectionError::Unreachable { beyond_rad });
    }
    let [first, second] = joints;
    let azimuth = triangle.azimuth(direction);
    let corners = triangle.corners(polar);
    let solution = |side: TriangleSide| {
        let (one, two) = triangle.angles_of_corners(corners, azimuth, side);
        let mut angles = [0.0; 3];
        angles[first.letter.index()] = first.sign() * math::within_half_turn(one);
        angles[second.letter.index()] = second.sign() * math::within_half_turn(two);
        angles
    };
    if is_pole && let Some(pole) = triangle.pole_angle(polar) {
        let mut angles = [0.0; 3];
        angles[second.letter.index()] = second.sign() * math::within_half_turn(pole);
        return Ok(JointSolutions::one(JointSolution { angles, free: Some(first.letter) }));
    }
    if triangle.second_is_free() {
        let mut angles = solution(TriangleSide::Left);
        angles[second.letter.index()] = 0.0;
        return Ok(JointSolutions::one(JointSolution { angles, free: Some(second.letter) }));
    }
    let [one, other] = [TriangleSide::Left, TriangleSide::Right]
        .map(|side| JointSolution { angles: solution(side), free: None });
    // At the limit of the reach both are the same, perhaps as +180 and -180 degrees.
    let differences =
        one.angles.iter().zip(other.angles).map(|(a, b)| math::within_half_turn(a - b));
    let are_same = differences.map(f64::abs).fold(0.0, f64::max) <= REACH_ROUNDING_RAD;
    Ok(JointSolutions { solutions: [one, other], count: if are_same { 1 } else { 2 } })
}

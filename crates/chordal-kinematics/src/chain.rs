//! The chain of rotary axes from the part to the tool, and where it brings the tool.

use core::fmt;

use chordal_geometry::{Transform, Vec3};

use crate::joint::{JointAngles, RotaryJoint, RotaryLetter, RotaryMount};
use crate::math;

/// The largest number of rotary axes of a chain.
pub const MAX_JOINTS: usize = 2;

/// The rotary axes of a machine in order from the part to the tool: tables, then the linear axes, then heads.
///
/// With `T(a) x = q + R(u, a)(x − q)` for an axis with direction `u` through `q`, a machine with two tables has
/// `w = T1(a1) T2(a2)(m + tool)` and one with two heads `w = m + T1(a1) T2(a2) tool`, where `m` is the gauge point in
/// machine coordinates, `tool` the vector from it to the tip, and `w` the tip in *part coordinates*: machine coordinates
/// of what the tables carry, with the tables at zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KinematicChain {
    /// Directions are unit vectors; the joints from `count` on are not used.
    joints: [RotaryJoint; MAX_JOINTS],
    count: usize,
    tool_direction: Vec3,
}

/// Why rotary axes are no chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ChainError {
    /// There are more than [`MAX_JOINTS`] rotary axes.
    TooManyJoints {
        /// How many there are.
        count: usize,
    },
    /// A head stands before a table.
    HeadBeforeTable {
        /// The head.
        head: RotaryLetter,
        /// The table after it.
        table: RotaryLetter,
    },
    /// Two axes have the same letter.
    SameLetter {
        /// The letter.
        letter: RotaryLetter,
    },
    /// The direction of an axis is zero or not finite.
    NoDirection {
        /// The axis.
        letter: RotaryLetter,
    },
    /// The point of an axis is not finite.
    NoPoint {
        /// The axis.
        letter: RotaryLetter,
    },
    /// The lowest angle of an axis is above the highest, or one of them is NaN.
    NoTravel {
        /// The axis.
        letter: RotaryLetter,
    },
    /// The direction of the tool is zero or not finite.
    NoToolDirection,
}

impl fmt::Display for ChainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ChainError::TooManyJoints { count } => {
                write!(
                    f,
                    "{count} rotary axes carry part and tool; at most {MAX_JOINTS} are supported"
                )
            }
            ChainError::HeadBeforeTable { head, table } => {
                write!(
                    f,
                    "the head {head} stands before the table {table}; from the part to the tool, tables come first"
                )
            }
            ChainError::SameLetter { letter } => write!(f, "two rotary axes are named {letter}"),
            ChainError::NoDirection { letter } => {
                write!(f, "the direction of {letter} is zero or not finite")
            }
            ChainError::NoPoint { letter } => write!(f, "the point of {letter} is not finite"),
            ChainError::NoTravel { letter } => {
                write!(f, "the lowest angle of {letter} is above the highest")
            }
            ChainError::NoToolDirection => {
                write!(f, "the direction of the tool is zero or not finite")
            }
        }
    }
}

impl core::error::Error for ChainError {}

/// Where a tool is, relative to the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolPose {
    /// Its tip, part coordinates, mm.
    pub tip: Vec3,
    /// The unit vector from its tip to its holder, part coordinates.
    pub direction: Vec3,
}

impl KinematicChain {
    /// A machine without rotary axes, with the tool along Z.
    pub const CARTESIAN: KinematicChain = KinematicChain {
        joints: [RotaryJoint::table(RotaryLetter::A, Vec3::ZERO); MAX_JOINTS],
        count: 0,
        tool_direction: Vec3::Z,
    };

    /// The chain of these axes in order from the part to the tool, with the tool along Z. Directions may have any
    /// length. Two axes may be parallel; only the inverse refuses them.
    ///
    /// # Errors
    /// See [`ChainError`].
    pub fn new(joints: &[RotaryJoint]) -> Result<Self, ChainError> {
        let count = joints.len();
        if count > MAX_JOINTS {
            return Err(ChainError::TooManyJoints { count });
        }
        let mut chain = Self { count, ..Self::CARTESIAN };
        for (place, joint) in chain.joints.iter_mut().zip(joints) {
            *place = checked(joint)?;
        }
        if let [first, second] = joints {
            if first.letter == second.letter {
                return Err(ChainError::SameLetter { letter: first.letter });
            }
            if (first.side, second.side) == (RotaryMount::Head, RotaryMount::Table) {
                let (head, table) = (first.letter, second.letter);
                return Err(ChainError::HeadBeforeTable { head, table });
            }
        }
        Ok(chain)
    }

    /// The same chain with another direction of the tool, from its tip to its holder with every rotary axis at zero
    /// (Fanuc parameter 19697); of any length.
    ///
    /// # Errors
    /// [`ChainError::NoToolDirection`] if the direction is zero or not finite.
    pub fn with_tool_direction(mut self, direction: Vec3) -> Result<Self, ChainError> {
        self.tool_direction = direction.normalized().ok_or(ChainError::NoToolDirection)?;
        Ok(self)
    }

    /// The same chain with every head turning about the gauge point: then the heads move the tip by the length of the tool
    /// alone.
    #[must_use]
    pub fn with_heads_at_gauge_point(mut self) -> Self {
        let heads = self.joints.iter_mut().filter(|joint| joint.side == RotaryMount::Head);
        heads.for_each(|joint| joint.point = Vec3::ZERO);
        self
    }

    /// The rotary axes in order from the part to the tool, with unit vectors as directions.
    #[must_use]
    pub fn joints(&self) -> &[RotaryJoint] {
        &self.joints[..self.count]
    }

    /// The axis with a letter; `None` if the chain has none.
    #[must_use]
    pub fn joint(&self, letter: RotaryLetter) -> Option<&RotaryJoint> {
        self.joints().iter().find(|joint| joint.letter == letter)
    }

    /// The letter of the axis whose movement Fanuc compares first, its master: the first from the part, which is the table
    /// of a machine with head and table, and of two heads the one that carries the other (A-79348E p.28 and 32, where the
    /// direction of the tool does not depend on the master while the slave is at zero); `None` without rotary axes.
    #[must_use]
    pub fn master(&self) -> Option<RotaryLetter> {
        self.joints().first().map(|joint| joint.letter)
    }

    /// The tables, in order from the part to the linear axes.
    pub(crate) fn tables(&self) -> impl DoubleEndedIterator<Item = &RotaryJoint> {
        self.joints().iter().filter(|joint| joint.side == RotaryMount::Table)
    }

    /// The heads, in order from the linear axes to the tool.
    pub(crate) fn heads(&self) -> impl DoubleEndedIterator<Item = &RotaryJoint> {
        self.joints().iter().filter(|joint| joint.side == RotaryMount::Head)
    }

    /// The unit vector from the tip of the tool to its holder with every rotary axis at zero.
    #[must_use]
    pub const fn tool_direction(&self) -> Vec3 {
        self.tool_direction
    }

    /// The vector from the gauge point to the tip of a tool of this length with every rotary axis at zero, mm.
    #[must_use]
    pub fn tool_vector(&self, length_mm: f64) -> Vec3 {
        -self.tool_direction * length_mm
    }

    /// The unit vector from the tip of the tool to its holder, part coordinates.
    #[must_use]
    pub fn direction(&self, angles: &JointAngles) -> Vec3 {
        let joints = self.joints().iter().rev();
        joints.fold(self.tool_direction, |direction, joint| {
            math::rotated(direction, joint.direction, joint.right_hand_angle(angles))
        })
    }

    /// Where the tool is if the gauge point is at these machine coordinates (mm) and the rotary axes at these angles.
    /// `tool` is the vector from the gauge point to the tip with the heads at zero ([`Self::tool_vector`]).
    #[must_use]
    pub fn pose(&self, gauge_point: Vec3, angles: &JointAngles, tool: Vec3) -> ToolPose {
        let on_machine = gauge_point + self.tool_on_heads(angles, tool);
        let tip = self.tables().rev().fold(on_machine, |point, joint| {
            joint.turned_point(point, joint.right_hand_angle(angles))
        });
        ToolPose { tip, direction: self.direction(angles) }
    }

    /// The machine coordinates of the gauge point that bring the tip of the tool to a point in part coordinates, mm.
    #[must_use]
    pub fn gauge_point(&self, tip: Vec3, angles: &JointAngles, tool: Vec3) -> Vec3 {
        let on_machine = self
            .tables()
            .fold(tip, |point, joint| joint.turned_point(point, -joint.right_hand_angle(angles)));
        on_machine - self.tool_on_heads(angles, tool)
    }

    /// The vector from the gauge point to the tip with the heads at these angles, machine coordinates, mm.
    #[must_use]
    pub fn tool_on_heads(&self, angles: &JointAngles, tool: Vec3) -> Vec3 {
        self.heads()
            .rev()
            .fold(tool, |point, joint| joint.turned_point(point, joint.right_hand_angle(angles)))
    }

    /// The transform from machine coordinates to part coordinates, which the tables make; its inverse brings a point of
    /// the part to where the tables have turned it.
    #[must_use]
    pub fn part_transform(&self, angles: &JointAngles) -> Transform {
        self.tables().rev().fold(Transform::identity(), |to_part, joint| {
            let angle = joint.right_hand_angle(angles);
            if angle == 0.0 {
                return to_part;
            }
            to_part.then(&Transform::rotation_about(joint.point, joint.direction, angle))
        })
    }
}

/// The axis with a unit vector as its direction, if its values are usable.
fn checked(joint: &RotaryJoint) -> Result<RotaryJoint, ChainError> {
    let letter = joint.letter;
    let direction = joint.direction.normalized().ok_or(ChainError::NoDirection { letter })?;
    if !joint.point.is_finite() {
        return Err(ChainError::NoPoint { letter });
    }
    if joint.travel.is_some_and(|(low, high)| low.is_nan() || high.is_nan() || low > high) {
        return Err(ChainError::NoTravel { letter });
    }
    Ok(RotaryJoint { direction, ..*joint })
}

//! A machine as a tree of links, each of which an axis moves on the one before.

use chordal_geometry::{PerAxis, Transform, Vec3};
use chordal_kinematics::{KinematicChain, RotaryMount};

/// How a link moves on the one that carries it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinkJoint {
    /// Not at all: the base.
    Fixed,
    /// Along X, Y or Z (0 to 2), by the position of the axis times the sign.
    Linear {
        /// 0 to 2.
        axis: usize,
        /// 1 or -1.
        sign: f64,
    },
    /// About a line, by the angle of A, B or C (3 to 5) times the sign, with the right hand about the direction.
    Rotary {
        /// 3 to 5.
        axis: usize,
        /// 1 or -1.
        sign: f64,
        /// A point on the line, with all axes at zero, mm.
        point: Vec3,
        /// The direction of the line.
        direction: Vec3,
    },
}

impl LinkJoint {
    /// The same joint, moved the other way.
    #[must_use]
    pub fn reversed(self) -> LinkJoint {
        match self {
            LinkJoint::Fixed => LinkJoint::Fixed,
            LinkJoint::Linear { axis, sign } => LinkJoint::Linear { axis, sign: -sign },
            LinkJoint::Rotary { axis, sign, point, direction } => {
                LinkJoint::Rotary { axis, sign: -sign, point, direction }
            }
        }
    }

    /// What it does to what it carries, with the axes at these positions (mm and rad).
    #[must_use]
    pub fn motion(&self, axes: &PerAxis<f64>) -> Transform {
        match *self {
            LinkJoint::Fixed => Transform::identity(),
            LinkJoint::Linear { axis, sign } => {
                Transform::translation([Vec3::X, Vec3::Y, Vec3::Z][axis] * (axes[axis] * sign))
            }
            LinkJoint::Rotary { axis, sign, point, direction } => {
                Transform::rotation_about(point, direction, axes[axis] * sign)
            }
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct MachineLink {
    /// What carries it; `None` for the base.
    parent: Option<usize>,
    joint: LinkJoint,
}

/// A machine as a tree of links: the base, what each axis moves, what holds the part, what holds the tool. Bodies on it are
/// given in machine coordinates with every axis at zero, where the gauge point of the spindle is at zero.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineLinks {
    links: Vec<MachineLink>,
    part: usize,
    tool: usize,
    by_axis: PerAxis<Option<usize>>,
}

impl MachineLinks {
    /// A machine with these rotary axes. `sides` says what X, Y and Z move, `order` which of them carries which, from the
    /// base outwards: 0 for X, 1 for Y, 2 for Z. Axes that the order does not name follow in the order X, Y, Z.
    #[must_use]
    pub fn new(chain: &KinematicChain, sides: [RotaryMount; 3], order: [usize; 3]) -> MachineLinks {
        let base = MachineLink { parent: None, joint: LinkJoint::Fixed };
        let mut machine = MachineLinks { links: vec![base], part: 0, tool: 0, by_axis: [None; 6] };
        for side in [RotaryMount::Table, RotaryMount::Head] {
            let mut last = 0;
            // A table moves the part the other way, so that the tool moves relative to the part as programmed.
            let sign = if side == RotaryMount::Table { -1.0 } else { 1.0 };
            for axis in order.into_iter().chain(0..3) {
                if sides.get(axis) == Some(&side) && machine.by_axis[axis].is_none() {
                    last = machine.add(last, axis, LinkJoint::Linear { axis, sign });
                }
            }
            let joints = chain.joints().iter().filter(|joint| joint.side == side);
            let outwards: Vec<_> = match side {
                RotaryMount::Table => joints.rev().collect(),
                RotaryMount::Head => joints.collect(),
            };
            for joint in outwards {
                let axis = 3 + joint.letter.index();
                let sign = if joint.reversed { -sign } else { sign };
                let (point, direction) = (joint.point, joint.direction);
                last = machine.add(last, axis, LinkJoint::Rotary { axis, sign, point, direction });
            }
            match side {
                RotaryMount::Table => machine.part = last,
                RotaryMount::Head => machine.tool = last,
            }
        }
        machine
    }

    fn add(&mut self, parent: usize, axis: usize, joint: LinkJoint) -> usize {
        self.links.push(MachineLink { parent: Some(parent), joint });
        let link = self.links.len() - 1;
        self.by_axis[axis] = Some(link);
        link
    }

    /// The link that stands.
    #[must_use]
    pub fn base(&self) -> usize {
        0
    }

    /// The link that holds the part.
    #[must_use]
    pub fn part(&self) -> usize {
        self.part
    }

    /// The link that holds the tool.
    #[must_use]
    pub fn tool(&self) -> usize {
        self.tool
    }

    /// The link that an axis moves: 0 to 5 for X, Y, Z, A, B, C; `None` if the machine has no such axis.
    #[must_use]
    pub fn of_axis(&self, axis: usize) -> Option<usize> {
        self.by_axis.get(axis).copied().flatten()
    }

    /// Whether one of two links carries the other directly.
    #[must_use]
    pub fn are_neighbours(&self, one: usize, other: usize) -> bool {
        let parent = |link: usize| self.links.get(link).and_then(|link| link.parent);
        parent(one) == Some(other) || parent(other) == Some(one)
    }

    /// The axes that change where two links are relative to each other: 0 to 5 for X, Y, Z, A, B, C.
    #[must_use]
    pub fn axes_between(&self, one: usize, other: usize) -> Vec<usize> {
        let [a, b] = self.sides_between(one, other);
        a.into_iter()
            .chain(b)
            .filter_map(|joint| match joint {
                LinkJoint::Fixed => None,
                LinkJoint::Linear { axis, .. } | LinkJoint::Rotary { axis, .. } => Some(axis),
            })
            .collect()
    }

    /// Where a link is with the axes at these positions (mm and rad): the transform from where it is with all at zero.
    #[must_use]
    pub fn pose(&self, link: usize, axes: &PerAxis<f64>) -> Transform {
        self.outwards(link)
            .iter()
            .rev()
            .fold(Transform::identity(), |pose, joint| pose.then(&joint.motion(axes)))
    }

    /// The motions that take a body on a link from where it is with all axes at zero to where it is relative to another
    /// link, in the order in which they are applied.
    #[must_use]
    pub fn motions_relative_to(&self, reference: usize, link: usize) -> Vec<LinkJoint> {
        let [own, of_reference] = self.sides_between(link, reference);
        own.into_iter().rev().chain(of_reference.into_iter().map(LinkJoint::reversed)).collect()
    }

    /// The joints from the base to a link.
    fn outwards(&self, link: usize) -> Vec<LinkJoint> {
        let mut joints = Vec::new();
        let mut next = self.links.get(link);
        while let Some(link) = next {
            joints.push(link.joint);
            next = link.parent.and_then(|parent| self.links.get(parent));
        }
        joints.reverse();
        joints
    }

    /// The joints from what carries both links to each of them, outwards.
    pub(crate) fn sides_between(&self, one: usize, other: usize) -> [Vec<LinkJoint>; 2] {
        let [a, b] = [self.outwards(one), self.outwards(other)];
        let shared = a.iter().zip(&b).take_while(|(a, b)| a == b).count();
        [a[shared..].to_vec(), b[shared..].to_vec()]
    }
}

/// The transform that joints make of what they carry; the first is the nearest to the base.
pub(crate) fn pose_of(joints: &[LinkJoint], axes: &PerAxis<f64>) -> Transform {
    joints.iter().rev().fold(Transform::identity(), |pose, joint| pose.then(&joint.motion(axes)))
}

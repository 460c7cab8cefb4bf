//! Positions and sets of axes.

use chordal_kinematics::KinematicChain;
use chordal_machine::{Axis, PerAxis};

/// A value for each axis X Y Z A B C, in mm and rad.
pub type Position = PerAxis<f64>;

/// A set of axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub struct AxisMask(pub u8);

impl AxisMask {
    /// No axis.
    pub const NONE: AxisMask = AxisMask(0);
    /// All six.
    pub const ALL: AxisMask = AxisMask(0b11_1111);
    /// X, Y and Z.
    pub const LINEAR: AxisMask = AxisMask(0b111);
    /// X and Y.
    pub const XY: AxisMask = AxisMask(0b11);
    /// A, B and C.
    pub const ROTARY: AxisMask = AxisMask(0b11_1000);

    /// The axes that have a value.
    pub fn with_values<T>(values: &PerAxis<Option<T>>) -> AxisMask {
        let mut axes = AxisMask::NONE;
        for (axis, value) in values.iter().enumerate() {
            if value.is_some() {
                axes.insert(axis);
            }
        }
        axes
    }

    /// The rotary axes of a chain.
    pub fn of_chain(chain: &KinematicChain) -> AxisMask {
        let mut axes = AxisMask::NONE;
        chain.joints().iter().for_each(|joint| axes.insert(joint.letter.index() + 3));
        axes
    }

    /// Whether the axis is in the set.
    #[inline]
    pub const fn has(self, axis: usize) -> bool {
        self.0 & (1 << axis) != 0
    }

    /// Adds an axis.
    #[inline]
    pub const fn insert(&mut self, axis: usize) {
        self.0 |= 1 << axis;
    }

    /// Removes an axis.
    #[inline]
    pub const fn remove(&mut self, axis: usize) {
        self.0 &= !(1 << axis);
    }

    /// The axes that are in both sets.
    #[inline]
    pub const fn and(self, other: AxisMask) -> AxisMask {
        AxisMask(self.0 & other.0)
    }

    /// The axes that are in at least one of the sets.
    #[inline]
    pub const fn or(self, other: AxisMask) -> AxisMask {
        AxisMask(self.0 | other.0)
    }

    /// The axes of this set that are not in the other.
    #[inline]
    pub const fn without(self, other: AxisMask) -> AxisMask {
        AxisMask(self.0 & !other.0)
    }

    /// Whether every axis of `other` is in this set.
    #[inline]
    pub const fn covers(self, other: AxisMask) -> bool {
        other.0 & !self.0 == 0
    }

    /// The axes of the set, X first.
    pub fn iter(self) -> impl Iterator<Item = Axis> {
        Axis::ALL.into_iter().filter(move |axis| self.has(*axis as usize))
    }
}

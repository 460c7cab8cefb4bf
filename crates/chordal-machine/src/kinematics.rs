//! The rotary axes of a machine as a kinematic chain.

use chordal_geometry::Vec3;
use chordal_kinematics::{ChainError, KinematicChain, RotaryJoint, RotaryLetter, RotaryMount};

use crate::axis::Axis;
use crate::machine::{Machine, RotaryTarget};
use crate::rotary::{CarrierError, part_to_tool};

/// The rotary axes by their index in [`Machine::rotary`].
const LETTERS: [(Axis, RotaryLetter); 3] =
    [(Axis::A, RotaryLetter::A), (Axis::B, RotaryLetter::B), (Axis::C, RotaryLetter::C)];

/// Why the kinematics of a machine are not known.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum KinematicsError {
    /// The machine has a rotary axis, and its file does not say what it turns.
    #[error("`rotary.{axis}.turns` is not given")]
    NoTarget {
        /// The rotary axis.
        axis: Axis,
    },
    /// A coordinate of the point on a rotary axis is not given.
    #[error("`rotary.{axis}.point.{along}` is not given")]
    NoPoint {
        /// The rotary axis.
        axis: Axis,
        /// The linear axis of the coordinate.
        along: Axis,
    },
    /// The axis that should carry another one turns nothing, or turns the tool where the other one turns the part.
    #[error("`rotary.{axis}.on`: {carrier} carries no {} of this machine", .target.as_str())]
    NoCarrier {
        /// The carried axis.
        axis: Axis,
        /// The one that should carry it.
        carrier: Axis,
        /// What the carried axis turns.
        target: RotaryTarget,
    },
    /// Rotary axes carry each other.
    #[error("`rotary.{axis}.on` goes in a circle")]
    CarrierCircle {
        /// One of them.
        axis: Axis,
    },
    /// The axes are no chain.
    #[error(transparent)]
    Chain(#[from] ChainError),
}

impl KinematicsError {
    /// The path of the key in a machine file that is missing or wrong; `None` if it is no single one.
    pub fn key(&self) -> Option<String> {
        match self {
            KinematicsError::NoTarget { axis } => Some(format!("rotary.{axis}.turns")),
            KinematicsError::NoPoint { axis, along } => {
                Some(format!("rotary.{axis}.point.{along}"))
            }
            KinematicsError::NoCarrier { axis, .. } | KinematicsError::CarrierCircle { axis } => {
                Some(format!("rotary.{axis}.on"))
            }
            KinematicsError::Chain(_) => None,
        }
    }
}

impl Machine {
    /// The rotary axes that the machine has, as a chain from the part to the tool, with their travel. Without rotary axes
    /// it is [`KinematicChain::CARTESIAN`].
    ///
    /// # Errors
    /// What the machine file does not give, or gives wrong: see [`KinematicsError`].
    pub fn kinematic_chain(&self) -> Result<KinematicChain, KinematicsError> {
        // What is left in the table of an axis that the machine does not have, or has no more, counts for nothing.
        let mut rotary = self.rotary;
        for (own, (axis, _)) in rotary.iter_mut().zip(LETTERS) {
            if self.axis(axis).is_none() {
                own.turns = None;
            } else if own.turns.is_none() {
                return Err(KinematicsError::NoTarget { axis });
            }
        }
        let mut joints = Vec::new();
        for target in [RotaryTarget::Table, RotaryTarget::Head] {
            let order = part_to_tool(&rotary, target).map_err(|error| refused(error, target))?;
            for index in order {
                joints.push(self.rotary_joint(index, target)?);
            }
        }
        Ok(KinematicChain::new(&joints)?)
    }

    fn rotary_joint(
        &self,
        index: usize,
        target: RotaryTarget,
    ) -> Result<RotaryJoint, KinematicsError> {
        let (own, (axis, letter)) = (&self.rotary[index], LETTERS[index]);
        let direction = own.direction.map_or(letter.direction(), Vec3::from_array);
        let mut point = [0.0; 3];
        for (place, along) in [Axis::X, Axis::Y, Axis::Z].into_iter().enumerate() {
            let mut others = direction.to_array();
            others[place] = 0.0;
            // Along its own direction an axis may be met anywhere.
            let is_needed = others != [0.0; 3];
            point[place] = match own.point_mm[place] {
                Some(mm) => mm,
                None if is_needed => return Err(KinematicsError::NoPoint { axis, along }),
                None => 0.0,
            };
        }
        Ok(RotaryJoint {
            letter,
            side: match target {
                RotaryTarget::Table => RotaryMount::Table,
                RotaryTarget::Head => RotaryMount::Head,
            },
            direction,
            point: Vec3::from_array(point),
            reversed: own.reversed,
            travel: self.axis(axis).and_then(|limits| limits.travel),
            rollover: own.rollover.unwrap_or_default(),
        })
    }
}

fn refused(error: CarrierError, target: RotaryTarget) -> KinematicsError {
    match error {
        CarrierError::NotOfChain { axis, carrier } => {
            KinematicsError::NoCarrier { axis: LETTERS[axis].0, carrier, target }
        }
        CarrierError::InCircle { axis } => KinematicsError::CarrierCircle { axis: LETTERS[axis].0 },
    }
}

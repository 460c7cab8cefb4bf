//! Velocity, acceleration and jerk of the axes.

use chordal_geometry::{AXIS_LETTERS, PerAxis};

use crate::AxisValues;

/// The limits of one axis, each a positive finite number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisLimit {
    /// mm/s or rad/s.
    pub velocity: f64,
    /// mm/s² or rad/s².
    pub acceleration: f64,
    /// mm/s³ or rad/s³.
    pub jerk: f64,
}

/// What the axes of a machine can do, by X Y Z A B C; `None`: there is no such axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KinematicLimits {
    axes: PerAxis<Option<AxisLimit>>,
}

/// The quantity that a limit of an axis concerns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitedQuantity {
    /// mm/s or rad/s.
    Velocity,
    /// mm/s² or rad/s².
    Acceleration,
    /// mm/s³ or rad/s³.
    Jerk,
}

impl std::fmt::Display for LimitedQuantity {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            LimitedQuantity::Velocity => "velocity",
            LimitedQuantity::Acceleration => "acceleration",
            LimitedQuantity::Jerk => "jerk",
        })
    }
}

/// A limit that is not a positive finite number.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the {quantity} limit of axis {} is {value}: it must be a positive number", letter(*.axis))]
pub struct LimitError {
    /// The index of the axis, from X = 0 to C = 5.
    pub axis: usize,
    /// The quantity whose limit is wrong.
    pub quantity: LimitedQuantity,
    /// The wrong value, in mm or rad and s.
    pub value: f64,
}

/// The letter of an axis.
pub(crate) fn letter(axis: usize) -> char {
    AXIS_LETTERS.chars().nth(axis).unwrap_or('?')
}

impl KinematicLimits {
    /// The limits of the axes that a machine has.
    ///
    /// # Errors
    /// The first limit that is not a positive finite number.
    pub fn new(axes: PerAxis<Option<AxisLimit>>) -> Result<KinematicLimits, LimitError> {
        for (axis, limit) in axes.iter().enumerate() {
            let Some(limit) = limit else { continue };
            for (quantity, value) in [
                (LimitedQuantity::Velocity, limit.velocity),
                (LimitedQuantity::Acceleration, limit.acceleration),
                (LimitedQuantity::Jerk, limit.jerk),
            ] {
                if !(value > 0.0 && value.is_finite()) {
                    return Err(LimitError { axis, quantity, value });
                }
            }
        }
        Ok(KinematicLimits { axes })
    }

    /// The limits of an axis; `None`: there is no such axis.
    pub fn axis(&self, axis: usize) -> Option<&AxisLimit> {
        self.axes.get(axis).and_then(Option::as_ref)
    }

    /// The largest speed of each axis; infinite for an axis that the machine does not have and that must not move.
    pub fn velocity(&self) -> AxisValues {
        self.axes.map(|axis| axis.map_or(f64::INFINITY, |limit| limit.velocity))
    }

    /// The largest acceleration of each axis; infinite for an axis that the machine does not have.
    pub fn acceleration(&self) -> AxisValues {
        self.axes.map(|axis| axis.map_or(f64::INFINITY, |limit| limit.acceleration))
    }

    /// The largest jerk of each axis; infinite for an axis that the machine does not have.
    pub fn jerk(&self) -> AxisValues {
        self.axes.map(|axis| axis.map_or(f64::INFINITY, |limit| limit.jerk))
    }

    /// The same limits with the jerks multiplied by `share`, which must be positive.
    pub(crate) fn with_jerk(&self, share: f64) -> KinematicLimits {
        let axes = self.axes.map(|axis| axis.map(|l| AxisLimit { jerk: l.jerk * share, ..l }));
        KinematicLimits { axes }
    }
}

//! Numbers that no drawing has, and what is said of them.

use crate::numbers::AnswerUnit;

/// Numbers that contradict each other.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct CalcError {
    /// What cannot be, with the numbers.
    pub message: String,
    /// What to do about it.
    pub help: String,
}

impl CalcError {
    /// An error from its two texts.
    pub fn new(message: impl Into<String>, help: impl Into<String>) -> CalcError {
        CalcError { message: message.into(), help: help.into() }
    }
}

/// Lengths that a shop measures, mm: a picometre to ten kilometres.
const LENGTHS: std::ops::RangeInclusive<f64> = 1e-9..=1e7;
/// The largest angle, rad; beyond it nothing is left of the digits.
const MAX_ANGLE: f64 = 1e4;

/// Refuses lengths, mm, and angles, rad, that no drawing has: what is computed from the others is
/// then finite.
pub(crate) fn bounded(lengths: &[f64], angles: &[f64], units: AnswerUnit) -> Result<(), CalcError> {
    for length in lengths {
        if *length != 0.0 && !LENGTHS.contains(&length.abs()) {
            let size = length / units.mm();
            return Err(CalcError::new(
                format!("{size:e} {} is not a length of a drawing", units.name()),
                "check the number and its unit",
            ));
        }
    }
    match angles.iter().find(|angle| angle.is_nan() || angle.abs() > MAX_ANGLE) {
        Some(angle) => Err(CalcError::new(
            format!("{:e}° is not an angle of a drawing", angle.to_degrees()),
            "check the number and its unit",
        )),
        None => Ok(()),
    }
}

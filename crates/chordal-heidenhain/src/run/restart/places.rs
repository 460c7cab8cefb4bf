//! Coordinates of a head.

use super::values::parameter_number;
use crate::syntax::AXIS_WORDS;

/// Digits after the point of lengths that a control keeps, in mm and in inches.
pub(super) const LENGTH_DIGITS: [usize; 2] = [5, 6];

/// Digits after the point of angles and factors.
pub(super) const ANGLE_DIGITS: usize = 6;

/// What stands in the way of a head.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct HeadFault(pub String);

/// Writes coordinates; those with more decimals than a block takes through parameters.
pub(super) struct PlaceWriter {
    /// The blocks that set them.
    pub lines: Vec<String>,
    free: std::vec::IntoIter<u32>,
}

impl PlaceWriter {
    /// Writes through these parameters.
    pub fn new(free: Vec<u32>) -> PlaceWriter {
        PlaceWriter { lines: Vec::new(), free: free.into_iter() }
    }

    /// The word of an axis; a value that `literal` does not write stands in a parameter.
    pub fn word(
        &mut self,
        axis: usize,
        literal: Option<String>,
        value: f64,
    ) -> Result<String, HeadFault> {
        let letter = AXIS_WORDS[axis];
        if let Some(number) = literal {
            return Ok(format!("{letter}{number}"));
        }
        let number = self.free.next().ok_or_else(|| {
            HeadFault(format!("the position in {letter} has more decimals than a block takes"))
        })?;
        self.lines.push(format!("FN 0: Q{number} = {}", parameter_number(value)));
        Ok(format!("{letter}+Q{number}"))
    }
}

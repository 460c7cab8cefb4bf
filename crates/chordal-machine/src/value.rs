//! The settings of the control as written; their meaning depends on the control.

use crate::error::ValueLocation;
use crate::quantity::{QuantityDimension, QuantityError, machine_quantity};

/// The value of a setting as written.
#[derive(Clone, Debug, PartialEq)]
pub enum SettingValue {
    /// A text, often a word or a quantity.
    Text(String),
    /// A whole number.
    Integer(i64),
    /// A number with a fraction; finite.
    Float(f64),
    /// `true` or `false`.
    Bool(bool),
}

impl SettingValue {
    /// The value as a length in millimetres; it must be a text with a unit of length.
    pub fn as_length_mm(&self) -> Result<f64, QuantityError> {
        self.as_quantity(QuantityDimension::Length)
    }

    /// The value as a quantity, in the unit of that dimension ([`QuantityDimension::inside`]).
    pub fn as_quantity(&self, dimension: QuantityDimension) -> Result<f64, QuantityError> {
        let bare = match self {
            SettingValue::Text(text) => return machine_quantity(text, dimension),
            SettingValue::Integer(number) => number.to_string(),
            SettingValue::Float(number) => number.to_string(),
            SettingValue::Bool(flag) => {
                return Err(QuantityError::NotANumber { text: flag.to_string(), dimension });
            }
        };
        Err(QuantityError::NoUnit { text: bare, dimension })
    }
}

/// A setting of the control.
#[derive(Clone, Debug)]
pub struct SettingEntry {
    /// Its value as written.
    pub value: SettingValue,
    /// Its position in the file.
    pub location: Option<ValueLocation>,
}

impl PartialEq for SettingEntry {
    /// The position does not matter for equality.
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

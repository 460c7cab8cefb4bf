//! A value and its conversions (Job Planning 07/2010, 1.8).

use std::sync::Arc;

use crate::alarms::NO_ALARM;
use crate::syntax::VariableType;

/// The alarm of an operation between types that do not go together.
pub(super) const WRONG_TYPE_ALARM: u32 = 12150;

/// The alarm of an illegal type conversion: the types do not convert, or the value is out of the range of the type.
pub(super) const CONVERSION_ALARM: u32 = 14096;

/// The alarm of an arithmetic error.
pub(super) const ARITHMETIC_ALARM: u32 = 14051;

/// The value of a variable or an expression.
#[derive(Clone, PartialEq, Debug)]
pub enum SinumerikValue {
    /// INT.
    Integer(i32),
    /// REAL; always finite.
    Real(f64),
    /// BOOL.
    Boolean(bool),
    /// CHAR: a code of 0 to 255.
    Character(u8),
    /// STRING.
    Text(Arc<str>),
    /// AXIS: the name of an axis in upper case.
    Axis(String),
    /// A value that nobody gave, of any type, with the name of what it depends on: `$AA_IM[X]`.
    Unknown(Arc<str>),
}

/// Why a value cannot be computed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ValueFault {
    /// The number of the alarm.
    pub alarm: u32,
    /// What is wrong, as a sentence without a full stop.
    pub message: String,
}

impl ValueFault {
    /// An arithmetic error.
    pub(super) fn arithmetic(message: impl Into<String>) -> ValueFault {
        ValueFault { alarm: ARITHMETIC_ALARM, message: message.into() }
    }

    /// No fault of the program: the value depends on something that nobody gave.
    fn unknown(cause: &str) -> ValueFault {
        ValueFault {
            alarm: NO_ALARM,
            message: format!("this depends on {cause}, which is not known"),
        }
    }

    fn conversion(value: &SinumerikValue, kind: &str) -> ValueFault {
        let message = format!("{} cannot be converted to {kind}", value.description());
        ValueFault { alarm: CONVERSION_ALARM, message }
    }
}

impl SinumerikValue {
    /// What the value depends on if it is not known; `None` for known values.
    pub fn unknown_cause(&self) -> Option<&Arc<str>> {
        match self {
            SinumerikValue::Unknown(cause) => Some(cause),
            _ => None,
        }
    }

    /// A text.
    pub fn text(text: &str) -> SinumerikValue {
        SinumerikValue::Text(Arc::from(text))
    }

    /// A finite number as a REAL; an arithmetic error for any other.
    pub(super) fn finite(value: f64) -> Result<SinumerikValue, ValueFault> {
        if value.is_finite() {
            Ok(SinumerikValue::Real(value))
        } else {
            Err(ValueFault::arithmetic("the result is out of the range of REAL"))
        }
    }

    /// A whole number: an INT in its range, else a REAL.
    pub(super) fn whole(value: f64) -> SinumerikValue {
        match exact_integer(value) {
            Some(whole) => SinumerikValue::Integer(whole),
            None => SinumerikValue::Real(value),
        }
    }

    /// The value a variable of this type has before anything is assigned; `None` for FRAME.
    pub fn initial(kind: VariableType) -> Option<SinumerikValue> {
        Some(match kind {
            VariableType::Integer => SinumerikValue::Integer(0),
            VariableType::Real => SinumerikValue::Real(0.0),
            VariableType::Boolean => SinumerikValue::Boolean(false),
            VariableType::Character => SinumerikValue::Character(0),
            VariableType::Text(_) => SinumerikValue::text(""),
            VariableType::Axis => SinumerikValue::Axis(String::new()),
            VariableType::Frame => return None,
        })
    }

    /// The value as it is assigned to a variable of this type. Errors when the types do not convert or the value is out
    /// of range.
    pub fn converted(self, kind: VariableType) -> Result<SinumerikValue, ValueFault> {
        if matches!(self, SinumerikValue::Unknown(_)) {
            return Ok(self);
        }
        Ok(match kind {
            VariableType::Integer => SinumerikValue::Integer(self.to_integer()?),
            VariableType::Real => SinumerikValue::Real(self.to_real()?),
            VariableType::Boolean => SinumerikValue::Boolean(self.to_boolean()?),
            VariableType::Character => SinumerikValue::Character(self.to_character()?),
            VariableType::Text(length) => self.assigned_text(length)?,
            VariableType::Axis => match self {
                SinumerikValue::Axis(_) => self,
                _ => return Err(ValueFault::conversion(&self, "AXIS")),
            },
            VariableType::Frame => return Err(ValueFault::conversion(&self, "FRAME")),
        })
    }

    /// Numbers do not become texts by an assignment, only by `<<`.
    fn assigned_text(self, length: u32) -> Result<SinumerikValue, ValueFault> {
        let text = match self {
            SinumerikValue::Text(text) => text,
            SinumerikValue::Character(_) | SinumerikValue::Boolean(_) => self.to_text()?,
            _ => return Err(ValueFault::conversion(&self, "STRING")),
        };
        if text.chars().count() > length as usize {
            let message = format!("the text is longer than the {length} characters of its STRING");
            return Err(ValueFault { alarm: CONVERSION_ALARM, message });
        }
        Ok(SinumerikValue::Text(text))
    }

    /// The value as a number; the code of a character. Errors for texts and axes.
    pub fn to_real(&self) -> Result<f64, ValueFault> {
        match self {
            SinumerikValue::Integer(value) => Ok(f64::from(*value)),
            SinumerikValue::Real(value) => Ok(*value),
            SinumerikValue::Boolean(value) => Ok(f64::from(u8::from(*value))),
            SinumerikValue::Character(code) => Ok(f64::from(*code)),
            SinumerikValue::Unknown(cause) => Err(ValueFault::unknown(cause)),
            SinumerikValue::Text(_) | SinumerikValue::Axis(_) => {
                Err(ValueFault::conversion(self, "REAL"))
            }
        }
    }

    /// The value rounded to a whole number, halves away from zero. Errors for texts and axes, and out of the range of
    /// INT.
    pub fn to_integer(&self) -> Result<i32, ValueFault> {
        if let SinumerikValue::Integer(value) = self {
            return Ok(*value);
        }
        if let SinumerikValue::Unknown(cause) = self {
            return Err(ValueFault::unknown(cause));
        }
        let value = self.to_real().map_err(|_| ValueFault::conversion(self, "INT"))?;
        exact_integer(value.round()).ok_or_else(|| ValueFault::conversion(self, "INT"))
    }

    /// True for a number other than 0 and for a text with characters. Errors for an axis.
    pub fn to_boolean(&self) -> Result<bool, ValueFault> {
        match self {
            SinumerikValue::Boolean(value) => Ok(*value),
            SinumerikValue::Text(text) => Ok(!text.is_empty()),
            SinumerikValue::Axis(_) => Err(ValueFault::conversion(self, "BOOL")),
            _ => self.to_real().map(|value| value != 0.0),
        }
    }

    /// The character of a text of one character, or of the code 0 to 255. Errors for anything else.
    pub fn to_character(&self) -> Result<u8, ValueFault> {
        let code = match self {
            SinumerikValue::Text(text) => single_character(text),
            _ => self.to_integer().ok().and_then(|value| u8::try_from(value).ok()),
        };
        code.ok_or_else(|| ValueFault::conversion(self, "CHAR"))
    }

    /// The value as `<<` joins it: numbers in their shortest form, BOOL as 1 or 0 (the manual gives no form). Errors for
    /// an axis, which needs AXSTRING.
    pub fn to_text(&self) -> Result<Arc<str>, ValueFault> {
        match self {
            SinumerikValue::Text(text) => Ok(Arc::clone(text)),
            SinumerikValue::Integer(value) => Ok(Arc::from(value.to_string())),
            SinumerikValue::Real(value) => Ok(Arc::from(number_text(*value))),
            SinumerikValue::Boolean(value) => Ok(Arc::from(if *value { "1" } else { "0" })),
            SinumerikValue::Character(0) => Ok(Arc::from("")),
            SinumerikValue::Character(code) => Ok(Arc::from(char::from(*code).to_string())),
            SinumerikValue::Unknown(cause) => Err(ValueFault::unknown(cause)),
            SinumerikValue::Axis(_) => Err(ValueFault::conversion(self, "STRING")),
        }
    }

    /// The type and the value for a message.
    pub(super) fn description(&self) -> String {
        match self {
            SinumerikValue::Integer(value) => format!("the INT {value}"),
            SinumerikValue::Real(value) => format!("the REAL {}", number_text(*value)),
            SinumerikValue::Boolean(value) => {
                format!("the BOOL {}", if *value { "TRUE" } else { "FALSE" })
            }
            SinumerikValue::Character(code) => format!("the CHAR {code}"),
            SinumerikValue::Text(text) => format!("the STRING \"{text}\""),
            SinumerikValue::Axis(name) => format!("the AXIS {name}"),
            SinumerikValue::Unknown(cause) => format!("{cause}, which is not known"),
        }
    }
}

/// A number in its shortest form, without a decimal point when it is whole.
pub fn number_text(value: f64) -> String {
    // Adding zero makes a negative zero positive.
    format!("{}", value + 0.0)
}

/// The INT of a whole number; `None` out of its range.
fn exact_integer(value: f64) -> Option<i32> {
    let is_whole = value.fract() == 0.0;
    let is_in_range = value >= f64::from(i32::MIN) && value <= f64::from(i32::MAX);
    (is_whole && is_in_range).then_some(value as i32)
}

/// The code of the only character of a text; `None` for other lengths.
pub(super) fn single_character(text: &str) -> Option<u8> {
    let mut characters = text.chars();
    let first = characters.next()?;
    characters.next().is_none().then(|| u8::try_from(u32::from(first)).ok())?
}

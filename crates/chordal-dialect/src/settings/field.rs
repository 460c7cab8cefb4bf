//! The parameters that settings change, and how a machine file's values become parameters and back.

use chordal_machine::SettingValue;

use crate::parameters::Parameters;

/// The parameter that a setting changes: one of the constants below, which are named after fields of [`Parameters`]
/// and its rules.
#[derive(Clone, Copy)]
pub struct SettingField {
    /// The name of its constant; fields are equal if name and index are.
    pub(super) name: &'static str,
    /// The index among similar parameters, such as the axis; 0 where there is one.
    pub(super) index: u8,
    pub(super) set: fn(&mut Parameters, &SettingInput<'_>) -> Result<(), String>,
    pub(super) text: fn(&Parameters, u8) -> String,
}

impl SettingField {
    /// The same field with another index, such as that of another axis.
    pub(super) const fn at(self, index: u8) -> SettingField {
        SettingField { index, ..self }
    }

    /// The value of the parameter, as a machine file writes it.
    pub fn value_text(self, parameters: &Parameters) -> String {
        (self.text)(parameters, self.index)
    }
}

impl PartialEq for SettingField {
    fn eq(&self, other: &SettingField) -> bool {
        (self.name, self.index) == (other.name, other.index)
    }
}

impl Eq for SettingField {}

impl std::fmt::Debug for SettingField {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}({})", self.name, self.index)
    }
}

/// The value of a setting in a machine file.
pub(super) struct SettingInput<'v> {
    /// The value as text; the common word where the setting has words of its own.
    pub word: &'v str,
    pub value: &'v SettingValue,
    /// [`SettingField::index`].
    pub index: u8,
}

impl SettingInput<'_> {
    /// A length, mm. The error shows `example`.
    pub fn length(&self, example: &str) -> Result<f64, String> {
        let length = self.value.as_length_mm();
        length.map_err(|_| format!("a length with its unit, such as \"{example}\""))
    }

    /// A whole number in a range; the error is `takes`, which describes the range.
    pub fn whole(&self, range: std::ops::RangeInclusive<u32>, takes: &str) -> Result<u32, String> {
        let number = match self.value {
            SettingValue::Integer(number) => u32::try_from(*number).ok(),
            _ => None,
        };
        number.filter(|number| range.contains(number)).ok_or_else(|| takes.to_string())
    }

    /// A whole number in a range that the error names.
    pub fn between(&self, min: u32, max: u32) -> Result<u32, String> {
        self.whole(min..=max, &format!("a whole number from {min} to {max}"))
    }

    /// A count up to 100,000, beyond any that a control has.
    pub fn count(&self) -> Result<u32, String> {
        self.whole(0..=100_000, "a whole number")
    }

    /// A number; NaN for other values, so that no range accepts it.
    pub fn number(&self) -> f64 {
        match self.value {
            SettingValue::Integer(number) => *number as f64,
            SettingValue::Float(number) => *number,
            SettingValue::Text(_) | SettingValue::Bool(_) => f64::NAN,
        }
    }

    /// `on` or `off`.
    pub fn flag(&self) -> Result<bool, String> {
        match self.word {
            "on" | "1" | "true" => Ok(true),
            "off" | "0" | "false" => Ok(false),
            _ => Err("`on` or `off`".to_string()),
        }
    }
}

/// The text of a switch.
pub(super) fn switch_text(on: bool) -> String {
    if on { "on" } else { "off" }.to_string()
}

/// Declares setting fields, one on each line; `place` is the path of the parameter in [`Parameters`]:
///
/// - `choice(place, choices)`: one of several words,
/// - `length(place, example)`: a length, mm; the reader of machine files decides whether it may be negative,
/// - `flag(place)`: `on` or `off`,
/// - `custom(set, text)`: two functions, `(&mut Parameters, &SettingInput) -> Result<(), String>` and
///   `(&Parameters, index) -> String`.
macro_rules! setting_fields {
    ($($(#[$doc:meta])* $name:ident = $kind:ident($($args:tt)*);)*) => {
        #[allow(missing_docs, reason = "each names a field of `Parameters` or of its rules")]
        impl $crate::settings::SettingField {
            $($(#[$doc])* pub const $name: $crate::settings::SettingField = $crate::settings::SettingField {
                name: stringify!($name),
                index: 0,
                set: setting_fields!(@set $kind $($args)*),
                text: setting_fields!(@text $kind $($args)*),
            };)*
        }
    };
    (@set choice $($place:ident).+, $choices:expr) => {
        |p, input| {
            p.$($place).+ = choose(input.word, $choices)?;
            Ok(())
        }
    };
    (@text choice $($place:ident).+, $choices:expr) => { |p, _| name_of(p.$($place).+, $choices) };
    (@set length $($place:ident).+, $example:expr) => {
        |p, input| {
            p.$($place).+ = input.length($example)?;
            Ok(())
        }
    };
    (@text length $($place:ident).+, $example:expr) => { |p, _| mm_text(p.$($place).+) };
    (@set flag $($place:ident).+) => {
        |p, input| {
            p.$($place).+ = input.flag()?;
            Ok(())
        }
    };
    (@text flag $($place:ident).+) => { |p, _| $crate::settings::field::switch_text(p.$($place).+) };
    (@set custom $set:expr, $text:expr) => { $set };
    (@text custom $set:expr, $text:expr) => { $text };
}
pub(super) use setting_fields;

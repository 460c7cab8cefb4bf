//! What writers of programs share: numbers as text, and what becomes of commands that no language has words for.

use chordal_command::{Coolant, Effect, Units};

/// Digits after the point of lengths, in millimetres and inches, where the caller asks for none.
const LENGTH_DIGITS: [usize; 2] = [5, 6];

/// Digits after the point of times, s.
const TIME_DIGITS: usize = 6;

/// Significant digits of feeds and speeds.
const SIGNIFICANT_DIGITS: f64 = 9.0;

/// A number without useless zeros and without a point where it is whole.
pub fn plain_number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if text == "-0" { "0".into() } else { text.into() }
}

/// A feed or a speed, with so many digits that it is the same again for every purpose; at most `max_digits` after the point.
pub fn significant_number(value: f64, max_digits: usize) -> String {
    let before_point = value.abs().max(1e-9).log10().floor() + 1.0;
    let digits = (SIGNIFICANT_DIGITS - before_point).clamp(0.0, max_digits as f64);
    plain_number(value, digits as usize)
}

/// A time, s.
pub fn time_number(seconds: f64) -> String {
    plain_number(seconds, TIME_DIGITS)
}

/// How lengths are written.
#[derive(Clone, Copy, Debug)]
pub struct WrittenLengths {
    /// The units of the program.
    pub units: Units,
    /// Digits after the point; `None` for the usual ones.
    pub digits: Option<usize>,
}

impl WrittenLengths {
    /// A length in program units.
    pub fn text(self, mm: f64) -> String {
        plain_number(mm / self.units.mm(), self.digits())
    }

    /// The value in program units that is read from [`WrittenLengths::text`].
    pub fn value(self, mm: f64) -> f64 {
        let scale = 10f64.powi(self.digits() as i32);
        (mm / self.units.mm() * scale).round() / scale
    }

    /// The same in mm.
    pub fn rounded(self, mm: f64) -> f64 {
        self.value(mm) * self.units.mm()
    }

    /// Digits after the point.
    pub fn digits(self) -> usize {
        let usual = match self.units {
            Units::Millimetre => LENGTH_DIGITS[0],
            Units::Inch => LENGTH_DIGITS[1],
        };
        self.digits.unwrap_or(usual)
    }
}

/// What an effect is in a language that has no words for it: a note, or nothing.
///
/// # Errors
/// Why the program cannot be written without it.
pub fn written_effect(effect: &Effect) -> Result<Option<String>, String> {
    match effect {
        Effect::Code(words) => {
            Ok(Some(format!("{words} is left out: its code is the builder's here")))
        }
        // Variables of the old control have no place on another one.
        Effect::Variable { .. } => Ok(None),
        Effect::Written { name, .. } => {
            Err(format!("a value that the control keeps is written ({name})"))
        }
        Effect::Alarm { .. } => Err("the program stops itself with an alarm".into()),
        Effect::Deletable { .. } => Err("a block that block delete may leave out".into()),
    }
}

/// Which codes of coolant bring one state from another, where one code closes all valves (M9).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CoolantChange {
    /// All valves close first.
    pub closes: bool,
    /// Mist opens.
    pub opens_mist: bool,
    /// Flood opens.
    pub opens_flood: bool,
}

impl CoolantChange {
    /// The change from one state to another; that of the coolant through the tool is left to the caller.
    pub fn between(before: Coolant, after: Coolant) -> CoolantChange {
        let closes = before.mist && !after.mist || before.flood && !after.flood;
        CoolantChange {
            closes,
            opens_mist: after.mist && (closes || !before.mist),
            opens_flood: after.flood && (closes || !before.flood),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_no_useless_digits() {
        assert_eq!(plain_number(10.0, 5), "10");
        assert_eq!(plain_number(-0.000_001, 5), "0");
        assert_eq!(plain_number(-0.5, 5), "-0.5");
        assert_eq!(plain_number(1000.0, 0), "1000");
        assert_eq!(significant_number(1200.0, 12), "1200");
        assert_eq!(significant_number(0.2, 12), "0.2");
        let inch = WrittenLengths { units: Units::Inch, digits: None };
        assert_eq!(inch.text(12.7), "0.5");
    }

    #[test]
    fn one_valve_that_closes_opens_the_other_again() {
        let [mist, flood] =
            [true, false].map(|mist| Coolant { mist, flood: !mist, ..Coolant::default() });
        let both = Coolant { flood: true, ..mist };
        let change = CoolantChange::between(both, flood);
        assert_eq!((change.closes, change.opens_mist, change.opens_flood), (true, false, true));
        let change = CoolantChange::between(mist, both);
        assert_eq!((change.closes, change.opens_mist, change.opens_flood), (false, false, true));
    }
}

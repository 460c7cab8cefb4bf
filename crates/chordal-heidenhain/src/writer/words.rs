//! Numbers as conversational programs have them: coordinates with their sign.

use chordal_command::Units;

/// Digits after the point of lengths, in millimetres and inches, where the caller asks for none.
const LENGTH_DIGITS: [usize; 2] = [5, 6];

/// Digits after the point of angles, degrees.
const ANGLE_DIGITS: usize = 6;

/// Digits after the point of times, s.
const TIME_DIGITS: usize = 6;

/// Significant digits of feeds and speeds, and the most after the point.
const SIGNIFICANT_DIGITS: f64 = 9.0;
const MAX_FEED_DIGITS: f64 = 7.0;

/// A number without useless zeros and without a point where it is whole.
pub(super) fn plain(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if text == "-0" { "0".into() } else { text.into() }
}

/// A number with its sign.
pub(super) fn signed(value: f64, digits: usize) -> String {
    let text = plain(value, digits);
    if text.starts_with('-') { text } else { format!("+{text}") }
}

/// A feed or a speed, with so many digits that it is the same again for every purpose.
pub(super) fn significant(value: f64) -> String {
    let before_point = value.abs().max(1e-9).log10().floor() + 1.0;
    plain(value, (SIGNIFICANT_DIGITS - before_point).clamp(0.0, MAX_FEED_DIGITS) as usize)
}

/// A time, s.
pub(super) fn seconds(value: f64) -> String {
    plain(value, TIME_DIGITS)
}

/// An angle, rad, as degrees.
pub(super) fn degrees(angle: f64) -> String {
    signed(angle.to_degrees(), ANGLE_DIGITS)
}

/// How lengths are written.
#[derive(Clone, Copy, Debug)]
pub(super) struct KlartextLengths {
    pub units: Units,
    /// Digits after the point; `None` for the usual ones.
    pub digits: Option<usize>,
}

impl KlartextLengths {
    /// A length in program units, with its sign.
    pub fn text(self, mm: f64) -> String {
        signed(mm / self.units.mm(), self.digits())
    }

    /// The value in program units that is read from [`KlartextLengths::text`].
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

    /// The unit of F, mm/s: mm/min, or tenths of an inch per minute.
    pub fn feed_unit(self) -> f64 {
        match self.units {
            Units::Millimetre => 1.0 / 60.0,
            Units::Inch => 2.54 / 60.0,
        }
    }

    /// The unit after the name of the program.
    pub fn name(self) -> &'static str {
        match self.units {
            Units::Millimetre => "MM",
            Units::Inch => "INCH",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_their_sign_and_no_useless_digits() {
        assert_eq!(signed(10.0, 5), "+10");
        assert_eq!(signed(-0.000_001, 5), "+0");
        assert_eq!(signed(-0.5, 5), "-0.5");
        assert_eq!(significant(1200.0), "1200");
        let inch = KlartextLengths { units: Units::Inch, digits: None };
        assert_eq!(inch.text(12.7), "+0.5");
        assert_eq!(inch.feed_unit() * 60.0, 2.54);
    }
}

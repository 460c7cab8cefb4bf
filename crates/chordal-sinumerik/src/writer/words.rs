//! Numbers and words as part programs have them.

use chordal_command::Units;

/// Digits after the point of lengths, in millimetres and inches, where the caller asks for none.
const LENGTH_DIGITS: [usize; 2] = [5, 6];

/// Digits after the point of angles, degrees.
const ANGLE_DIGITS: usize = 6;

/// Significant digits of feeds and speeds.
const SIGNIFICANT_DIGITS: f64 = 9.0;

/// Digits after the point of times, s.
const TIME_DIGITS: usize = 6;

/// A number without useless zeros and without a point where it is whole.
pub(super) fn plain(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if text == "-0" { "0".into() } else { text.into() }
}

/// A number with so many digits that it is the same again for every purpose of a feed or a speed.
pub(super) fn significant(value: f64) -> String {
    let before_point = value.abs().max(1e-9).log10().floor() + 1.0;
    plain(value, (SIGNIFICANT_DIGITS - before_point).clamp(0.0, 12.0) as usize)
}

/// A time, s.
pub(super) fn seconds(value: f64) -> String {
    plain(value, TIME_DIGITS)
}

/// An angle, rad, as degrees.
pub(super) fn degrees(angle: f64) -> String {
    plain(angle.to_degrees(), ANGLE_DIGITS)
}

/// How lengths are written.
#[derive(Clone, Copy, Debug)]
pub(super) struct LengthWords {
    pub units: Units,
    /// Digits after the point; `None` for the usual ones.
    pub digits: Option<usize>,
}

impl LengthWords {
    /// A length in program units.
    pub fn text(self, mm: f64) -> String {
        plain(mm / self.units.mm(), self.digits())
    }

    /// The value that is read from [`LengthWords::text`], mm.
    pub fn rounded(self, mm: f64) -> f64 {
        let scale = 10f64.powi(self.digits() as i32);
        (mm / self.units.mm() * scale).round() / scale * self.units.mm()
    }

    fn digits(self) -> usize {
        let usual = match self.units {
            Units::Millimetre => LENGTH_DIGITS[0],
            Units::Inch => LENGTH_DIGITS[1],
        };
        self.digits.unwrap_or(usual)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_no_useless_digits() {
        assert_eq!(plain(10.0, 5), "10");
        assert_eq!(plain(-0.000_001, 5), "0");
        assert_eq!(plain(-0.5, 5), "-0.5");
        assert_eq!(plain(1000.0, 0), "1000");
        assert_eq!(significant(1200.0), "1200");
        assert_eq!(significant(0.2), "0.2");
        let inch = LengthWords { units: Units::Inch, digits: None };
        assert_eq!(inch.text(12.7), "0.5");
    }
}

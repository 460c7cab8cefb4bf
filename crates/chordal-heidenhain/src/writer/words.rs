//! Numbers as conversational programs have them: coordinates with their sign.

use chordal_command::Units;
use chordal_kernel::{WrittenLengths, plain_number, significant_number};

/// Digits after the point of angles, degrees.
const ANGLE_DIGITS: usize = 6;

/// Digits after the point of feeds and speeds at most.
const MAX_FEED_DIGITS: usize = 7;

/// A number with its sign.
pub(super) fn signed(value: f64, digits: usize) -> String {
    with_sign(plain_number(value, digits))
}

/// A length in program units, with its sign.
pub(super) fn signed_length(lengths: WrittenLengths, mm: f64) -> String {
    with_sign(lengths.text(mm))
}

fn with_sign(text: String) -> String {
    if text.starts_with('-') { text } else { format!("+{text}") }
}

/// A feed or a speed.
pub(super) fn significant(value: f64) -> String {
    significant_number(value, MAX_FEED_DIGITS)
}

/// An angle, rad, as degrees.
pub(super) fn degrees(angle: f64) -> String {
    signed(angle.to_degrees(), ANGLE_DIGITS)
}

/// The unit of F, mm/s: mm/min, or tenths of an inch per minute.
pub(super) fn feed_unit(units: Units) -> f64 {
    match units {
        Units::Millimetre => 1.0 / 60.0,
        Units::Inch => 2.54 / 60.0,
    }
}

/// The unit after the name of the program.
pub(super) fn unit_name(units: Units) -> &'static str {
    match units {
        Units::Millimetre => "MM",
        Units::Inch => "INCH",
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
        let inch = WrittenLengths { units: Units::Inch, digits: None };
        assert_eq!(signed_length(inch, 12.7), "+0.5");
        assert_eq!(feed_unit(Units::Inch) * 60.0, 2.54);
    }
}

//! Converts the numbers of a program into millimetres and radians, with a single rounding.

use chordal_command::Units;
use chordal_syntax::Decimal;

use crate::parameters::{DecimalPoint, Parameters};

/// The conversion of literals: a length in mm is `mantissa · factor / 10^(scale + extra)`, where `extra` depends on
/// whether the literal has a point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LiteralScale {
    factor: i64,
    with_point: u8,
    without_point: u8,
    angle_without_point: u8,
    /// Decimals of a length, in the program's units, that the control keeps.
    pub decimals: u8,
}

impl LiteralScale {
    /// The conversion for the active units.
    pub fn new(units: Units, parameters: &Parameters) -> LiteralScale {
        let whole = parameters.decimal_point == DecimalPoint::Calculator;
        let digits = |digits: u8| if whole { 0 } else { digits };
        let decimals = parameters.kept_decimals(units);
        match units {
            Units::Inch => LiteralScale {
                factor: 254,
                with_point: 1,
                without_point: 1 + digits(parameters.rules.increment_digits_inch),
                angle_without_point: digits(3),
                decimals,
            },
            Units::Millimetre => LiteralScale {
                factor: 1,
                with_point: 0,
                without_point: digits(parameters.rules.increment_digits_mm),
                angle_without_point: digits(3),
                decimals,
            },
        }
    }

    /// A length in mm.
    #[inline]
    pub fn length(&self, number: Decimal) -> f64 {
        let extra = if number.has_point { self.with_point } else { self.without_point };
        number.times(self.factor, extra)
    }

    /// An angle in rad.
    #[inline]
    pub fn angle(&self, number: Decimal) -> f64 {
        self.degrees(number).to_radians()
    }

    /// An angle in degrees, exactly as written.
    #[inline]
    pub fn degrees(&self, number: Decimal) -> f64 {
        let extra = if number.has_point { 0 } else { self.angle_without_point };
        number.times(1, extra)
    }
}

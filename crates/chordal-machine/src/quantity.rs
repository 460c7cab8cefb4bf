//! Quantities: texts with a unit, converted exactly.

use crate::decimal::{ExactDecimal, ExactFactor};
use crate::suggest;

/// The dimension of a quantity, which determines the unit that it is converted to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum QuantityDimension {
    /// Millimetres.
    Length,
    /// Radians.
    Angle,
    /// Seconds.
    Time,
    /// Millimetres per second.
    Velocity,
    /// Radians per second.
    AngularVelocity,
    /// mm/s².
    Acceleration,
    /// rad/s².
    AngularAcceleration,
    /// mm/s³.
    Jerk,
    /// rad/s³.
    AngularJerk,
    /// Revolutions per minute, as spindles are rated.
    SpindleSpeed,
    /// Kilowatts.
    Power,
    /// Newtons per square millimetre.
    Stress,
}

impl QuantityDimension {
    /// Its name with an article, for messages: `a length`.
    pub const fn noun(self) -> &'static str {
        match self {
            QuantityDimension::Length => "a length",
            QuantityDimension::Angle => "an angle",
            QuantityDimension::Time => "a time",
            QuantityDimension::Velocity => "a velocity",
            QuantityDimension::AngularVelocity => "an angular velocity",
            QuantityDimension::Acceleration => "an acceleration",
            QuantityDimension::AngularAcceleration => "an angular acceleration",
            QuantityDimension::Jerk => "a jerk",
            QuantityDimension::AngularJerk => "an angular jerk",
            QuantityDimension::SpindleSpeed => "a spindle speed",
            QuantityDimension::Power => "a power",
            QuantityDimension::Stress => "a force by area",
        }
    }

    /// Examples of its units, for messages.
    pub const fn units(self) -> &'static [&'static str] {
        match self {
            QuantityDimension::Length => &["in", "mm"],
            QuantityDimension::Angle => &["deg", "rad"],
            QuantityDimension::Time => &["s", "ms", "min"],
            QuantityDimension::Velocity => &["in/min", "mm/min", "m/min", "mm/s"],
            QuantityDimension::AngularVelocity => &["deg/s", "deg/min", "rpm"],
            QuantityDimension::Acceleration => &["mm/s^2", "m/s^2", "in/s^2"],
            QuantityDimension::AngularAcceleration => &["deg/s^2", "rad/s^2"],
            QuantityDimension::Jerk => &["mm/s^3", "m/s^3", "in/s^3"],
            QuantityDimension::AngularJerk => &["deg/s^3", "rad/s^3"],
            QuantityDimension::SpindleSpeed => &["rpm"],
            QuantityDimension::Power => &["kW", "hp"],
            QuantityDimension::Stress => &["N/mm^2", "MPa", "ksi"],
        }
    }

    /// The unit that a quantity is converted to.
    pub const fn inside(self) -> &'static str {
        match self {
            QuantityDimension::Length => "mm",
            QuantityDimension::Angle => "rad",
            QuantityDimension::Time => "s",
            QuantityDimension::Velocity => "mm/s",
            QuantityDimension::AngularVelocity => "rad/s",
            QuantityDimension::Acceleration => "mm/s^2",
            QuantityDimension::AngularAcceleration => "rad/s^2",
            QuantityDimension::Jerk => "mm/s^3",
            QuantityDimension::AngularJerk => "rad/s^3",
            QuantityDimension::SpindleSpeed => "rpm",
            QuantityDimension::Power => "kW",
            QuantityDimension::Stress => "N/mm^2",
        }
    }

    /// The corresponding dimension of a rotary axis: an angle for a length, and so on.
    pub const fn of_rotary(self) -> QuantityDimension {
        match self {
            QuantityDimension::Length => QuantityDimension::Angle,
            QuantityDimension::Velocity => QuantityDimension::AngularVelocity,
            QuantityDimension::Acceleration => QuantityDimension::AngularAcceleration,
            QuantityDimension::Jerk => QuantityDimension::AngularJerk,
            other => other,
        }
    }

    /// The dimension of a base divided by a power of time; `None` if there is none.
    const fn of(base: UnitBase, per_time: i64) -> Option<QuantityDimension> {
        match (base, per_time) {
            (UnitBase::Length, 0) => Some(QuantityDimension::Length),
            (UnitBase::Length, 1) => Some(QuantityDimension::Velocity),
            (UnitBase::Length, 2) => Some(QuantityDimension::Acceleration),
            (UnitBase::Length, 3) => Some(QuantityDimension::Jerk),
            (UnitBase::Angle | UnitBase::Turn, 0) => Some(QuantityDimension::Angle),
            (UnitBase::Angle | UnitBase::Turn, 1) => Some(QuantityDimension::AngularVelocity),
            (UnitBase::Angle | UnitBase::Turn, 2) => Some(QuantityDimension::AngularAcceleration),
            (UnitBase::Angle | UnitBase::Turn, 3) => Some(QuantityDimension::AngularJerk),
            (UnitBase::Time, 0) => Some(QuantityDimension::Time),
            (UnitBase::Power, 0) => Some(QuantityDimension::Power),
            (UnitBase::Stress, 0) => Some(QuantityDimension::Stress),
            _ => None,
        }
    }
}

/// Why a text is not a quantity of the expected dimension.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("this must be {}; {}", self.dimension().noun(), self.fault())]
pub enum QuantityError {
    /// It does not start with a number.
    NotANumber {
        /// The text.
        text: String,
        /// The expected dimension.
        dimension: QuantityDimension,
    },
    /// A number without a unit.
    NoUnit {
        /// The number.
        text: String,
        /// The expected dimension.
        dimension: QuantityDimension,
    },
    /// An unknown unit.
    UnknownUnit {
        /// The text.
        text: String,
        /// The unknown unit.
        unit: String,
        /// The expected dimension.
        dimension: QuantityDimension,
    },
    /// Another kind of quantity.
    WrongDimension {
        /// The text.
        text: String,
        /// Its dimension; `None` if it is none of [`QuantityDimension`].
        found: Option<QuantityDimension>,
        /// The expected dimension.
        dimension: QuantityDimension,
    },
    /// A number that is too large.
    OutOfRange {
        /// The text.
        text: String,
        /// The expected dimension.
        dimension: QuantityDimension,
    },
}

impl QuantityError {
    /// The expected dimension.
    pub const fn dimension(&self) -> QuantityDimension {
        match self {
            QuantityError::NotANumber { dimension, .. }
            | QuantityError::NoUnit { dimension, .. }
            | QuantityError::UnknownUnit { dimension, .. }
            | QuantityError::WrongDimension { dimension, .. }
            | QuantityError::OutOfRange { dimension, .. } => *dimension,
        }
    }

    /// The problem of the text, for messages, without the expected dimension.
    pub fn fault(&self) -> String {
        match self {
            QuantityError::NotANumber { text, .. } => {
                format!("`{text}` does not start with a number")
            }
            QuantityError::NoUnit { text, .. } => format!("`{text}` has no unit"),
            QuantityError::UnknownUnit { unit, .. } => format!("`{unit}` is not a unit"),
            QuantityError::WrongDimension { text, found: Some(found), .. } => {
                format!("`{text}` is {}", found.noun())
            }
            QuantityError::WrongDimension { text, found: None, .. } => {
                format!("`{text}` is not a quantity of a machine file")
            }
            QuantityError::OutOfRange { text, .. } => format!("`{text}` is out of range"),
        }
    }

    /// How to correct it, for messages; `None` if there is no advice.
    pub fn help(&self) -> Option<String> {
        let number = match self {
            QuantityError::NoUnit { text, .. } => text.as_str(),
            QuantityError::UnknownUnit { text, unit, dimension } => {
                let near = suggest::nearest(unit, dimension.units().iter().copied());
                let number = text.strip_suffix(unit.as_str()).unwrap_or("1").trim_end();
                if let Some(near) = near {
                    return Some(format!("did you mean \"{number} {near}\"?"));
                }
                number
            }
            QuantityError::OutOfRange { .. } => return None,
            QuantityError::NotANumber { .. } | QuantityError::WrongDimension { .. } => "",
        };
        if number.is_empty() {
            let (noun, units) = (self.dimension().noun(), self.dimension().units());
            return Some(format!("{noun} is a number with a unit: {}", suggest::or_list(units)));
        }
        let forms: Vec<String> =
            self.dimension().units().iter().map(|unit| format!("\"{number} {unit}\"")).collect();
        Some(format!("write it with its unit: {}", suggest::or_list(&forms)))
    }
}

/// What a unit measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum UnitBase {
    Length,
    Angle,
    /// An angle in revolutions.
    Turn,
    Time,
    Power,
    Stress,
}

struct UnitSpec {
    names: &'static [&'static str],
    base: UnitBase,
    factor: ExactFactor,
}

/// π to 79 decimals.
const PI: &str = "31415926535897932384626433832795028841971693993751058209749445923078164062862090";
/// 2π to 79 decimals.
const TWO_PI: &str =
    "62831853071795864769252867665590057683943387987502116419498891846156328125724180";
const PI_DECIMALS: i64 = 79;

const fn unit(
    names: &'static [&'static str],
    base: UnitBase,
    digits: &'static str,
    exponent: i64,
    denominator: u64,
) -> UnitSpec {
    UnitSpec { names, base, factor: ExactFactor { digits, exponent, denominator } }
}

/// The units, in millimetres, radians and seconds. Case does not matter, because megametres and megaseconds do not occur.
const UNITS: &[UnitSpec] = &[
    unit(
        &["mm", "millimetre", "millimetres", "millimeter", "millimeters"],
        UnitBase::Length,
        "1",
        0,
        1,
    ),
    unit(&["in", "inch", "inches", "\""], UnitBase::Length, "254", -1, 1),
    unit(&["ft", "foot", "feet"], UnitBase::Length, "3048", -1, 1),
    unit(&["m"], UnitBase::Length, "1", 3, 1),
    unit(&["cm"], UnitBase::Length, "1", 1, 1),
    // The two code points of the Greek letter: the micro sign and the letter mu.
    unit(&["um", "\u{b5}m", "\u{3bc}m"], UnitBase::Length, "1", -3, 1),
    unit(&["rad"], UnitBase::Angle, "1", 0, 1),
    unit(&["deg", "degree", "degrees", "\u{b0}"], UnitBase::Angle, PI, -PI_DECIMALS, 180),
    unit(&["rev", "turn", "turns"], UnitBase::Turn, TWO_PI, -PI_DECIMALS, 1),
    unit(&["s", "sec", "second", "seconds"], UnitBase::Time, "1", 0, 1),
    unit(&["ms"], UnitBase::Time, "1", -3, 1),
    unit(&["min", "minute", "minutes"], UnitBase::Time, "6", 1, 1),
    unit(&["kW"], UnitBase::Power, "1", 0, 1),
    unit(&["W"], UnitBase::Power, "1", -3, 1),
    // 550 foot-pounds per second; 75 kilopond-metres per second.
    unit(&["hp"], UnitBase::Power, "74569987158227022", -17, 1),
    unit(&["PS"], UnitBase::Power, "73549875", -8, 1),
    unit(&["MPa"], UnitBase::Stress, "1", 0, 1),
    // 1000 pounds of force per square inch: 4448.2216152605 N per 645.16 mm².
    unit(&["ksi"], UnitBase::Stress, "44482216152605", -8, 64516),
];

/// Abbreviations of units with a quotient: per time, and force per area.
const SHORT_UNIT_NAMES: &[(&str, &str)] = &[
    ("rpm", "rev/min"),
    ("ipm", "in/min"),
    ("N/mm^2", "MPa"),
    ("N/mm\u{b2}", "MPa"),
    ("N/mm2", "MPa"),
];

fn find_unit(name: &str) -> Option<&'static UnitSpec> {
    let name = name.trim();
    UNITS.iter().find(|unit| unit.names.iter().any(|own| own.eq_ignore_ascii_case(name)))
}

/// The largest accepted value, mm, rad and s: sums and products of a few such values are still finite.
const MAX_QUANTITY: f64 = 1e30;

/// Reads a quantity (`"0.5 in"`, `"25 m/min"`, `"2000 mm/s^2"`) into the unit of its dimension
/// ([`QuantityDimension::inside`]). The conversion is exact, with one rounding.
pub fn parse_quantity(text: &str, dimension: QuantityDimension) -> Result<f64, QuantityError> {
    let text = text.trim();
    let own = || text.to_string();
    let Some((number, rest)) = ExactDecimal::read(text) else {
        return Err(QuantityError::NotANumber { text: own(), dimension });
    };
    let written = rest.trim();
    if written.is_empty() {
        return Err(QuantityError::NoUnit { text: own(), dimension });
    }
    let Some((base, per_time, factor)) = read_unit(written) else {
        return Err(QuantityError::UnknownUnit {
            text: own(),
            unit: written.to_string(),
            dimension,
        });
    };
    let found = QuantityDimension::of(base, per_time);
    let factor = match dimension {
        // Revolutions per minute need no factor of π.
        QuantityDimension::SpindleSpeed if base == UnitBase::Turn && per_time == 1 => {
            ExactFactor { digits: "60", exponent: factor.exponent + PI_DECIMALS, ..factor }
        }
        _ if found == Some(dimension) => factor,
        _ => return Err(QuantityError::WrongDimension { text: own(), found, dimension }),
    };
    let value = number.times(factor);
    if !value.is_finite() {
        return Err(QuantityError::OutOfRange { text: own(), dimension });
    }
    Ok(value)
}

/// Reads a quantity of a machine, which must not exceed [`MAX_QUANTITY`].
pub(crate) fn machine_quantity(
    text: &str,
    dimension: QuantityDimension,
) -> Result<f64, QuantityError> {
    let value = parse_quantity(text, dimension)?;
    if value.abs() > MAX_QUANTITY {
        return Err(QuantityError::OutOfRange { text: text.trim().to_string(), dimension });
    }
    Ok(value)
}

/// Converts a decimal number in inches or millimetres to millimetres, with one rounding; `None` if it is not a number.
pub(crate) fn length_of_bare(text: &str, millimetres: bool) -> Option<f64> {
    let (number, rest) = ExactDecimal::read(text)?;
    let (digits, exponent) = if millimetres { ("1", 0) } else { ("254", -1) };
    let value = number.times(ExactFactor { digits, exponent, denominator: 1 });
    (rest.is_empty() && value.abs() <= MAX_QUANTITY).then_some(value)
}

/// The base of a unit, the power of time that it is divided by, and its factor; `None` for an unknown unit.
fn read_unit(text: &str) -> Option<(UnitBase, i64, ExactFactor)> {
    let text = SHORT_UNIT_NAMES
        .iter()
        .find(|(short, _)| short.eq_ignore_ascii_case(text))
        .map_or(text, |(_, long)| long);
    let mut parts = text.split('/');
    let top = find_unit(parts.next()?)?;
    let mut factor = top.factor;
    let mut per_time = 0;
    for part in parts {
        let (name, power) = read_power(part.trim());
        let below = find_unit(name)?;
        per_time += power;
        if below.base != UnitBase::Time || per_time > 3 {
            return None;
        }
        for _ in 0..power {
            // A minute is 6·10 s, a millisecond is 10^-3 s: the digits (1 or 6) are in the denominator.
            let digits: u64 = below.factor.digits.parse().ok()?;
            factor.denominator *= digits;
            factor.exponent -= below.factor.exponent;
        }
    }
    Some((top.base, per_time, factor))
}

/// The name and the power of `s^2`, `s²`, `s2` or `s`.
fn read_power(text: &str) -> (&str, i64) {
    for (endings, power) in
        [(["^2", "\u{b2}", "2"], 2), (["^3", "\u{b3}", "3"], 3), (["^1", "\u{b9}", "1"], 1)]
    {
        for ending in endings {
            if let Some(name) = text.strip_suffix(ending) {
                return (name, power);
            }
        }
    }
    (text, 1)
}

//! Numbers of the command line, with a unit of their own or that of `--units`.

use chordal::machine::{QuantityDimension, QuantityError, parse_quantity};
use chordal_calc::AnswerUnit;
use clap::ValueEnum;

use crate::failure::CommandFailure;
use crate::options::wrong_quantity;

/// What `--units` takes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum UnitsName {
    /// Inches
    Inch,
    /// Millimetres
    Mm,
}

/// A length, or a feed, as it was written.
#[derive(Clone, PartialEq, Debug)]
pub struct WrittenQuantity {
    text: String,
    dimension: QuantityDimension,
    /// Its size when it has a unit, and whether that is inches.
    read: Option<(f64, bool)>,
}

fn written(text: &str, dimension: QuantityDimension) -> Result<WrittenQuantity, String> {
    let read = match parse_quantity(text, dimension) {
        Ok(value) => {
            let unit = text.trim_start_matches(|c: char| !c.is_ascii_alphabetic() && c != '"');
            let unit = unit.to_ascii_lowercase();
            Some((value, unit.starts_with("in") || unit.starts_with('"') || unit == "ipm"))
        }
        Err(QuantityError::NoUnit { .. }) => None,
        Err(error) => return Err(wrong_quantity(&error)),
    };
    Ok(WrittenQuantity { text: text.trim().to_string(), dimension, read })
}

/// `1.5in`, `38 mm`, or a number alone.
pub fn length(text: &str) -> Result<WrittenQuantity, String> {
    written(text, QuantityDimension::Length)
}

/// `10in/min`, `400 mm/min`, or a number alone: units a minute.
pub fn feed(text: &str) -> Result<WrittenQuantity, String> {
    written(text, QuantityDimension::Velocity)
}

/// `30deg`, `0.5rad`, or a number alone: degrees. In rad.
pub fn angle(text: &str) -> Result<f64, String> {
    match parse_quantity(text, QuantityDimension::Angle) {
        Err(QuantityError::NoUnit { text, .. }) => {
            parse_quantity(&format!("{text} deg"), QuantityDimension::Angle)
        }
        other => other,
    }
    .map_err(|error| wrong_quantity(&error))
}

/// `1200`, `1200rpm`. In rpm.
pub fn spindle(text: &str) -> Result<f64, String> {
    match parse_quantity(text, QuantityDimension::SpindleSpeed) {
        Err(QuantityError::NoUnit { text, .. }) => {
            parse_quantity(&format!("{text} rpm"), QuantityDimension::SpindleSpeed)
        }
        other => other,
    }
    .map_err(|error| wrong_quantity(&error))
}

/// The unit of an answer, and of numbers without one.
#[derive(Clone, Copy, Debug)]
pub struct UnitReader {
    requested: Option<UnitsName>,
    /// The unit of the answer.
    pub units: AnswerUnit,
}

impl UnitReader {
    /// The unit that was asked for; without, inches when one of the numbers is in inches.
    pub fn new<'a>(
        queried: Option<UnitsName>,
        written: impl IntoIterator<Item = Option<&'a WrittenQuantity>>,
    ) -> UnitReader {
        let inch = match queried {
            Some(name) => name == UnitsName::Inch,
            None => written.into_iter().flatten().any(|own| own.read.is_some_and(|(_, inch)| inch)),
        };
        UnitReader {
            requested: queried,
            units: if inch { AnswerUnit::Inch } else { AnswerUnit::Millimetre },
        }
    }

    /// A length in mm, or a feed in mm/s.
    pub fn of(&self, own: &WrittenQuantity) -> Result<f64, CommandFailure> {
        if let Some((value, _)) = own.read {
            return Ok(value);
        }
        let per = if own.dimension == QuantityDimension::Velocity { "/min" } else { "" };
        if self.requested.is_none() {
            let text = &own.text;
            return Err(CommandFailure::wrong(
                format!("`{text}` has no unit"),
                format!("write {text}in{per} or {text}mm{per}, or say --units inch or --units mm"),
            ));
        }
        let with_unit = format!("{} {}{per}", own.text, self.units.name());
        parse_quantity(&with_unit, own.dimension)
            .map_err(|error| CommandFailure::wrong(error.to_string(), "give a number"))
    }

    /// The same of a number that may be missing.
    pub fn maybe(&self, own: Option<&WrittenQuantity>) -> Result<Option<f64>, CommandFailure> {
        own.map(|own| self.of(own)).transpose()
    }
}

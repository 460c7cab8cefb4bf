//! How F counts rotary axes, as settings of a machine file.

use chordal_kernel::rules::*;

use super::choices::{Choices, choose, mm_text, name_of};
use crate::parameters::Parameters;

/// The rule that a setting changes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "each names a part of `RotaryFeedRules`")]
pub enum RotaryFeedField {
    Measure,
    FourthDiameter,
    FifthDiameter,
}

const MEASURES: Choices<RotaryFeed> = &[
    ("linear-axes", RotaryFeed::LinearAxes),
    ("degrees-as-units", RotaryFeed::DegreesAsUnits),
    ("degrees-as-mm", RotaryFeed::DegreesAsMillimetres),
    ("on-diameter", RotaryFeed::OnDiameter),
];

/// A diameter that nobody gave.
const NOT_KNOWN: &str = "not known";

/// The largest diameter that is taken, mm.
const MAX_DIAMETER_MM: f64 = 4000.0;

/// Sets one rule; the error says what it takes.
pub(super) fn set(
    p: &mut Parameters,
    field: RotaryFeedField,
    word: &str,
    length: impl Fn() -> Result<f64, String>,
) -> Result<(), String> {
    let rules = &mut p.rules.rotary_feed;
    let diameter_mm = || match length() {
        _ if word.eq_ignore_ascii_case(NOT_KNOWN) => Ok(None),
        Err(error) => Err(error),
        Ok(mm) if mm > 0.0 && mm <= MAX_DIAMETER_MM => Ok(Some(mm)),
        _ => Err(format!("a diameter above 0 and up to {MAX_DIAMETER_MM} mm")),
    };
    match field {
        RotaryFeedField::Measure => rules.measure = choose(word, MEASURES)?,
        RotaryFeedField::FourthDiameter => rules.diameters_mm[0] = diameter_mm()?,
        RotaryFeedField::FifthDiameter => rules.diameters_mm[1] = diameter_mm()?,
    }
    Ok(())
}

/// The present value of a rule, as a machine file writes it.
pub(super) fn value_text(p: &Parameters, field: RotaryFeedField) -> String {
    let rules = &p.rules.rotary_feed;
    let diameter = |at: usize| rules.diameters_mm[at].map_or(NOT_KNOWN.to_string(), mm_text);
    match field {
        RotaryFeedField::Measure => name_of(rules.measure, MEASURES),
        RotaryFeedField::FourthDiameter => diameter(0),
        RotaryFeedField::FifthDiameter => diameter(1),
    }
}

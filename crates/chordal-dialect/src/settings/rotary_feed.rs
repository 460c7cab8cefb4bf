//! Settings of F in moves with rotary axes.

use chordal_kernel::rules::*;

use super::choices::{Choices, choose, mm_text, name_of};
use super::field::{SettingField, SettingInput, setting_fields};
use crate::parameters::Parameters;

const MEASURES: Choices<RotaryFeed> = &[
    ("linear-axes", RotaryFeed::LinearAxes),
    ("degrees-as-units", RotaryFeed::DegreesAsUnits),
    ("degrees-as-mm", RotaryFeed::DegreesAsMillimetres),
    ("on-diameter", RotaryFeed::OnDiameter),
];

/// The text of a diameter that the machine file does not give.
const NOT_KNOWN: &str = "not known";

/// The largest diameter that is accepted, mm: larger than any machine's table.
const MAX_DIAMETER_MM: f64 = 4000.0;

setting_fields! {
    ROTARY_FEED_MEASURE = choice(rules.rotary_feed.measure, MEASURES);
    ROTARY_FEED_FOURTH_DIAMETER = custom(set_diameter, |p, index| {
        p.rules.rotary_feed.diameters_mm[usize::from(index)].map_or(NOT_KNOWN.to_string(), mm_text)
    });
}

#[allow(missing_docs, reason = "as those above")]
impl SettingField {
    pub const ROTARY_FEED_FIFTH_DIAMETER: SettingField =
        SettingField::ROTARY_FEED_FOURTH_DIAMETER.at(1);
}

fn set_diameter(p: &mut Parameters, input: &SettingInput<'_>) -> Result<(), String> {
    let diameter_mm = match input.length("0.0005 in") {
        _ if input.word.eq_ignore_ascii_case(NOT_KNOWN) => None,
        Err(error) => return Err(error),
        Ok(mm) if mm > 0.0 && mm <= MAX_DIAMETER_MM => Some(mm),
        Ok(_) => return Err(format!("a diameter above 0 and up to {MAX_DIAMETER_MM} mm")),
    };
    p.rules.rotary_feed.diameters_mm[usize::from(input.index)] = diameter_mm;
    Ok(())
}

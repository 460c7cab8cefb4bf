//! Settings of canned cycles.

use chordal_kernel::rules::*;

use super::choices::{Choices, SWITCH, choose, mm_text, name_of};
use super::field::{SettingField, SettingInput, setting_fields};
use crate::parameters::Parameters;

const AXES: Choices<DrillingAxis> = &[
    ("z", DrillingAxis::AlwaysZ),
    ("plane-normal", DrillingAxis::PlaneNormal),
    ("of-code", DrillingAxis::OfCode),
];

const FIRING: Choices<FiringWords> = &[
    ("place", FiringWords::Place),
    ("any-axis", FiringWords::AnyAxis),
    ("axis-or-level", FiringWords::AxisOrLevel),
];

const DEFINITIONS: Choices<DefinitionFires> = &[
    ("always", DefinitionFires::Always),
    ("with-place", DefinitionFires::WithPlace),
    ("never", DefinitionFires::Never),
];

const MISSING: Choices<MissingLevel> = &[
    ("refused", MissingLevel::Refused),
    ("current", MissingLevel::Current),
    ("initial", MissingLevel::Initial),
];

const R_LEVELS: Choices<bool> = &[("from-initial", true), ("absolute", false)];

const ZERO_REPEATS: Choices<ZeroRepeats> = &[
    ("refused", ZeroRepeats::Refused),
    ("stored", ZeroRepeats::Stored),
    ("place-only", ZeroRepeats::PlaceOnly),
];

const PECK_DWELLS: Choices<PeckDwell> =
    &[("none", PeckDwell::None), ("bottom", PeckDwell::Bottom), ("each-peck", PeckDwell::EachPeck)];

const TAP_FEEDS: Choices<TapFeed> = &[
    ("programmed", TapFeed::Programmed),
    ("lead", TapFeed::Lead),
    ("speed", TapFeed::SpeedWithLeadQ),
];

const SHIFTS: Choices<ShiftWords> =
    &[("q", ShiftWords::Q), ("vector", ShiftWords::Vector), ("q-or-vector", ShiftWords::QOrVector)];

const DIRECTIONS: Choices<ShiftDirection> = &[
    ("x+", ShiftDirection { second: false, minus: false }),
    ("x-", ShiftDirection { second: false, minus: true }),
    ("y+", ShiftDirection { second: true, minus: false }),
    ("y-", ShiftDirection { second: true, minus: true }),
];

const BACK_BORES: Choices<BackBore> = &[
    ("shift-at-initial", BackBore::ShiftAtInitial),
    ("shift-at-r", BackBore::ShiftAtR),
    ("up-and-down", BackBore::UpAndDown),
];

const LETTERS: Choices<u8> = &[("K", b'K'), ("L", b'L')];

setting_fields! {
    CYCLE_AXIS = choice(rules.cycles.axis, AXES);
    CYCLE_FIRES_ON = choice(rules.cycles.fires_on, FIRING);
    CYCLE_DEFINITION = choice(rules.cycles.definition, DEFINITIONS);
    CYCLE_MISSING_R = choice(rules.cycles.missing_r, MISSING);
    CYCLE_R_FROM_INITIAL = choice(rules.cycles.r_from_initial, R_LEVELS);
    CYCLE_FULL_RETURN = choice(rules.cycles.peck.full_return, SWITCH);
    CYCLE_REPEAT_LETTER = choice(rules.cycles.repeat_letter, LETTERS);
    CYCLE_ZERO_REPEATS = choice(rules.cycles.zero_repeats, ZERO_REPEATS);
    /// One lift for chip-breaking and full-retract pecks.
    CYCLE_LIFTS = custom(
        |p, input| {
            p.rules.chip_break_mm = input.length(EXAMPLE)?;
            p.rules.peck_clearance_mm = p.rules.chip_break_mm;
            Ok(())
        },
        |p, _| mm_text(p.rules.chip_break_mm)
    );
    CYCLE_RETURN_ABOVE_R = length(rules.cycles.peck.return_above_r_mm, EXAMPLE);
    CYCLE_CHIP_BREAK_ABOVE_R = choice(rules.cycles.peck.chip_break_above_r, SWITCH);
    CYCLE_PECK_DWELL = choice(rules.cycles.peck.dwell, PECK_DWELLS);
    CYCLE_P_IS_LIFT = choice(rules.cycles.peck.p_is_lift, SWITCH);
    CYCLE_P_IS_CLEARANCE = choice(rules.cycles.peck.p_is_clearance, SWITCH);
    CYCLE_TAP_FEED = choice(rules.cycles.tap.feed, TAP_FEEDS);
    CYCLE_TAP_OUT_FACTOR = custom(
        |p, input| {
            p.rules.cycles.tap.out_factor = factor(input.number())?;
            Ok(())
        },
        |p, _| p.rules.cycles.tap.out_factor.to_string()
    );
    CYCLE_TAP_PECKS = choice(rules.cycles.tap.pecks_by_q, SWITCH);
    CYCLE_TAP_FULL_RETURN = choice(rules.cycles.tap.peck_full_return, SWITCH);
    CYCLE_TAP_LIFT = length(rules.cycles.tap.peck_lift_mm, EXAMPLE);
    CYCLE_TAP_DWELL_AT_R = choice(rules.cycles.tap.dwell_at_r, SWITCH);
    CYCLE_DWELL_BEFORE_STOP = choice(rules.cycles.bore.dwell_before_stop, SWITCH);
    CYCLE_SHIFT = choice(rules.cycles.bore.shift, SHIFTS);
    CYCLE_SHIFT_DIRECTION = choice(rules.cycles.bore.direction, DIRECTIONS);
    CYCLE_BACK_BORE = choice(rules.cycles.bore.back, BACK_BORES);
    CYCLE_BOLT_CIRCLE_RADIUS_REGISTER = custom(set_bolt_circle, bolt_circle_text);
    /// How H and F are read: Fadal Format 1 (`on`) or 2.
    CYCLE_FORMAT = custom(
        |p, input| {
            p.length_by_h_alone = choose(input.word, SWITCH)?;
            p.rules.cycles.tap.feed =
                if p.length_by_h_alone { TapFeed::SpeedWithLeadQ } else { TapFeed::Programmed };
            Ok(())
        },
        |p, _| name_of(p.length_by_h_alone, SWITCH)
    );
}

#[allow(missing_docs, reason = "as those above")]
impl SettingField {
    pub const CYCLE_BOLT_CIRCLE_ANGLE_REGISTER: SettingField =
        SettingField::CYCLE_BOLT_CIRCLE_RADIUS_REGISTER.at(1);
}

/// The length that messages give as an example.
const EXAMPLE: &str = "0.02 in";

/// The factor of the return speed of a tap. 0 and 1 both mean no change, as in Haas Setting 130.
fn factor(number: f64) -> Result<f64, String> {
    match number {
        0.0 => Ok(1.0),
        number if (0.1..=9.0).contains(&number) => Ok(number),
        _ => Err("a number from 0.1 to 9, or 0 for no change".to_string()),
    }
}

fn set_bolt_circle(p: &mut Parameters, input: &SettingInput<'_>) -> Result<(), String> {
    let register = input.whole(0..=9, "the number of a register, 0 to 9")?;
    p.rules.cycles.bolt_circle[usize::from(input.index)] = register as u8;
    Ok(())
}

fn bolt_circle_text(p: &Parameters, index: u8) -> String {
    p.rules.cycles.bolt_circle[usize::from(index)].to_string()
}

//! The rules of canned cycles as settings of a machine file.

use chordal_kernel::rules::*;
use chordal_machine::SettingValue;

use super::choices::{Choices, SWITCH, choose, mm_text, name_of};
use crate::parameters::Parameters;

/// The rule that a setting changes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "each names a field of `CycleRules`")]
pub enum CycleField {
    Axis,
    FiresOn,
    Definition,
    MissingR,
    RFromInitial,
    FullReturn,
    RepeatLetter,
    ZeroRepeats,
    Lifts,
    ReturnAboveR,
    ChipBreakAboveR,
    PeckDwell,
    PIsLift,
    PIsClearance,
    TapFeed,
    TapOutFactor,
    TapPecks,
    TapFullReturn,
    TapLift,
    TapDwellAtR,
    DwellBeforeStop,
    Shift,
    ShiftDirection,
    BackBore,
    BoltCircleRadius,
    BoltCircleAngle,
    /// Fadal Format 1 (`on`) or 2: how H and F are read.
    Format,
}

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

/// Sets one rule; the error says what it takes.
pub(crate) fn set(
    p: &mut Parameters,
    field: CycleField,
    word: &str,
    value: &SettingValue,
) -> Result<(), String> {
    let length = || {
        value.as_length_mm().map_err(|_| "a length with its unit, such as \"0.02 in\"".to_string())
    };
    let rules = &mut p.rules.cycles;
    match field {
        CycleField::Axis => rules.axis = choose(word, AXES)?,
        CycleField::FiresOn => rules.fires_on = choose(word, FIRING)?,
        CycleField::Definition => rules.definition = choose(word, DEFINITIONS)?,
        CycleField::MissingR => rules.missing_r = choose(word, MISSING)?,
        CycleField::RFromInitial => rules.r_from_initial = choose(word, R_LEVELS)?,
        CycleField::FullReturn => rules.peck.full_return = choose(word, SWITCH)?,
        CycleField::RepeatLetter => rules.repeat_letter = choose(word, LETTERS)?,
        CycleField::ZeroRepeats => rules.zero_repeats = choose(word, ZERO_REPEATS)?,
        CycleField::Lifts => {
            p.rules.chip_break_mm = length()?;
            p.rules.peck_clearance_mm = p.rules.chip_break_mm;
        }
        CycleField::ReturnAboveR => rules.peck.return_above_r_mm = length()?,
        CycleField::ChipBreakAboveR => rules.peck.chip_break_above_r = choose(word, SWITCH)?,
        CycleField::PeckDwell => rules.peck.dwell = choose(word, PECK_DWELLS)?,
        CycleField::PIsLift => rules.peck.p_is_lift = choose(word, SWITCH)?,
        CycleField::PIsClearance => rules.peck.p_is_clearance = choose(word, SWITCH)?,
        CycleField::TapFeed => rules.tap.feed = choose(word, TAP_FEEDS)?,
        CycleField::TapOutFactor => rules.tap.out_factor = factor(value)?,
        CycleField::TapPecks => rules.tap.pecks_by_q = choose(word, SWITCH)?,
        CycleField::TapFullReturn => rules.tap.peck_full_return = choose(word, SWITCH)?,
        CycleField::TapLift => rules.tap.peck_lift_mm = length()?,
        CycleField::TapDwellAtR => rules.tap.dwell_at_r = choose(word, SWITCH)?,
        CycleField::DwellBeforeStop => rules.bore.dwell_before_stop = choose(word, SWITCH)?,
        CycleField::Shift => rules.bore.shift = choose(word, SHIFTS)?,
        CycleField::ShiftDirection => rules.bore.direction = choose(word, DIRECTIONS)?,
        CycleField::BackBore => rules.bore.back = choose(word, BACK_BORES)?,
        CycleField::BoltCircleRadius => rules.bolt_circle[0] = register(value)?,
        CycleField::BoltCircleAngle => rules.bolt_circle[1] = register(value)?,
        CycleField::Format => {
            p.length_by_h_alone = choose(word, SWITCH)?;
            rules.tap.feed =
                if p.length_by_h_alone { TapFeed::SpeedWithLeadQ } else { TapFeed::Programmed };
        }
    }
    Ok(())
}

/// The present value of a rule, as a machine file writes it.
pub(crate) fn value_text(p: &Parameters, field: CycleField) -> String {
    let rules = &p.rules.cycles;
    match field {
        CycleField::Axis => name_of(rules.axis, AXES),
        CycleField::FiresOn => name_of(rules.fires_on, FIRING),
        CycleField::Definition => name_of(rules.definition, DEFINITIONS),
        CycleField::MissingR => name_of(rules.missing_r, MISSING),
        CycleField::RFromInitial => name_of(rules.r_from_initial, R_LEVELS),
        CycleField::FullReturn => name_of(rules.peck.full_return, SWITCH),
        CycleField::RepeatLetter => name_of(rules.repeat_letter, LETTERS),
        CycleField::ZeroRepeats => name_of(rules.zero_repeats, ZERO_REPEATS),
        CycleField::Lifts => mm_text(p.rules.chip_break_mm),
        CycleField::ReturnAboveR => mm_text(rules.peck.return_above_r_mm),
        CycleField::ChipBreakAboveR => name_of(rules.peck.chip_break_above_r, SWITCH),
        CycleField::PeckDwell => name_of(rules.peck.dwell, PECK_DWELLS),
        CycleField::PIsLift => name_of(rules.peck.p_is_lift, SWITCH),
        CycleField::PIsClearance => name_of(rules.peck.p_is_clearance, SWITCH),
        CycleField::TapFeed => name_of(rules.tap.feed, TAP_FEEDS),
        CycleField::TapOutFactor => format!("{}", rules.tap.out_factor),
        CycleField::TapPecks => name_of(rules.tap.pecks_by_q, SWITCH),
        CycleField::TapFullReturn => name_of(rules.tap.peck_full_return, SWITCH),
        CycleField::TapLift => mm_text(rules.tap.peck_lift_mm),
        CycleField::TapDwellAtR => name_of(rules.tap.dwell_at_r, SWITCH),
        CycleField::DwellBeforeStop => name_of(rules.bore.dwell_before_stop, SWITCH),
        CycleField::Shift => name_of(rules.bore.shift, SHIFTS),
        CycleField::ShiftDirection => name_of(rules.bore.direction, DIRECTIONS),
        CycleField::BackBore => name_of(rules.bore.back, BACK_BORES),
        CycleField::BoltCircleRadius => rules.bolt_circle[0].to_string(),
        CycleField::BoltCircleAngle => rules.bolt_circle[1].to_string(),
        CycleField::Format => name_of(p.length_by_h_alone, SWITCH),
    }
}

/// 0 and 1 are both "no change", as Haas Setting 130 has it.
fn factor(value: &SettingValue) -> Result<f64, String> {
    let number = match value {
        SettingValue::Integer(number) => *number as f64,
        SettingValue::Float(number) => *number,
        _ => f64::NAN,
    };
    match number {
        0.0 => Ok(1.0),
        number if (0.1..=9.0).contains(&number) => Ok(number),
        _ => Err("a number from 0.1 to 9, or 0 for no change".to_string()),
    }
}

fn register(value: &SettingValue) -> Result<u8, String> {
    match value {
        SettingValue::Integer(number @ 0..=9) => Ok(*number as u8),
        _ => Err("the number of a register, 0 to 9".to_string()),
    }
}

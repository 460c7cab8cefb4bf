//! Settings of the cycles of lathes.

use chordal_kernel::rules::FirstLevel;
use chordal_machine::SettingValue;

use super::choices::{choose, mm_text, name_of};
use crate::parameters::Parameters;

/// The rule of a lathe's cycles that a setting changes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "each names a field of `TurningRules`")]
pub enum TurningField {
    RoughDepth,
    RoughRetract,
    FirstLevel,
    PeckRetract,
    ThreadExit,
    ThreadLeast,
    ThreadFinish,
    ThreadFinishPasses,
    ThreadAngle,
    PocketsByR,
    ReturnOfContour,
    ThreadPoint,
}

const FIRST_LEVELS: &[(&str, FirstLevel)] =
    &[("allowance", FirstLevel::Allowance), ("start", FirstLevel::Start)];

const RETURNS: &[(&str, bool)] = &[("left out", true), ("refused", false)];

const POINTS: &[(&str, bool)] = &[("allowed", true), ("reported", false)];

const STYLES: &[(&str, Option<u8>)] = &[("fanuc", None), ("yasnac", Some(b'R'))];

/// Sets one of them; the error says what it takes.
pub(super) fn set(
    p: &mut Parameters,
    field: TurningField,
    word: &str,
    value: &SettingValue,
) -> Result<(), String> {
    let rules = &mut p.rules.turning;
    let length = || {
        value.as_length_mm().map_err(|_| "a length with its unit, such as \"0.5 mm\"".to_string())
    };
    let whole = |most: i64| match value {
        SettingValue::Integer(number) if (0..=most).contains(number) => Ok(*number as u32),
        _ => Err(format!("a whole number up to {most}")),
    };
    match field {
        TurningField::RoughDepth => rules.rough_depth_mm = length()?,
        TurningField::RoughRetract => rules.rough_retract_mm = length()?,
        TurningField::FirstLevel => rules.first_level = choose(word, FIRST_LEVELS)?,
        TurningField::PeckRetract => rules.peck_retract_mm = length()?,
        TurningField::ThreadExit => rules.thread_exit_leads = f64::from(whole(127)?) / 10.0,
        TurningField::ThreadLeast => rules.thread_least_mm = length()?,
        TurningField::ThreadFinish => rules.thread_finish_mm = length()?,
        TurningField::ThreadFinishPasses => rules.thread_finish_passes = whole(99)?,
        TurningField::ThreadAngle => rules.thread_angle_deg = f64::from(whole(120)?),
        TurningField::PocketsByR => rules.pockets_by = choose(word, STYLES)?,
        TurningField::ReturnOfContour => rules.return_left_out = choose(word, RETURNS)?,
        TurningField::ThreadPoint => rules.thread_words_take_point = choose(word, POINTS)?,
    }
    Ok(())
}

/// The present value, as a machine file writes it.
pub(super) fn value_text(p: &Parameters, field: TurningField) -> String {
    let rules = &p.rules.turning;
    match field {
        TurningField::RoughDepth => mm_text(rules.rough_depth_mm),
        TurningField::RoughRetract => mm_text(rules.rough_retract_mm),
        TurningField::FirstLevel => name_of(rules.first_level, FIRST_LEVELS),
        TurningField::PeckRetract => mm_text(rules.peck_retract_mm),
        TurningField::ThreadExit => (rules.thread_exit_leads * 10.0).to_string(),
        TurningField::ThreadLeast => mm_text(rules.thread_least_mm),
        TurningField::ThreadFinish => mm_text(rules.thread_finish_mm),
        TurningField::ThreadFinishPasses => rules.thread_finish_passes.to_string(),
        TurningField::ThreadAngle => rules.thread_angle_deg.to_string(),
        TurningField::PocketsByR => name_of(rules.pockets_by, STYLES),
        TurningField::ReturnOfContour => name_of(rules.return_left_out, RETURNS),
        TurningField::ThreadPoint => name_of(rules.thread_words_take_point, POINTS),
    }
}

//! The rules of frames as settings of a machine file.

use chordal_kernel::rules::*;
use chordal_machine::SettingValue;

use super::choices::{Choices, SWITCH, choose, name_of};
use crate::parameters::Parameters;

/// The rule that a setting changes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "each names a field of `FrameRules`")]
pub enum FrameField {
    AngleAdds,
    OmittedAngle,
    /// The factor of all axes, or of one: 0 for X.
    OmittedFactor(Option<u8>),
    FactorsByVector,
    UnequalArcs,
    InCompensation,
    HasScaling,
    HasRotation,
    CyclesAlongScaled,
}

const ANGLES: Choices<bool> = &[("absolute", false), ("adds", true)];

const ARCS: Choices<UnequalArcs> =
    &[("judged", UnequalArcs::Judged), ("refused", UnequalArcs::Refused)];

const OPTIONS: Choices<bool> = &[("present", true), ("absent", false)];

const CYCLES: Choices<bool> = &[("allowed", true), ("warned", false)];

const FACTORS: Choices<bool> = &[("one", false), ("each", true)];

/// Sets one rule; the error says what it takes.
pub(crate) fn set(
    p: &mut Parameters,
    field: FrameField,
    word: &str,
    value: &SettingValue,
) -> Result<(), String> {
    let number = || match value {
        SettingValue::Integer(number) => Ok(*number as f64),
        SettingValue::Float(number) if number.is_finite() => Ok(*number),
        _ => Err("a number".to_string()),
    };
    let rules = &mut p.rules.frames;
    match field {
        FrameField::AngleAdds => rules.angle_adds = choose(word, ANGLES)?,
        FrameField::OmittedAngle => rules.omitted_angle_deg = number()?,
        FrameField::OmittedFactor(axis) => {
            let factor = number()?;
            if factor == 0.0 {
                return Err("a number other than 0".to_string());
            }
            match axis {
                Some(axis) => rules.omitted_factors[usize::from(axis.min(2))] = factor,
                None => rules.omitted_factors = [factor; 3],
            }
        }
        FrameField::FactorsByVector => rules.factors_by_vector = choose(word, FACTORS)?,
        FrameField::UnequalArcs => rules.unequal_arcs = choose(word, ARCS)?,
        FrameField::InCompensation => rules.in_compensation = choose(word, SWITCH)?,
        FrameField::HasScaling => rules.has_scaling = choose(word, OPTIONS)?,
        FrameField::HasRotation => rules.has_rotation = choose(word, OPTIONS)?,
        FrameField::CyclesAlongScaled => rules.cycles_along_scaled = choose(word, CYCLES)?,
    }
    Ok(())
}

/// The present value of a rule, as a machine file writes it.
pub(crate) fn value_text(p: &Parameters, field: FrameField) -> String {
    let rules = &p.rules.frames;
    match field {
        FrameField::AngleAdds => name_of(rules.angle_adds, ANGLES),
        FrameField::OmittedAngle => rules.omitted_angle_deg.to_string(),
        FrameField::OmittedFactor(axis) => {
            rules.omitted_factors[usize::from(axis.unwrap_or(0).min(2))].to_string()
        }
        FrameField::FactorsByVector => name_of(rules.factors_by_vector, FACTORS),
        FrameField::UnequalArcs => name_of(rules.unequal_arcs, ARCS),
        FrameField::InCompensation => name_of(rules.in_compensation, SWITCH),
        FrameField::HasScaling => name_of(rules.has_scaling, OPTIONS),
        FrameField::HasRotation => name_of(rules.has_rotation, OPTIONS),
        FrameField::CyclesAlongScaled => name_of(rules.cycles_along_scaled, CYCLES),
    }
}

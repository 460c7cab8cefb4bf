//! Settings of frames: scaling, rotation, mirror image.

use chordal_kernel::rules::*;

use super::choices::{Choices, SWITCH, choose, name_of};
use super::field::{SettingField, SettingInput, setting_fields};

const ANGLES: Choices<bool> = &[("absolute", false), ("adds", true)];

const ARCS: Choices<UnequalArcs> =
    &[("judged", UnequalArcs::Judged), ("refused", UnequalArcs::Refused)];

const OPTIONS: Choices<bool> = &[("present", true), ("absent", false)];

const CYCLES: Choices<bool> = &[("allowed", true), ("warned", false)];

const FACTORS: Choices<bool> = &[("one", false), ("each", true)];

const TIP_FRAMES: Choices<bool> = &[("table", false), ("stays", true)];

setting_fields! {
    FRAME_OF_TIP = choice(rules.frames.tip_frame_stays, TIP_FRAMES);
    FRAME_ANGLE_ADDS = choice(rules.frames.angle_adds, ANGLES);
    FRAME_OMITTED_ANGLE = custom(
        |p, input| {
            p.rules.frames.omitted_angle_deg = finite(input)?;
            Ok(())
        },
        |p, _| p.rules.frames.omitted_angle_deg.to_string()
    );
    /// The scale factor of an axis that G51 does not name.
    FRAME_OMITTED_FACTOR = custom(
        |p, input| {
            p.rules.frames.omitted_factors = [factor(input)?; 3];
            Ok(())
        },
        |p, _| p.rules.frames.omitted_factors[0].to_string()
    );
    FRAME_OMITTED_FACTOR_X = custom(
        |p, input| {
            p.rules.frames.omitted_factors[usize::from(input.index)] = factor(input)?;
            Ok(())
        },
        |p, index| p.rules.frames.omitted_factors[usize::from(index)].to_string()
    );
    FRAME_FACTORS_BY_VECTOR = choice(rules.frames.factors_by_vector, FACTORS);
    FRAME_UNEQUAL_ARCS = choice(rules.frames.unequal_arcs, ARCS);
    FRAME_IN_COMPENSATION = choice(rules.frames.in_compensation, SWITCH);
    FRAME_HAS_SCALING = choice(rules.frames.has_scaling, OPTIONS);
    FRAME_HAS_ROTATION = choice(rules.frames.has_rotation, OPTIONS);
    FRAME_CYCLES_ALONG_SCALED = choice(rules.frames.cycles_along_scaled, CYCLES);
}

#[allow(missing_docs, reason = "as those above")]
impl SettingField {
    pub const FRAME_OMITTED_FACTOR_Y: SettingField = SettingField::FRAME_OMITTED_FACTOR_X.at(1);
    pub const FRAME_OMITTED_FACTOR_Z: SettingField = SettingField::FRAME_OMITTED_FACTOR_X.at(2);
}

fn finite(input: &SettingInput<'_>) -> Result<f64, String> {
    Some(input.number()).filter(|number| number.is_finite()).ok_or_else(|| "a number".to_string())
}

fn factor(input: &SettingInput<'_>) -> Result<f64, String> {
    match finite(input)? {
        0.0 => Err("a number other than 0".to_string()),
        factor => Ok(factor),
    }
}

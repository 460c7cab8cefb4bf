//! Settings of the cycles of lathes.

use chordal_kernel::rules::FirstLevel;

use super::choices::{choose, mm_text, name_of};
use super::field::{SettingInput, setting_fields};

const FIRST_LEVELS: &[(&str, FirstLevel)] =
    &[("allowance", FirstLevel::Allowance), ("start", FirstLevel::Start)];

const RETURNS: &[(&str, bool)] = &[("left out", true), ("refused", false)];

const POINTS: &[(&str, bool)] = &[("allowed", true), ("reported", false)];

const STYLES: &[(&str, Option<u8>)] = &[("fanuc", None), ("yasnac", Some(b'R'))];

setting_fields! {
    TURNING_ROUGH_DEPTH = length(rules.turning.rough_depth_mm, EXAMPLE);
    TURNING_ROUGH_RETRACT = length(rules.turning.rough_retract_mm, EXAMPLE);
    TURNING_FIRST_LEVEL = choice(rules.turning.first_level, FIRST_LEVELS);
    TURNING_PECK_RETRACT = length(rules.turning.peck_retract_mm, EXAMPLE);
    TURNING_THREAD_EXIT = custom(
        |p, input| {
            p.rules.turning.thread_exit_leads = f64::from(up_to(input, 127)?) / 10.0;
            Ok(())
        },
        |p, _| (p.rules.turning.thread_exit_leads * 10.0).to_string()
    );
    TURNING_THREAD_LEAST = length(rules.turning.thread_least_mm, EXAMPLE);
    TURNING_THREAD_FINISH = length(rules.turning.thread_finish_mm, EXAMPLE);
    TURNING_THREAD_FINISH_PASSES = custom(
        |p, input| {
            p.rules.turning.thread_finish_passes = up_to(input, 99)?;
            Ok(())
        },
        |p, _| p.rules.turning.thread_finish_passes.to_string()
    );
    TURNING_THREAD_ANGLE = custom(
        |p, input| {
            p.rules.turning.thread_angle_deg = f64::from(up_to(input, 120)?);
            Ok(())
        },
        |p, _| p.rules.turning.thread_angle_deg.to_string()
    );
    TURNING_POCKETS_BY_R = choice(rules.turning.pockets_by, STYLES);
    TURNING_RETURN_OF_CONTOUR = choice(rules.turning.return_left_out, RETURNS);
    TURNING_THREAD_POINT = choice(rules.turning.thread_words_take_point, POINTS);
}

/// The length that messages give as an example.
const EXAMPLE: &str = "0.5 mm";

fn up_to(input: &SettingInput<'_>, most: u32) -> Result<u32, String> {
    input.whole(0..=most, &format!("a whole number up to {most}"))
}

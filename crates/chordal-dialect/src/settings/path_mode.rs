//! Settings of path modes, junctions and arc segments.

use chordal_kernel::rules::*;

use super::choices::{Choices, SWITCH, choose, mm_text, name_of};
use super::field::{SettingField, SettingInput, setting_fields};
use super::{Certainty, Setting, setting};
use crate::parameters::Parameters;

const STARTS: Choices<StartMode> = &[
    ("continuous", StartMode::Continuous),
    ("exact-path", StartMode::ExactPath),
    ("exact-stop", StartMode::ExactStop),
];

const LEVELS: Choices<u8> =
    &[("rough", 1), ("medium", 2), ("finish", 3), ("1", 1), ("2", 2), ("3", 3)];

// `$32=2` of grblHAL selects a lathe, which is no laser.
const LASER_MODES: Choices<bool> =
    &[("on", true), ("off", false), ("1", true), ("0", false), ("2", false)];

const SHORT_BLOCKS: Choices<ShortBlocks> = &[
    ("apart", ShortBlocks::Separate),
    ("look-ahead", ShortBlocks::LookAhead),
    ("joined", ShortBlocks::Joined),
];

/// The settings of every control, under common names.
pub const COMMON: &[Setting] = &[
    plain(
        "start_path_mode",
        SettingField::POWER_ON_PATH_MODE,
        "path mode at power-on: `continuous`, `exact-path` or `exact-stop`",
        Certainty::Practice,
    ),
    plain(
        "stop_before_cut",
        SettingField::PATH_STOP_BEFORE_CUT,
        "a rapid ends at rest before a cut: `on` or `off`",
        Certainty::Practice,
    ),
    plain(
        "stop_between_rapids",
        SettingField::PATH_STOP_BETWEEN_RAPIDS,
        "a rapid ends at rest before another rapid: `on` or `off`",
        Certainty::Unknown,
    ),
    plain(
        "stop_after_cut",
        SettingField::PATH_STOP_AFTER_CUT,
        "a cut ends at rest before a rapid: `on` or `off`",
        Certainty::Unknown,
    ),
];

/// The corner rounding in G64 of controls whose programs do not give it.
pub const CORNER_ROUNDING: Setting = setting(
    "corner rounding",
    SettingField::PATH_ROUNDING,
    &[],
    "how far from a corner the tool passes in G64; `none`: `[motion] corner_tolerance`",
    Certainty::Unknown,
    "G64",
);

/// Whether a control turns short blocks into one curve, with the source of that.
pub const fn short_blocks(certainty: Certainty, source: &'static str) -> Setting {
    setting(
        "short blocks",
        SettingField::PATH_SHORT_BLOCKS,
        &[],
        "many short blocks become one smooth curve within the tolerance: `joined`, `look-ahead` (only in \
         look-ahead and high-accuracy modes) or `apart` (each corner is passed by itself)",
        certainty,
        source,
    )
}

const fn plain(
    name: &'static str,
    field: SettingField,
    text: &'static str,
    certainty: Certainty,
) -> Setting {
    Setting { name, field, values: &[], text, certainty, source: "" }
}

setting_fields! {
    POWER_ON_PATH_MODE = choice(rules.path.start, STARTS);
    PATH_STOP_BEFORE_CUT = choice(rules.path.stop_before_cut, SWITCH);
    PATH_STOP_BETWEEN_RAPIDS = choice(rules.path.stop_between_rapids, SWITCH);
    PATH_STOP_AFTER_CUT = choice(rules.path.stop_after_cut, SWITCH);
    PATH_LASER_MODE = choice(rules.path.laser_mode, LASER_MODES);
    PATH_ROUNDING = custom(
        |p, input| {
            p.rules.path.rounding_mm = optional_length(input)?;
            Ok(())
        },
        |p, _| optional_text(p.rules.path.rounding_mm)
    );
    /// The fraction of the first smoothness level; the other levels have the next indexes.
    PATH_LEVEL_PART = custom(set_level_part, |p, index| {
        p.rules.path.level_parts[usize::from(index)].to_string()
    });
    PATH_LEVEL = choice(rules.path.level, LEVELS);
    PATH_LOOK_AHEAD = custom(
        |p, input| {
            p.rules.path.look_ahead_mm = optional_length(input)?;
            Ok(())
        },
        |p, _| optional_text(p.rules.path.look_ahead_mm)
    );
    PATH_SHORT_BLOCKS = choice(rules.path.short_blocks, SHORT_BLOCKS);
    PATH_JUNCTION_DEVIATION = custom(
        |p, input| {
            junctions(p)?.deviation_mm = length(input)?;
            Ok(())
        },
        |p, _| optional_text(p.rules.path.junctions.map(|junctions| junctions.deviation_mm))
    );
    PATH_ARC_TOLERANCE = custom(
        |p, input| {
            let above_zero = Some(length(input)?).filter(|tolerance| *tolerance > 0.0);
            junctions(p)?.arc_tolerance_mm = above_zero.ok_or("a length above zero")?;
            Ok(())
        },
        |p, _| optional_text(p.rules.path.junctions.map(|junctions| junctions.arc_tolerance_mm))
    );
    PATH_JUNCTION_JERK = custom(
        |p, input| {
            junctions(p)?.limited_jerk = choose(input.word, SWITCH)?;
            Ok(())
        },
        |p, _| name_of(p.rules.path.junctions.is_some_and(|junctions| junctions.limited_jerk), SWITCH)
    );
    PATH_ARC_SEGMENT_LEAST = custom(
        |p, input| {
            arc_segments(p)?.least_mm = length(input)?.max(MIN_ARC_SEGMENT_MM);
            Ok(())
        },
        |p, _| optional_text(segments_of(p).map(|segments| segments.least_mm))
    );
    PATH_ARC_SEGMENT_MOST = custom(
        |p, input| {
            arc_segments(p)?.most_mm = length(input)?.max(MIN_ARC_SEGMENT_MM);
            Ok(())
        },
        |p, _| optional_text(segments_of(p).map(|segments| segments.most_mm))
    );
    PATH_ARC_SEGMENTS_OF_CIRCLE = custom(
        |p, input| {
            let count = input.whole(1..=10_000, "a whole number, 1 or more")?;
            arc_segments(p)?.of_circle = count;
            Ok(())
        },
        |p, _| segments_of(p).map_or("none".to_string(), |segments| segments.of_circle.to_string())
    );
    /// The speed step of X at a junction; Y and Z have the next indexes.
    PATH_SPEED_STEP = custom(set_speed_step, |p, index| {
        let steps = p.rules.path.junctions.and_then(|junctions| junctions.speed_steps_mm_s);
        steps.map_or("none".to_string(), |steps| steps[usize::from(index)].to_string())
    });
    /// Steps per mm of X; Y and Z have the next indexes.
    PATH_STEPS = custom(
        |p, input| {
            let steps = Some(input.number()).filter(|steps| *steps > 0.0 && *steps < 1e6);
            junctions(p)?.steps_per_mm[usize::from(input.index)] =
                steps.ok_or("a number of steps above 0")?;
            Ok(())
        },
        |p, index| {
            p.rules.path.junctions.map_or("none".to_string(), |junctions| {
                junctions.steps_per_mm[usize::from(index)].to_string()
            })
        }
    );
    PATH_JUNCTION_BLOCKS = custom(
        |p, input| {
            let blocks = input.whole(1..=10_000, "a whole number, 1 or more")?;
            junctions(p)?.blocks = blocks;
            Ok(())
        },
        |p, _| p.rules.path.junctions.map_or("none".to_string(), |junctions| junctions.blocks.to_string())
    );
}

impl SettingField {
    /// The fraction of a smoothness level, 1 to 3.
    pub const fn path_level_part(level: u8) -> SettingField {
        SettingField::PATH_LEVEL_PART.at(level - 1)
    }

    /// The speed step at a junction of X (0), Y (1) or Z (2).
    pub const fn path_speed_step(axis: u8) -> SettingField {
        SettingField::PATH_SPEED_STEP.at(axis)
    }

    /// Steps per mm of X (0), Y (1) or Z (2).
    pub const fn path_steps(axis: u8) -> SettingField {
        SettingField::PATH_STEPS.at(axis)
    }
}

/// The shortest segments of arcs that are accepted, mm: shorter ones would make an arc of too many moves to compute.
const MIN_ARC_SEGMENT_MM: f64 = 1e-6;

fn length(input: &SettingInput<'_>) -> Result<f64, String> {
    let length = input.value.as_length_mm().ok().filter(|mm| *mm >= 0.0);
    length.ok_or_else(|| "a length with its unit, such as \"0.05 mm\", or `none`".to_string())
}

fn optional_length(input: &SettingInput<'_>) -> Result<Option<f64>, String> {
    if input.word.eq_ignore_ascii_case("none") { Ok(None) } else { length(input).map(Some) }
}

fn optional_text(mm: Option<f64>) -> String {
    mm.map_or("none".to_string(), mm_text)
}

fn set_level_part(p: &mut Parameters, input: &SettingInput<'_>) -> Result<(), String> {
    let part = Some(input.number()).filter(|part| *part > 0.0 && *part <= 10.0);
    p.rules.path.level_parts[usize::from(input.index)] =
        part.ok_or("a number above 0, at most 10")?;
    Ok(())
}

fn set_speed_step(p: &mut Parameters, input: &SettingInput<'_>) -> Result<(), String> {
    if input.word.eq_ignore_ascii_case("none") {
        junctions(p)?.speed_steps_mm_s = None;
        return Ok(());
    }
    let step = Some(input.number()).filter(|step| *step > 0.0 && *step < 1e6);
    let step = step.ok_or("a speed in mm/s above 0, or `none` for the junction deviation")?;
    let steps = junctions(p)?.speed_steps_mm_s.get_or_insert([f64::INFINITY; 3]);
    steps[usize::from(input.index)] = step;
    Ok(())
}

/// The junction rules, or the error for a control without any.
fn junctions(p: &mut Parameters) -> Result<&mut JunctionRules, String> {
    let none = "nothing: this control has no junction deviation";
    p.rules.path.junctions.as_mut().ok_or_else(|| none.to_string())
}

/// The rules of arc segments, or the error for a control that does not divide arcs by length.
fn arc_segments(p: &mut Parameters) -> Result<&mut ArcSegments, String> {
    let none = "nothing: this control does not cut arcs by the length of segments";
    junctions(p)?.arc_segments.as_mut().ok_or_else(|| none.to_string())
}

fn segments_of(p: &Parameters) -> Option<ArcSegments> {
    p.rules.path.junctions.and_then(|junctions| junctions.arc_segments)
}

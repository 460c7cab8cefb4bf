//! The rules of path modes as settings of a machine file.

use chordal_kernel::rules::*;
use chordal_machine::SettingValue;

use super::choices::{Choices, SWITCH, choose, mm_text, name_of};
use super::{Certainty, Setting, SettingField, setting};
use crate::parameters::Parameters;

/// The rule that a setting changes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "each names a field of `PathRules`")]
pub enum PathField {
    Start,
    StopBeforeCut,
    StopBetweenRapids,
    StopAfterCut,
    Rounding,
    /// The part of a level, 1 to 3.
    LevelPart(u8),
    Level,
    LookAhead,
    ShortBlocks,
    JunctionDeviation,
    JunctionBlocks,
    ArcTolerance,
    JunctionJerk,
    ArcSegmentLeast,
    ArcSegmentMost,
    ArcSegmentsOfCircle,
    /// The step of speed of X, Y or Z at a junction, by the number of the axis.
    SpeedStep(u8),
    /// Steps of X, Y or Z a mm, by the number of the axis.
    Steps(u8),
    LaserMode,
}

const STARTS: Choices<StartMode> = &[
    ("continuous", StartMode::Continuous),
    ("exact-path", StartMode::ExactPath),
    ("exact-stop", StartMode::ExactStop),
];

const LEVELS: Choices<u8> =
    &[("rough", 1), ("medium", 2), ("finish", 3), ("1", 1), ("2", 2), ("3", 3)];

// `$32=2` of grblHAL is a lathe.
const LASER_MODES: Choices<bool> =
    &[("on", true), ("off", false), ("1", true), ("0", false), ("2", false)];

const SHORT_BLOCKS: Choices<ShortBlocks> = &[
    ("apart", ShortBlocks::Separate),
    ("look-ahead", ShortBlocks::LookAhead),
    ("joined", ShortBlocks::Joined),
];

/// The settings that every control has, under plain names.
pub const COMMON: &[Setting] = &[
    plain(
        "start_path_mode",
        PathField::Start,
        "path mode at power-on: `continuous`, `exact-path` or `exact-stop`",
        Certainty::Trade,
    ),
    plain(
        "stop_before_cut",
        PathField::StopBeforeCut,
        "a rapid ends at rest before a cut: `on` or `off`",
        Certainty::Trade,
    ),
    plain(
        "stop_between_rapids",
        PathField::StopBetweenRapids,
        "a rapid ends at rest before another rapid: `on` or `off`",
        Certainty::Unknown,
    ),
    plain(
        "stop_after_cut",
        PathField::StopAfterCut,
        "a cut ends at rest before a rapid: `on` or `off`",
        Certainty::Unknown,
    ),
];

/// The distance in G64, of controls that name none.
pub const CORNER_ROUNDING: Setting = setting(
    "corner rounding",
    SettingField::Path(PathField::Rounding),
    &[],
    "how far from a corner the tool passes in G64; `none`: `[motion] corner_tolerance`",
    Certainty::Unknown,
    "G64",
);

/// Where short blocks become one curve, by what is known of a control.
pub const fn short_blocks(certainty: Certainty, source: &'static str) -> Setting {
    setting(
        "short blocks",
        SettingField::Path(PathField::ShortBlocks),
        &[],
        "many short blocks become one smooth curve within the tolerance: `joined`, `look-ahead` (only in \
         look-ahead and high-accuracy modes) or `apart` (each corner is passed by itself)",
        certainty,
        source,
    )
}

const fn plain(
    name: &'static str,
    field: PathField,
    text: &'static str,
    certainty: Certainty,
) -> Setting {
    Setting { name, field: SettingField::Path(field), values: &[], text, certainty, source: "" }
}

/// Sets one rule; the error says what it takes.
pub(crate) fn set(
    p: &mut Parameters,
    field: PathField,
    word: &str,
    value: &SettingValue,
) -> Result<(), String> {
    let length = || match value.as_length_mm() {
        Ok(mm) if mm >= 0.0 => Ok(mm),
        _ => Err("a length with its unit, such as \"0.05 mm\", or `none`".to_string()),
    };
    let optional = || if word.eq_ignore_ascii_case("none") { Ok(None) } else { length().map(Some) };
    let number = || match value {
        SettingValue::Integer(number) => *number as f64,
        SettingValue::Float(number) => *number,
        SettingValue::Text(_) | SettingValue::Bool(_) => f64::NAN,
    };
    let rules = &mut p.rules.path;
    match field {
        PathField::Start => rules.start = choose(word, STARTS)?,
        PathField::StopBeforeCut => rules.stop_before_cut = choose(word, SWITCH)?,
        PathField::StopBetweenRapids => rules.stop_between_rapids = choose(word, SWITCH)?,
        PathField::LaserMode => rules.laser_mode = choose(word, LASER_MODES)?,
        PathField::StopAfterCut => rules.stop_after_cut = choose(word, SWITCH)?,
        PathField::Rounding => rules.rounding_mm = optional()?,
        PathField::LevelPart(level) => {
            let part = number();
            if !(part > 0.0 && part <= 10.0) {
                return Err("a number above 0, at most 10".to_string());
            }
            rules.level_parts[usize::from(level.clamp(1, 3)) - 1] = part;
        }
        PathField::Level => rules.level = choose(word, LEVELS)?,
        PathField::LookAhead => rules.look_ahead_mm = optional()?,
        PathField::ShortBlocks => rules.short_blocks = choose(word, SHORT_BLOCKS)?,
        PathField::JunctionDeviation => junctions(rules)?.deviation_mm = length()?,
        PathField::ArcTolerance => {
            let above_zero = Some(length()?).filter(|tolerance| *tolerance > 0.0);
            junctions(rules)?.arc_tolerance_mm = above_zero.ok_or("a length above zero")?;
        }
        PathField::JunctionJerk => junctions(rules)?.limited_jerk = choose(word, SWITCH)?,
        PathField::ArcSegmentLeast => arc_segments(rules)?.least_mm = length()?.max(1e-6),
        PathField::ArcSegmentMost => arc_segments(rules)?.most_mm = length()?.max(1e-6),
        PathField::ArcSegmentsOfCircle => match value {
            SettingValue::Integer(count @ 1..=10_000) => {
                arc_segments(rules)?.of_circle = *count as u32;
            }
            _ => return Err("a whole number, 1 or more".to_string()),
        },
        PathField::SpeedStep(_) if word.eq_ignore_ascii_case("none") => {
            junctions(rules)?.speed_steps_mm_s = None;
        }
        PathField::SpeedStep(axis) => {
            let step = Some(number()).filter(|step| *step > 0.0 && *step < 1e6);
            let step =
                step.ok_or("a speed in mm/s above 0, or `none` for the junction deviation")?;
            let steps = junctions(rules)?.speed_steps_mm_s.get_or_insert([f64::INFINITY; 3]);
            steps[usize::from(axis.min(2))] = step;
        }
        PathField::JunctionBlocks => match value {
            SettingValue::Integer(count @ 1..=10_000) => junctions(rules)?.blocks = *count as u32,
            _ => return Err("a whole number, 1 or more".to_string()),
        },
        PathField::Steps(axis) => {
            let steps = Some(number()).filter(|steps| *steps > 0.0 && *steps < 1e6);
            junctions(rules)?.steps_per_mm[usize::from(axis.min(2))] =
                steps.ok_or("a number of steps above 0")?;
        }
    }
    Ok(())
}

/// The rules of junctions of a control that has them.
fn junctions(rules: &mut PathRules) -> Result<&mut JunctionRules, String> {
    let none = "nothing: this control has no junction deviation";
    rules.junctions.as_mut().ok_or_else(|| none.to_string())
}

/// The rules of segments of a control that cuts arcs by their length.
fn arc_segments(rules: &mut PathRules) -> Result<&mut ArcSegments, String> {
    let none = "nothing: this control does not cut arcs by the length of segments";
    junctions(rules)?.arc_segments.as_mut().ok_or_else(|| none.to_string())
}

/// The present value of a rule, as a machine file writes it.
pub(crate) fn value_text(p: &Parameters, field: PathField) -> String {
    let rules = &p.rules.path;
    let optional = |mm: Option<f64>| mm.map_or("none".to_string(), mm_text);
    let segments = rules.junctions.and_then(|junctions| junctions.arc_segments);
    match field {
        PathField::Start => name_of(rules.start, STARTS),
        PathField::StopBeforeCut => name_of(rules.stop_before_cut, SWITCH),
        PathField::StopBetweenRapids => name_of(rules.stop_between_rapids, SWITCH),
        PathField::LaserMode => name_of(rules.laser_mode, LASER_MODES),
        PathField::StopAfterCut => name_of(rules.stop_after_cut, SWITCH),
        PathField::Rounding => optional(rules.rounding_mm),
        PathField::LevelPart(level) => {
            rules.level_parts[usize::from(level.clamp(1, 3)) - 1].to_string()
        }
        PathField::Level => name_of(rules.level, LEVELS),
        PathField::LookAhead => optional(rules.look_ahead_mm),
        PathField::ShortBlocks => name_of(rules.short_blocks, SHORT_BLOCKS),
        PathField::JunctionDeviation => optional(rules.junctions.map(|j| j.deviation_mm)),
        PathField::ArcTolerance => optional(rules.junctions.map(|j| j.arc_tolerance_mm)),
        PathField::Steps(axis) => rules.junctions.map_or("none".to_string(), |junctions| {
            junctions.steps_per_mm[usize::from(axis.min(2))].to_string()
        }),
        PathField::ArcSegmentLeast => optional(segments.map(|segments| segments.least_mm)),
        PathField::ArcSegmentMost => optional(segments.map(|segments| segments.most_mm)),
        PathField::ArcSegmentsOfCircle => {
            segments.map_or("none".to_string(), |segments| segments.of_circle.to_string())
        }
        PathField::SpeedStep(axis) => {
            let steps = rules.junctions.and_then(|junctions| junctions.speed_steps_mm_s);
            steps.map_or("none".to_string(), |steps| steps[usize::from(axis.min(2))].to_string())
        }
        PathField::JunctionJerk => {
            name_of(rules.junctions.is_some_and(|junctions| junctions.limited_jerk), SWITCH)
        }
        PathField::JunctionBlocks => {
            rules.junctions.map_or("none".to_string(), |junctions| junctions.blocks.to_string())
        }
    }
}

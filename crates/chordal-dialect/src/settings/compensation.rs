//! The rules of cutter compensation as settings of a machine file.

use chordal_kernel::rules::*;
use chordal_machine::SettingValue;

use super::choices::{Choices, SWITCH, choose, mm_text, name_of};
use super::{Certainty, Setting, SettingField, setting};
use crate::parameters::Parameters;

/// The rule that a setting changes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "each names a field of `CompensationRules`")]
pub enum CompensationField {
    Tangent,
    DropLink,
    IdleBlocks,
    /// Blocks read ahead: two more than may stand without motion.
    BlocksRead,
    ZeroMoveCounts,
    StopsEndLookAhead,
    /// G41 and G40 without a move.
    Alone,
    OffToward,
    StartOnArc,
    Repeated,
    SideChange,
    NewOffset,
    NewOffsetOnArc,
    Lead,
    Planes,
    Interference,
    /// Whether the control looks for interference at all.
    Check,
    Remedy,
    EqualRadius,
    Spirals,
    CoordinateChange,
    InsideFeed,
}

const ALONE: Choices<AloneAction> =
    &[("waits", AloneAction::Waits), ("perpendicular", AloneAction::Perpendicular)];
const REPEATED: Choices<RepeatedCodeRule> = &[
    ("ignored", RepeatedCodeRule::Ignored),
    ("perpendicular", RepeatedCodeRule::Perpendicular),
    ("refused", RepeatedCodeRule::Refused),
];
const SIDE_CHANGES: Choices<SideChange> = &[
    ("crossing", SideChange::Crossing),
    ("along", SideChange::Along),
    ("refused-on-line", SideChange::RefusedOnLine),
    ("refused", SideChange::Refused),
];
const ALLOWANCES: Choices<AllowanceRule> = &[
    ("allowed", AllowanceRule::Allowed),
    ("ignored", AllowanceRule::Ignored),
    ("refused", AllowanceRule::Refused),
];
const LEADS: Choices<LeadLength> = &[
    ("any", LeadLength::Any),
    ("at-least-offset", LeadLength::AtLeastOffset),
    ("above-offset", LeadLength::AboveOffset),
];
const PLANES: Choices<CompensationPlanes> = &[
    ("all", CompensationPlanes::All),
    ("not-yz", CompensationPlanes::NotYz),
    ("xy", CompensationPlanes::XyOnly),
];
const CHECKS: Choices<InterferenceSearch> = &[
    ("direction", InterferenceSearch::Direction),
    ("arc-angle", InterferenceSearch::ArcAngle),
    ("vectors", InterferenceSearch::Vectors),
    ("strict", InterferenceSearch::Strict),
];
const REMEDIES: Choices<InterferenceRemedy> =
    &[("alarm", InterferenceRemedy::Alarm), ("avoid", InterferenceRemedy::Avoid)];
const EQUAL: Choices<bool> = &[("refused", true), ("allowed", false)];
const SPIRALS: Choices<SpiralCompensation> =
    &[("refused", SpiralCompensation::Refused), ("circles", SpiralCompensation::ByCircles)];

/// The settings of compensation that every control has, under plain names.
pub const COMMON: &[Setting] = &[
    plain(
        "compensation_tangent_joint",
        CompensationField::Tangent,
        "offset paths that lie closer than this at a joint count as tangent",
    ),
    plain(
        "compensation_idle_blocks",
        CompensationField::IdleBlocks,
        "most blocks without motion between two moves of a compensated contour, or `no limit`",
    ),
    plain(
        "compensation_zero_move",
        CompensationField::ZeroMoveCounts,
        "a move of length zero counts as this many blocks without motion",
    ),
    plain(
        "compensation_stops_end_look_ahead",
        CompensationField::StopsEndLookAhead,
        "M0 and M1 end the look-ahead: `on` or `off`",
    ),
    plain(
        "compensation_alone",
        CompensationField::Alone,
        "G41 or G40 without a move: `waits`, or offsets the tool at once (`perpendicular`)",
    ),
    plain(
        "compensation_cancel_direction",
        CompensationField::OffToward,
        "G40 with I J ends the contour at the crossing with that direction: `on` or `off`",
    ),
    plain(
        "compensation_start_on_arc",
        CompensationField::StartOnArc,
        "compensation may start on an arc: `on` or `off`",
    ),
    plain(
        "compensation_repeated",
        CompensationField::Repeated,
        "the same G41 again: `ignored`, `perpendicular` or `refused`",
    ),
    plain(
        "compensation_side_change",
        CompensationField::SideChange,
        "G41 to G42: at the `crossing` of the offsets, `along` the block, `refused-on-line` or `refused`",
    ),
    plain(
        "compensation_new_offset",
        CompensationField::NewOffset,
        "a new D while compensation is on: `allowed`, `ignored` or `refused`",
    ),
    plain(
        "compensation_new_offset_on_arc",
        CompensationField::NewOffsetOnArc,
        "a new D in the block of an arc: `allowed` or `refused`",
    ),
    plain(
        "compensation_lead",
        CompensationField::Lead,
        "length of the first move: `any`, `at-least-offset` or `above-offset`",
    ),
    plain("compensation_planes", CompensationField::Planes, "`all`, `not-yz` or `xy`"),
    plain(
        "compensation_interference",
        CompensationField::Interference,
        "how the control checks for interference: `direction`, `arc-angle`, `vectors` or `strict`",
    ),
    plain(
        "compensation_check",
        CompensationField::Check,
        "the control checks for interference: `on` or `off`",
    ),
    plain(
        "compensation_remedy",
        CompensationField::Remedy,
        "where a block interferes: `alarm`, or skip it (`avoid`)",
    ),
    plain(
        "compensation_equal_radius",
        CompensationField::EqualRadius,
        "an inside arc of exactly the offset: `allowed` or `refused`",
    ),
    plain(
        "compensation_spirals",
        CompensationField::Spirals,
        "spirals: `refused`, or offset as `circles`",
    ),
    plain(
        "compensation_coordinate_change",
        CompensationField::CoordinateChange,
        "G28, G52, G92 or a new work offset while compensation is on: `allowed` or `refused`",
    ),
];

const fn plain(name: &'static str, field: CompensationField, text: &'static str) -> Setting {
    setting(name, SettingField::Compensation(field), &[], text, Certainty::Unknown, "")
}

/// Sets one rule; the error says what it takes.
pub(crate) fn set(
    p: &mut Parameters,
    field: CompensationField,
    word: &str,
    value: &SettingValue,
) -> Result<(), String> {
    let length = || {
        value.as_length_mm().map_err(|_| "a length with its unit, such as \"0.002 mm\"".to_string())
    };
    let rules = &mut p.rules.compensation;
    match field {
        CompensationField::Tangent => rules.tangent_mm = length()?,
        CompensationField::DropLink => rules.drop_link_mm = length()?,
        CompensationField::IdleBlocks if word == NO_LIMIT => rules.idle_blocks = None,
        CompensationField::IdleBlocks => rules.idle_blocks = Some(count(value, 0..=1000)?),
        CompensationField::BlocksRead => rules.idle_blocks = Some(count(value, 3..=8)? - 2),
        CompensationField::ZeroMoveCounts => rules.zero_move_counts = count(value, 0..=8)?,
        CompensationField::StopsEndLookAhead => {
            rules.stops_end_look_ahead = choose(word, SWITCH)?;
        }
        CompensationField::Alone => {
            rules.on_alone = choose(word, ALONE)?;
            rules.off_alone = rules.on_alone;
        }
        CompensationField::OffToward => rules.off_toward = choose(word, SWITCH)?,
        CompensationField::StartOnArc => rules.start_on_arc = choose(word, SWITCH)?,
        CompensationField::Repeated => rules.repeated = choose(word, REPEATED)?,
        CompensationField::SideChange => rules.side_change = choose(word, SIDE_CHANGES)?,
        CompensationField::NewOffset => rules.new_offset = choose(word, ALLOWANCES)?,
        CompensationField::NewOffsetOnArc => rules.new_offset_on_arc = choose(word, ALLOWANCES)?,
        CompensationField::Lead => rules.lead = choose(word, LEADS)?,
        CompensationField::Planes => rules.planes = choose(word, PLANES)?,
        CompensationField::Interference => rules.interference = choose(word, CHECKS)?,
        CompensationField::Check => rules.checks = choose(word, SWITCH)?,
        CompensationField::Remedy => rules.remedy = choose(word, REMEDIES)?,
        CompensationField::EqualRadius => rules.equal_radius_refused = choose(word, EQUAL)?,
        CompensationField::Spirals => rules.spirals = choose(word, SPIRALS)?,
        CompensationField::CoordinateChange => {
            rules.coordinate_change = choose(word, ALLOWANCES)?;
        }
        CompensationField::InsideFeed => {
            rules.inside_feed_least = f64::from(count(value, 1..=100)?) / 100.0;
        }
    }
    Ok(())
}

const NO_LIMIT: &str = "no limit";

/// The present value of a rule, as a machine file writes it.
pub(crate) fn value_text(p: &Parameters, field: CompensationField) -> String {
    let rules = &p.rules.compensation;
    let limit = |extra: u32| match rules.idle_blocks {
        Some(blocks) => (blocks.saturating_add(extra)).to_string(),
        None => NO_LIMIT.to_string(),
    };
    match field {
        CompensationField::Tangent => mm_text(rules.tangent_mm),
        CompensationField::DropLink => mm_text(rules.drop_link_mm),
        CompensationField::IdleBlocks => limit(0),
        CompensationField::BlocksRead => limit(2),
        CompensationField::ZeroMoveCounts => rules.zero_move_counts.to_string(),
        CompensationField::StopsEndLookAhead => name_of(rules.stops_end_look_ahead, SWITCH),
        CompensationField::Alone => name_of(rules.on_alone, ALONE),
        CompensationField::OffToward => name_of(rules.off_toward, SWITCH),
        CompensationField::StartOnArc => name_of(rules.start_on_arc, SWITCH),
        CompensationField::Repeated => name_of(rules.repeated, REPEATED),
        CompensationField::SideChange => name_of(rules.side_change, SIDE_CHANGES),
        CompensationField::NewOffset => name_of(rules.new_offset, ALLOWANCES),
        CompensationField::NewOffsetOnArc => name_of(rules.new_offset_on_arc, ALLOWANCES),
        CompensationField::Lead => name_of(rules.lead, LEADS),
        CompensationField::Planes => name_of(rules.planes, PLANES),
        CompensationField::Interference => name_of(rules.interference, CHECKS),
        CompensationField::Check => name_of(rules.checks, SWITCH),
        CompensationField::Remedy => name_of(rules.remedy, REMEDIES),
        CompensationField::EqualRadius => name_of(rules.equal_radius_refused, EQUAL),
        CompensationField::Spirals => name_of(rules.spirals, SPIRALS),
        CompensationField::CoordinateChange => name_of(rules.coordinate_change, ALLOWANCES),
        CompensationField::InsideFeed => {
            format!("{}", (rules.inside_feed_least * 100.0).round())
        }
    }
}

fn count(value: &SettingValue, range: std::ops::RangeInclusive<u32>) -> Result<u32, String> {
    let provided = match value {
        SettingValue::Integer(number) => u32::try_from(*number).ok(),
        _ => None,
    };
    provided
        .filter(|number| range.contains(number))
        .ok_or_else(|| format!("a whole number from {} to {}", range.start(), range.end()))
}

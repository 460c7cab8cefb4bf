//! Settings of cutter compensation.

use chordal_kernel::rules::*;

use super::choices::{Choices, SWITCH, choose, mm_text, name_of};
use super::field::{SettingField, setting_fields};
use super::{Certainty, Setting, setting};
use crate::parameters::Parameters;

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

/// The settings of every control, under common names.
pub const COMMON: &[Setting] = &[
    plain(
        "compensation_tangent_joint",
        SettingField::COMPENSATION_TANGENT,
        "offset paths that lie closer than this at a joint count as tangent",
    ),
    plain(
        "compensation_idle_blocks",
        SettingField::COMPENSATION_IDLE_BLOCKS,
        "most blocks without motion between two moves of a compensated contour, or `no limit`",
    ),
    plain(
        "compensation_zero_move",
        SettingField::COMPENSATION_ZERO_MOVE_COUNTS,
        "a move of length zero counts as this many blocks without motion",
    ),
    plain(
        "compensation_stops_end_look_ahead",
        SettingField::COMPENSATION_STOPS_END_LOOK_AHEAD,
        "M0 and M1 end the look-ahead: `on` or `off`",
    ),
    plain(
        "compensation_alone",
        SettingField::COMPENSATION_ALONE,
        "G41 or G40 without a move: `waits`, or offsets the tool at once (`perpendicular`)",
    ),
    plain(
        "compensation_cancel_direction",
        SettingField::COMPENSATION_OFF_TOWARD,
        "G40 with I J ends the contour at the crossing with that direction: `on` or `off`",
    ),
    plain(
        "compensation_start_on_arc",
        SettingField::COMPENSATION_START_ON_ARC,
        "compensation may start on an arc: `on` or `off`",
    ),
    plain(
        "compensation_repeated",
        SettingField::COMPENSATION_REPEATED,
        "the same G41 again: `ignored`, `perpendicular` or `refused`",
    ),
    plain(
        "compensation_side_change",
        SettingField::COMPENSATION_SIDE_CHANGE,
        "G41 to G42: at the `crossing` of the offsets, `along` the block, `refused-on-line` or `refused`",
    ),
    plain(
        "compensation_new_offset",
        SettingField::COMPENSATION_NEW_OFFSET,
        "a new D while compensation is on: `allowed`, `ignored` or `refused`",
    ),
    plain(
        "compensation_new_offset_on_arc",
        SettingField::COMPENSATION_NEW_OFFSET_ON_ARC,
        "a new D in the block of an arc: `allowed` or `refused`",
    ),
    plain(
        "compensation_lead",
        SettingField::COMPENSATION_LEAD,
        "length of the first move: `any`, `at-least-offset` or `above-offset`",
    ),
    plain("compensation_planes", SettingField::COMPENSATION_PLANES, "`all`, `not-yz` or `xy`"),
    plain(
        "compensation_interference",
        SettingField::COMPENSATION_INTERFERENCE,
        "how the control checks for interference: `direction`, `arc-angle`, `vectors` or `strict`",
    ),
    plain(
        "compensation_check",
        SettingField::COMPENSATION_CHECK,
        "the control checks for interference: `on` or `off`",
    ),
    plain(
        "compensation_remedy",
        SettingField::COMPENSATION_REMEDY,
        "where a block interferes: `alarm`, or skip it (`avoid`)",
    ),
    plain(
        "compensation_equal_radius",
        SettingField::COMPENSATION_EQUAL_RADIUS,
        "an inside arc of exactly the offset: `allowed` or `refused`",
    ),
    plain(
        "compensation_spirals",
        SettingField::COMPENSATION_SPIRALS,
        "spirals: `refused`, or offset as `circles`",
    ),
    plain(
        "compensation_coordinate_change",
        SettingField::COMPENSATION_COORDINATE_CHANGE,
        "G28, G52, G92 or a new work offset while compensation is on: `allowed` or `refused`",
    ),
];

const fn plain(name: &'static str, field: SettingField, text: &'static str) -> Setting {
    setting(name, field, &[], text, Certainty::Unknown, "")
}

setting_fields! {
    COMPENSATION_TANGENT = length(rules.compensation.tangent_mm, EXAMPLE);
    COMPENSATION_DROP_LINK = length(rules.compensation.drop_link_mm, EXAMPLE);
    COMPENSATION_IDLE_BLOCKS = custom(
        |p, input| {
            let limited = input.word != NO_LIMIT;
            p.rules.compensation.idle_blocks = if limited { Some(input.between(0, 1000)?) } else { None };
            Ok(())
        },
        |p, _| idle_blocks_text(p, 0)
    );
    /// Blocks read ahead: two more than the blocks without motion that are allowed in a row.
    COMPENSATION_BLOCKS_READ = custom(
        |p, input| {
            p.rules.compensation.idle_blocks = Some(input.between(3, 8)? - 2);
            Ok(())
        },
        |p, _| idle_blocks_text(p, 2)
    );
    COMPENSATION_ZERO_MOVE_COUNTS = custom(
        |p, input| {
            p.rules.compensation.zero_move_counts = input.between(0, 8)?;
            Ok(())
        },
        |p, _| p.rules.compensation.zero_move_counts.to_string()
    );
    COMPENSATION_STOPS_END_LOOK_AHEAD = choice(rules.compensation.stops_end_look_ahead, SWITCH);
    /// G41 and G40 in a block without a move.
    COMPENSATION_ALONE = custom(
        |p, input| {
            let rules = &mut p.rules.compensation;
            rules.on_alone = choose(input.word, ALONE)?;
            rules.off_alone = rules.on_alone;
            Ok(())
        },
        |p, _| name_of(p.rules.compensation.on_alone, ALONE)
    );
    COMPENSATION_OFF_TOWARD = choice(rules.compensation.off_toward, SWITCH);
    COMPENSATION_START_ON_ARC = choice(rules.compensation.start_on_arc, SWITCH);
    COMPENSATION_REPEATED = choice(rules.compensation.repeated, REPEATED);
    COMPENSATION_SIDE_CHANGE = choice(rules.compensation.side_change, SIDE_CHANGES);
    COMPENSATION_NEW_OFFSET = choice(rules.compensation.new_offset, ALLOWANCES);
    COMPENSATION_NEW_OFFSET_ON_ARC = choice(rules.compensation.new_offset_on_arc, ALLOWANCES);
    COMPENSATION_LEAD = choice(rules.compensation.lead, LEADS);
    COMPENSATION_PLANES = choice(rules.compensation.planes, PLANES);
    COMPENSATION_INTERFERENCE = choice(rules.compensation.interference, CHECKS);
    /// Whether the control checks for interference.
    COMPENSATION_CHECK = choice(rules.compensation.checks, SWITCH);
    COMPENSATION_REMEDY = choice(rules.compensation.remedy, REMEDIES);
    COMPENSATION_EQUAL_RADIUS = choice(rules.compensation.equal_radius_refused, EQUAL);
    COMPENSATION_SPIRALS = choice(rules.compensation.spirals, SPIRALS);
    COMPENSATION_COORDINATE_CHANGE = choice(rules.compensation.coordinate_change, ALLOWANCES);
    COMPENSATION_INSIDE_FEED = custom(
        |p, input| {
            p.rules.compensation.inside_feed_least = f64::from(input.between(1, 100)?) / 100.0;
            Ok(())
        },
        |p, _| (p.rules.compensation.inside_feed_least * 100.0).round().to_string()
    );
}

/// The length that messages give as an example.
const EXAMPLE: &str = "0.002 mm";

const NO_LIMIT: &str = "no limit";

/// The largest number of blocks without motion, plus `extra`.
fn idle_blocks_text(p: &Parameters, extra: u32) -> String {
    let blocks = p.rules.compensation.idle_blocks;
    blocks.map_or(NO_LIMIT.to_string(), |blocks| blocks.saturating_add(extra).to_string())
}

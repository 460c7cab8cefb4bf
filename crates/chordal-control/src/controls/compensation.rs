//! Cutter radius compensation of the five controls: their rules and their settings.
//!
//! A rule without a manual's word behind it is a setting with a plain name that all controls
//! share; see [`crate::compensation_settings::COMMON`].

use crate::compensation::{
    Allowance, CompensationPlanes, CompensationRules, Interference, LeadLength, Repeated,
    SideChange, SpiralCompensation,
};
use crate::compensation_settings::CompensationField as C;
use crate::settings::{Certainty, Field, Setting, setting};

/// Fadal User Manual section 10, and the start-up of its contoured slot, which works only with
/// a vector square to the next block.
pub const FADAL: CompensationRules = CompensationRules {
    side_change: SideChange::RefusedOnLine,
    coordinate_change: Allowance::Refused,
    ..CompensationRules::COMMON
};

/// Haas Mill NGC Operator's Manual (2017), cutter compensation.
pub const HAAS: CompensationRules = CompensationRules {
    side_change: SideChange::Along,
    // The note on thread milling: longer than the amount that is compensated.
    lead: LeadLength::AboveOffset,
    planes: CompensationPlanes::XyOnly,
    new_offset_on_arc: Allowance::Refused,
    inside_feed_least: 0.5,
    ..CompensationRules::COMMON
};

/// Fanuc 16i and 30i: three blocks are read ahead, so one without motion may stand between.
pub const FANUC: CompensationRules = CompensationRules {
    idle_blocks: Some(1),
    zero_move_counts: 2,
    off_toward: true,
    repeated: Repeated::Perpendicular,
    spirals: SpiralCompensation::ByCircles,
    ..CompensationRules::COMMON
};

/// Mitsubishi M700V manual: fewer than four blocks without motion, and no M0, M1, M2, M30.
pub const MITSUBISHI: CompensationRules = CompensationRules {
    idle_blocks: Some(3),
    stops_end_look_ahead: true,
    off_toward: true,
    interference: Interference::Vectors,
    ..CompensationRules::COMMON
};

/// LinuxCNC 2.9, as its interpreter does it.
pub const LINUXCNC: CompensationRules = CompensationRules {
    tangent_rad: 0.05,
    start_on_arc: true,
    repeated: Repeated::Refused,
    side_change: SideChange::Refused,
    new_offset: Allowance::Refused,
    lead: LeadLength::AboveOffset,
    lead_follows_code: true,
    planes: CompensationPlanes::NotYz,
    interference: Interference::Strict,
    equal_radius_refused: true,
    longer_arc_rad: [0.0254, 0.001],
    coordinate_change: Allowance::Refused,
    offset_of_tool: true,
    ..CompensationRules::COMMON
};

const fn rule(
    name: &'static str,
    field: C,
    values: &'static [(&'static str, &'static str)],
    text: &'static str,
    certainty: Certainty,
    source: &'static str,
) -> Setting {
    setting(name, Field::Compensation(field), values, text, certainty, source)
}

/// SUP.
pub const FANUC_TYPE: Setting = setting(
    "No. 5003#0",
    Field::CompensationEntry,
    &[("0", "A"), ("1", "B")],
    "SUP: start-up and cancel of compensation by type A or B",
    Certainty::Trade,
    "16i, 30i",
);

/// SUV.
pub const FANUC_TYPE_C: Setting = rule(
    "No. 5003#1",
    C::Alone,
    &[("0", "waits"), ("1", "perpendicular")],
    "SUV: G41 or G40 alone waits for the next move (0), or offsets the tool at once (1, type C)",
    Certainty::Trade,
    "16i, 30i",
);

/// CNC.
pub const FANUC_ANGLES_ONLY: Setting = rule(
    "No. 5008#1",
    C::Interference,
    &[("0", "direction"), ("1", "arc-angle")],
    "CNC: interference is checked by the direction and angle of the moves, or only by the angle of arcs",
    Certainty::Trade,
    "16i, 30i",
);

/// CNV.
pub const FANUC_NO_CHECK: Setting = rule(
    "No. 5008#3",
    C::Check,
    &[("0", "on"), ("1", "off")],
    "CNV: interference is looked for (0) or not (1)",
    Certainty::Trade,
    "16i, 30i",
);

/// The length of a link that is left out.
pub const FANUC_LINK: Setting = rule(
    "No. 5010",
    C::DropLink,
    &[],
    "links round an outside corner that are not longer than this on either axis are left out",
    Certainty::Trade,
    "16i, 30i",
);

/// Blocks read ahead.
pub const FANUC_BLOCKS_READ: Setting = rule(
    "No. 19625",
    C::BlocksRead,
    &[],
    "blocks read ahead in compensation, 3 to 8; two fewer may be without motion between two moves",
    Certainty::Documented,
    "B-63944EN",
);

/// The same on 15i.
pub const FANUC_BLOCKS_READ_15I: Setting =
    rule("No. 6009", C::BlocksRead, &[], "the same on 15i", Certainty::Documented, "B-63324EN");

/// CCC.
pub const FANUC_CORNER: Setting = setting(
    "No. 19607#2",
    Field::OutsideCorner,
    &[("0", "linear"), ("1", "arc")],
    "CCC: outside corners by straight lines or by arcs",
    Certainty::Trade,
    "30i",
);

/// CAV.
pub const FANUC_AVOIDANCE: Setting = rule(
    "No. 19607#5",
    C::Remedy,
    &[("0", "alarm"), ("1", "avoid")],
    "CAV: where a block interferes, alarm PS0041 or leave the block out",
    Certainty::Trade,
    "30i",
);

/// Type A or B.
pub const MITSUBISHI_TYPE: Setting = setting(
    "#1229 set01/bit2",
    Field::CompensationEntry,
    &[("0", "A"), ("1", "B")],
    "start-up and cancel of compensation by type A or B",
    Certainty::Documented,
    "M700V, tool radius compensation",
);

/// Avoidance.
pub const MITSUBISHI_AVOIDANCE: Setting = rule(
    "#8102",
    C::Remedy,
    &[("0", "alarm"), ("1", "avoid")],
    "COLL. ALM OFF: where a block interferes, P153 or leave the block out",
    Certainty::Documented,
    "M700V, interference check",
);

/// No check.
pub const MITSUBISHI_NO_CHECK: Setting = rule(
    "#8103",
    C::Check,
    &[("0", "on"), ("1", "off")],
    "COLL. CHK OFF: interference is looked for (0) or not (1)",
    Certainty::Documented,
    "M700V, interference check",
);

/// Feed of inside arcs.
pub const HAAS_INSIDE_FEED: Setting = rule(
    "Setting 44",
    C::InsideFeed,
    &[],
    "inside arcs are fed at F(R-r)/R, but not below this percentage of F; 100 for F as it is",
    Certainty::Trade,
    "Setting 44, Min F in Radius CC %",
);

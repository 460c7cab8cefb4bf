//! The settings of Mitsubishi M700 and M800, by the names of its manuals.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    setting(
        "high-accuracy tolerance",
        SettingField::PATH_LOOK_AHEAD,
        &[],
        "how far from a corner the tool may pass with G61.1, G08 P1, G05.1 Q1 and G05 P10000: the control has a coefficient of corner accuracy instead, so this value is assumed",
        Certainty::Unknown,
        "high-accuracy control",
    ),
    short_blocks(
        Certainty::Practice,
        "high-accuracy control and SSS: the speed follows the shape over many blocks",
    ),
    CORNER_ROUNDING,
    TYPE,
    AVOIDANCE,
    NO_CHECK,
    setting(
        "#1084 RadErr",
        SettingField::RADIUS_ERROR_TOLERANCE,
        &[],
        "largest difference of an arc's radii at start and end; above it P70",
        Certainty::Documented,
        "M700V manual, #1084",
    ),
    setting(
        "#11028",
        SettingField::SEMICIRCLE_TOLERANCE,
        &[("0", "two-increments")],
        "|2R - chord| up to here makes the middle of the chord the centre; 0 of the manual is `two-increments`",
        Certainty::Documented,
        "M700V manual, #11028",
    ),
    setting(
        "#1272 ex08/bit2",
        SettingField::SPIRAL,
        &[("0", "pitches"), ("1", "increment-height-count")],
        "spiral commands: type 1 (G2.1, G3.1 with P) or type 2 (G2, G3 with Q, K, L)",
        Certainty::Documented,
        "M700V manual 6.13",
    ),
    setting(
        "spiral on the ray",
        SettingField::SPIRAL_ON_RAY,
        &[],
        "type 2: a spiral with L whose start and end are on one ray from the centre: L1 is `no-turn` or a `full-turn`",
        Certainty::Inferred,
        "M700V manual 6.13: L1 is less than a turn",
    ),
    setting(
        "machine_move",
        SettingField::MACHINE_MOVE,
        &[],
        "a move of G53 is a `rapid`, or uses the active motion code (`in-force`)",
        Certainty::Practice,
        "M700V manual, G53",
    ),
    setting(
        "excess_decimals",
        SettingField::EXCESS_DECIMALS,
        &[],
        "decimals beyond the least increment: `cut`, `rounded` or `exact`",
        Certainty::Practice,
        "M700V manual 5.3",
    ),
    setting(
        "#1235 set07/bit0",
        SettingField::HELIX_FEED,
        &[("0", "path"), ("1", "plane")],
        "F of a helix: composite of the three axes, or of the arc plane",
        Certainty::Documented,
        "M700V manual, helical interpolation",
    ),
    setting(
        "#1078 Decpt2",
        SettingField::DECIMAL_POINT,
        &[("0", "least-increment"), ("1", "calculator")],
        "a number without a decimal point",
        Certainty::Practice,
        "",
    ),
    setting("#8012", SettingField::CHIP_BREAK, &[], "lift of G73", Certainty::Practice, ""),
    setting("#8013", SettingField::PECK_CLEARANCE, &[], "clearance of G83", Certainty::Practice, ""),
    setting(
        "#1080 Dril_Z",
        SettingField::CYCLE_AXIS,
        &[("1", "z"), ("0", "plane-normal")],
        "cycles drill along Z, or along the normal of the plane",
        Certainty::Practice,
        "",
    ),
    setting(
        "G73 dwell",
        SettingField::CYCLE_PECK_DWELL,
        &[],
        "P of pecks: `each-peck` of G73, at the `bottom` of G73 and G83, or `none`",
        Certainty::Practice,
        "",
    ),
    setting(
        "tapping F",
        SettingField::CYCLE_TAP_FEED,
        &[("asynchronous", "programmed"), ("synchronous", "lead")],
        "F of a tap without ,R: feed per minute, or the pitch",
        Certainty::Practice,
        "",
    ),
    setting(
        "cycle fires on",
        SettingField::CYCLE_FIRES_ON,
        &[],
        "which words drill a hole with an active cycle: `place`, `any-axis` or `axis-or-level`",
        Certainty::Practice,
        "",
    ),
    setting(
        "#8072 SCALING P",
        SettingField::FRAME_OMITTED_FACTOR,
        &[],
        "scale factor of a G51 without P",
        Certainty::Documented,
        "M700V manual, G51",
    ),
    setting(
        "scaling option",
        SettingField::FRAME_HAS_SCALING,
        &[],
        "the option of scaling (G51) is `present` or `absent` (P350)",
        Certainty::Unknown,
        "M700V manual, G51",
    ),
    setting(
        "rotation option",
        SettingField::FRAME_HAS_ROTATION,
        &[],
        "the option of coordinate rotation (G68) is `present` or `absent` (P260)",
        Certainty::Unknown,
        "M700V manual, G68",
    ),
    setting(
        "unequal scale arcs",
        SettingField::FRAME_UNEQUAL_ARCS,
        &[],
        "an arc while both axes of its plane have different factors: `judged`, or `refused` (P70)",
        Certainty::Unknown,
        "M700V manual, G51",
    ),
    setting(
        "cycle without R",
        SettingField::CYCLE_MISSING_R,
        &[],
        "a cycle without R: it feeds from the `initial` level, with a note; or from where the tool stands (`current`), or it is `refused`",
        Certainty::Practice,
        "proven programs: M29, then G84 without R",
    ),
];

/// Start-up type A or B.
const TYPE: Setting = setting(
    "#1229 set01/bit2",
    SettingField::COMPENSATION_ENTRY,
    &[("0", "A"), ("1", "B")],
    "start-up and cancel of compensation by type A or B",
    Certainty::Documented,
    "M700V, tool radius compensation",
);

/// Remedy for interference.
const AVOIDANCE: Setting = rule(
    "#8102",
    SettingField::COMPENSATION_REMEDY,
    &[("0", "alarm"), ("1", "avoid")],
    "COLL. ALM OFF: where a block interferes, alarm P153 or skip the block",
    Certainty::Documented,
    "M700V, interference check",
);

/// No interference check.
const NO_CHECK: Setting = rule(
    "#8103",
    SettingField::COMPENSATION_CHECK,
    &[("0", "on"), ("1", "off")],
    "COLL. CHK OFF: interference is checked (0) or not (1)",
    Certainty::Documented,
    "M700V, interference check",
);

const fn rule(
    name: &'static str,
    field: SettingField,
    values: &'static [(&'static str, &'static str)],
    text: &'static str,
    certainty: Certainty,
    source: &'static str,
) -> Setting {
    setting(name, field, values, text, certainty, source)
}

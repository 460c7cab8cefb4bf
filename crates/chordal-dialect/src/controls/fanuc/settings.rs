//! The settings of Fanuc 0i, by the names of its manuals.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    setting(
        "cycles in a mirror image",
        SettingField::FRAME_CYCLES_ALONG_SCALED,
        &[],
        "canned cycles along an axis that is mirrored or scaled: `warned` or `allowed`",
        Certainty::Practice,
        "",
    ),
    setting(
        "look-ahead tolerance",
        SettingField::PATH_LOOK_AHEAD,
        &[],
        "how far from a corner the tool may pass with G05.1 Q1, G05 P10000 and G08 P1: the control has speeds at corners instead (No. 1783), so this value is assumed",
        Certainty::Unknown,
        "AI contour control",
    ),
    short_blocks(
        Certainty::Practice,
        "AI contour control: G05.1 Q1 plans the speed over many blocks, G05.1 Q3 also corrects their points",
    ),
    CORNER_ROUNDING,
    TYPE,
    TYPE_C,
    ANGLES_ONLY,
    NO_CHECK,
    LINK,
    BLOCKS_READ,
    BLOCKS_READ_15I,
    CORNER,
    AVOIDANCE,
    TIP_FRAME,
    setting(
        "No. 6004#0",
        SettingField::MACRO_ANGLES,
        &[("0", "0-to-360"), ("1", "180")],
        "NAT: ATAN and ASIN give 0 to 360 degrees (0) or -180 to 180 (1)",
        Certainty::Practice,
        "16i",
    ),
    setting(
        "No. 3410",
        SettingField::RADIUS_ERROR_TOLERANCE,
        &[],
        "largest difference of an arc's radii at start and end (2410 on 15i); above it PS0020",
        Certainty::Documented,
        "B-63534EN, circular interpolation",
    ),
    setting(
        "No. 2410",
        SettingField::RADIUS_ERROR_TOLERANCE,
        &[],
        "the same on 15i",
        Certainty::Documented,
        "B-63324EN",
    ),
    setting(
        "No. 3471",
        SettingField::SPIRAL_END_TOLERANCE,
        &[],
        "largest distance of a computed spiral end from the programmed one; above it PS5123",
        Certainty::Documented,
        "16i spiral interpolation",
    ),
    setting(
        "spiral on the ray",
        SettingField::SPIRAL_ON_RAY,
        &[],
        "a spiral with L whose start and end are on one ray from the centre: L1 is `no-turn` or a `full-turn`",
        Certainty::Inferred,
        "16i spiral interpolation: L is rounded up, so one turn is L1",
    ),
    setting(
        "rotary_in_arc",
        SettingField::ROTARY_IN_ARC,
        &[],
        "a rotary axis in the block of an arc: `allowed` or `refused`",
        Certainty::Inferred,
        "textbooks for Fanuc-style controls do not have it; with the option helical interpolation B a machine may do it",
    ),
    setting(
        "machine_move",
        SettingField::MACHINE_MOVE,
        &[],
        "a move of G53 is a `rapid`, or uses the active motion code (`in-force`)",
        Certainty::Practice,
        "B-63534EN, G53",
    ),
    setting(
        "excess_decimals",
        SettingField::EXCESS_DECIMALS,
        &[],
        "decimals beyond the least increment: `cut`, `rounded` or `exact`",
        Certainty::Practice,
        "B-63534EN, decimal point programming",
    ),
    setting(
        "most_digits",
        SettingField::MOST_DIGITS,
        &[],
        "most digits of a length; above it PS0003",
        Certainty::Practice,
        "B-63534EN, decimal point programming",
    ),
    setting(
        "No. 1403#5",
        SettingField::HELIX_FEED,
        &[("0", "plane"), ("1", "path")],
        "HTG: F of a helix along the circle (0) or along the helix (1)",
        Certainty::Practice,
        "30i; 1401#2 on 15i is documented",
    ),
    setting(
        "No. 1401#1",
        SettingField::RAPID,
        &[("0", "dog-leg"), ("1", "straight")],
        "LRP: straight rapids",
        Certainty::Practice,
        "30i",
    ),
    setting(
        "No. 3403#5",
        SettingField::ARC_WITHOUT_CENTER,
        &[("0", "line"), ("1", "refused")],
        "CIR: a block of G2 or G3 with neither a centre nor a radius is a straight line (0), or alarm PS0022 (1)",
        Certainty::Practice,
        "30i",
    ),
    setting(
        "No. 3401#0",
        SettingField::DECIMAL_POINT,
        &[("0", "least-increment"), ("1", "calculator")],
        "DPI: a number without a decimal point",
        Certainty::Practice,
        "30i",
    ),
    setting(
        "No. 5004#2",
        SettingField::RADIUS_OFFSETS,
        &[("0", "radius"), ("1", "diameter")],
        "ODI: compensation values are radii or diameters",
        Certainty::Practice,
        "30i",
    ),
    setting("No. 5114", SettingField::CHIP_BREAK, &[], "lift of G73", Certainty::Documented, "16i"),
    setting("No. 5115", SettingField::PECK_CLEARANCE, &[], "clearance of G83", Certainty::Practice, "16i"),
    setting(
        "unit_codes",
        SettingField::UNIT_CODES,
        &[],
        "the codes that choose inch and millimetres",
        Certainty::Practice,
        "15i",
    ),
    setting(
        "offset_memory",
        SettingField::OFFSET_MEMORY,
        &[],
        "tool offset memory: `A` (#2001 to #2200 are offsets), `B` or `C` (wear there, geometry from #2201 on), or `not known`",
        Certainty::Documented,
        "B-63534EN, tool compensation memory",
    ),
    setting(
        "subprogram_repeats",
        SettingField::PACKED_CALLS,
        &[("packed", "on"), ("separate", "off")],
        "`M98 P100013` repeats O0013 ten times, or names program 100013",
        Certainty::Practice,
        "",
    ),
    setting(
        "No. 5101#0",
        SettingField::CYCLE_AXIS,
        &[("0", "z"), ("1", "plane-normal")],
        "FXY: cycles drill along Z, or along the normal of the plane",
        Certainty::Practice,
        "16i",
    ),
    setting(
        "No. 5101#4-5",
        SettingField::CYCLE_SHIFT_DIRECTION,
        &[("00", "x+"), ("01", "x-"), ("10", "y+"), ("11", "y-")],
        "RD1, RD2: where Q shifts the tool in G76 and G87",
        Certainty::Practice,
        "16i, 0i",
    ),
    setting(
        "No. 5148",
        SettingField::CYCLE_SHIFT_DIRECTION,
        &[("1", "x+"), ("-1", "x-"), ("2", "y+"), ("-2", "y-")],
        "where Q shifts the tool in G76 and G87, as a signed axis",
        Certainty::Practice,
        "30i",
    ),
    setting(
        "No. 6240",
        SettingField::CYCLE_SHIFT_DIRECTION,
        &[],
        "the same on 15i: `x+`, `x-`, `y+`, `y-`",
        Certainty::Documented,
        "B-63324EN, G76",
    ),
    setting(
        "No. 6200#2",
        SettingField::CYCLE_SHIFT,
        &[("0", "q"), ("1", "vector")],
        "the shift of G76 and G87 is Q, or I and J",
        Certainty::Documented,
        "B-63324EN, G76",
    ),
    setting(
        "No. 5200#5",
        SettingField::CYCLE_TAP_FULL_RETURN,
        &[("0", "off"), ("1", "on")],
        "PCP: peck tapping returns to R (1), or by No. 5213 (0)",
        Certainty::Practice,
        "16i",
    ),
    setting(
        "No. 5213",
        SettingField::CYCLE_TAP_LIFT,
        &[],
        "lift of peck tapping",
        Certainty::Practice,
        "16i",
    ),
    setting(
        "tapping dwell at R",
        SettingField::CYCLE_TAP_DWELL_AT_R,
        &[],
        "the dwell of a tapping cycle is repeated at R",
        Certainty::Practice,
        "",
    ),
    setting(
        "cycle repeats",
        SettingField::CYCLE_REPEAT_LETTER,
        &[],
        "letter of the repeat count: `K`, or `L` on 6M and 15",
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
    call("No. 6050", SettingField::alias_g(0), "G code that calls macro O9010"),
    call("No. 6051", SettingField::alias_g(1), "G code that calls macro O9011"),
    call("No. 6052", SettingField::alias_g(2), "G code that calls macro O9012"),
    call("No. 6053", SettingField::alias_g(3), "G code that calls macro O9013"),
    call("No. 6054", SettingField::alias_g(4), "G code that calls macro O9014"),
    call("No. 6055", SettingField::alias_g(5), "G code that calls macro O9015"),
    call("No. 6056", SettingField::alias_g(6), "G code that calls macro O9016"),
    call("No. 6057", SettingField::alias_g(7), "G code that calls macro O9017"),
    call("No. 6058", SettingField::alias_g(8), "G code that calls macro O9018"),
    call("No. 6059", SettingField::alias_g(9), "G code that calls macro O9019"),
    call("No. 6071", SettingField::alias_subprogram(0), "M code that calls subprogram O9001"),
    call("No. 6072", SettingField::alias_subprogram(1), "M code that calls subprogram O9002"),
    call("No. 6073", SettingField::alias_subprogram(2), "M code that calls subprogram O9003"),
    call("No. 6074", SettingField::alias_subprogram(3), "M code that calls subprogram O9004"),
    call("No. 6075", SettingField::alias_subprogram(4), "M code that calls subprogram O9005"),
    call("No. 6076", SettingField::alias_subprogram(5), "M code that calls subprogram O9006"),
    call("No. 6077", SettingField::alias_subprogram(6), "M code that calls subprogram O9007"),
    call("No. 6078", SettingField::alias_subprogram(7), "M code that calls subprogram O9008"),
    call("No. 6079", SettingField::alias_subprogram(8), "M code that calls subprogram O9009"),
    call("No. 6080", SettingField::alias_m(0), "M code that calls macro O9020"),
    call("No. 6081", SettingField::alias_m(1), "M code that calls macro O9021"),
    call("No. 6082", SettingField::alias_m(2), "M code that calls macro O9022"),
    call("No. 6083", SettingField::alias_m(3), "M code that calls macro O9023"),
    call("No. 6084", SettingField::alias_m(4), "M code that calls macro O9024"),
    call("No. 6085", SettingField::alias_m(5), "M code that calls macro O9025"),
    call("No. 6086", SettingField::alias_m(6), "M code that calls macro O9026"),
    call("No. 6087", SettingField::alias_m(7), "M code that calls macro O9027"),
    call("No. 6088", SettingField::alias_m(8), "M code that calls macro O9028"),
    call("No. 6089", SettingField::alias_m(9), "M code that calls macro O9029"),
    setting(
        "No. 5400#0 RIN",
        SettingField::FRAME_ANGLE_ADDS,
        &[("0", "absolute"), ("1", "adds")],
        "the angle of a G68 in G91 is `absolute`, or `adds` to the one in force",
        Certainty::Documented,
        "parameter 5400",
    ),
    setting(
        "No. 5400#6 XSC",
        SettingField::FRAME_FACTORS_BY_VECTOR,
        &[("0", "one"), ("1", "each")],
        "factors of G51: `one` by P, or `each` by I, J and K",
        Certainty::Practice,
        "parameter 5400",
    ),
    setting(
        "No. 5410",
        SettingField::FRAME_OMITTED_ANGLE,
        &[],
        "angle of a G68 without R, degrees",
        Certainty::Documented,
        "parameter 5410",
    ),
    setting(
        "No. 5411",
        SettingField::FRAME_OMITTED_FACTOR,
        &[],
        "scale factor of a G51 without P; 1 is no scaling",
        Certainty::Documented,
        "parameter 5411",
    ),
    setting(
        "unequal scale arcs",
        SettingField::FRAME_UNEQUAL_ARCS,
        &[],
        "an arc while the axes of its plane have different factors: `judged` as always, or `refused`",
        Certainty::Inferred,
        "G51",
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

/// A setting with the code that calls a program; 0 for none.
const fn call(name: &'static str, field: SettingField, text: &'static str) -> Setting {
    setting(name, field, &[], text, Certainty::Practice, "16i")
}

/// SUP: start-up type A or B.
const TYPE: Setting = setting(
    "No. 5003#0",
    SettingField::COMPENSATION_ENTRY,
    &[("0", "A"), ("1", "B")],
    "SUP: start-up and cancel of compensation by type A or B",
    Certainty::Practice,
    "16i, 30i",
);

/// SUV: start-up type C.
const TYPE_C: Setting = rule(
    "No. 5003#1",
    SettingField::COMPENSATION_ALONE,
    &[("0", "waits"), ("1", "perpendicular")],
    "SUV: G41 or G40 alone waits for the next move (0), or offsets the tool at once (1, type C)",
    Certainty::Practice,
    "16i, 30i",
);

/// CNC: the interference check looks at angles alone.
const ANGLES_ONLY: Setting = rule(
    "No. 5008#1",
    SettingField::COMPENSATION_INTERFERENCE,
    &[("0", "direction"), ("1", "arc-angle")],
    "CNC: interference is checked by the direction and angle of the moves, or only by the angle of arcs",
    Certainty::Practice,
    "16i, 30i",
);

/// CNV: no interference check.
const NO_CHECK: Setting = rule(
    "No. 5008#3",
    SettingField::COMPENSATION_CHECK,
    &[("0", "on"), ("1", "off")],
    "CNV: interference is checked (0) or not (1)",
    Certainty::Practice,
    "16i, 30i",
);

/// How short a connecting move at a corner is left out.
const LINK: Setting = rule(
    "No. 5010",
    SettingField::COMPENSATION_DROP_LINK,
    &[],
    "links around an outside corner that are not longer than this on either axis are skipped",
    Certainty::Practice,
    "16i, 30i",
);

/// How many blocks are read ahead.
const BLOCKS_READ: Setting = rule(
    "No. 19625",
    SettingField::COMPENSATION_BLOCKS_READ,
    &[],
    "blocks read ahead in compensation, 3 to 8; two fewer may be without motion between two moves",
    Certainty::Documented,
    "B-63944EN",
);

/// How many blocks a 15i reads ahead.
const BLOCKS_READ_15I: Setting =
    rule("No. 6009", SettingField::COMPENSATION_BLOCKS_READ, &[], "the same on 15i", Certainty::Documented, "B-63324EN");

/// CCC: moves at outside corners.
const CORNER: Setting = setting(
    "No. 19607#2",
    SettingField::OUTSIDE_CORNER,
    &[("0", "linear"), ("1", "arc")],
    "CCC: outside corners by straight lines or by arcs",
    Certainty::Practice,
    "30i",
);

/// WKP: the frame of tool centre point control.
const TIP_FRAME: Setting = setting(
    "No. 19696#5",
    SettingField::FRAME_OF_TIP,
    &[("0", "table"), ("1", "stays")],
    "WKP: under G43.4 the coordinates ride on the table (0), or their axes stay those of the machine (1): then X, Y and Z are the end after the table has turned, and G43.5 is PS5459",
    Certainty::Documented,
    "A-79348E, 30i",
);

/// CAV: remedy for interference.
const AVOIDANCE: Setting = rule(
    "No. 19607#5",
    SettingField::COMPENSATION_REMEDY,
    &[("0", "alarm"), ("1", "avoid")],
    "CAV: where a block interferes, alarm PS0041 or skip the block",
    Certainty::Practice,
    "30i",
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

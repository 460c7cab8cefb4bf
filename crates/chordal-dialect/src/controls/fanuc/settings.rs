//! The settings of Fanuc 0i, by the names of its manuals.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    setting(
        "cycles in a mirror image",
        SettingField::Frame(FrameField::CyclesAlongScaled),
        &[],
        "canned cycles along an axis that is mirrored or scaled: `warned` or `allowed`",
        Certainty::Trade,
        "",
    ),
    setting(
        "look-ahead tolerance",
        SettingField::Path(PathField::LookAhead),
        &[],
        "how far from a corner the tool may pass with G05.1 Q1, G05 P10000 and G08 P1: the control has speeds at corners instead (No. 1783), so this value is assumed",
        Certainty::Unknown,
        "AI contour control",
    ),
    short_blocks(
        Certainty::Trade,
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
    setting(
        "No. 6004#0",
        SettingField::MacroAngles,
        &[("0", "0-to-360"), ("1", "180")],
        "NAT: ATAN and ASIN give 0 to 360 degrees (0) or -180 to 180 (1)",
        Certainty::Trade,
        "16i",
    ),
    setting(
        "No. 3410",
        SettingField::RadiusErrorTolerance,
        &[],
        "largest difference of an arc's radii at start and end (2410 on 15i); above it PS0020",
        Certainty::Documented,
        "B-63534EN, circular interpolation",
    ),
    setting(
        "No. 2410",
        SettingField::RadiusErrorTolerance,
        &[],
        "the same on 15i",
        Certainty::Documented,
        "B-63324EN",
    ),
    setting(
        "No. 3471",
        SettingField::SpiralEndTolerance,
        &[],
        "largest distance of a computed spiral end from the programmed one; above it PS5123",
        Certainty::Documented,
        "16i spiral interpolation",
    ),
    setting(
        "spiral on the ray",
        SettingField::SpiralOnRay,
        &[],
        "a spiral with L whose start and end are on one ray from the centre: L1 is `no-turn` or a `full-turn`",
        Certainty::Inferred,
        "16i spiral interpolation: L is rounded up, so one turn is L1",
    ),
    setting(
        "rotary_in_arc",
        SettingField::RotaryInArc,
        &[],
        "a rotary axis in the block of an arc: `allowed` or `refused`",
        Certainty::Inferred,
        "textbooks for Fanuc-style controls do not have it; with the option helical interpolation B a machine may do it",
    ),
    setting(
        "machine_move",
        SettingField::MachineMove,
        &[],
        "a move of G53 is a `rapid`, or uses the active motion code (`in-force`)",
        Certainty::Trade,
        "B-63534EN, G53",
    ),
    setting(
        "excess_decimals",
        SettingField::ExcessDecimals,
        &[],
        "decimals beyond the least increment: `cut`, `rounded` or `exact`",
        Certainty::Trade,
        "B-63534EN, decimal point programming",
    ),
    setting(
        "most_digits",
        SettingField::MostDigits,
        &[],
        "most digits of a length; above it PS0003",
        Certainty::Trade,
        "B-63534EN, decimal point programming",
    ),
    setting(
        "No. 1403#5",
        SettingField::HelixFeed,
        &[("0", "plane"), ("1", "path")],
        "HTG: F of a helix along the circle (0) or along the helix (1)",
        Certainty::Trade,
        "30i; 1401#2 on 15i is documented",
    ),
    setting(
        "No. 1401#1",
        SettingField::Rapid,
        &[("0", "dog-leg"), ("1", "straight")],
        "LRP: straight rapids",
        Certainty::Trade,
        "30i",
    ),
    setting(
        "No. 3403#5",
        SettingField::ArcWithoutCenter,
        &[("0", "line"), ("1", "refused")],
        "CIR: a block of G2 or G3 with neither a centre nor a radius is a straight line (0), or alarm PS0022 (1)",
        Certainty::Trade,
        "30i",
    ),
    setting(
        "No. 3401#0",
        SettingField::DecimalPoint,
        &[("0", "least-increment"), ("1", "calculator")],
        "DPI: a number without a decimal point",
        Certainty::Trade,
        "30i",
    ),
    setting(
        "No. 5004#2",
        SettingField::RadiusOffsets,
        &[("0", "radius"), ("1", "diameter")],
        "ODI: compensation values are radii or diameters",
        Certainty::Trade,
        "30i",
    ),
    setting("No. 5114", SettingField::ChipBreak, &[], "lift of G73", Certainty::Documented, "16i"),
    setting("No. 5115", SettingField::PeckClearance, &[], "clearance of G83", Certainty::Trade, "16i"),
    setting(
        "unit_codes",
        SettingField::UnitCodes,
        &[],
        "the codes that choose inch and millimetres",
        Certainty::Trade,
        "15i",
    ),
    setting(
        "offset_memory",
        SettingField::OffsetMemory,
        &[],
        "tool offset memory: `A` (#2001 to #2200 are offsets), `B` or `C` (wear there, geometry from #2201 on), or `not known`",
        Certainty::Documented,
        "B-63534EN, tool compensation memory",
    ),
    setting(
        "subprogram_repeats",
        SettingField::PackedCalls,
        &[("packed", "on"), ("separate", "off")],
        "`M98 P100013` repeats O0013 ten times, or names program 100013",
        Certainty::Trade,
        "",
    ),
    setting(
        "No. 5101#0",
        SettingField::Cycle(CycleField::Axis),
        &[("0", "z"), ("1", "plane-normal")],
        "FXY: cycles drill along Z, or along the normal of the plane",
        Certainty::Trade,
        "16i",
    ),
    setting(
        "No. 5101#4-5",
        SettingField::Cycle(CycleField::ShiftDirection),
        &[("00", "x+"), ("01", "x-"), ("10", "y+"), ("11", "y-")],
        "RD1, RD2: where Q shifts the tool in G76 and G87",
        Certainty::Trade,
        "16i, 0i",
    ),
    setting(
        "No. 5148",
        SettingField::Cycle(CycleField::ShiftDirection),
        &[("1", "x+"), ("-1", "x-"), ("2", "y+"), ("-2", "y-")],
        "where Q shifts the tool in G76 and G87, as a signed axis",
        Certainty::Trade,
        "30i",
    ),
    setting(
        "No. 6240",
        SettingField::Cycle(CycleField::ShiftDirection),
        &[],
        "the same on 15i: `x+`, `x-`, `y+`, `y-`",
        Certainty::Documented,
        "B-63324EN, G76",
    ),
    setting(
        "No. 6200#2",
        SettingField::Cycle(CycleField::Shift),
        &[("0", "q"), ("1", "vector")],
        "the shift of G76 and G87 is Q, or I and J",
        Certainty::Documented,
        "B-63324EN, G76",
    ),
    setting(
        "No. 5200#5",
        SettingField::Cycle(CycleField::TapFullReturn),
        &[("0", "off"), ("1", "on")],
        "PCP: peck tapping returns to R (1), or by No. 5213 (0)",
        Certainty::Trade,
        "16i",
    ),
    setting(
        "No. 5213",
        SettingField::Cycle(CycleField::TapLift),
        &[],
        "lift of peck tapping",
        Certainty::Trade,
        "16i",
    ),
    setting(
        "tapping dwell at R",
        SettingField::Cycle(CycleField::TapDwellAtR),
        &[],
        "the dwell of a tapping cycle is repeated at R",
        Certainty::Trade,
        "",
    ),
    setting(
        "cycle repeats",
        SettingField::Cycle(CycleField::RepeatLetter),
        &[],
        "letter of the repeat count: `K`, or `L` on 6M and 15",
        Certainty::Trade,
        "",
    ),
    setting(
        "cycle fires on",
        SettingField::Cycle(CycleField::FiresOn),
        &[],
        "which words drill a hole with an active cycle: `place`, `any-axis` or `axis-or-level`",
        Certainty::Trade,
        "",
    ),
    call("No. 6050", SettingField::AliasG(0), "G code that calls macro O9010"),
    call("No. 6051", SettingField::AliasG(1), "G code that calls macro O9011"),
    call("No. 6052", SettingField::AliasG(2), "G code that calls macro O9012"),
    call("No. 6053", SettingField::AliasG(3), "G code that calls macro O9013"),
    call("No. 6054", SettingField::AliasG(4), "G code that calls macro O9014"),
    call("No. 6055", SettingField::AliasG(5), "G code that calls macro O9015"),
    call("No. 6056", SettingField::AliasG(6), "G code that calls macro O9016"),
    call("No. 6057", SettingField::AliasG(7), "G code that calls macro O9017"),
    call("No. 6058", SettingField::AliasG(8), "G code that calls macro O9018"),
    call("No. 6059", SettingField::AliasG(9), "G code that calls macro O9019"),
    call("No. 6071", SettingField::AliasSubprogram(0), "M code that calls subprogram O9001"),
    call("No. 6072", SettingField::AliasSubprogram(1), "M code that calls subprogram O9002"),
    call("No. 6073", SettingField::AliasSubprogram(2), "M code that calls subprogram O9003"),
    call("No. 6074", SettingField::AliasSubprogram(3), "M code that calls subprogram O9004"),
    call("No. 6075", SettingField::AliasSubprogram(4), "M code that calls subprogram O9005"),
    call("No. 6076", SettingField::AliasSubprogram(5), "M code that calls subprogram O9006"),
    call("No. 6077", SettingField::AliasSubprogram(6), "M code that calls subprogram O9007"),
    call("No. 6078", SettingField::AliasSubprogram(7), "M code that calls subprogram O9008"),
    call("No. 6079", SettingField::AliasSubprogram(8), "M code that calls subprogram O9009"),
    call("No. 6080", SettingField::AliasM(0), "M code that calls macro O9020"),
    call("No. 6081", SettingField::AliasM(1), "M code that calls macro O9021"),
    call("No. 6082", SettingField::AliasM(2), "M code that calls macro O9022"),
    call("No. 6083", SettingField::AliasM(3), "M code that calls macro O9023"),
    call("No. 6084", SettingField::AliasM(4), "M code that calls macro O9024"),
    call("No. 6085", SettingField::AliasM(5), "M code that calls macro O9025"),
    call("No. 6086", SettingField::AliasM(6), "M code that calls macro O9026"),
    call("No. 6087", SettingField::AliasM(7), "M code that calls macro O9027"),
    call("No. 6088", SettingField::AliasM(8), "M code that calls macro O9028"),
    call("No. 6089", SettingField::AliasM(9), "M code that calls macro O9029"),
    setting(
        "No. 5400#0 RIN",
        SettingField::Frame(FrameField::AngleAdds),
        &[("0", "absolute"), ("1", "adds")],
        "the angle of a G68 in G91 is `absolute`, or `adds` to the one in force",
        Certainty::Documented,
        "parameter 5400",
    ),
    setting(
        "No. 5400#6 XSC",
        SettingField::Frame(FrameField::FactorsByVector),
        &[("0", "one"), ("1", "each")],
        "factors of G51: `one` by P, or `each` by I, J and K",
        Certainty::Trade,
        "parameter 5400",
    ),
    setting(
        "No. 5410",
        SettingField::Frame(FrameField::OmittedAngle),
        &[],
        "angle of a G68 without R, degrees",
        Certainty::Documented,
        "parameter 5410",
    ),
    setting(
        "No. 5411",
        SettingField::Frame(FrameField::OmittedFactor(None)),
        &[],
        "scale factor of a G51 without P; 1 is no scaling",
        Certainty::Documented,
        "parameter 5411",
    ),
    setting(
        "unequal scale arcs",
        SettingField::Frame(FrameField::UnequalArcs),
        &[],
        "an arc while the axes of its plane have different factors: `judged` as always, or `refused`",
        Certainty::Inferred,
        "G51",
    ),
    setting(
        "cycle without R",
        SettingField::Cycle(CycleField::MissingR),
        &[],
        "a cycle without R: it feeds from the `initial` level, with a note; or from where the tool stands (`current`), or it is `refused`",
        Certainty::Trade,
        "proven programs: M29, then G84 without R",
    ),
];

/// A code that calls a program; 0 for none.
const fn call(name: &'static str, field: SettingField, text: &'static str) -> Setting {
    setting(name, field, &[], text, Certainty::Trade, "16i")
}

/// SUP.
const TYPE: Setting = setting(
    "No. 5003#0",
    SettingField::CompensationEntry,
    &[("0", "A"), ("1", "B")],
    "SUP: start-up and cancel of compensation by type A or B",
    Certainty::Trade,
    "16i, 30i",
);

/// SUV.
const TYPE_C: Setting = rule(
    "No. 5003#1",
    C::Alone,
    &[("0", "waits"), ("1", "perpendicular")],
    "SUV: G41 or G40 alone waits for the next move (0), or offsets the tool at once (1, type C)",
    Certainty::Trade,
    "16i, 30i",
);

/// CNC.
const ANGLES_ONLY: Setting = rule(
    "No. 5008#1",
    C::Interference,
    &[("0", "direction"), ("1", "arc-angle")],
    "CNC: interference is checked by the direction and angle of the moves, or only by the angle of arcs",
    Certainty::Trade,
    "16i, 30i",
);

/// CNV.
const NO_CHECK: Setting = rule(
    "No. 5008#3",
    C::Check,
    &[("0", "on"), ("1", "off")],
    "CNV: interference is checked (0) or not (1)",
    Certainty::Trade,
    "16i, 30i",
);

/// The length of a link that is left out.
const LINK: Setting = rule(
    "No. 5010",
    C::DropLink,
    &[],
    "links around an outside corner that are not longer than this on either axis are skipped",
    Certainty::Trade,
    "16i, 30i",
);

/// Blocks read ahead.
const BLOCKS_READ: Setting = rule(
    "No. 19625",
    C::BlocksRead,
    &[],
    "blocks read ahead in compensation, 3 to 8; two fewer may be without motion between two moves",
    Certainty::Documented,
    "B-63944EN",
);

/// The same on 15i.
const BLOCKS_READ_15I: Setting =
    rule("No. 6009", C::BlocksRead, &[], "the same on 15i", Certainty::Documented, "B-63324EN");

/// CCC.
const CORNER: Setting = setting(
    "No. 19607#2",
    SettingField::OutsideCorner,
    &[("0", "linear"), ("1", "arc")],
    "CCC: outside corners by straight lines or by arcs",
    Certainty::Trade,
    "30i",
);

/// CAV.
const AVOIDANCE: Setting = rule(
    "No. 19607#5",
    C::Remedy,
    &[("0", "alarm"), ("1", "avoid")],
    "CAV: where a block interferes, alarm PS0041 or skip the block",
    Certainty::Trade,
    "30i",
);

const fn rule(
    name: &'static str,
    field: C,
    values: &'static [(&'static str, &'static str)],
    text: &'static str,
    certainty: Certainty,
    source: &'static str,
) -> Setting {
    setting(name, SettingField::Compensation(field), values, text, certainty, source)
}

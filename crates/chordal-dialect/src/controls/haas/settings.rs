//! The settings of Haas mill, by the names of its manuals.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    INSIDE_FEED,
    setting(
        "Setting 9",
        Field::Units,
        &[("INCH", "inch"), ("MM", "mm")],
        "units at power-on",
        Certainty::Documented,
        "Setting 9, Dimensioning",
    ),
    setting(
        "Setting 15",
        Field::LengthMustMatchTool,
        &[],
        "H must be the number of the tool in the spindle (alarm 332)",
        Certainty::Documented,
        "Setting 15, H & T Code Agreement",
    ),
    setting(
        "Setting 22",
        Field::Cycle(CycleField::Lifts),
        &[],
        "lift of G73 and clearance of G83 between pecks",
        Certainty::Documented,
        "Setting 22, Can Cycle Delta Z",
    ),
    setting(
        "Setting 40",
        Field::RadiusOffsets,
        &[],
        "the tool table holds `diameter` or `radius`",
        Certainty::Documented,
        "Setting 40, Tool Offset Measure",
    ),
    setting(
        "Setting 43",
        Field::CompensationEntry,
        &[],
        "cutter compensation type",
        Certainty::Documented,
        "Setting 43, Cutter Comp Type",
    ),
    setting(
        "Setting 58",
        Field::OutsideCorner,
        &[("fanuc", "linear"), ("yasnac", "arc")],
        "outside corners of cutter compensation",
        Certainty::Documented,
        "Setting 58, Cutter Compensation",
    ),
    setting(
        "Setting 85",
        Field::Path(PathField::Rounding),
        &[],
        "how far from a corner the tool may pass: at level rough, if G187 gives no tolerance",
        Certainty::Trade,
        "Setting 85, Maximum Corner Rounding",
    ),
    setting(
        "Setting 191",
        Field::Path(PathField::Level),
        &[],
        "smoothness if G187 gives none: `rough`, `medium` or `finish`",
        Certainty::Trade,
        "Setting 191, Default Smoothness",
    ),
    part("G187 P1 part", 1, "part of Setting 85 that level rough uses"),
    part("G187 P2 part", 2, "part of Setting 85 that level medium uses"),
    part("G187 P3 part", 3, "part of Setting 85 that level finish uses"),
    setting(
        "Setting 162",
        Field::DecimalPoint,
        &[("on", "calculator"), ("off", "least-increment")],
        "on: a number without a decimal point is in whole units",
        Certainty::Documented,
        "Setting 162, Default To Float",
    ),
    setting(
        "Setting 335",
        Field::Rapid,
        &[("none", "dog-leg"), ("linear xyz", "straight"), ("linear xyz + rotary", "straight")],
        "straight rapids",
        Certainty::Documented,
        "Setting 335, Linear Rapid Mode",
    ),
    setting(
        "Setting 27",
        Field::Cycle(CycleField::ShiftDirection),
        &[("X+", "x+"), ("X-", "x-"), ("Y+", "y+"), ("Y-", "y-")],
        "where Q shifts the tool in G76 and G77",
        Certainty::Documented,
        "Setting 27, G76/G77 Shift Dir.",
    ),
    setting(
        "Setting 28",
        Field::Cycle(CycleField::Definition),
        &[("on", "always"), ("off", "with-place")],
        "on: a cycle drills also where it is defined without X and Y",
        Certainty::Documented,
        "Setting 28, Can Cycle Act w/o X/Y",
    ),
    setting(
        "Setting 52",
        Field::Cycle(CycleField::ReturnAboveR),
        &[],
        "how far above R the chip-clearing return of G83 goes",
        Certainty::Documented,
        "Setting 52, G83 Retract Above R",
    ),
    setting(
        "Setting 52 in G73",
        Field::Cycle(CycleField::ChipBreakAboveR),
        &[],
        "G73 also returns to that height above R",
        Certainty::Documented,
        "manual of 1999",
    ),
    setting(
        "Setting 130",
        Field::Cycle(CycleField::TapOutFactor),
        &[],
        "retract speed of a tap divided by its speed on the way in; 0 or 1: the same speed",
        Certainty::Documented,
        "Setting 130, Tap Retract Speed",
    ),
    setting(
        "cycle fires on",
        Field::Cycle(CycleField::FiresOn),
        &[],
        "which words drill a hole with an active cycle: `place`, `any-axis` or `axis-or-level`",
        Certainty::Unknown,
        "",
    ),
    setting(
        "cycle axis",
        Field::Cycle(CycleField::Axis),
        &[],
        "cycles drill along `z` or the `plane-normal`",
        Certainty::Unknown,
        "",
    ),
    setting(
        "G77 scheme",
        Field::Cycle(CycleField::BackBore),
        &[],
        "back boring: `shift-at-initial`, or `shift-at-r` as the text of the manual says",
        Certainty::Unknown,
        "G77",
    ),
    call("Parameter 81", Field::AliasM(0), "M code that calls O9000"),
    call("Parameter 82", Field::AliasM(1), "M code that calls O9001"),
    call("Parameter 83", Field::AliasM(2), "M code that calls O9002"),
    call("Parameter 84", Field::AliasM(3), "M code that calls O9003"),
    call("Parameter 85", Field::AliasM(4), "M code that calls O9004"),
    call("Parameter 86", Field::AliasM(5), "M code that calls O9005"),
    call("Parameter 87", Field::AliasM(6), "M code that calls O9006"),
    call("Parameter 88", Field::AliasM(7), "M code that calls O9007"),
    call("Parameter 89", Field::AliasM(8), "M code that calls O9008"),
    call("Parameter 90", Field::AliasM(9), "M code that calls O9009"),
    call("Parameter 91", Field::AliasG(0), "G code that calls macro O9010"),
    call("Parameter 92", Field::AliasG(1), "G code that calls macro O9011"),
    call("Parameter 93", Field::AliasG(2), "G code that calls macro O9012"),
    call("Parameter 94", Field::AliasG(3), "G code that calls macro O9013"),
    call("Parameter 95", Field::AliasG(4), "G code that calls macro O9014"),
    call("Parameter 96", Field::AliasG(5), "G code that calls macro O9015"),
    call("Parameter 97", Field::AliasG(6), "G code that calls macro O9016"),
    call("Parameter 98", Field::AliasG(7), "G code that calls macro O9017"),
    call("Parameter 99", Field::AliasG(8), "G code that calls macro O9018"),
    call("Parameter 100", Field::AliasG(9), "G code that calls macro O9019"),
];

/// A code that calls a program; 0 for none.
const fn call(name: &'static str, field: Field, text: &'static str) -> Setting {
    setting(
        name,
        field,
        &[],
        text,
        Certainty::Trade,
        "Aliasing; on an NGC the pages of G and M codes",
    )
}

/// How much of the largest rounding a level of smoothness uses: no text gives figures.
const fn part(name: &'static str, level: u8, text: &'static str) -> Setting {
    setting(name, Field::Path(PathField::LevelPart(level)), &[], text, Certainty::Unknown, "G187")
}

/// Feed of inside arcs.
const INSIDE_FEED: Setting = rule(
    "Setting 44",
    C::InsideFeed,
    &[],
    "inside arcs are cut at F(R-r)/R, but not below this percentage of F; 100: F is not reduced",
    Certainty::Trade,
    "Setting 44, Min F in Radius CC %",
);

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

//! The settings of Fanuc lathes, by the names of their manuals.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    CORNER_ROUNDING,
    setting(
        "No. 5132",
        Field::Turning(TurningField::RoughDepth),
        &[],
        "depth of a pass of G71 and G72 before a program gives one",
        Certainty::Trade,
        "18i-T",
    ),
    setting(
        "No. 5133",
        Field::Turning(TurningField::RoughRetract),
        &[],
        "how far a pass of G71 and G72 backs off",
        Certainty::Documented,
        "B-62754EN",
    ),
    setting(
        "first level",
        Field::Turning(TurningField::FirstLevel),
        &[],
        "the levels of G71 and G72 begin at the start with the finishing `allowance`, or at the `start` itself",
        Certainty::Trade,
        "G71",
    ),
    setting(
        "No. 5139",
        Field::Turning(TurningField::PeckRetract),
        &[],
        "how far a peck of G74 and G75 backs off",
        Certainty::Trade,
        "18i-T",
    ),
    setting(
        "No. 5130",
        Field::Turning(TurningField::ThreadExit),
        &[],
        "length of the exit of G92 and G76, in tenths of the lead",
        Certainty::Documented,
        "B-62754EN",
    ),
    setting(
        "No. 5140",
        Field::Turning(TurningField::ThreadLeast),
        &[],
        "least depth of a pass of G76",
        Certainty::Trade,
        "18i-T",
    ),
    setting(
        "No. 5141",
        Field::Turning(TurningField::ThreadFinish),
        &[],
        "depth of the finishing pass of G76",
        Certainty::Trade,
        "18i-T",
    ),
    setting(
        "No. 5142",
        Field::Turning(TurningField::ThreadFinishPasses),
        &[],
        "finishing passes of G76",
        Certainty::Trade,
        "18i-T",
    ),
    setting(
        "No. 5143",
        Field::Turning(TurningField::ThreadAngle),
        &[],
        "angle of the tool of G76, degrees",
        Certainty::Trade,
        "18i-T",
    ),
];

//! The settings of Mitsubishi lathes, by the numbers of their parameters. Only #8056 was found in a manual.

use crate::controls::fanuc_lathe::settings::FACE_X;
use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    CORNER_ROUNDING,
    setting(
        "#1037 cmdtyp",
        SettingField::CODE_SYSTEM,
        &[("2", "A"), ("3", "B"), ("4", "A"), ("5", "B"), ("6", "A"), ("7", "B")],
        "list of G codes: even ones read as system A of Fanuc, odd ones as system B",
        Certainty::Practice,
        "M700, #1037",
    ),
    setting(
        "#8051",
        SettingField::TURNING_ROUGH_DEPTH,
        &[],
        "depth of a pass of G71 and G72 before a program gives one",
        Certainty::Practice,
        "M700, #8051",
    ),
    setting(
        "#8052",
        SettingField::TURNING_ROUGH_RETRACT,
        &[],
        "how far a pass of G71 and G72 backs off",
        Certainty::Practice,
        "M700, #8052",
    ),
    FACE_X,
    setting(
        "first level",
        SettingField::TURNING_FIRST_LEVEL,
        &[],
        "the levels of G71 and G72 begin at the start with the finishing `allowance`, or at the `start` itself",
        Certainty::Unknown,
        "G71",
    ),
    setting(
        "#8056",
        SettingField::TURNING_PECK_RETRACT,
        &[],
        "how far a peck of G74 and G75 backs off",
        Certainty::Documented,
        "M70, #8056",
    ),
    setting(
        "#8014",
        SettingField::TURNING_THREAD_EXIT,
        &[],
        "length of the exit of G92 and G76, in tenths of the lead",
        Certainty::Practice,
        "M700, #8014",
    ),
    setting(
        "#8057",
        SettingField::TURNING_THREAD_FINISH,
        &[],
        "depth of the finishing pass of G76",
        Certainty::Practice,
        "M700, #8057",
    ),
    setting(
        "point in G76",
        SettingField::TURNING_THREAD_POINT,
        &[],
        "a decimal point in P and Q of G76 is `allowed`, or `reported`: they count least increments",
        Certainty::Unknown,
        "G76",
    ),
];

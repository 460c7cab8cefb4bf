//! The settings of grblHAL, and of the sender.

use super::super::grbl::settings::{
    ARC_TOLERANCE, BLOCKS, DEVIATION, ON_ERROR, STEPS, build, laser_mode,
};
use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    ON_ERROR,
    laser_mode("$32"),
    build("tool table", BuildOption::ToolTable, "the build has a tool table, and with it G43 H: `on` or `off`"),
    build(
        "expressions",
        BuildOption::Expressions,
        "the build has parameters, expressions, O words, M98 and G65: `on` or `off`",
    ),
    DEVIATION,
    ARC_TOLERANCE,
    setting(
        "$28",
        SettingField::CHIP_BREAK,
        &[],
        "retract of a chip-breaking peck (G73)",
        Certainty::Documented,
        "settings",
    ),
    STEPS[0],
    STEPS[1],
    STEPS[2],
    BLOCKS,
    setting(
        "jerk",
        SettingField::PATH_JUNCTION_JERK,
        &[],
        "the build limits jerk, by the `max_jerk` of the axes: `on` or `off`",
        Certainty::Documented,
        "options of the build",
    ),
];

//! The settings of FluidNC, named as in its configuration file, and of the sender.

use super::super::grbl::settings::{ON_ERROR, laser_mode};
use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    ON_ERROR,
    laser_mode("laser_mode"),
    of_file(
        "junction_deviation_mm",
        SettingField::PATH_JUNCTION_DEVIATION,
        "junction deviation: how fast corners are passed; 0 stops at each",
    ),
    of_file(
        "arc_tolerance_mm",
        SettingField::PATH_ARC_TOLERANCE,
        "arc tolerance: how far the segments of an arc are from it",
    ),
    of_file("x/steps_per_mm", SettingField::path_steps(0), "steps of X a mm: segments end on whole steps"),
    of_file("y/steps_per_mm", SettingField::path_steps(1), "steps of Y a mm"),
    of_file("z/steps_per_mm", SettingField::path_steps(2), "steps of Z a mm"),
    of_file(
        "planner_blocks",
        SettingField::PATH_JUNCTION_BLOCKS,
        "segments that are known ahead, with the one under way: its number less one",
    ),
];

const fn of_file(name: &'static str, field: SettingField, text: &'static str) -> Setting {
    setting(name, field, &[], text, Certainty::Documented, "configuration file")
}

//! The settings of FluidNC by the names of its configuration file, and of who sends it programs.

use super::super::grbl::settings::{ON_ERROR, laser_mode};
use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    ON_ERROR,
    laser_mode("laser_mode"),
    of_file(
        "junction_deviation_mm",
        PathField::JunctionDeviation,
        "junction deviation: how fast corners are passed; 0 stops at each",
    ),
    of_file(
        "arc_tolerance_mm",
        PathField::ArcTolerance,
        "arc tolerance: how far the segments of an arc are from it",
    ),
    of_file("x/steps_per_mm", PathField::Steps(0), "steps of X a mm: segments end on whole steps"),
    of_file("y/steps_per_mm", PathField::Steps(1), "steps of Y a mm"),
    of_file("z/steps_per_mm", PathField::Steps(2), "steps of Z a mm"),
    of_file(
        "planner_blocks",
        PathField::JunctionBlocks,
        "segments that are known ahead, with the one under way: its number less one",
    ),
];

const fn of_file(name: &'static str, field: PathField, text: &'static str) -> Setting {
    setting(name, SettingField::Path(field), &[], text, Certainty::Documented, "configuration file")
}

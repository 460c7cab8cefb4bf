//! The settings of LinuxCNC (RS274/NGC), by the names of its manuals.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    short_blocks(Certainty::Documented, "G64: P rounds each corner; Q makes one line of nearly straight ones"),
    setting(
        "CENTER_ARC_RADIUS_TOLERANCE_MM",
        SettingField::RADIUS_ERROR_TOLERANCE,
        &[],
        "difference of an arc's radii that is accepted without checking the radius",
        Certainty::Documented,
        "INI file, [RS274NGC]",
    ),
];

//! The settings of LinuxCNC (RS274/NGC), by the names of its manuals.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[setting(
    "CENTER_ARC_RADIUS_TOLERANCE_MM",
    Field::RadiusErrorTolerance,
    &[],
    "difference of an arc's radii that is accepted without checking the radius",
    Certainty::Documented,
    "INI file, [RS274NGC]",
)];

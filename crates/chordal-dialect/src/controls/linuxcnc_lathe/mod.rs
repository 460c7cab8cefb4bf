//! LinuxCNC (RS274/NGC) on a lathe: the interpreter of mills, with the plane ZX at power-on.

use super::linuxcnc::{MILL, PARAMETERS};
use crate::vocabulary::*;

/// LinuxCNC (RS274/NGC) on a lathe, version 2.9.
pub static TABLE: ControlTable = ControlTable {
    name: "linuxcnc-lathe",
    title: "LinuxCNC lathe",
    source: "LinuxCNC G-code reference and lathe user information, version 2.9",
    parameters: Parameters {
        starts_with_radii: true,
        rules: Rules { starts_in: Plane::Zx, ..PARAMETERS.rules },
        ..PARAMETERS
    },
    settings: SETTINGS,
    kind: Some(&crate::lathe_signs::LINUXCNC_LATHE),
    default_machine: "linuxcnc-lathe",
    ..MILL
};

const SETTINGS: &[Setting] = &[
    short_blocks(
        Certainty::Documented,
        "G64: P rounds each corner; Q makes one line of nearly straight ones",
    ),
    setting(
        "CENTER_ARC_RADIUS_TOLERANCE_MM",
        SettingField::RADIUS_ERROR_TOLERANCE,
        &[],
        "difference of an arc's radii that is accepted without checking the radius",
        Certainty::Documented,
        "INI file, [RS274NGC]",
    ),
    setting(
        "X at power-on",
        SettingField::START_RADII,
        &[("G8", "radii"), ("G7", "diameters")],
        "X words are radii (G8), or diameters where RS274NGC_STARTUP_CODE has G7",
        Certainty::Documented,
        "INI file, [RS274NGC] RS274NGC_STARTUP_CODE",
    ),
];

//! The settings of Mach3, by the names of its screens.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    setting(
        "IJ Mode",
        SettingField::ARC_CENTER,
        &[("Inc", "from-start"), ("Absolute", "absolute")],
        "I, J and K at power-on: the way from the start to the centre (`Inc`), or its coordinates (`Absolute`)",
        Certainty::Documented,
        "General Config",
    ),
    setting(
        "G04 Dwell in ms",
        SettingField::DWELL_UNIT,
        &[("off", "s"), ("on", "ms")],
        "P of G4 is in milliseconds (`on`) or seconds (`off`)",
        Certainty::Documented,
        "General Config",
    ),
    setting(
        "Motion Mode",
        SettingField::POWER_ON_PATH_MODE,
        &[("Constant Velocity", "continuous"), ("Exact Stop", "exact-stop")],
        "G64 or G61 at power-on",
        Certainty::Documented,
        "General Config",
    ),
    setting(
        "G73 Pullback",
        SettingField::CHIP_BREAK,
        &[],
        "how far G73 goes back after each peck: each machine has its own value, and this one is assumed",
        Certainty::Unknown,
        "General Config",
    ),
    setting(
        "arc tolerance",
        SettingField::RADIUS_ERROR_TOLERANCE,
        &[],
        "difference of an arc's radii that is accepted: not published, LinuxCNC's is assumed",
        Certainty::Unknown,
        "",
    ),
    short_blocks(
        Certainty::Unknown,
        "constant velocity: how it passes corners is not published, that of LinuxCNC's G64 is assumed",
    ),
];

//! The settings of GRBL 1.1, and of the sender.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    ON_ERROR,
    setting(
        "M6",
        SettingField::TOOL_CHANGER,
        &[],
        "who changes tools: the `sender`, which keeps M6 from GRBL, or `nobody`: error:20",
        Certainty::Practice,
        "senders; GRBL itself refuses M6",
    ),
    build("mist coolant", BuildOption::Mist, "the build has M7: `on` or `off`"),
    DEVIATION,
    ARC_TOLERANCE,
    STEPS[0],
    STEPS[1],
    STEPS[2],
    BLOCKS,
    laser_mode("$32"),
];

/// What a sender does after an error.
pub(in crate::controls) const ON_ERROR: Setting = setting(
    "on error",
    SettingField::AFTER_REFUSAL,
    &[],
    "what the sender does after a block that the firmware refuses: `stop` or `continue`",
    Certainty::Practice,
    "senders; the firmware itself goes on with the next block",
);

/// Junction deviation (`$11`).
pub(in crate::controls) const DEVIATION: Setting = setting(
    "$11",
    SettingField::PATH_JUNCTION_DEVIATION,
    &[],
    "junction deviation: how fast corners are passed; 0 stops at each",
    Certainty::Documented,
    "settings",
);

/// Arc tolerance (`$12`).
pub(in crate::controls) const ARC_TOLERANCE: Setting = setting(
    "$12",
    SettingField::PATH_ARC_TOLERANCE,
    &[],
    "arc tolerance: how far the segments of an arc are from it",
    Certainty::Documented,
    "settings",
);

/// Steps per mm (`$100` to `$102`).
pub(in crate::controls) const STEPS: [Setting; 3] = [
    steps("$100", 0, "steps of X a mm: segments end on whole steps"),
    steps("$101", 1, "steps of Y a mm"),
    steps("$102", 2, "steps of Z a mm"),
];

/// How many blocks the planner's queue holds.
pub(in crate::controls) const BLOCKS: Setting = setting(
    "planner blocks",
    SettingField::PATH_JUNCTION_BLOCKS,
    &[],
    "segments that are known ahead, with the one under way",
    Certainty::Documented,
    "BLOCK_BUFFER_SIZE of the build, less one",
);

/// Whether the output of the spindle drives a laser.
pub(in crate::controls) const fn laser_mode(name: &'static str) -> Setting {
    setting(
        name,
        SettingField::PATH_LASER_MODE,
        &[],
        "laser mode: another S in a block with a motion does not stop the axes: `on` or `off`",
        Certainty::Documented,
        "GRBL 1.1, laser mode",
    )
}

/// A setting for an option of the build.
pub(in crate::controls) const fn build(name: &'static str, option: BuildOption, text: &'static str) -> Setting {
    setting(name, SettingField::build(option), &[], text, Certainty::Documented, "options of the build")
}

const fn steps(name: &'static str, axis: u8, text: &'static str) -> Setting {
    let field = SettingField::path_steps(axis);
    setting(name, field, &[], text, Certainty::Documented, "settings")
}

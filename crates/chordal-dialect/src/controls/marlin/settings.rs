//! The settings of Marlin, by the names of its configuration files. Most are fixed when the firmware is built.

use crate::vocabulary::*;

pub(super) const SETTINGS: &[Setting] = &[
    setting(
        "G0_FEEDRATE",
        SettingField::RAPID_FEED,
        &[],
        "G0 moves at this feed, mm/min; `programmed`: at the F in force, as G1 does",
        Certainty::Documented,
        ADVANCED,
    ),
    build("GCODE_MOTION_MODES", BuildOption::MotionModes, "a line of words alone goes on with the motion before it"),
    build("CNC_COORDINATE_SYSTEMS", BuildOption::WorkSystems, "G53 to G59.3"),
    build("CNC_WORKSPACE_PLANES", BuildOption::Planes, "G17, G18, G19"),
    build("INCH_MODE_SUPPORT", BuildOption::Inch, "G20; without it G21 is passed over"),
    build("ARC_P_CIRCLES", BuildOption::Turns, "P of G2 and G3 counts full circles before the arc"),
    build("BEZIER_CURVE_SUPPORT", BuildOption::Splines, "G5"),
    build("G38_PROBE_TARGET", BuildOption::Probe, "G38.2 to G38.5"),
    build("COOLANT_CONTROL", BuildOption::Coolant, "M7, M8, M9"),
    build("PAREN_COMMENTS", BuildOption::Parentheses, "parentheses enclose comments"),
    build("GCODE_CASE_INSENSITIVE", BuildOption::LowerCase, "lower-case letters count"),
    setting(
        "M3 P",
        SettingField::POWER_LETTER,
        &[],
        "P of M3 and M4 is the power in percent (Snapmaker): `on` or `off`",
        Certainty::Practice,
        "posts for Snapmaker",
    ),
    path(
        "JUNCTION_DEVIATION_MM",
        SettingField::PATH_JUNCTION_DEVIATION,
        "how fast corners are passed, where CLASSIC_JERK is off",
    ),
    path(
        "DEFAULT_XJERK",
        SettingField::path_speed_step(0),
        "CLASSIC_JERK: X may change its speed at once by this, mm/s; `none`: the junction deviation counts",
    ),
    path("DEFAULT_YJERK", SettingField::path_speed_step(1), "the same of Y"),
    path("DEFAULT_ZJERK", SettingField::path_speed_step(2), "the same of Z"),
    path("MIN_ARC_SEGMENT_MM", SettingField::PATH_ARC_SEGMENT_LEAST, "the shortest segment of an arc"),
    path("MAX_ARC_SEGMENT_MM", SettingField::PATH_ARC_SEGMENT_MOST, "the longest segment of an arc"),
    path(
        "MIN_CIRCLE_SEGMENTS",
        SettingField::PATH_ARC_SEGMENTS_OF_CIRCLE,
        "a full circle has so many segments at least",
    ),
    path("M92 X", SettingField::path_steps(0), "steps of X a mm: segments end on whole steps"),
    path("M92 Y", SettingField::path_steps(1), "steps of Y a mm"),
    path("M92 Z", SettingField::path_steps(2), "steps of Z a mm"),
    path("BLOCK_BUFFER_SIZE", SettingField::PATH_JUNCTION_BLOCKS, "segments that are known ahead: the size of the queue, less one"),
    setting(
        "arc end",
        SettingField::RADIUS_ERROR_TOLERANCE,
        &[],
        "how far the end may be off its arc before it is reported: Marlin itself does not look, and goes there with the \
         last segment",
        Certainty::Unknown,
        "",
    ),
];

const ADVANCED: &str = "Configuration_adv.h";

const fn build(name: &'static str, option: BuildOption, text: &'static str) -> Setting {
    setting(name, SettingField::build(option), &[], text, Certainty::Documented, ADVANCED)
}

const fn path(name: &'static str, field: SettingField, text: &'static str) -> Setting {
    setting(name, field, &[], text, Certainty::Documented, "Configuration.h, Configuration_adv.h")
}

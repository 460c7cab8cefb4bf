//! Settings of tool lengths: what activates one and what cancels it.

use chordal_kernel::rules::{LengthWithoutNumber, ToolLengths};

use super::choices::{choose, name_of};
use super::field::{SettingField, setting_fields};
use super::{Certainty, Setting, common, setting};

pub(super) const COMMON: &[Setting] = &[
    common(
        "tool_lengths",
        SettingField::LENGTH_SOURCE,
        "where the length of a tool comes from: `table` (a code of the program), `touched-off` (the work offset is set with each tool) or `absent`",
    ),
    common(
        "length_without_h",
        SettingField::LENGTH_WITHOUT_NUMBER,
        "G43 without H: the length that is `in-force` (none at power-on), or that of the `tool` in the spindle",
    ),
    common(
        "length_in_increment",
        SettingField::LENGTH_IN_INCREMENT,
        "`G91 G43 Z-32. H1`: the length is `added` to the way of Z, or `not-added`",
    ),
    setting(
        "length_with_h0",
        SettingField::LENGTH_OF_ZERO,
        &[],
        "`G43 H0`: `none` is in force, or the length of the `tool` in the spindle",
        Certainty::Documented,
        "LinuxCNC: documentation of G43, of changers that put tools back",
    ),
    setting(
        "length_at_tool_change",
        SettingField::LENGTH_AT_TOOL_CHANGE,
        &[],
        "a change of tools: the length in force is `kept` or `ended`",
        Certainty::Practice,
        "Haas: manual, G43 (ended by G49, H0, M30 and reset); the others: how programs are written, no manual was found",
    ),
    setting(
        "length_at_reference_return",
        SettingField::LENGTH_AT_REFERENCE_RETURN,
        &[],
        "G28 or G30 with Z: the length in force is `kept` or `ended`",
        Certainty::Practice,
        "Haas: manual, G43 (ended by G49, H0, M30 and reset); the others: how programs are written, no manual was found",
    ),
    setting(
        "length_at_machine_move",
        SettingField::LENGTH_AT_MACHINE_MOVE,
        &[],
        "G53 with Z: the length in force is `kept` or `ended`",
        Certainty::Practice,
        "Haas: manual, G43 (ended by G49, H0, M30 and reset); the others: how programs are written, no manual was found",
    ),
    setting(
        "length_at_program_end",
        SettingField::LENGTH_AT_PROGRAM_END,
        &[],
        "M2, M30 and reset: the length in force is `ended`, or `kept` for the program that follows",
        Certainty::Practice,
        "Haas: manual, G43 (ended by G49, H0, M30 and reset); LinuxCNC: documentation of M2 and M30, whose list has no \
         tool length (kept); the others: how programs are written, no manual was found",
    ),
];

const TOOL_LENGTHS: &[(&str, ToolLengths)] = &[
    ("table", ToolLengths::Table),
    ("touched-off", ToolLengths::TouchedOff),
    ("absent", ToolLengths::Absent),
];

const LENGTHS_WITHOUT_NUMBER: &[(&str, LengthWithoutNumber)] =
    &[("in-force", LengthWithoutNumber::InForce), ("tool", LengthWithoutNumber::OfTool)];

const LENGTHS_IN_INCREMENT: &[(&str, bool)] = &[("added", true), ("not-added", false)];

const LENGTHS_OF_ZERO: &[(&str, bool)] = &[("none", false), ("tool", true)];

const LENGTH_ENDS: &[(&str, bool)] = &[("kept", false), ("ended", true)];

setting_fields! {
    LENGTH_SOURCE = choice(rules.length.source, TOOL_LENGTHS);
    LENGTH_WITHOUT_NUMBER = choice(rules.length.without_number, LENGTHS_WITHOUT_NUMBER);
    LENGTH_IN_INCREMENT = choice(rules.length.adds_to_increment, LENGTHS_IN_INCREMENT);
    LENGTH_OF_ZERO = choice(rules.length.zero_is_of_tool, LENGTHS_OF_ZERO);
    LENGTH_AT_TOOL_CHANGE = choice(rules.length.ended_by.tool_change, LENGTH_ENDS);
    LENGTH_AT_REFERENCE_RETURN = choice(rules.length.ended_by.reference_return, LENGTH_ENDS);
    LENGTH_AT_MACHINE_MOVE = choice(rules.length.ended_by.machine_move, LENGTH_ENDS);
    LENGTH_AT_PROGRAM_END = choice(rules.length.ended_by.program_end, LENGTH_ENDS);
}

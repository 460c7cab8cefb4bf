//! What brings a tool length into force and what ends it, as settings of a machine file.

use chordal_kernel::rules::{LengthWithoutNumber, ToolLengths};

use super::choices::{choose, name_of};
use super::{Certainty, Setting, SettingField, common, setting};
use crate::parameters::Parameters;

/// The rule of tool lengths that a setting changes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "each names a field of `LengthRules`")]
pub enum LengthField {
    Source,
    WithoutNumber,
    InIncrement,
    OfZero,
    AtToolChange,
    AtReferenceReturn,
    AtMachineMove,
}

pub(super) const COMMON: &[Setting] = &[
    common(
        "tool_lengths",
        SettingField::Length(LengthField::Source),
        "where the length of a tool comes from: `table` (a code of the program), `touched-off` (the work offset is set with each tool) or `absent`",
    ),
    common(
        "length_without_h",
        SettingField::Length(LengthField::WithoutNumber),
        "G43 without H: the length that is `in-force` (none at power-on), or that of the `tool` in the spindle",
    ),
    common(
        "length_in_increment",
        SettingField::Length(LengthField::InIncrement),
        "`G91 G43 Z-32. H1`: the length is `added` to the way of Z, or `not-added`",
    ),
    setting(
        "length_with_h0",
        SettingField::Length(LengthField::OfZero),
        &[],
        "`G43 H0`: `none` is in force, or the length of the `tool` in the spindle",
        Certainty::Documented,
        "LinuxCNC: documentation of G43, of changers that put tools back",
    ),
    setting(
        "length_at_tool_change",
        SettingField::Length(LengthField::AtToolChange),
        &[],
        "a change of tools: the length in force is `kept` or `ended`",
        Certainty::Trade,
        "Haas: manual, G43 (ended by G49, H0, M30 and reset); the others: how programs are written, no manual was found",
    ),
    setting(
        "length_at_reference_return",
        SettingField::Length(LengthField::AtReferenceReturn),
        &[],
        "G28 or G30 with Z: the length in force is `kept` or `ended`",
        Certainty::Trade,
        "Haas: manual, G43 (ended by G49, H0, M30 and reset); the others: how programs are written, no manual was found",
    ),
    setting(
        "length_at_machine_move",
        SettingField::Length(LengthField::AtMachineMove),
        &[],
        "G53 with Z: the length in force is `kept` or `ended`",
        Certainty::Trade,
        "Haas: manual, G43 (ended by G49, H0, M30 and reset); the others: how programs are written, no manual was found",
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

/// Sets one of them; the error says what it takes.
pub(super) fn set(p: &mut Parameters, field: LengthField, word: &str) -> Result<(), String> {
    let rules = &mut p.rules.length;
    match field {
        LengthField::Source => rules.source = choose(word, TOOL_LENGTHS)?,
        LengthField::WithoutNumber => {
            rules.without_number = choose(word, LENGTHS_WITHOUT_NUMBER)?;
        }
        LengthField::InIncrement => {
            rules.adds_to_increment = choose(word, LENGTHS_IN_INCREMENT)?;
        }
        LengthField::OfZero => rules.zero_is_of_tool = choose(word, LENGTHS_OF_ZERO)?,
        LengthField::AtToolChange => {
            rules.ended_by.tool_change = choose(word, LENGTH_ENDS)?;
        }
        LengthField::AtReferenceReturn => {
            rules.ended_by.reference_return = choose(word, LENGTH_ENDS)?;
        }
        LengthField::AtMachineMove => {
            rules.ended_by.machine_move = choose(word, LENGTH_ENDS)?;
        }
    }
    Ok(())
}

/// The present value, as a machine file writes it.
pub(super) fn value_text(p: &Parameters, field: LengthField) -> String {
    let rules = &p.rules.length;
    match field {
        LengthField::Source => name_of(rules.source, TOOL_LENGTHS),
        LengthField::WithoutNumber => name_of(rules.without_number, LENGTHS_WITHOUT_NUMBER),
        LengthField::InIncrement => name_of(rules.adds_to_increment, LENGTHS_IN_INCREMENT),
        LengthField::OfZero => name_of(rules.zero_is_of_tool, LENGTHS_OF_ZERO),
        LengthField::AtToolChange => name_of(rules.ended_by.tool_change, LENGTH_ENDS),
        LengthField::AtReferenceReturn => name_of(rules.ended_by.reference_return, LENGTH_ENDS),
        LengthField::AtMachineMove => name_of(rules.ended_by.machine_move, LENGTH_ENDS),
    }
}

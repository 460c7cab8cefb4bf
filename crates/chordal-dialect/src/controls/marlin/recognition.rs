//! Signs by which programs of routers and lasers with Marlin are recognized. Those of printers are in `not_read`.

use crate::vocabulary::*;

const NAMES: &[&str] = &[
    "MARLIN",
    "SNAPMAKER",
    "MPCNC",
    "LOWRIDER",
    "V1 ENGINEERING",
    "V1CNC",
    "KIRI:MOTO",
    "HEADER_TYPE: CNC",
    "HEADER_TYPE: LASER",
    "HEADER START",
];

/// Fewer signs than these are no sign: a plain program is for any control.
pub(super) static KIND: MachineKind = MachineKind { turns: false, signs: SIGNS, needed: 6 };

const SIGNS: &[Evidence] = &[
    evidence(Sign::Header(NAMES), 14, "the header names Marlin or a machine that has it"),
    evidence(Sign::Comment(NAMES), 10, "a comment names Marlin or a machine that has it"),
    evidence(Sign::Block("M84"), 5, "M84 switches the motors off"),
    evidence(Sign::Block("M400"), 6, "M400 waits for the moves"),
    evidence(Sign::Block("M106|M107"), 5, "M106 switches a fan or what is on its output"),
    evidence(Sign::Block("M280 P S"), 6, "M280 moves a servo"),
    evidence(Sign::Block("M3 P"), 5, "M3 P is a power in percent"),
    evidence(Sign::Block("G4 S !T"), 3, "G4 S is a dwell in seconds"),
    evidence(Sign::Code(&["M117 "]), 6, "M117 shows a text"),
    evidence(Sign::Block("G0 F X|Y|Z"), 3, "F is written with G0"),
    evidence(Sign::Form(Form::MacroStatement), -8, "macro statements"),
    evidence(Sign::Form(Form::OWord), -12, "O words are flow control"),
    evidence(Sign::Form(Form::DollarLine), -8, "$ commands"),
    evidence(Sign::Block("G81..89"), -6, "canned cycles"),
    evidence(Sign::Block("G43 H"), -8, "G43 applies the tool length"),
    evidence(Sign::Block("G1 E:dec"), -14, "E is the way of the filament"),
    evidence(Sign::Block("M104|M109|M140|M190 S"), -14, "M104 and M140 set temperatures"),
];

pub(super) const EVIDENCE: &[Evidence] =
    &[evidence(Sign::Form(Form::SemicolonComments), 1, "comments begin with a semicolon")];

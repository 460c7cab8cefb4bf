//! Signs by which programs for routers and lasers with Marlin are recognized. Those for printers are in `not_read`.

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

/// A lower sum shows nothing: a plain program is for any control.
pub(super) static KIND: MachineKind = MachineKind { turns: false, signs: SIGNS, needed: 6 };

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 14, "the header names Marlin or a machine that has it"),
    evidence(RecognitionSign::Comment(NAMES), 10, "a comment names Marlin or a machine that has it"),
    evidence(RecognitionSign::Block("M84"), 5, "M84 switches the motors off"),
    evidence(RecognitionSign::Block("M400"), 6, "M400 waits for the moves"),
    evidence(RecognitionSign::Block("M106|M107"), 5, "M106 switches a fan or what is on its output"),
    evidence(RecognitionSign::Block("M280 P S"), 6, "M280 moves a servo"),
    evidence(RecognitionSign::Block("M3 P"), 5, "M3 P is a power in percent"),
    evidence(RecognitionSign::Block("G4 S !T"), 3, "G4 S is a dwell in seconds"),
    evidence(RecognitionSign::Code(&["M117 "]), 6, "M117 shows a text"),
    evidence(RecognitionSign::Block("G0 F X|Y|Z"), 3, "F is written with G0"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -8, "macro statements"),
    evidence(RecognitionSign::Form(TextForm::OWord), -12, "O words are flow control"),
    evidence(RecognitionSign::Form(TextForm::DollarLine), -8, "$ commands"),
    evidence(RecognitionSign::Block("G81..89"), -6, "canned cycles"),
    evidence(RecognitionSign::Block("G43 H"), -8, "G43 applies the tool length"),
    evidence(RecognitionSign::Block("G1 E:dec"), -14, "E is the way of the filament"),
    evidence(RecognitionSign::Block("M104|M109|M140|M190 S"), -14, "M104 and M140 set temperatures"),
];

pub(super) const EVIDENCE: &[RecognitionEvidence] =
    &[evidence(RecognitionSign::Form(TextForm::SemicolonComments), 1, "comments begin with a semicolon")];

//! Signs by which programs of Haas mills are recognized. G53 is none of them: posts for all controls write it.

use crate::vocabulary::*;

/// Names of Haas controls, those of lathes included.
pub(crate) const NAMES: &[&str] = &["HAAS", "HAAS AUTOMATION", "NGC CONTROL"];

const MODELS: &[&str] = &[
    "VF-1", "VF-2", "VF-3", "VF-4", "VF-5", "VF-6", "VF2", "VF3", "VF4", "VF2SS", "VF-2SS", "VF2YT",
    "VF-2YT", "VM-2", "VM-3", "TM-1", "TM-2", "TM-1P", "TM-2P", "DT-1", "DM-1", "DM-2", "UMC-500",
    "UMC-750", "UMC750", "EC-400", "EC-500", "SUPER MINI MILL", "MINI MILL",
];

pub(super) const EVIDENCE: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 12, "the header names a Haas"),
    evidence(RecognitionSign::Comment(NAMES), 7, "a comment names a Haas"),
    evidence(RecognitionSign::Header(MODELS), 12, "the header names a Haas"),
    evidence(RecognitionSign::Comment(MODELS), 6, "a comment names a model of Haas"),
    evidence(RecognitionSign::Block("G154 P"), 8, "G154 chooses an extended work offset"),
    evidence(RecognitionSign::Block("G187"), 7, "G187 sets smoothness"),
    evidence(RecognitionSign::Block("G150 P"), 6, "G150 mills a pocket"),
    evidence(RecognitionSign::Block("G103"), 6, "G103 limits look-ahead"),
    evidence(RecognitionSign::Block("G234"), 7, "G234 is tool centre point control"),
    evidence(RecognitionSign::Block("G254|G255"), 6, "G254 is dynamic work offset"),
    evidence(RecognitionSign::Block("G253"), 6, "G253 turns the spindle to the feature"),
    evidence(RecognitionSign::Block("G12|G13 I D"), 2, "G12 mills a circular pocket"),
    evidence(RecognitionSign::Block("G12|G13 K Q"), 4, "G12 mills a circular pocket"),
    evidence(RecognitionSign::Block("G70|G71|G72 I J L"), 2, "G70 to G72 drill a pattern"),
    evidence(RecognitionSign::Block("G136"), 3, "G136 probes a centre"),
    evidence(RecognitionSign::Block("G35|G37 D|H !X"), 2, "G35 to G37 measure the tool"),
    evidence(RecognitionSign::Block("G110..129"), 4, "G110 to G129 choose a work offset"),
    evidence(RecognitionSign::Block("M97 P"), 5, "M97 calls within the program"),
    evidence(RecognitionSign::Block("M88|M89"), 1, "M88 is coolant through the spindle"),
    evidence(RecognitionSign::Block("M31|M33"), 1, "M31 and M33 drive the chip conveyor"),
    evidence(RecognitionSign::Block("M130|M131"), 3, "M130 shows a picture"),
    evidence(RecognitionSign::Block("M109 P"), 4, "M109 asks the operator"),
    evidence(RecognitionSign::Block("M83|M84"), 2, "M83 is the air gun"),
    evidence(RecognitionSign::Block("O:5"), 3, "a program number of five digits"),
    evidence(RecognitionSign::Code(&["#10000", "#8550", "#3032"]), 2, "variables of Haas"),
    evidence(RecognitionSign::Block("G43 H:3"), 3, "H has three digits, as SolidCAM writes it for a Haas"),
    evidence(RecognitionSign::Comment(&["* TOOL LIST *"]), 4, "the tool list as SolidCAM writes it for a Haas"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), 1, "macro B statements"),
    evidence(RecognitionSign::Block("G43"), 1, "G43 applies the tool length"),
    // Codes that a Haas refuses.
    evidence(RecognitionSign::Block("G5.1|G8 P|Q"), -4, "look-ahead codes of another control"),
    evidence(RecognitionSign::Block("M29"), -3, "M29 announces rigid tapping"),
    evidence(RecognitionSign::Form(TextForm::MixedNumbers), -3, "whole numbers without a point next to decimals"),
];

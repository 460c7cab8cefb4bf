//! Signs by which programs of Haas mills are recognized. G53 says nothing: every post writes it.

use crate::vocabulary::*;

/// Also those of Haas lathes.
pub(crate) const NAMES: &[&str] = &["HAAS", "HAAS AUTOMATION", "NGC CONTROL"];

const MODELS: &[&str] = &[
    "VF-1", "VF-2", "VF-3", "VF-4", "VF-5", "VF-6", "VF2", "VF3", "VF4", "VF2SS", "VF-2SS", "VF2YT",
    "VF-2YT", "VM-2", "VM-3", "TM-1", "TM-2", "TM-1P", "TM-2P", "DT-1", "DM-1", "DM-2", "UMC-500",
    "UMC-750", "UMC750", "EC-400", "EC-500", "SUPER MINI MILL", "MINI MILL",
];

pub(super) const EVIDENCE: &[Evidence] = &[
    evidence(Sign::Header(NAMES), 12, "the header names a Haas"),
    evidence(Sign::Comment(NAMES), 7, "a comment names a Haas"),
    evidence(Sign::Header(MODELS), 12, "the header names a Haas"),
    evidence(Sign::Comment(MODELS), 6, "a comment names a model of Haas"),
    evidence(Sign::Block("G154 P"), 8, "G154 chooses an extended work offset"),
    evidence(Sign::Block("G187"), 7, "G187 sets smoothness"),
    evidence(Sign::Block("G150 P"), 6, "G150 mills a pocket"),
    evidence(Sign::Block("G103"), 6, "G103 limits look-ahead"),
    evidence(Sign::Block("G234"), 7, "G234 is tool centre point control"),
    evidence(Sign::Block("G254|G255"), 6, "G254 is dynamic work offset"),
    evidence(Sign::Block("G253"), 6, "G253 turns the spindle to the feature"),
    evidence(Sign::Block("G12|G13 I D"), 2, "G12 mills a circular pocket"),
    evidence(Sign::Block("G12|G13 K Q"), 4, "G12 mills a circular pocket"),
    evidence(Sign::Block("G70|G71|G72 I J L"), 2, "G70 to G72 drill a pattern"),
    evidence(Sign::Block("G136"), 3, "G136 probes a centre"),
    evidence(Sign::Block("G35|G37 D|H !X"), 2, "G35 to G37 measure the tool"),
    evidence(Sign::Block("G110..129"), 4, "G110 to G129 choose a work offset"),
    evidence(Sign::Block("M97 P"), 5, "M97 calls within the program"),
    evidence(Sign::Block("M88|M89"), 1, "M88 is coolant through the spindle"),
    evidence(Sign::Block("M31|M33"), 1, "M31 and M33 drive the chip conveyor"),
    evidence(Sign::Block("M130|M131"), 3, "M130 shows a picture"),
    evidence(Sign::Block("M109 P"), 4, "M109 asks the operator"),
    evidence(Sign::Block("M83|M84"), 2, "M83 is the air gun"),
    evidence(Sign::Block("O:5"), 3, "a program number of five digits"),
    evidence(Sign::Code(&["#10000", "#8550", "#3032"]), 2, "variables of Haas"),
    evidence(Sign::Block("G43 H:3"), 3, "H has three digits, as SolidCAM writes it for a Haas"),
    evidence(Sign::Form(Form::MacroStatement), 1, "macro B statements"),
    evidence(Sign::Block("G43"), 1, "G43 applies the tool length"),
    // Codes that a Haas refuses.
    evidence(Sign::Block("G5.1|G8 P|Q"), -4, "look-ahead codes of another control"),
    evidence(Sign::Block("M29"), -3, "M29 announces rigid tapping"),
    evidence(Sign::Form(Form::MixedNumbers), -3, "whole numbers without a point next to decimals"),
];

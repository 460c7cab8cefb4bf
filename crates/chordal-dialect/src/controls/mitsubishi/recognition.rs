//! Signs by which programs of Mitsubishi M700 and M800 are recognized, and ISO programs of Mazak, whose controls are
//! made by Mitsubishi.

use crate::vocabulary::*;

pub(in crate::controls) const NAMES: &[&str] = &[
    "MITSUBISHI", "MELDAS", "M70", "M700", "M80", "M800", "M700V", "M70V", "M64", "M520", "M80W",
];

pub(in crate::controls) const MAZAK: &[&str] = &[
    "MAZAK", "MAZATROL", "VARIAXIS", "INTEGREX", "NEXUS", "VTC-200", "VCN-510", "VCN-530", "SMOOTHX", "SMOOTHG",
    "MATRIX", "FJV",
];

pub(super) const EVIDENCE: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 12, "the header names a Mitsubishi"),
    evidence(RecognitionSign::Comment(&["MITSUBISHI", "MELDAS"]), 7, "a comment names a Mitsubishi"),
    evidence(RecognitionSign::Header(MAZAK), 11, "the header names a Mazak, whose control is of Mitsubishi"),
    evidence(RecognitionSign::Comment(MAZAK), 6, "a comment names a Mazak, whose control is of Mitsubishi"),
    evidence(RecognitionSign::Block("G2.1|G3.1 X|Y"), 8, "G2.1 cuts a spiral"),
    evidence(RecognitionSign::Block("G61.1"), 5, "G61.1 switches high-accuracy control on"),
    evidence(RecognitionSign::Block("G34.1|G35.1|G36.1|G37.1"), 6, "G34.1 to G37.1 drill a pattern"),
    evidence(RecognitionSign::Block("G5 P:1 P>0 P<9"), 5, "G5 P1 and P2 are high-speed modes"),
    evidence(RecognitionSign::Block("M98 H"), 5, "M98 with H begins at a block"),
    evidence(RecognitionSign::Block("G54.1 P"), 1, "G54.1 chooses an extended work offset"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), 1, "macro B statements"),
    evidence(RecognitionSign::Block("G43"), 1, "G43 applies the tool length"),
    evidence(RecognitionSign::Block("G84|G74 ,R"), 3, ",R1 in a cycle is synchronous tapping"),
    evidence(RecognitionSign::Form(TextForm::MixedNumbers), -3, "whole numbers without a point next to decimals"),
];

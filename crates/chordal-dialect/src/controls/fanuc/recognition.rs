//! Signs by which programs of Fanuc controls and of machines that have one are recognized.

use crate::vocabulary::*;

/// Names of Fanuc controls, those of lathes included.
pub(crate) const NAMES: &[&str] = &[
    "FANUC", "FANUC 0I", "0I-MD", "0I-MF", "0I-MC", "0I-TD", "0I-TF", "31I", "30I", "32I", "18I", "16I",
    "21I", "OI-MD", "OI-MF",
];

/// Builders and machines with a Fanuc, or with a control that reads programs as a Fanuc does.
pub(crate) const MACHINES: &[&str] = &[
    "DOOSAN", "DAEWOO", "DN SOLUTIONS", "DNM", "ROBODRILL", "MAKINO", "MATSUURA", "KITAMURA", "MYCENTER",
    "MORI SEIKI", "MORISEIKI", "HYUNDAI", "HYUNDAI-WIA", "WIA", "YCM", "FEELER", "LEADWELL", "HARDINGE",
    "BRIDGEPORT", "TOYODA", "ENSHU", "HWACHEON", "SAMSUNG", "AWEA", "TAKISAWA", "JOHNFORD", "QUASER",
    "LITZ", "MITSUI SEIKI", "CHIRON", "OKK", "KIA",
];

/// Controls of other makers that read blocks as a Fanuc does.
const RELATED_CONTROLS: &[&str] = &["BROTHER", "SPEEDIO", "TC-S2D", "S700X1", "HURCO", "WINMAX", "CENTROID", "SYIL"];

pub(super) const EVIDENCE: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 12, "the header names a Fanuc"),
    evidence(RecognitionSign::Comment(NAMES), 7, "a comment names a Fanuc"),
    evidence(RecognitionSign::Header(MACHINES), 10, "the header names a machine that has a Fanuc"),
    evidence(RecognitionSign::Comment(MACHINES), 6, "a comment names a machine that has a Fanuc"),
    evidence(RecognitionSign::Header(RELATED_CONTROLS), 9, "the header names a control that reads as a Fanuc"),
    evidence(RecognitionSign::Comment(RELATED_CONTROLS), 6, "a comment names a control that reads as a Fanuc"),
    evidence(RecognitionSign::Block("G54.1 P"), 3, "G54.1 chooses an extended work offset"),
    evidence(RecognitionSign::Block("G5.1 Q"), 4, "G5.1 switches look-ahead on"),
    evidence(RecognitionSign::Block("G8 P"), 4, "G8 P1 switches look-ahead on"),
    evidence(RecognitionSign::Block("G5 P>99"), 5, "G5 P10000 switches look-ahead on"),
    evidence(RecognitionSign::Block("G43.4|G43.5|G68.2|G53.1"), 3, "G43.4 and G68.2 are tool centre point control"),
    evidence(RecognitionSign::Block("M29"), 4, "M29 announces rigid tapping"),
    evidence(RecognitionSign::Block("G10 L52|L50"), 3, "G10 L50 sets parameters"),
    evidence(RecognitionSign::Code(&["SETVN["]), 5, "SETVN names variables"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), 1, "macro B statements"),
    evidence(RecognitionSign::Block("G43"), 1, "G43 applies the tool length"),
    evidence(RecognitionSign::Code(&["&F=/", "<PROG", "//CNC_MEM"]), 6, "folder lines of a Fanuc memory"),
    evidence(RecognitionSign::Block("O:4"), 1, "a program number of four digits"),
    evidence(RecognitionSign::Block("G40 G17 G90 G70|G71 !P !G91.1"), 8, "NX writes the units as G70 or G71")
        .on("fanuc-units-g70"),
    evidence(RecognitionSign::Codes(&["G70", "G71"]), 3, "the units are G70 or G71").on("fanuc-units-g70"),
    evidence(RecognitionSign::Form(TextForm::MixedNumbers), -3, "whole numbers without a point next to decimals"),
];

//! Signs by which programs of Fadal CNC 88 are recognized.

use crate::vocabulary::*;

const NAMES: &[&str] = &["FADAL", "CNC88", "CNC 88", "VMC 4020", "VMC4020", "VMC 3016", "VMC 6030"];

pub(super) const EVIDENCE: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 12, "the header names a Fadal"),
    evidence(RecognitionSign::Comment(NAMES), 7, "a comment names a Fadal"),
    evidence(RecognitionSign::Form(TextForm::SubroutineHead), 8, "a subroutine section headed by an L word"),
    evidence(RecognitionSign::Block("M17 !S !T"), 3, "M17 ends a subroutine"),
    evidence(RecognitionSign::Form(TextForm::Register), 8, "R0+ is a register word"),
    evidence(RecognitionSign::Form(TextForm::HashLine), 8, "macro lines begin with #"),
    // Not in macro calls, where E is an argument.
    evidence(
        RecognitionSign::Block("E:int X|Y E<100 !G65 !G66 !G66.1 !M98 !G10 !F"),
        5,
        "E chooses a work offset",
    ),
    evidence(RecognitionSign::Block("E:int X|Y E<100 S !G65 !G66 !G66.1 !M98 !G10"), 5, "E chooses a work offset"),
    evidence(
        RecognitionSign::Block("H Z !G43 !G43.1 !G43.4 !G44 !G49 !G56 !G65 !G66 !G10 !M98 !P"),
        3,
        "H applies the length without G43",
    ),
    evidence(RecognitionSign::Form(TextForm::OpenComments), 3, "comments are left open"),
    evidence(RecognitionSign::Block("G8 !P"), 2, "G8 switches feed ramps off"),
    evidence(RecognitionSign::Block("G9 !X !Y !Z"), 1, "G9 switches feed ramps on"),
    evidence(RecognitionSign::Block("N O"), 3, "the program number has a block number"),
    evidence(RecognitionSign::Block("M45"), 4, "M45 runs a cycle on the spot"),
    evidence(RecognitionSign::Block("M46|M47|M49 !P"), 1, "M46 to M49"),
    evidence(RecognitionSign::Block("L>9099 L<9999 !P"), 6, "L9101 to L9998 are fixed routines"),
    evidence(RecognitionSign::Block("G43"), -3, "G43 applies the length"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -3, "macro statements of another language"),
    evidence(RecognitionSign::Form(TextForm::MixedNumbers), -3, "whole numbers without a point next to decimals"),
];

//! Signs by which programs of GRBL and its relatives are recognized. Nearly all of their blocks mean the same on
//! other controls: names, and commands that no other control has, weigh most.

use crate::vocabulary::*;

const NAMES: &[&str] = &[
    "GRBL",
    "SHAPEOKO",
    "CARBIDE 3D",
    "CARBIDE MOTION",
    "X-CARVE",
    "XCARVE",
    "EASEL",
    "OPENBUILDS",
    "LIGHTBURN",
    "LASERGRBL",
    "UGS",
    "NOMAD",
    "SAINSMART",
    "GENMITSU",
    "CANDLE",
];

/// A lower sum shows nothing: a plain program is for any control.
pub(super) static KIND: MachineKind = MachineKind { turns: false, signs: SIGNS, needed: 6 };

/// Names in comments of CAM systems for small routers.
const ROUTER_SOURCES: &[&str] = &["ESTLCAM", "FLATCAM", "MAKERCAM", "KIRI:MOTO", "JSCUT", "LASERWEB"];

/// Comments of Carbide Create, whose machines have GRBL.
const CARBIDE_CREATE: &[&str] = &["TOOL/MILL", "STOCK/BLOCK", "PREPOSITION FOR RAPID PLUNGE", "STOCKMIN:", "DESIGN FILE:"];

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 14, "the header names GRBL or a machine that has it"),
    evidence(RecognitionSign::Comment(NAMES), 10, "a comment names GRBL or a machine that has it"),
    evidence(RecognitionSign::Comment(CARBIDE_CREATE), 8, "comments as Carbide Create writes them"),
    evidence(RecognitionSign::Comment(ROUTER_SOURCES), 3, "a comment names software for small routers"),
    evidence(RecognitionSign::Comment(&["-ATTENTION- PROPERTY SAFE RETRACTS"]), 4, "the post for GRBL speaks of safe retracts"),
    evidence(RecognitionSign::Form(TextForm::DollarLine), 6, "$ commands set the control up"),
    evidence(RecognitionSign::Form(TextForm::SmallControl), 3, "no O number, H, cycle, compensation or call"),
    evidence(RecognitionSign::Form(TextForm::BareText), 2, "no %, O number, tool change, G43 or H"),
    evidence(RecognitionSign::Form(TextForm::MixedNumbers), 3, "whole numbers without a point next to decimals"),
    evidence(RecognitionSign::Form(TextForm::TrailingPoints), -4, "whole numbers with a point"),
    evidence(RecognitionSign::Form(TextForm::SemicolonComments), 1, "comments after semicolons"),
    evidence(RecognitionSign::Codes(&["G90G94"]), 2, "G90 G94 is a line of its own"),
    evidence(RecognitionSign::Codes(&["G17"]), 1, "G17 is a line of its own"),
    evidence(RecognitionSign::Codes(&["G90"]), 1, "G90 is a line of its own"),
    evidence(RecognitionSign::Codes(&["G20", "G21"]), 1, "the units are a line of their own"),
    evidence(RecognitionSign::Block("G53 G0 Z:int"), 1, "G53 retracts to a whole number"),
    evidence(RecognitionSign::Block("G1 S X|Y"), 3, "S in a cut is the power of a laser"),
    evidence(RecognitionSign::Block("S X|Y !G !M !T"), 3, "S in a cut is the power of a laser"),
    evidence(RecognitionSign::Block("M4 S0"), 3, "M4 S0 is a laser"),
    evidence(RecognitionSign::Block("O:1-8"), -5, "a program number"),
    evidence(RecognitionSign::Block("H:1-4"), -5, "H chooses a length"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -8, "macro statements"),
    evidence(RecognitionSign::Form(TextForm::OWord), -12, "O words are flow control"),
    evidence(RecognitionSign::Block("G81..89"), -4, "canned cycles"),
    evidence(RecognitionSign::Block("G41|G42"), -4, "cutter compensation"),
    evidence(RecognitionSign::Block("G64|G61.1"), -6, "a path mode that it does not have"),
    evidence(RecognitionSign::Block("M98|G65"), -6, "calls of subprograms"),
];

pub(super) const EVIDENCE: &[RecognitionEvidence] =
    &[evidence(RecognitionSign::Block("M3 S !T"), 1, "M3 starts the spindle")];

//! Signs by which programs of GRBL and its kin are recognized. Nearly all of their blocks mean the same elsewhere,
//! so that a name, or what nobody else has, says most.

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

/// Fewer signs than these are no sign: a plain program is for any control.
pub(super) static KIND: MachineKind = MachineKind { turns: false, signs: SIGNS, needed: 6 };

const SIGNS: &[Evidence] = &[
    evidence(Sign::Header(NAMES), 14, "the header names GRBL or a machine that has it"),
    evidence(Sign::Comment(NAMES), 10, "a comment names GRBL or a machine that has it"),
    evidence(Sign::Form(Form::DollarLine), 6, "$ commands set the control up"),
    evidence(Sign::Form(Form::BareText), 2, "no %, O number, tool change, G43 or H"),
    evidence(Sign::Block("G1 S X|Y"), 3, "S in a cut is the power of a laser"),
    evidence(Sign::Block("M4 S0"), 3, "M4 S0 is a laser"),
    evidence(Sign::Form(Form::MacroStatement), -8, "macro statements"),
    evidence(Sign::Form(Form::OWord), -12, "O words are flow control"),
    evidence(Sign::Block("G81..89"), -4, "canned cycles"),
    evidence(Sign::Block("G41|G42"), -4, "cutter compensation"),
    evidence(Sign::Block("M98|G65"), -6, "calls of subprograms"),
];

pub(super) const EVIDENCE: &[Evidence] =
    &[evidence(Sign::Block("M3 S !T"), 1, "M3 starts the spindle")];

//! Programs of GRBL and its kin. Nearly all of their blocks mean the same elsewhere, so that only a name or what
//! nobody else has decides; otherwise such a text is read as that of the control that is assumed.

use super::NotRead;
use crate::recognition::{Evidence, Form, Sign, evidence};
use chordal_machine::ControlName;

pub(super) const GRBL: NotRead = NotRead {
    name: "grbl",
    what: "a program for GRBL",
    why: "GRBL programs are not followed as GRBL would yet",
    signs: SIGNS,
    needed: 6,
    own: &[],
    shown_on: ControlName::Linuxcnc,
};

const NAMES: &[&str] = &[
    "GRBL",
    "GRBLHAL",
    "FLUIDNC",
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
    "ONEFINITY",
    "SAINSMART",
    "GENMITSU",
    "SNAPMAKER",
    "TINYG",
    "SMOOTHIEWARE",
    "CANDLE",
];

const SIGNS: &[Evidence] = &[
    evidence(Sign::Header(NAMES), 14, "the header names GRBL or a machine that has it"),
    evidence(Sign::Comment(NAMES), 10, "a comment names GRBL or a machine that has it"),
    evidence(Sign::Form(Form::DollarLine), 6, "$ commands set the control up"),
    evidence(Sign::Form(Form::BareText), 2, "no %, O number, tool change, G43 or H"),
    evidence(Sign::Block("G1 S X|Y"), 3, "S in a cut is the power of a laser"),
    evidence(Sign::Block("M4 S0"), 3, "M4 S0 is a laser"),
    evidence(Sign::Block("M3 S !T"), 1, "M3 starts the spindle"),
    evidence(Sign::Form(Form::MacroStatement), -8, "macro statements"),
    evidence(Sign::Form(Form::OWord), -12, "O words are flow control"),
    evidence(Sign::Block("G81..89"), -4, "canned cycles"),
    evidence(Sign::Block("G41|G42"), -4, "cutter compensation"),
    evidence(Sign::Block("M98|G65"), -6, "calls of subprograms"),
];

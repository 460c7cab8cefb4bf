//! Programs of relatives of GRBL that read blocks differently: Smoothieware, TinyG and others.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, evidence};
use chordal_machine::ControlName;

pub(super) const GRBL_KIN: NotRead = NotRead {
    name: "grbl-kin",
    what: "a program for a kin of GRBL (Smoothieware, TinyG, Snapmaker, Onefinity)",
    why: "they read lines otherwise than GRBL does, and are not followed; `--machine grbl` reads it as GRBL 1.1 would",
    signs: SIGNS,
    needed: 10,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Grbl,
};

const NAMES: &[&str] = &["SMOOTHIEWARE", "SMOOTHIE", "TINYG", "G2CORE", "ONEFINITY", "CARVERA"];

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 16, "the header names a kin of GRBL"),
    evidence(RecognitionSign::Comment(NAMES), 12, "a comment names a kin of GRBL"),
];

//! Signs by which programs of grblHAL are recognized: its name, and machines that are sold with it.

use crate::vocabulary::*;

const NAMES: &[&str] = &["GRBLHAL", "ALTMILL", "SUPERLONGBOARD", "FLEXI-HAL"];

/// Whatever else is in such programs, GRBL and others have too: only a name or an own command reaches this sum.
pub(super) static KIND: MachineKind = MachineKind { turns: false, signs: SIGNS, needed: 10 };

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 16, "the header names grblHAL or a machine that has it"),
    evidence(RecognitionSign::Comment(NAMES), 12, "a comment names grblHAL or a machine that has it"),
];

pub(super) const EVIDENCE: &[RecognitionEvidence] =
    &[evidence(RecognitionSign::Block("M3 S !T"), 1, "M3 starts the spindle")];

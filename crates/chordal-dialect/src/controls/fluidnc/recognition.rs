//! Signs by which programs of FluidNC are recognized: its name, and its own commands.

use crate::vocabulary::*;

const NAMES: &[&str] = &["FLUIDNC", "GRBL_ESP32"];

/// Whatever else is in such programs, GRBL and others have too: only a name or an own command reaches this sum.
pub(super) static KIND: MachineKind = MachineKind { turns: false, signs: SIGNS, needed: 10 };

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 16, "the header names FluidNC"),
    evidence(RecognitionSign::Comment(NAMES), 12, "a comment names FluidNC"),
    evidence(RecognitionSign::Code(&["$SD/RUN", "$LOCALFS/RUN"]), 12, "$SD/Run is a command of FluidNC"),
];

pub(super) const EVIDENCE: &[RecognitionEvidence] =
    &[evidence(RecognitionSign::Block("M3 S !T"), 1, "M3 starts the spindle")];

//! Signs of a Mitsubishi among the controls of lathes, and of a Mazak, whose control is made by Mitsubishi.

use crate::controls::mitsubishi::recognition::{MAZAK, NAMES};
use crate::vocabulary::*;

const LATHES: &[&str] = &["QUICK TURN", "QTN", "QT-200", "QTU", "SQT", "INTEGREX", "NEXUS"];

pub(super) const EVIDENCE: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 8, "the header names a Mitsubishi"),
    evidence(RecognitionSign::Comment(&["MITSUBISHI", "MELDAS"]), 6, "a comment names a Mitsubishi"),
    evidence(RecognitionSign::Header(MAZAK), 8, "the header names a Mazak, whose control is of Mitsubishi"),
    evidence(RecognitionSign::Comment(MAZAK), 6, "a comment names a Mazak, whose control is of Mitsubishi"),
    evidence(RecognitionSign::Comment(LATHES), 6, "a comment names a lathe of Mazak"),
    evidence(RecognitionSign::Block("G71|G72 P Q H"), 3, "G71 with H cuts pockets"),
    evidence(RecognitionSign::Block("M98 H"), 3, "M98 with H begins at a block"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), 1, "macro B statements"),
];

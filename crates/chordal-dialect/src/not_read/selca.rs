//! Programs of Selca controls.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, TextForm, evidence};
use chordal_machine::ControlName;

pub(super) const SELCA: NotRead = NotRead {
    name: "selca",
    what: "a program for a Selca",
    why: "programs of Selca controls are not read yet",
    signs: SIGNS,
    needed: 7,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Fanuc,
};

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(&["SELCA"]), 12, "the header names a Selca"),
    evidence(RecognitionSign::Comment(&["SELCA"]), 8, "a comment names a Selca"),
    evidence(RecognitionSign::Begins(&["[ SELCA"]), 8, "a comment names a Selca"),
    evidence(RecognitionSign::Begins(&["[ "]), 6, "comments begin with ["),
    evidence(RecognitionSign::Block("G62 K"), 6, "G62 K1"),
    evidence(RecognitionSign::Line(&["O?", "O??"]), 2, "O alone is a work offset"),
    evidence(RecognitionSign::Block("G43 H"), -5, "G43 H applies the tool length"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -4, "variables are numbered"),
    evidence(RecognitionSign::Form(TextForm::OWord), -8, "O words are flow control"),
];

//! Programs of the Acramatic 2100 by Cincinnati and Siemens.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, TextForm, evidence};
use chordal_machine::ControlName;

pub(super) const ACRAMATIC: NotRead = NotRead {
    name: "acramatic",
    what: "a program for an Acramatic",
    why: "programs of the Acramatic are not read yet",
    signs: SIGNS,
    needed: 8,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Fanuc,
};

const SIGNS: &[RecognitionEvidence] = &[
    evidence(
        RecognitionSign::Header(&["ACRAMATIC", "A2100", "CINCINNATI"]),
        12,
        "the header names an Acramatic",
    ),
    evidence(RecognitionSign::Comment(&["ACRAMATIC", "A2100"]), 9, "a comment names an Acramatic"),
    evidence(
        RecognitionSign::Comment(&["PGM, NAME=", "PGM,NAME="]),
        14,
        "(PGM, NAME=…) heads the program",
    ),
    evidence(RecognitionSign::Begins(&[":T?", ": T?"]), 7, "a colon begins the block of a tool"),
    evidence(RecognitionSign::Begins(&[":G?", ": G?"]), 7, "a colon begins a block of modes"),
    evidence(RecognitionSign::Comment(&["MSG,", "TYP,", "PGM,"]), 2, "statements in parentheses"),
    evidence(RecognitionSign::Line(&["M26"]), 2, "M26 retracts"),
    evidence(RecognitionSign::Line(&["H?", "H??"]), 2, "H alone is a work offset"),
    evidence(RecognitionSign::Form(TextForm::SemicolonComments), 1, "comments after semicolons"),
    evidence(RecognitionSign::Block("G43 H"), -6, "G43 applies the tool length"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -4, "variables are numbered"),
];

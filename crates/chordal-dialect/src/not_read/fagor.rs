//! Programs of Fagor controls: 8025 and 8055 with their heads `%00227` and `%NAME,MX--,`.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, TextForm, evidence};
use chordal_machine::ControlName;

pub(super) const FAGOR: NotRead = NotRead {
    name: "fagor",
    what: "a program for a Fagor",
    why: "programs of Fagor controls are not read yet",
    signs: SIGNS,
    needed: 6,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Fanuc,
};

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(&["FAGOR"]), 12, "the header names a Fagor"),
    evidence(RecognitionSign::Comment(&["FAGOR"]), 8, "a comment names a Fagor"),
    evidence(RecognitionSign::Code(&[",MX-", ",MX,"]), 16, "%NAME,MX--, heads the program"),
    evidence(RecognitionSign::Line(&["%?????"]), 6, "% with five digits heads the program"),
    evidence(RecognitionSign::Block("T:dec !X !Y !Z"), 5, "T1.1 is a tool with its offset"),
    evidence(RecognitionSign::Block("G43 Z !H"), 2, "G43 has no H"),
    evidence(RecognitionSign::Block("G81|G82|G83 Z I !J !K !R"), 3, "I is the depth of a hole"),
    evidence(
        RecognitionSign::Form(TextForm::StatementInParentheses),
        5,
        "statements are in parentheses",
    ),
    evidence(RecognitionSign::Block("N:4 !O"), 1, "block numbers have four digits"),
    evidence(RecognitionSign::Block("H !G65"), -6, "H is an offset number"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -6, "variables begin with #"),
];

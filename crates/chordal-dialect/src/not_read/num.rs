//! Programs of NUM controls.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, TextForm, evidence};
use chordal_machine::ControlName;

pub(super) const NUM: NotRead = NotRead {
    name: "num",
    what: "a program for a NUM",
    why: "programs of NUM controls are not read yet",
    signs: SIGNS,
    needed: 7,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Fanuc,
};

const SIGNS: &[RecognitionEvidence] = &[
    evidence(
        RecognitionSign::Header(&["NUM 1060", "NUM 1040", "NUM 1020", "NUM FLEXIUM", "FLEXIUM"]),
        12,
        "the header names a NUM",
    ),
    evidence(
        RecognitionSign::Comment(&["NUM 1060", "NUM 1040", "NUM 1020", "FLEXIUM"]),
        8,
        "a comment names a NUM",
    ),
    evidence(
        RecognitionSign::Begins(&[
            "%? (", "%?? (", "%??? (", "%???? (", "%?????(", "%?(", "%??(", "%???(", "%????(",
            "%?.? (",
        ]),
        6,
        "% with the number and the name heads the program",
    ),
    evidence(
        RecognitionSign::Line(&["%?", "%??", "%???", "%????"]),
        3,
        "% with a number heads the program",
    ),
    evidence(RecognitionSign::Block("G0 G52"), 6, "G52 moves in the coordinates of the machine"),
    evidence(RecognitionSign::Block("G79 N !X !Y !Z"), 2, "G79 jumps"),
    evidence(RecognitionSign::Form(TextForm::LParameter), 5, "L0 is a variable"),
    evidence(RecognitionSign::Block("E80000..89999"), 5, "E80000 is a parameter"),
    evidence(RecognitionSign::Block("G77 H|N"), 4, "G77 calls a subprogram"),
    evidence(RecognitionSign::Block("G71 !P !Q !U !W !Z"), 1, "G71 for millimetres"),
    evidence(RecognitionSign::Block("G43 H"), -6, "G43 H applies the tool length"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -6, "variables are numbered"),
    evidence(RecognitionSign::Form(TextForm::OWord), -8, "O words are flow control"),
];

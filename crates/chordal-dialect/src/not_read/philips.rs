//! Programs of Philips, Maho and MillPlus controls.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, TextForm, evidence};
use chordal_machine::ControlName;

pub(super) const PHILIPS: NotRead = NotRead {
    name: "philips",
    what: "a program for a Philips or MillPlus control",
    why: "programs of Philips and MillPlus controls are not read yet",
    signs: SIGNS,
    needed: 7,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Fanuc,
};

const SIGNS: &[RecognitionEvidence] = &[
    evidence(
        RecognitionSign::Header(&["PHILIPS", "MILLPLUS", "MAHO", "CNC432", "CNC532"]),
        10,
        "the header names a Philips control",
    ),
    evidence(
        RecognitionSign::Comment(&["MILLPLUS", "PHILIPS"]),
        6,
        "a comment names a Philips control",
    ),
    evidence(RecognitionSign::Begins(&["%PM", "%MM"]), 14, "%PM heads the program"),
    evidence(RecognitionSign::Block("T M66"), 6, "M66 changes the tool by hand"),
    evidence(
        RecognitionSign::Block("G98|G99 X Y Z I J K"),
        6,
        "G98 and G99 give the window of the picture",
    ),
    evidence(RecognitionSign::Block("G54 I !X !Y"), 5, "G54 I1 chooses a work offset"),
    evidence(RecognitionSign::Block("G79 X Y !P !R"), 3, "G79 calls the cycle at a point"),
    evidence(
        RecognitionSign::Block("G74 Z L !F !R !X !Y"),
        5,
        "G74 moves to a place of the machine",
    ),
    evidence(RecognitionSign::Block("N9000..9999 !G !X !Y !Z !M"), 2, "N9000 heads a program"),
    evidence(RecognitionSign::Block("G29 E N"), 4, "G29 E jumps"),
    evidence(RecognitionSign::Block("G43 H"), -5, "G43 H applies the tool length"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -5, "variables are numbered"),
];

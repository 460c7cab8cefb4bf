//! Programs of Selca controls.

use super::NotRead;
use crate::recognition::{Evidence, Form, Sign, evidence};
use chordal_machine::ControlName;

pub(super) const SELCA: NotRead = NotRead {
    name: "selca",
    what: "a program for a Selca",
    why: "programs of Selca controls are not read yet",
    signs: SIGNS,
    needed: 7,
    own: &[],
    shown_on: ControlName::Fanuc,
};

const SIGNS: &[Evidence] = &[
    evidence(Sign::Header(&["SELCA"]), 12, "the header names a Selca"),
    evidence(Sign::Comment(&["SELCA"]), 8, "a comment names a Selca"),
    evidence(Sign::Begins(&["[ SELCA"]), 8, "a comment names a Selca"),
    evidence(Sign::Begins(&["[ "]), 6, "comments begin with ["),
    evidence(Sign::Block("G62 K"), 6, "G62 K1"),
    evidence(Sign::Line(&["O?", "O??"]), 2, "O alone is a work offset"),
    evidence(Sign::Block("G43 H"), -5, "G43 H applies the tool length"),
    evidence(Sign::Form(Form::MacroStatement), -4, "variables are numbered"),
    evidence(Sign::Form(Form::OWord), -8, "O words are flow control"),
];

//! Programs of the Acramatic 2100 by Cincinnati and Siemens.

use super::NotRead;
use crate::recognition::{Evidence, Form, Sign, evidence};
use chordal_machine::ControlName;

pub(super) const ACRAMATIC: NotRead = NotRead {
    name: "acramatic",
    what: "a program for an Acramatic",
    why: "programs of the Acramatic are not read yet",
    signs: SIGNS,
    needed: 8,
    own: &[],
    shown_on: ControlName::Fanuc,
};

const SIGNS: &[Evidence] = &[
    evidence(
        Sign::Header(&["ACRAMATIC", "A2100", "CINCINNATI"]),
        12,
        "the header names an Acramatic",
    ),
    evidence(Sign::Comment(&["ACRAMATIC", "A2100"]), 9, "a comment names an Acramatic"),
    evidence(Sign::Comment(&["PGM, NAME=", "PGM,NAME="]), 14, "(PGM, NAME=…) heads the program"),
    evidence(Sign::Begins(&[":T?", ": T?"]), 7, "a colon begins the block of a tool"),
    evidence(Sign::Begins(&[":G?", ": G?"]), 7, "a colon begins a block of modes"),
    evidence(Sign::Comment(&["MSG,", "TYP,", "PGM,"]), 2, "statements in parentheses"),
    evidence(Sign::Line(&["M26"]), 2, "M26 retracts"),
    evidence(Sign::Line(&["H?", "H??"]), 2, "H alone is a work offset"),
    evidence(Sign::Form(Form::SemicolonComments), 1, "comments after semicolons"),
    evidence(Sign::Block("G43 H"), -6, "G43 applies the tool length"),
    evidence(Sign::Form(Form::MacroStatement), -4, "variables are numbered"),
];

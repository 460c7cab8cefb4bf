//! Programs of Haas lathes.

use super::NotRead;
use crate::controls::haas;
use crate::lathe_signs::{LATHE, MODELS};
use crate::recognition::{Sign, evidence};
use chordal_machine::ControlName;

const WHY: &str = "lathe programs are not followed yet";

/// A lathe program for a Haas.
pub(super) const HAAS_LATHE: NotRead = NotRead {
    name: "haas-lathe",
    what: "a lathe program for a Haas",
    why: WHY,
    signs: LATHE.signs,
    needed: LATHE.needed,
    own: &[
        evidence(Sign::Header(haas::recognition::NAMES), 8, "the header names a Haas"),
        evidence(Sign::Comment(haas::recognition::NAMES), 5, "a comment names a Haas"),
        evidence(Sign::Comment(MODELS), 5, "a comment names a lathe of Haas"),
        evidence(Sign::Block("G71|G72|G73 D P Q"), 4, "G71 in one block with D"),
        evidence(Sign::Block("G28:bare !M"), 2, "G28 without an axis"),
        evidence(Sign::Block("G53 X|Z"), 2, "G53 goes to the tool change position"),
        evidence(Sign::Block("G154 P"), 4, "G154 chooses an extended work offset"),
        evidence(Sign::Block("M97 P"), 4, "M97 calls within the program"),
        evidence(Sign::Block("O:5"), 2, "a program number of five digits"),
        evidence(Sign::Block("G76 D !P"), 1, "G76 with D"),
    ],
    shown_on: ControlName::Haas,
};

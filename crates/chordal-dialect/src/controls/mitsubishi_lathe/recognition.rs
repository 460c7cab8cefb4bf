//! Signs that tell a Mitsubishi among lathes, and a Mazak, whose control is of Mitsubishi.

use crate::controls::mitsubishi::recognition::{MAZAK, NAMES};
use crate::vocabulary::*;

const LATHES: &[&str] = &["QUICK TURN", "QTN", "QT-200", "QTU", "SQT", "INTEGREX", "NEXUS"];

pub(super) const EVIDENCE: &[Evidence] = &[
    evidence(Sign::Header(NAMES), 8, "the header names a Mitsubishi"),
    evidence(Sign::Comment(&["MITSUBISHI", "MELDAS"]), 6, "a comment names a Mitsubishi"),
    evidence(Sign::Header(MAZAK), 8, "the header names a Mazak, whose control is of Mitsubishi"),
    evidence(Sign::Comment(MAZAK), 6, "a comment names a Mazak, whose control is of Mitsubishi"),
    evidence(Sign::Comment(LATHES), 6, "a comment names a lathe of Mazak"),
    evidence(Sign::Block("G71|G72 P Q H"), 3, "G71 with H cuts pockets"),
    evidence(Sign::Block("M98 H"), 3, "M98 with H begins at a block"),
    evidence(Sign::Form(Form::MacroStatement), 1, "macro B statements"),
];

//! Programs of Marlin and other firmware of 3D printers.

use super::NotRead;
use crate::recognition::{Evidence, Form, Sign, evidence};
use chordal_machine::ControlName;

pub(super) const MARLIN_PRINTER: NotRead = NotRead {
    name: "marlin-printer",
    what: "a program for a 3D printer, as Marlin reads it",
    why: "programs of 3D printers are not read",
    signs: SIGNS,
    needed: 8,
    own: &[],
    shown_on: ControlName::Marlin,
};

const NAMES: &[&str] = &[
    "CURA",
    "CURA_STEAMENGINE",
    "PRUSASLICER",
    "SLIC3R",
    "SUPERSLICER",
    "REPRAP",
    "KLIPPER",
    "SIMPLIFY3D",
    "REPRAPFIRMWARE",
    "ORCASLICER",
];

const SIGNS: &[Evidence] = &[
    evidence(Sign::Header(NAMES), 14, "the header names a slicer or a firmware of printers"),
    evidence(Sign::Comment(NAMES), 9, "a comment names a slicer or a firmware of printers"),
    evidence(Sign::Block("M104|M109|M140|M190 S"), 6, "M104 and M140 set temperatures"),
    evidence(Sign::Block("M106|M107"), 3, "M106 turns a fan"),
    evidence(Sign::Block("M82|M83 !X !Y"), 2, "M82 and M83 say how E counts"),
    evidence(Sign::Block("G1 E:dec"), 5, "E is the way of the filament"),
    evidence(Sign::Block("G92 E"), 5, "G92 E sets the filament"),
    evidence(Sign::Block("G29 !X !Y"), 2, "G29 levels the bed"),
    evidence(
        Sign::Comment(&["LAYER:", "TYPE:", "LAYER_CHANGE", "FLAVOR:MARLIN"]),
        5,
        "comments name layers",
    ),
    evidence(Sign::Block("G43"), -6, "G43 applies the tool length"),
    evidence(Sign::Form(Form::MacroStatement), -6, "macro statements"),
];

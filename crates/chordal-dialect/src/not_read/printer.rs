//! Programs of 3D printers, which extrude plastic and cut nothing.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, TextForm, evidence};
use chordal_machine::ControlName;

pub(super) const PRINTER: NotRead = NotRead {
    name: "printer",
    what: "a program for a 3D printer",
    why: "programs of 3D printers are not read",
    signs: SIGNS,
    needed: 8,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Marlin,
};

const SLICERS: &[&str] = &[
    "CURA",
    "CURA_STEAMENGINE",
    "PRUSASLICER",
    "SLIC3R",
    "SUPERSLICER",
    "ORCASLICER",
    "BAMBUSTUDIO",
    "SIMPLIFY3D",
    "IDEAMAKER",
    "FLAVOR:MARLIN",
    "FLAVOR:REPRAP",
];

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Comment(SLICERS), 9, "a comment names a slicer"),
    evidence(RecognitionSign::Block("M104|M109|M140|M190 S"), 7, "M104 and M140 set temperatures"),
    evidence(RecognitionSign::Block("M82|M83 !X !Y !G"), 3, "M82 and M83 say how E counts"),
    evidence(RecognitionSign::Block("G0|G1 E:dec X|Y"), 6, "E is the length of filament"),
    evidence(RecognitionSign::Block("G92 E"), 5, "G92 E sets the filament"),
    evidence(RecognitionSign::Block("G29 !X !Y"), 2, "G29 levels the bed"),
    evidence(
        RecognitionSign::Begins(&[
            ";LAYER:",
            ";LAYER_C",
            "; LAYER ?",
            ";TYPE:",
            "; FEATURE:",
            ";LAYER_COUNT",
            ";Z:?",
            ";MESH:",
        ]),
        5,
        "comments name layers",
    ),
    evidence(
        RecognitionSign::Comment(&["EXTRUSION WIDTH", "FILAMENT USED"]),
        4,
        "comments name filament",
    ),
    evidence(RecognitionSign::Block("G43"), -6, "G43 applies the tool length"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -6, "macro statements"),
];

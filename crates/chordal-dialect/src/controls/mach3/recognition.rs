//! Signs by which programs of Mach3 and of controls that read programs as it does are recognized.

use crate::vocabulary::*;

const NAMES: &[&str] = &[
    "MACH3",
    "MACH3MILL",
    "MACH3-MM",
    "MACH3-CV",
    "MACH 3",
    "MACH2/3",
    "MACH2",
    "ARTSOFT",
    "LAZYCAM",
];

/// Controls that are made to read programs for Mach3.
const RELATED_CONTROLS: &[&str] = &["UCCNC"];

pub(super) const EVIDENCE: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 14, "the header names Mach3"),
    evidence(RecognitionSign::Comment(NAMES), 9, "a comment names Mach3"),
    evidence(RecognitionSign::Header(RELATED_CONTROLS), 9, "the header names a control that reads as Mach3"),
    evidence(RecognitionSign::Comment(RELATED_CONTROLS), 6, "a comment names a control that reads as Mach3"),
    evidence(RecognitionSign::Block("M47"), 6, "M47 starts the program again"),
    evidence(RecognitionSign::Block("G68 A B R"), 8, "G68 with A and B turns about a centre"),
    evidence(RecognitionSign::Block("G59 P"), 6, "G59 P chooses one of 254 work offsets"),
    evidence(RecognitionSign::Block("M98 P Q !L"), 3, "Q of M98 counts"),
    evidence(RecognitionSign::Block("G70|G71 G91.1|G90.1"), 6, "G70 or G71 chooses the unit next to arc centres"),
    evidence(RecognitionSign::Block("G40 G49 G91.1"), 4, "arc centres are chosen with compensation and length off"),
    evidence(
        RecognitionSign::Block("G0 G17 G40 G49 G50 G80 G90 !G69 !G94 !G98"),
        3,
        "its wizards begin with G49 G40 G17 G80 G50 G90",
    ),
    evidence(RecognitionSign::Block("G40 G53:bare G91.1"), 4, "the first block has G53 without an axis"),
    evidence(RecognitionSign::Block("G12|G13 I !K !Q !D !X !Y !Z"), 3, "I alone is the radius of a circular pocket"),
    evidence(RecognitionSign::Block("G90.1"), 5, "G90.1 sets absolute arc centres"),
    evidence(RecognitionSign::Block("G91.1"), 4, "G91.1 sets incremental arc centres"),
    evidence(RecognitionSign::Block("G92.2|G92.3"), 4, "G92.2 switches an offset off"),
    evidence(RecognitionSign::Block("G28.1"), 2, "G28.1 goes to the home switches"),
    evidence(RecognitionSign::Form(TextForm::LengthWithoutTape), 3, "G43 in a text without % and O number"),
    evidence(RecognitionSign::Block("M2"), 1, "M2 ends the program"),
];

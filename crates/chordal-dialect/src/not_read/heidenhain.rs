//! Heidenhain programs, conversational and DIN/ISO, which a crate of their own reads.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, evidence};
use chordal_machine::ControlName;

pub(super) const HEIDENHAIN: NotRead = NotRead {
    name: "heidenhain",
    what: "a Heidenhain conversational program",
    why: "",
    signs: SIGNS,
    needed: 8,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Heidenhain,
};

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Code(&["BEGIN PGM"]), 20, "BEGIN PGM"),
    evidence(RecognitionSign::Code(&["END PGM"]), 10, "END PGM"),
    evidence(RecognitionSign::Code(&["TOOL CALL"]), 8, "TOOL CALL"),
    evidence(RecognitionSign::Code(&["CYCL DEF", "CYCLE DEF"]), 8, "CYCL DEF"),
    evidence(RecognitionSign::Code(&["BLK FORM"]), 8, "BLK FORM"),
    evidence(RecognitionSign::Code(&["FMAX", "F MAX"]), 6, "FMAX is a rapid"),
    evidence(RecognitionSign::Code(&["DR+", "DR-"]), 4, "DR+ turns an arc"),
    evidence(RecognitionSign::Code(&["CALL LBL", "LBL "]), 4, "LBL is a label"),
    evidence(
        RecognitionSign::Code(&["L X+", "L X-", "L Z+", "L Z-", "L Y+", "L Y-", "L IX", "L IZ"]),
        5,
        "L is a straight cut",
    ),
    evidence(RecognitionSign::Code(&["CC X", "CC Y", "CC IX"]), 3, "CC is a centre"),
    evidence(
        RecognitionSign::Code(&[
            "M128",
            "FUNCTION TCPM",
            "PLANE SPATIAL",
            "PLANE VECTOR",
            "PLANE RESET",
            "PLANE EULER",
            "PLANE POINTS",
            "PLANE RELATIV",
            "PLANE AXIAL",
            "PLANE PROJECTED",
        ]),
        4,
        "M128, TCPM or PLANE is for a machine with rotary axes",
    )
    .on("heidenhain-ac-trunnion"),
    evidence(
        RecognitionSign::Code(&[" B+", " B-", " IB+", " IB-", "B+Q121"]),
        5,
        "B turns, so that the tables are B and C",
    )
    .on("heidenhain-bc-trunnion"),
    evidence(RecognitionSign::Block("B M128"), 5, "M128 stands with B")
        .on("heidenhain-bc-trunnion"),
    evidence(RecognitionSign::Block("A|C M128"), 2, "M128 stands with a rotary axis")
        .on("heidenhain-ac-trunnion"),
    evidence(
        RecognitionSign::Code(&[" A+", " A-", " C+", " C-", " IA+", " IA-", " IC+", " IC-"]),
        1,
        "A or C turns",
    )
    .on("heidenhain-ac-trunnion"),
    // DIN/ISO programs.
    evidence(RecognitionSign::Code(&[" G71 *", " G71*", " G70 *", " G70*"]), 8, "* ends a block"),
    evidence(RecognitionSign::Code(&["N99999999 %"]), 12, "N99999999 ends a program"),
    evidence(RecognitionSign::Code(&["D00 Q", "D01 Q", "D02 Q", "D03 Q"]), 6, "D calculates"),
    evidence(RecognitionSign::Block("G30 G17|G18|G19 X Y Z"), 8, "G30 with a plane is the blank"),
    evidence(RecognitionSign::Block("G31 X Y Z !F"), 3, "G31 without F is the blank"),
    evidence(RecognitionSign::Block("G99 T L R"), 8, "G99 gives length and radius of a tool"),
    evidence(RecognitionSign::Block("T S G17|G18|G19"), 4, "T stands with its axis and S"),
    evidence(RecognitionSign::Block("G98 L"), 2, "G98 L is a label"),
    evidence(
        RecognitionSign::Code(&["FN 0:", "FN0:", "FN 1:", "FN 9:", "FN 18:"]),
        6,
        "FN calculates",
    ),
];

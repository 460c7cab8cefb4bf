//! Programs of Okuma's OSP: G15 and G56 mean something else than on a Fanuc, so that they cannot be read as programs of one.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, evidence};
use chordal_machine::ControlName;

pub(super) const OKUMA: NotRead = NotRead {
    name: "okuma",
    what: "a program for an Okuma",
    why: "programs of Okuma's OSP are not read yet",
    signs: SIGNS,
    needed: 6,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Fanuc,
};

const NAMES: &[&str] =
    &["OKUMA", "OSP", "OSP-P300", "OSP-P300M", "OSP-P200", "OSP-E100", "GENOS", "OSP P300"];

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 14, "the header names an Okuma"),
    evidence(RecognitionSign::Comment(NAMES), 9, "a comment names an Okuma"),
    evidence(
        RecognitionSign::Code(&[".MIN%", ".SUB%", ".SSB%"]),
        30,
        "$NAME.MIN% heads the program",
    ),
    evidence(RecognitionSign::Block("G15 H"), 8, "G15 H chooses a work offset"),
    evidence(RecognitionSign::Block("G16 H X|Y|Z"), 3, "G16 H chooses a work offset"),
    evidence(RecognitionSign::Block("G56 H Z"), 4, "G56 H applies the length"),
    evidence(
        RecognitionSign::Code(&["CALL O", "MODIN", "MODOUT", "RTS"]),
        7,
        "CALL and RTS call subprograms",
    ),
    evidence(
        RecognitionSign::Code(&["VC1", "VC2", "VZOF", "VTOF", "VRSTT", "VATOL", "NOEX"]),
        7,
        "variables as VC1 and VZOFZ",
    ),
    evidence(RecognitionSign::Begins(&["NAT?"]), 6, "NAT01 names the block of a tool"),
    evidence(
        RecognitionSign::Code(&["G85 NL", "G86 NL", "G87 NL", "G88 NL"]),
        8,
        "G85 to G88 call a contour by its name",
    ),
    evidence(RecognitionSign::Block("T:6 !M6 !X !Z"), 2, "T has six digits"),
    evidence(RecognitionSign::Block("G116 T"), 5, "G116 changes the tool"),
    evidence(RecognitionSign::Code(&["NCYL"]), 3, "NCYL leaves a cycle out"),
    evidence(RecognitionSign::Block("G71 Z !P !Q !R !X !Y"), 1, "G71 Z is the return level"),
    evidence(RecognitionSign::Block("G43"), -3, "G43 applies the tool length"),
];

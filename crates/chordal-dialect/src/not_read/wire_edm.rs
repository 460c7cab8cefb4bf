//! Programs of wire EDM machines.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, TextForm, evidence};
use chordal_machine::ControlName;

pub(super) const WIRE_EDM: NotRead = NotRead {
    name: "wire-edm",
    what: "a program for a wire EDM",
    why: "programs of wire EDM machines are not read yet",
    signs: SIGNS,
    needed: 8,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Fanuc,
};

const SIGNS: &[RecognitionEvidence] = &[
    evidence(
        RecognitionSign::Comment(&["WIRE EDM", "WEDM", "WIRE CUT", "WIRE"]),
        3,
        "a comment names the wire",
    ),
    evidence(
        RecognitionSign::Block("S<100 D !G !M !X !Y !T"),
        5,
        "S1 D1 chooses the condition and the offset",
    ),
    evidence(RecognitionSign::Line(&["M60"]), 3, "M60 threads the wire"),
    evidence(RecognitionSign::Line(&["M50"]), 3, "M50 cuts the wire"),
    evidence(RecognitionSign::Block("G51 T !P !X !Y"), 4, "G51 T leans the wire"),
    evidence(RecognitionSign::Block("G52 T !X !Y"), 4, "G52 T leans the wire"),
    evidence(RecognitionSign::Block("G92 X Y !Z !S"), 2, "G92 sets the start hole"),
    evidence(RecognitionSign::Form(TextForm::HParameter), 6, "H175 = … sets an offset"),
    evidence(RecognitionSign::Block("G41|G42 H !D !G43"), 3, "H is the offset of the wire"),
    evidence(RecognitionSign::Line(&["L???"]), 2, "L heads the program"),
    evidence(RecognitionSign::Line(&["E????", "E???"]), 2, "E chooses the condition"),
    evidence(
        RecognitionSign::Line(&["M80", "M82", "M84"]),
        3,
        "M80, M82 and M84 switch water, wire and current",
    ),
    evidence(
        RecognitionSign::Letters { used: "XY", unused: "Z", least: 3 },
        2,
        "X and Y, and never Z",
    ),
    evidence(RecognitionSign::Block("Z !G92"), -6, "moves in Z"),
    evidence(RecognitionSign::Block("M6 T"), -6, "M6 changes the tool"),
    evidence(RecognitionSign::Block("S>99"), -6, "a spindle turns"),
];

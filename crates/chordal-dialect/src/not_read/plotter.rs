//! Programs of plotters and engravers: HPGL and Roland RML.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, TextForm, evidence};
use chordal_machine::ControlName;

pub(super) const PLOTTER: NotRead = NotRead {
    name: "plotter",
    what: "a program for a plotter (HPGL or Roland RML)",
    why: "the languages of plotters are not read",
    signs: SIGNS,
    needed: 8,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Grbl,
};

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Begins(&["IN;"]), 8, "IN starts a plot"),
    evidence(RecognitionSign::Begins(&["PU?", "PU;", "PU-"]), 6, "PU moves with the pen up"),
    evidence(RecognitionSign::Begins(&["PD?", "PD;", "PD-"]), 6, "PD draws"),
    evidence(
        RecognitionSign::Begins(&["PA;", "PA?", "PR;", "PR?"]),
        4,
        "PA and PR choose absolute and relative moves",
    ),
    evidence(RecognitionSign::Begins(&["SP?"]), 3, "SP chooses a pen"),
    evidence(
        RecognitionSign::Begins(&[";;^IN", "^IN;", "^DF;"]),
        10,
        "^IN starts a program of Roland",
    ),
    evidence(
        RecognitionSign::Begins(&["^PA", "^PR", "!MC?", "!PZ", "!VZ", "!RC"]),
        6,
        "commands begin with ^ and !",
    ),
    evidence(RecognitionSign::Begins(&["!PG;"]), 4, "!PG ends the page"),
    evidence(
        RecognitionSign::Form(TextForm::CommaCoordinates),
        6,
        "Z has three whole numbers with commas",
    ),
];

//! Programs of ShopBot routers in their own language, `.sbp`.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, evidence};
use chordal_machine::ControlName;

pub(super) const SHOPBOT: NotRead = NotRead {
    name: "shopbot",
    what: "a ShopBot program",
    why: "the commands of ShopBot are not read",
    signs: SIGNS,
    needed: 8,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Grbl,
};

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Begins(&["'SHOPBOT"]), 10, "a comment names ShopBot"),
    evidence(
        RecognitionSign::Begins(&["JZ,", "JX,", "JY,", "J2,", "J3,"]),
        6,
        "J2 and JZ are rapids",
    ),
    evidence(
        RecognitionSign::Begins(&["M2,", "M3,", "MX,", "MY,", "MZ,"]),
        6,
        "M3 with commas is a cut",
    ),
    evidence(RecognitionSign::Begins(&["MS,", "VS,", "JS,"]), 5, "MS sets the speeds"),
    evidence(RecognitionSign::Begins(&["SO,"]), 4, "SO switches an output"),
    evidence(RecognitionSign::Begins(&["CN,", "CN "]), 3, "CN runs a custom cut"),
    evidence(RecognitionSign::Begins(&["CG,", "CP,"]), 4, "CG cuts an arc"),
    evidence(RecognitionSign::Code(&["%(25)", "%(24)", "%(1)"]), 5, "%(25) is a system variable"),
    evidence(RecognitionSign::Begins(&["TR,", "C6", "C7", "C9"]), 2, "TR sets the spindle"),
    evidence(RecognitionSign::Begins(&["&"]), 3, "variables begin with &"),
    evidence(
        RecognitionSign::Line(&["SA", "SR"]),
        2,
        "SA and SR choose absolute and relative moves",
    ),
    evidence(RecognitionSign::Begins(&["PAUSE "]), 1, "PAUSE waits"),
    evidence(RecognitionSign::Begins(&["'"]), 1, "comments after apostrophes"),
];

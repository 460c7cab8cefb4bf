//! Signs of a Haas among the controls of lathes. `lathe_signs.rs` has those of lathes in general.

use crate::controls::haas::recognition::NAMES;
use crate::lathe_signs::MODELS;
use crate::vocabulary::*;

pub(super) const EVIDENCE: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 8, "the header names a Haas"),
    evidence(RecognitionSign::Comment(NAMES), 5, "a comment names a Haas"),
    evidence(RecognitionSign::Comment(MODELS), 5, "a comment names a lathe of Haas"),
    evidence(RecognitionSign::Block("G71|G72|G73 D P Q"), 4, "G71 in one block with D"),
    evidence(RecognitionSign::Block("G28:bare !M"), 2, "G28 without an axis"),
    evidence(RecognitionSign::Block("G53 X|Z"), 2, "G53 goes to the tool change position"),
    evidence(RecognitionSign::Block("G154 P"), 4, "G154 chooses an extended work offset"),
    evidence(RecognitionSign::Block("M133|M134 P"), 3, "M133 with P turns a live tool"),
    evidence(RecognitionSign::Block("M97 P"), 4, "M97 calls within the program"),
    evidence(RecognitionSign::Block("O:5"), 2, "a program number of five digits"),
    evidence(RecognitionSign::Block("G76 D !P"), 1, "G76 with D"),
];

//! Signs of a Fanuc among the controls of lathes. `lathe_signs.rs` has those of lathes in general.

use crate::controls::fanuc::recognition::{MACHINES, NAMES};
use crate::lathe_signs::BUILDERS;
use crate::vocabulary::*;

pub(super) const EVIDENCE: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 8, "the header names a Fanuc"),
    evidence(RecognitionSign::Comment(NAMES), 5, "a comment names a Fanuc"),
    evidence(RecognitionSign::Comment(MACHINES), 5, "a comment names a machine that has a Fanuc"),
    evidence(RecognitionSign::Comment(BUILDERS), 5, "a comment names a lathe that has a Fanuc"),
    evidence(RecognitionSign::Block("G94|G95 !X !Z"), 3, "G94 and G95 choose the feed in code system B").on("fanuc-lathe-b"),
    evidence(RecognitionSign::Block("G71|G72|G73 U|W R !P"), 2, "G71 in two blocks"),
    evidence(RecognitionSign::Block("G76 P:6"), 1, "G76 with P of six digits"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), 1, "macro B statements"),
];

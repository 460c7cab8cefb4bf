//! The lines at the begin and the end of a program for GRBL.

use crate::post::PostTemplate;

pub(super) const POST: PostTemplate = PostTemplate {
    remark: ["(", ")"],
    open: &["({title})"],
    begin: &[
        "{units} G17 G90 G94 G40 G49",
        "G54 G0 {clear}",
        "G0 {start} {spindle} M3",
        "M8",
    ],
    end: &["G0 {clear} M9", "M5", "M2"],
    two_digits: false,
};

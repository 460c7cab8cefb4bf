//! The lines at the begin and the end of a program for Mach3.

use crate::post::PostTemplate;

pub(super) const POST: PostTemplate = PostTemplate {
    remark: ["(", ")"],
    open: &["(Mach3: {title})"],
    begin: &[
        "{units} G17 G90 G94 G91.1 G40 G49 G80 G64",
        "T{tool} M6",
        "G54 G0 {start} {spindle} M3",
        "G43 H{tool} {clear} M8",
    ],
    end: &["G0 {clear} M9", "M5", "G49", "M30"],
    two_digits: false,
};

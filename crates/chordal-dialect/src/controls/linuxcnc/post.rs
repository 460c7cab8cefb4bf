//! The lines at the begin and the end of a program for LinuxCNC.

use crate::post::PostTemplate;

pub(super) const POST: PostTemplate = PostTemplate {
    // Semicolons: they are a sign by which the program is recognized as one for LinuxCNC.
    remark: ["; ", ""],
    open: &["%", "; {title}"],
    begin: &[
        "{units} G17 G90 G94 G40 G49 G80 G64 {blend}",
        "T{tool} M6",
        "G54 G0 {start} {spindle} M3",
        "G43 H{tool} {clear} M8",
    ],
    end: &["G0 {clear} M9", "M5", "G49", "M2", "%"],
    two_digits: false,
};

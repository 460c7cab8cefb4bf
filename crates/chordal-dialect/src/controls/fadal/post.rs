//! The lines at the begin and the end of a program for Fadal CNC 88.

use crate::post::PostTemplate;

pub(super) const POST: PostTemplate = PostTemplate {
    remark: ["(", ")"],
    open: &["O{number} ({title})"],
    begin: &[
        "M6 T{tool}",
        "G90 G17 {units} G40",
        "G0 {spindle} M3 E1 {start}",
        "H{tool} {wear}{clear} M8",
    ],
    end: &["G0 {clear}", "M5 M9", "G90 G0 H0 Z0", "M2"],
    two_digits: false,
};

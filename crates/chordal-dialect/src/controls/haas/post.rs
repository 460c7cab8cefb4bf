//! The lines at the begin and the end of a program for Haas mills.

use crate::post::PostTemplate;

pub(super) const POST: PostTemplate = PostTemplate {
    remark: ["(", ")"],
    open: &["%", "O{number} ({title})"],
    begin: &[
        "T{tool} M06",
        "G00 G90 G17 {units} G40 G49 G80",
        "G54 {start} {spindle} M03",
        "G43 H{offset} {clear} M08",
    ],
    end: &["G00 {clear} M09", "G53 G49 Z0. M05", "M30", "%"],
    two_digits: true,
};

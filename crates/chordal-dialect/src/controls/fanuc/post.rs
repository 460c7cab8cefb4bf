//! The lines at the begin and the end of a program for Fanuc 0i.

use crate::post::PostTemplate;

pub(in crate::controls) const POST: PostTemplate = PostTemplate {
    remark: ["(", ")"],
    open: &["%", "O{number} ({title})"],
    begin: &[
        "{units} G17 G90 G40 G49 G80",
        "T{tool} M06",
        "G54 G00 {start} {spindle} M03",
        "G43 H{offset} {clear} M08",
    ],
    end: &["G00 {clear} M09", "M05", "G91 G28 Z0.", "G90 G49", "M30", "%"],
    two_digits: true,
};

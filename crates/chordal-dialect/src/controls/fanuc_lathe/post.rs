//! The lines at the begin and the end of a program for Fanuc lathes. Thread milling programs need a live tool.

use crate::post::PostTemplate;

pub(in crate::controls) const POST: PostTemplate = PostTemplate {
    remark: ["(", ")"],
    open: &["%", "O{number} ({title})"],
    begin: &[
        "{units} G17 G40 G98",
        "T{tool}{tool}",
        "G54 G00 {start} {spindle} M03",
        "{clear} M08",
    ],
    end: &["G00 {clear} M09", "M05", "G28 U0. W0.", "M30", "%"],
    two_digits: true,
};

//! The lines at the begin and the end of a program for Marlin: one command on each line, and no end code.

use crate::post::PostTemplate;

pub(super) const POST: PostTemplate = PostTemplate {
    remark: ["; ", ""],
    open: &["; {title}"],
    begin: &["{units}", "G90", "G0 {clear} F600", "G0 {start} F1500", "M3 {spindle}"],
    end: &["G0 {clear}", "M5", "M400"],
    two_digits: false,
};

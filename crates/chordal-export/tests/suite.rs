//! The formats, read back and compared with what a person wrote down.

#[path = "suite/common.rs"]
mod common;
#[path = "suite/report.rs"]
mod report;

//! The formats, read back and compared with what a person wrote down.

#[path = "suite/commands.rs"]
mod commands;
#[path = "suite/common.rs"]
mod common;
#[path = "suite/figure.rs"]
mod figure;
#[path = "suite/path.rs"]
mod path;
#[path = "suite/plot.rs"]
mod plot;
#[path = "suite/report.rs"]
mod report;

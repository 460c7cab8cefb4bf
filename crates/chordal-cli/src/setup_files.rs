//! What commands on stock share: the files that a setup names, and the format of the answer.

use std::path::Path;

use chordal_load::{FileAccess, reason};
use clap::ValueEnum;

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum SetupProblemFormat {
    /// Text for the reader
    Text,
    /// One JSON object
    Json,
    /// The problems as SARIF 2.1.0, for code scanning
    Sarif,
}

/// The files that a setup names.
pub fn files(name: &str) -> Result<Vec<u8>, String> {
    FileAccess::Disk.bytes(Path::new(name)).map_err(|error| reason(&error))
}

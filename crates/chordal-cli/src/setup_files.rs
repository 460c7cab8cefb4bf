//! The files that a setup names.

use std::path::Path;

use chordal_load::{FileAccess, reason};

/// The files that a setup names.
pub fn files(name: &str) -> Result<Vec<u8>, String> {
    FileAccess::Disk.bytes(Path::new(name)).map_err(|error| reason(&error))
}

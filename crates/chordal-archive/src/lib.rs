//! Checks all programs of a folder tree into one table, and compares two such archives.
//!
//! The unit of work is a file: [`check_file`] computes its rows only from its bytes and from the answers of a
//! [`FileLoader`] ([`DiskFiles`] for files on disk), so that the rows do not depend on where and in which order the
//! files are checked. Finished records are stored in a [`TableJournal`]; [`TableJournal::finish`] writes all of them
//! into one Parquet file, sorted by path. [`check_all`] does this with the threads of one computer. To use several
//! computers, distribute files to [`check_file`] and put the records into the journal.
//!
//! ```
//! use std::path::Path;
//!
//! use chordal::Machine;
//! use chordal_archive::{FileLoader, ArchiveOptions, PreparedFile, check_file};
//!
//! /// Every file is the same program.
//! struct Memory;
//!
//! impl FileLoader for Memory {
//!     fn is_other_by_name(&self, _: &Path) -> bool {
//!         false
//!     }
//!     fn read(&mut self, _: &Path) -> Result<Vec<u8>, String> {
//!         Ok(b"G21 G90 S900 M3\nG1 X0 Y0 F100.\nX10.\nM30\n".to_vec())
//!     }
//!     fn may_be_program(&self, _: &[u8]) -> bool {
//!         true
//!     }
//!     fn prepare(&mut self, path: &Path, bytes: Vec<u8>) -> Result<PreparedFile, String> {
//!         Ok(PreparedFile {
//!             texts: vec![(path.display().to_string(), bytes)],
//!             machine: Machine::from_builtin("haas-vf2").map_err(|_| "no machine")?,
//!             chosen: "haas-vf2".into(),
//!             options: Default::default(),
//!             meshes: Vec::new(),
//!         })
//!     }
//! }
//!
//! let record = check_file(&mut Memory, Path::new("part.nc"), ArchiveOptions { plan: true, stock: false }, |_| false);
//! assert_eq!(record.unwrap().rows.len(), 1);
//! ```

#![forbid(unsafe_code)]
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a shell: the journal is files, and an archive is done by threads"
)]

mod archive_walk;
mod check;
mod columns;
pub mod diff;
mod disk;
mod error;
mod journal;
mod row;
mod run;

pub use archive_walk::{ArchiveEntry, walk};
pub use check::{ArchiveOptions, FileLoader, PreparedFile, check_file, file_key};
pub use columns::{ARCHIVE_COLUMNS, archive_reference};
pub use disk::DiskFiles;
pub use error::ArchiveError;
pub use journal::{JournalShard, TableJournal, record_of};
pub use row::{ArchiveRow, ArchivedProblem, FileRecord};
pub use run::{ArchiveProgress, ArchiveTotals, check_all};

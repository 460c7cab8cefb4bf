//! Whole archives: every program of a folder tree checked into one table, and two archives compared.
//!
//! The unit of work is a file: [`check_file`] makes its rows of its bytes and what a [`Loader`]
//! says about it, and of nothing else, so that the rows are the same wherever and in whatever order
//! the files are done. What is done stands in a [`Journal`]; [`Journal::finish`] brings all of it
//! into one Parquet file in the order of paths. [`check_all`] does the rest with the threads of one
//! machine; who has several machines hands files to [`check_file`] and records to the journal.

#![forbid(unsafe_code)]
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a shell: the journal is files, and an archive is done by threads"
)]

mod check;
mod columns;
pub mod diff;
mod error;
mod journal;
mod row;
mod run;
mod walk;

pub use check::{Loader, Options, Prepared, check_file, file_key};
pub use columns::{ARCHIVE_COLUMNS, archive_reference};
pub use error::ArchiveError;
pub use journal::{Journal, Shard, record_of};
pub use row::{FileRecord, Problem, Row};
pub use run::{Done, Progress, check_all};
pub use walk::{Entry, walk};

//! Checks an archive with the threads of one computer.

use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use crate::archive_walk::ArchiveEntry;
use crate::check::{ArchiveOptions, FileLoader, check_file};
use crate::error::ArchiveError;
use crate::journal::{TableJournal, record_of};
use crate::row::FileRecord;

/// The stack size of a thread, bytes: as large as the main thread's usually is.
const STACK: usize = 8 << 20;

/// Receives the progress, from several threads.
pub trait ArchiveProgress: Sync {
    /// A file is done. `anew` is false when an earlier run has done it; `bytes` is the size of the file, 0 when it
    /// was not read.
    fn file(&self, bytes: u64, anew: bool);
}

/// The totals of an archive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ArchiveTotals {
    /// Files with at least one row.
    pub files: u64,
    /// Rows of the table.
    pub rows: u64,
    /// Programs that were run.
    pub programs: u64,
    /// Programs with errors, or stopped by the limit on blocks.
    pub with_errors: u64,
    /// Programs with warnings only.
    pub with_warnings: u64,
    /// Programs without errors and warnings whose stock is not proved to be clean.
    pub not_proved: u64,
    /// Files and programs that could not be run.
    pub failed: u64,
    /// Files that are not programs.
    pub skipped: u64,
    /// Files that an earlier run has done.
    pub resumed: u64,
}

impl ArchiveTotals {
    /// Adds the rows of a file.
    pub fn add(&mut self, record: &FileRecord) {
        self.files += 1;
        for row in &record.rows {
            self.rows += 1;
            self.programs += u64::from(row.ran.is_some());
            let stock = row.ran.as_ref().and_then(|ran| ran.stock.as_ref());
            let is_proved = stock.is_none_or(|stock| stock.verdict == "clean");
            self.not_proved += u64::from(row.status == "ok" && !is_proved);
            let sum = match row.status.as_str() {
                "errors" | "stopped" => &mut self.with_errors,
                "warnings" => &mut self.with_warnings,
                "failed" => &mut self.failed,
                "skipped" => &mut self.skipped,
                _ => continue,
            };
            *sum += 1;
        }
    }
}

/// Checks all files with `jobs` threads, each with its own loader, and writes the table. Files that an earlier,
/// incomplete run for the same table has done are not checked again if the file, the machine and options, and the
/// version of Chordal are unchanged.
///
/// # Errors The journal or the table cannot be written. Finished files remain in the journal.
pub fn check_all<L: FileLoader>(
    entries: &[ArchiveEntry],
    out: &Path,
    jobs: usize,
    options: ArchiveOptions,
    loader: impl Fn() -> L + Sync,
    progress: &dyn ArchiveProgress,
) -> Result<ArchiveTotals, ArchiveError> {
    let names = entries.iter().map(|entry| entry.path.to_string_lossy().into_owned()).collect();
    let journal = TableJournal::open(out, names)?;
    let resumed = AtomicUsize::new(0);
    let next = AtomicUsize::new(0);
    let stop = AtomicBool::new(false);
    let failure: Mutex<Option<ArchiveError>> = Mutex::new(None);
    let work = || {
        let mut loader = loader();
        let mut shard = journal.shard()?;
        while !stop.load(Ordering::Relaxed) {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(entry) = entries.get(index) else { break };
            let is_known = |key: &str| journal.has_key(index, key);
            match done(&mut loader, entry, options, is_known) {
                Some(record) => {
                    let name = &journal.names()[index];
                    journal.put(&mut shard, index, &record_of(name, &record))?;
                    progress.file(record.file_bytes, true);
                }
                None => {
                    resumed.fetch_add(1, Ordering::Relaxed);
                    progress.file(0, false);
                }
            }
        }
        Ok(())
    };
    with_jobs(jobs.min(entries.len()), || {
        if let Err(error) = work() {
            stop.store(true, Ordering::Relaxed);
            let mut first = failure.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            first.get_or_insert(error);
        }
    });
    let failure = failure.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    if let Some(error) = failure {
        return Err(error);
    }
    let mut done = ArchiveTotals::default();
    journal.finish(|_, record| done.add(record))?;
    done.resumed = resumed.into_inner() as u64;
    Ok(done)
}

/// Runs the same closure on several threads, which distribute the work among themselves: on this thread, and on up to
/// `jobs - 1` more as far as the system provides them.
pub(crate) fn with_jobs(jobs: usize, work: impl Fn() + Sync) {
    std::thread::scope(|scope| {
        for _ in 1..jobs {
            let thread = std::thread::Builder::new().stack_size(STACK);
            if thread.spawn_scoped(scope, &work).is_err() {
                break;
            }
        }
        work();
    });
}

fn done(
    loader: &mut impl FileLoader,
    entry: &ArchiveEntry,
    options: ArchiveOptions,
    is_known: impl FnOnce(&str) -> bool,
) -> Option<FileRecord> {
    match &entry.failure {
        Some(message) => Some(FileRecord::unreadable(String::new(), message.clone())),
        None => check_file(loader, &entry.path, options, is_known),
    }
}

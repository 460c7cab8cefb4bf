//! Archives: the records of files, and the journal that gathers them.

use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

use chordal::Machine;
use chordal::control::configured_control;
use chordal::machine::ControlName;
use chordal_archive::{
    ArchiveError, ArchiveTotals, DiskFiles, FileRecord, JournalShard, check_file, record_of,
};
use pyo3::exceptions::{PyOSError, PyRuntimeError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::error;
use crate::program::PyProgramOptions;
use crate::signals::PythonSignals;

/// The files of folder trees in the order of the table: name, path, and why it cannot be read.
#[pyfunction]
pub fn archive_walk(
    py: Python<'_>,
    paths: Vec<PathBuf>,
    leave_out: Vec<PathBuf>,
) -> Vec<(String, OsString, Option<String>)> {
    let entries = py.detach(|| chordal_archive::walk(&paths, &leave_out));
    let named = |entry: chordal_archive::ArchiveEntry| {
        let name = entry.path.to_string_lossy().into_owned();
        (name, entry.path.into_os_string(), entry.failure)
    };
    entries.into_iter().map(named).collect()
}

/// True where a text calls programs that may lie in files in its folder, by the rules of some control.
#[pyfunction]
pub fn archive_calls(py: Python<'_>, text: &[u8]) -> bool {
    let text = text.to_vec();
    py.detach(|| {
        let decoded = chordal::syntax::decode(&text);
        let calls = |name: ControlName| {
            configured_control(&Machine::new("archive", name))
                .is_some_and(|(control, _)| !control.called_programs(&decoded.text).is_empty())
        };
        !decoded.binary && ControlName::all().into_iter().any(calls)
    })
}

/// The record of a file that could not be done.
#[pyfunction]
pub fn archive_failed<'py>(py: Python<'py>, name: &str, message: String) -> Bound<'py, PyBytes> {
    PyBytes::new(py, &record_of(name, &FileRecord::unreadable(String::new(), message)))
}

/// What makes records of files. It remembers the folders that it looked into.
#[pyclass(frozen, module = "chordal._chordal")]
pub struct ArchiveWorker {
    disk: Mutex<DiskFiles>,
    plan: bool,
}

#[pymethods]
impl ArchiveWorker {
    /// `chordal.toml` counts up to the `roots`; paths that begin as the first of `renamed` are reported
    /// as if they began as the second.
    #[new]
    fn new(
        py: Python<'_>,
        options: PyProgramOptions,
        plan: bool,
        roots: Vec<PathBuf>,
        renamed: (String, String),
    ) -> PyResult<ArchiveWorker> {
        let request = options.request(py, &PythonSignals::new())?;
        let disk = py.detach(|| DiskFiles::new(request, &roots));
        let disk = disk.map_err(|error| error::of_loading(py, &error))?;
        let disk = Mutex::new(disk.renamed(renamed.0, renamed.1));
        Ok(ArchiveWorker { disk, plan })
    }

    /// The records of files, each its name in the table, its path and the shortened key of the
    /// record that there is already; empty where that one stands.
    fn records<'py>(
        &self,
        py: Python<'py>,
        files: Vec<(String, PathBuf, Option<String>)>,
    ) -> Vec<Bound<'py, PyBytes>> {
        let options = chordal_archive::ArchiveOptions { plan: self.plan, stock: false };
        let records: Vec<Vec<u8>> = py.detach(|| {
            let mut disk = self.disk.lock().unwrap_or_else(PoisonError::into_inner);
            let record = |(name, path, known): &(String, PathBuf, Option<String>)| {
                let is_known =
                    |key: &str| known.as_deref().is_some_and(|known| key.starts_with(known));
                let record = check_file(&mut *disk, path, options, is_known);
                record.map_or_else(Vec::new, |record| record_of(name, &record))
            };
            files.iter().map(record).collect()
        });
        records.iter().map(|record| PyBytes::new(py, record)).collect()
    }
}

/// The journal of a table, and one shard of it that this process writes.
#[pyclass(frozen, module = "chordal._chordal")]
pub struct Journal(Mutex<Option<(chordal_archive::TableJournal, JournalShard)>>);

#[pymethods]
impl Journal {
    #[new]
    fn new(py: Python<'_>, out: PathBuf, names: Vec<String>) -> PyResult<Journal> {
        let open = || {
            let journal = chordal_archive::TableJournal::open(&out, names)?;
            let shard = journal.shard()?;
            Ok((journal, shard))
        };
        let opened = py.detach(open).map_err(wrong)?;
        Ok(Journal(Mutex::new(Some(opened))))
    }

    /// The folder of a table's journal.
    #[staticmethod]
    fn folder_of(out: PathBuf) -> OsString {
        chordal_archive::TableJournal::folder_of(&out).into_os_string()
    }

    /// The key of the record that a file has, shortened.
    fn key(&self, index: usize) -> PyResult<Option<String>> {
        let retained = self.lock_journal();
        let (journal, _) = retained.as_ref().ok_or_else(finished)?;
        Ok(journal.key(index))
    }

    /// Takes the record of a file.
    fn put(&self, py: Python<'_>, index: usize, record: &[u8]) -> PyResult<()> {
        let record = record.to_vec();
        py.detach(|| {
            let mut retained = self.lock_journal();
            let (journal, shard) = retained.as_mut().ok_or_else(finished)?;
            journal.put(shard, index, &record).map_err(wrong)
        })
    }

    /// Writes the table and takes the journal away; says what the archive came to: files, rows,
    /// programs, with errors, with warnings, failed, skipped.
    fn finish(&self, py: Python<'_>) -> PyResult<(u64, u64, u64, u64, u64, u64, u64)> {
        py.detach(|| {
            let (journal, shard) = self.lock_journal().take().ok_or_else(finished)?;
            drop(shard);
            let mut done = ArchiveTotals::default();
            journal.finish(|_, record| done.add(record)).map_err(wrong)?;
            let ArchiveTotals {
                files,
                rows,
                programs,
                with_errors,
                with_warnings,
                failed,
                skipped,
                ..
            } = done;
            Ok((files, rows, programs, with_errors, with_warnings, failed, skipped))
        })
    }
}

impl Journal {
    fn lock_journal(
        &self,
    ) -> MutexGuard<'_, Option<(chordal_archive::TableJournal, JournalShard)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn finished() -> PyErr {
    PyRuntimeError::new_err("the table is already written")
}

fn wrong(error: ArchiveError) -> PyErr {
    match error {
        ArchiveError::Write { .. } => PyOSError::new_err(error.to_string()),
        other => PyRuntimeError::new_err(other.to_string()),
    }
}

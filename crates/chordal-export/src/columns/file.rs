//! Columns as a file: text, Parquet and Arrow, written as the rows come.

use std::fmt;
use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};

use arrow_array::RecordBatch;
#[cfg(feature = "files")]
use arrow_ipc::writer::FileWriter;
use arrow_schema::ArrowError;
#[cfg(feature = "files")]
use parquet::errors::ParquetError;

#[cfg(feature = "files")]
use super::parquet::ParquetFile;
use super::rows::{BATCH, RowBatcher};
use super::text_table::TextTable;
use crate::format::OutputFormat;

/// Writes rows as they come. Of a Parquet file the rows of one group are held, of the others a
/// few thousand.
pub struct ColumnFile<W, R> {
    format: OutputFormat,
    rows: R,
    table: TableWriter,
    out: SharedOutput<W>,
}

/// A file of one format. What it writes to is a `dyn Write`, so that its code is made once.
enum TableWriter {
    Text(TextTable),
    #[cfg(feature = "files")]
    Parquet(Box<ParquetFile>),
    #[cfg(feature = "files")]
    Arrow(Box<FileWriter<Box<dyn Write + Send>>>),
}

impl TableWriter {
    fn new(
        out: Box<dyn Write + Send>,
        format: OutputFormat,
        rows: &impl RowBatcher,
    ) -> io::Result<TableWriter> {
        let names = rows.text_columns();
        match (format, rows.json_header()) {
            (OutputFormat::Csv, _) => {
                Ok(TableWriter::Text(TextTable::separated(out, rows.schema(), &names, ",")))
            }
            (OutputFormat::Jsonl, Some(header)) => {
                Ok(TableWriter::Text(TextTable::json_lines(out, rows.schema(), &names, header)))
            }
            #[cfg(feature = "files")]
            (OutputFormat::Parquet, _) => {
                let file = ParquetFile::new(out, rows.schema()).map_err(of_parquet)?;
                Ok(TableWriter::Parquet(Box::new(file)))
            }
            #[cfg(feature = "files")]
            (OutputFormat::Arrow, _) => {
                let file = FileWriter::try_new(out, rows.schema()).map_err(of_arrow)?;
                Ok(TableWriter::Arrow(Box::new(file)))
            }
            (other, _) => {
                let message = format!("rows are not written as {}", other.name());
                Err(io::Error::new(io::ErrorKind::InvalidInput, message))
            }
        }
    }

    fn write(&mut self, batch: RecordBatch) -> io::Result<()> {
        match self {
            TableWriter::Text(out) => out.write(&batch),
            #[cfg(feature = "files")]
            TableWriter::Parquet(out) => out.write(batch).map_err(of_parquet),
            #[cfg(feature = "files")]
            TableWriter::Arrow(out) => out.write(&batch).map_err(of_arrow),
        }
    }

    fn finish(self) -> io::Result<()> {
        match self {
            TableWriter::Text(mut out) => out.finish(),
            #[cfg(feature = "files")]
            TableWriter::Parquet(out) => out.finish().map_err(of_parquet),
            #[cfg(feature = "files")]
            TableWriter::Arrow(mut out) => out.finish().map_err(of_arrow),
        }
    }
}

/// An output lent to the writer of a table, and taken back from it.
struct SharedOutput<W>(Arc<Mutex<W>>);

impl<W> SharedOutput<W> {
    fn lend(&self) -> SharedOutput<W> {
        SharedOutput(Arc::clone(&self.0))
    }

    fn with<T>(&self, what: impl FnOnce(&mut W) -> T) -> T {
        what(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// The output, once nobody else has it.
    fn back(self) -> io::Result<W> {
        let whole = Arc::into_inner(self.0);
        let whole = whole.ok_or_else(|| io::Error::other("the output is still being written"))?;
        Ok(whole.into_inner().unwrap_or_else(PoisonError::into_inner))
    }
}

impl<W: Write> Write for SharedOutput<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.with(|out| out.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.with(W::flush)
    }
}

impl<W: Write + Send + 'static, R: RowBatcher> ColumnFile<W, R> {
    /// Writes what stands before the rows.
    ///
    /// # Errors
    /// Those of the output, and a format that has no rows.
    pub fn new(out: W, format: OutputFormat, rows: R) -> io::Result<ColumnFile<W, R>> {
        let out = SharedOutput(Arc::new(Mutex::new(out)));
        let table = TableWriter::new(Box::new(out.lend()), format, &rows)?;
        Ok(ColumnFile { format, rows, table, out })
    }

    /// Lets a row be added, or a few, and hands them on when they are many.
    ///
    /// # Errors
    /// Those of the output.
    #[inline]
    pub fn put(&mut self, add: impl FnOnce(&mut R)) -> io::Result<()> {
        add(&mut self.rows);
        if self.rows.rows() >= BATCH { self.hand_on() } else { Ok(()) }
    }

    /// Writes what is left and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(mut self) -> io::Result<W> {
        if self.rows.rows() > 0 {
            self.hand_on()?;
        }
        self.table.finish()?;
        let mut out = self.out.back()?;
        out.flush()?;
        Ok(out)
    }

    /// What gathers the rows.
    pub(super) fn gathered(&self) -> &R {
        &self.rows
    }

    fn hand_on(&mut self) -> io::Result<()> {
        let batch = self.rows.take().map_err(of_arrow)?;
        self.table.write(batch)
    }
}

impl<W, R: fmt::Debug> fmt::Debug for ColumnFile<W, R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ColumnFile")
            .field("rows", &self.rows)
            .field("format", &self.format)
            .finish()
    }
}

/// The output's own error where it is one.
fn of_arrow(error: ArrowError) -> io::Error {
    match error {
        ArrowError::IoError(_, error) => error,
        other => io::Error::other(other),
    }
}

#[cfg(feature = "files")]
fn of_parquet(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(inner) => match inner.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(inner) => io::Error::other(inner),
        },
        other => io::Error::other(other),
    }
}

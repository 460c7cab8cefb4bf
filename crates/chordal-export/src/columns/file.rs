//! Columns as a file: Parquet and Arrow, written as the rows come.

use std::fmt;
use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};

use arrow_array::RecordBatch;
use arrow_ipc::writer::FileWriter;
use arrow_schema::{ArrowError, SchemaRef};
use parquet::errors::ParquetError;

use super::parquet::ParquetFile;
use super::rows::{BATCH, RowBatcher};

/// The formats of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnFormat {
    /// Apache Parquet: groups of rows, each column compressed.
    Parquet,
    /// The Arrow IPC file, also called Feather: the columns as they lie in memory.
    Arrow,
}

/// Writes rows as they come. Of a Parquet file the rows of one group are held, of an Arrow file a
/// few thousand.
pub struct ColumnFile<W, R> {
    rows: R,
    table: TableWriter,
    out: SharedOutput<W>,
}

/// A file of either format. What it writes to is a `dyn Write`, so that its code is made once.
enum TableWriter {
    Parquet(Box<ParquetFile>),
    Arrow(Box<FileWriter<Box<dyn Write + Send>>>),
}

impl TableWriter {
    fn new(
        out: Box<dyn Write + Send>,
        format: ColumnFormat,
        schema: &SchemaRef,
    ) -> io::Result<TableWriter> {
        Ok(match format {
            ColumnFormat::Parquet => {
                TableWriter::Parquet(Box::new(ParquetFile::new(out, schema).map_err(of_parquet)?))
            }
            ColumnFormat::Arrow => {
                TableWriter::Arrow(Box::new(FileWriter::try_new(out, schema).map_err(of_arrow)?))
            }
        })
    }

    fn write(&mut self, batch: RecordBatch) -> io::Result<()> {
        match self {
            TableWriter::Parquet(out) => out.write(batch).map_err(of_parquet),
            TableWriter::Arrow(out) => out.write(&batch).map_err(of_arrow),
        }
    }

    fn finish(self) -> io::Result<()> {
        match self {
            TableWriter::Parquet(out) => out.finish().map_err(of_parquet),
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
    /// Those of the output.
    pub fn new(out: W, format: ColumnFormat, rows: R) -> io::Result<ColumnFile<W, R>> {
        let out = SharedOutput(Arc::new(Mutex::new(out)));
        let table = TableWriter::new(Box::new(out.lend()), format, rows.schema())?;
        Ok(ColumnFile { rows, table, out })
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
        let format = match self.table {
            TableWriter::Parquet(_) => ColumnFormat::Parquet,
            TableWriter::Arrow(_) => ColumnFormat::Arrow,
        };
        f.debug_struct("ColumnFile").field("rows", &self.rows).field("format", &format).finish()
    }
}

/// The output's own error where it is one.
fn of_arrow(error: ArrowError) -> io::Error {
    match error {
        ArrowError::IoError(_, error) => error,
        other => io::Error::other(other),
    }
}

fn of_parquet(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(inner) => match inner.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(inner) => io::Error::other(inner),
        },
        other => io::Error::other(other),
    }
}

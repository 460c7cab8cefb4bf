//! Columns as a file: Parquet and Arrow, written as the rows come.

use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};

use arrow_array::RecordBatch;
use arrow_ipc::writer::FileWriter;
use arrow_schema::{ArrowError, DataType, SchemaRef};
use parquet::arrow::ArrowWriter;
use parquet::basic::Compression;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::schema::types::ColumnPath;

/// Rows that are gathered before they are emitted, and the rows of a batch of an Arrow file.
pub(crate) const BATCH: usize = 1 << 13;

/// Rows of a group of a Parquet file: what a reader reads at once, some 10 MB.
const ROWS_OF_A_GROUP: usize = 1 << 17;

/// What gathers rows and gives them as a batch when it is asked.
pub trait Rows {
    /// Rows gathered since the last batch.
    fn rows(&self) -> usize;

    /// The columns, with their units and what they come from.
    fn schema(&self) -> &SchemaRef;

    /// The rows gathered so far; the next begin anew.
    ///
    /// # Errors
    /// A row without a number where its column must have one.
    fn take(&mut self) -> Result<RecordBatch, ArrowError>;
}

/// The formats of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnFormat {
    /// Apache Parquet: groups of rows, each column compressed.
    Parquet,
    /// The Arrow IPC file, also called Feather: the columns as they lie in memory.
    Arrow,
}

/// Writes rows as they come. Of a Parquet file the rows of one group are held, compressed; of an
/// Arrow file a few thousand.
#[derive(Debug)]
pub struct ColumnFile<W: Write + Send, R> {
    rows: R,
    out: Out<W>,
}

enum Out<W: Write + Send> {
    Parquet(Box<ArrowWriter<Lent<W>>>, Lent<W>),
    Arrow(Box<FileWriter<W>>),
}

/// An output lent to a Parquet writer, which otherwise gives it back with its last error put into
/// words only.
struct Lent<W>(Arc<Mutex<W>>);

impl<W> Lent<W> {
    fn lend(&self) -> Lent<W> {
        Lent(Arc::clone(&self.0))
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

impl<W: Write> Write for Lent<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.with(|out| out.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.with(W::flush)
    }
}

impl<W: Write + Send, R: Rows> ColumnFile<W, R> {
    /// Writes what stands before the rows.
    ///
    /// # Errors
    /// Those of the output.
    pub fn new(out: W, format: ColumnFormat, rows: R) -> io::Result<ColumnFile<W, R>> {
        let schema = rows.schema();
        let out = match format {
            ColumnFormat::Parquet => {
                let out = Lent(Arc::new(Mutex::new(out)));
                let made =
                    ArrowWriter::try_new(out.lend(), schema.clone(), Some(properties(schema)));
                Out::Parquet(Box::new(made.map_err(of_parquet)?), out)
            }
            ColumnFormat::Arrow => {
                Out::Arrow(Box::new(FileWriter::try_new(out, schema).map_err(of_arrow)?))
            }
        };
        Ok(ColumnFile { rows, out })
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
        let mut out = match self.out {
            Out::Parquet(mut writer, out) => {
                writer.finish().map_err(of_parquet)?;
                drop(writer);
                out.back()?
            }
            Out::Arrow(mut out) => {
                out.finish().map_err(of_arrow)?;
                out.into_inner().map_err(of_arrow)?
            }
        };
        out.flush()?;
        Ok(out)
    }

    /// What gathers the rows.
    pub(super) fn gathered(&self) -> &R {
        &self.rows
    }

    fn hand_on(&mut self) -> io::Result<()> {
        let batch = self.rows.take().map_err(of_arrow)?;
        match &mut self.out {
            Out::Parquet(out, _) => out.write(&batch).map_err(of_parquet),
            Out::Arrow(out) => out.write(&batch).map_err(of_arrow),
        }
    }
}

/// How a Parquet file is made: hardly two doubles of a movement are the same, all else repeats.
fn properties(schema: &SchemaRef) -> WriterProperties {
    let mut about: Vec<(&String, &String)> = schema.metadata().iter().collect();
    about.sort();
    let about = about.into_iter().map(|(key, value)| KeyValue::new(key.clone(), value.clone()));
    let mut properties = WriterProperties::builder()
        .set_created_by(concat!("chordal ", env!("CARGO_PKG_VERSION")).to_string())
        .set_compression(Compression::SNAPPY)
        .set_max_row_group_row_count(Some(ROWS_OF_A_GROUP))
        .set_key_value_metadata(Some(about.collect()));
    for field in schema.fields() {
        let repeats = field.data_type() != &DataType::Float64;
        let path = ColumnPath::from(field.name().as_str());
        properties = properties.set_column_dictionary_enabled(path, repeats);
    }
    properties.build()
}

impl<W: Write + Send> std::fmt::Debug for Out<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Out::Parquet(..) => "Parquet",
            Out::Arrow(_) => "Arrow",
        })
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

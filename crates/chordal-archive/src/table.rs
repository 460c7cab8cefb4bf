//! The table of an archive as a Parquet file.

use std::io::{self, Write};

use arrow_schema::ArrowError;
use parquet::arrow::ArrowWriter;
use parquet::basic::Compression;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;

use crate::columns::{ArchiveColumns, about, schema};
use crate::row::FileRecord;

/// Rows of a group: what a reader reads at once, some 20 MB at most.
const ROWS_OF_A_GROUP: usize = 1 << 14;

/// Writes rows as they come, a group at a time: the same rows give the same bytes.
pub struct TableFile<W: Write + Send> {
    columns: ArchiveColumns,
    out: ArrowWriter<W>,
}

impl<W: Write + Send> TableFile<W> {
    /// A table without rows.
    ///
    /// # Errors
    /// Where nothing can be written.
    pub fn new(out: W) -> io::Result<TableFile<W>> {
        let out = ArrowWriter::try_new(out, schema(), Some(properties(about())));
        Ok(TableFile { columns: ArchiveColumns::new(), out: out.map_err(of_parquet)? })
    }

    /// Takes the rows of a file.
    ///
    /// # Errors
    /// Where nothing more can be written.
    pub fn file(&mut self, path: &str, record: &FileRecord) -> io::Result<()> {
        for row in &record.rows {
            self.columns.push(path, record, row);
            if self.columns.rows() >= ROWS_OF_A_GROUP {
                self.hand_on()?;
            }
        }
        Ok(())
    }

    /// Writes what is left and gives the output back.
    ///
    /// # Errors
    /// Where nothing more can be written.
    pub fn finish(mut self) -> io::Result<W> {
        if self.columns.rows() > 0 {
            self.hand_on()?;
        }
        self.out.into_inner().map_err(of_parquet)
    }

    fn hand_on(&mut self) -> io::Result<()> {
        let batch = self.columns.take().map_err(of_arrow)?;
        self.out.write(&batch).map_err(of_parquet)?;
        self.out.flush().map_err(of_parquet)
    }
}

impl<W: Write + Send> std::fmt::Debug for TableFile<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TableFile").field("rows", &self.columns.rows()).finish_non_exhaustive()
    }
}

/// How the tables of archives are written.
pub(crate) fn properties(about: impl IntoIterator<Item = (String, String)>) -> WriterProperties {
    let about = about.into_iter().map(|(key, value)| KeyValue::new(key, value)).collect();
    WriterProperties::builder()
        .set_created_by(concat!("chordal ", env!("CARGO_PKG_VERSION")).to_string())
        .set_compression(Compression::SNAPPY)
        .set_key_value_metadata(Some(about))
        .build()
}

/// The output's own error where it is one.
pub(crate) fn of_arrow(error: ArrowError) -> io::Error {
    match error {
        ArrowError::IoError(_, error) => error,
        other => io::Error::other(other),
    }
}

pub(crate) fn of_parquet(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(inner) => match inner.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(inner) => io::Error::other(inner),
        },
        other => io::Error::other(other),
    }
}

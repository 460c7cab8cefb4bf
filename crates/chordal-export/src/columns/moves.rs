//! What moves cut, of a mill or of a lathe, as columns and as comma-separated text: one row a move, with its line,
//! file and tool.

use std::fmt;
use std::io::{self, Write};
use std::marker::PhantomData;

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};
use chordal::Job;
use chordal::control::Origin;
use chordal::diagnostics::FileId;

use super::cells::{FileColumn, IntegerColumn, NumberColumn};
use super::field::{CellType, Column, schema};
use super::rows::RowBatcher;

/// What is known of a move that cuts.
pub trait CuttingMoveData: Sized + 'static {
    /// Name and version of its columns.
    const COLUMNS: &'static str;
    /// Every number of it.
    const NUMBERS: &'static [NumberSpec<Self>];

    /// Its block.
    fn origin(&self) -> Origin;

    /// Its tool.
    fn tool(&self) -> u32;
}

/// A column of numbers: its name, its unit, what it means, its value.
#[derive(Debug)]
pub struct NumberSpec<T> {
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&T) -> Option<f64>,
}

pub(super) const fn number<T>(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&T) -> Option<f64>,
) -> NumberSpec<T> {
    NumberSpec { name, unit, meaning, value }
}

/// The columns of a table of moves.
pub(super) fn columns<T: CuttingMoveData>() -> Vec<Column> {
    let mut columns = vec![
        Column::new("line", CellType::Integer, "", "line of the block, from 1"),
        Column::new("file", CellType::File, "", "the text that the block is in"),
        Column::new("tool", CellType::Integer, "", "the tool in the spindle or turret"),
    ];
    let number =
        |row: &NumberSpec<T>| Column::new(row.name, CellType::NumberOrGap, row.unit, row.meaning);
    columns.extend(T::NUMBERS.iter().map(number));
    columns
}

/// Gathers moves that cut, one row each.
pub struct CutColumns<'a, T: CuttingMoveData> {
    schema: SchemaRef,
    rows: usize,
    line: IntegerColumn,
    file: FileColumn<'a>,
    tool: IntegerColumn,
    numbers: Vec<NumberColumn>,
    of: PhantomData<fn(&T)>,
}

impl<T: CuttingMoveData> fmt::Debug for CutColumns<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = f.debug_struct("CutColumns");
        text.field("columns", &T::COLUMNS).field("rows", &self.rows).finish_non_exhaustive()
    }
}

impl<'a, T: CuttingMoveData> CutColumns<'a, T> {
    /// Columns for the cuts of a job.
    pub fn new(job: &'a Job<'a>) -> CutColumns<'a, T> {
        CutColumns {
            schema: schema(job, T::COLUMNS, &columns::<T>(), &[]),
            rows: 0,
            line: IntegerColumn::new(),
            file: FileColumn::of(job),
            tool: IntegerColumn::new(),
            numbers: T::NUMBERS.iter().map(|_| NumberColumn::new()).collect(),
            of: PhantomData,
        }
    }

    /// Takes a move.
    pub fn cut(&mut self, each: &T) {
        let row = self.rows;
        let origin = each.origin();
        self.line.put(row, origin.line);
        self.file.push(origin.span.file);
        self.tool.put(row, each.tool());
        for (column, number) in self.numbers.iter_mut().zip(T::NUMBERS) {
            if let Some(value) = (number.value)(each) {
                column.put(row, value);
            }
        }
        self.rows += 1;
    }
}

impl<T: CuttingMoveData> RowBatcher for CutColumns<'_, T> {
    fn rows(&self) -> usize {
        self.rows
    }

    fn schema(&self) -> &SchemaRef {
        &self.schema
    }

    fn take(&mut self) -> Result<RecordBatch, ArrowError> {
        let rows = std::mem::take(&mut self.rows);
        let mut arrays = vec![self.line.take(rows), self.file.take()?, self.tool.take(rows)];
        arrays.extend(self.numbers.iter_mut().map(|column| column.take(rows)));
        RecordBatch::try_new(self.schema.clone(), arrays)
    }
}

/// Writes moves that cut as comma-separated text, with the names of the columns first; a gap is empty.
///
/// # Errors
/// Those of the output.
pub fn cuts_csv<T: CuttingMoveData>(
    mut out: impl Write,
    job: &Job<'_>,
    moves: &[T],
) -> io::Result<()> {
    let names: Vec<String> = columns::<T>().into_iter().map(|column| column.name).collect();
    writeln!(out, "{}", names.join(","))?;
    let file = |id: FileId| {
        let name = job.sources().get(id).map_or("", |source| source.name());
        let is_plain = !name.contains([',', '"', '\n', '\r']);
        if is_plain { name.to_string() } else { format!("\"{}\"", name.replace('"', "\"\"")) }
    };
    for each in moves {
        let origin = each.origin();
        write!(out, "{},{},{}", origin.line, file(origin.span.file), each.tool())?;
        for number in T::NUMBERS {
            match (number.value)(each) {
                Some(value) => write!(out, ",{value}")?,
                None => write!(out, ",")?,
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

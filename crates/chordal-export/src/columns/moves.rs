//! Numbers of moves as columns and as comma-separated text: one row a move, with its line, file and tool.

use std::io::{self, Write};

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};
use chordal::Job;
use chordal::control::Origin;
use chordal::diagnostics::FileId;

use super::cells::{Files, Integers, Numbers};
use super::field::{Cell, Column, schema};
use super::file::Rows;

/// A column of numbers: its name, its unit, what it means, its value.
pub(super) struct Number<T> {
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
) -> Number<T> {
    Number { name, unit, meaning, value }
}

/// The columns of a table of moves.
pub(super) fn columns<T>(numbers: &[Number<T>]) -> Vec<Column> {
    let mut columns = vec![
        Column::new("line", Cell::Integer, "", "line of the block, from 1"),
        Column::new("file", Cell::File, "", "the text that the block is in"),
        Column::new("tool", Cell::Integer, "", "the tool in the spindle or turret"),
    ];
    columns.extend(
        numbers.iter().map(|row| Column::new(row.name, Cell::NumberOrGap, row.unit, row.meaning)),
    );
    columns
}

/// Gathers moves, one row each.
pub(super) struct MoveColumns<'a, T: 'static> {
    schema: SchemaRef,
    rows: usize,
    line: Integers,
    file: Files<'a>,
    tool: Integers,
    numbers: Vec<Numbers>,
    table: &'static [Number<T>],
}

impl<'a, T> MoveColumns<'a, T> {
    pub fn new(job: &'a Job<'a>, name: &str, table: &'static [Number<T>]) -> MoveColumns<'a, T> {
        MoveColumns {
            schema: schema(job, name, &columns(table), &[]),
            rows: 0,
            line: Integers::new(),
            file: Files::of(job),
            tool: Integers::new(),
            numbers: table.iter().map(|_| Numbers::new()).collect(),
            table,
        }
    }

    /// Takes a move.
    pub fn put(&mut self, origin: Origin, tool: u32, each: &T) {
        let row = self.rows;
        self.line.put(row, origin.line);
        self.file.push(origin.span.file);
        self.tool.put(row, tool);
        for (column, number) in self.numbers.iter_mut().zip(self.table) {
            if let Some(value) = (number.value)(each) {
                column.put(row, value);
            }
        }
        self.rows += 1;
    }
}

impl<T> Rows for MoveColumns<'_, T> {
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

/// Writes moves as comma-separated text, with the names of the columns first; a gap is empty.
///
/// # Errors
/// Those of the output.
pub(super) fn csv<'m, T: 'm>(
    mut out: impl Write,
    job: &Job<'_>,
    table: &[Number<T>],
    moves: impl Iterator<Item = (Origin, u32, &'m T)>,
) -> io::Result<()> {
    let names: Vec<String> = columns(table).into_iter().map(|column| column.name).collect();
    writeln!(out, "{}", names.join(","))?;
    let file = |id: FileId| {
        let name = job.sources().get(id).map_or("", |source| source.name());
        let is_plain = !name.contains([',', '"', '\n', '\r']);
        if is_plain { name.to_string() } else { format!("\"{}\"", name.replace('"', "\"\"")) }
    };
    for (origin, tool, each) in moves {
        write!(out, "{},{},{tool}", origin.line, file(origin.span.file))?;
        for number in table {
            match (number.value)(each) {
                Some(value) => write!(out, ",{value}")?,
                None => write!(out, ",")?,
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

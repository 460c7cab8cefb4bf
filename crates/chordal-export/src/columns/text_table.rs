//! Rows as text: comma-separated, the names of the columns first, or JSON lines, an object each after a header.

use std::io::{self, Write};

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int8Type, Int16Type, UInt32Type};
use arrow_array::{Array, RecordBatch};
use arrow_schema::{DataType, SchemaRef};

use crate::json::push_text;
use crate::number::{push_finite, push_integer};

/// Writes batches as text.
pub(super) struct TextTable {
    out: Box<dyn Write + Send>,
    text: Vec<u8>,
    /// What stands before the value of each column, and its place in the batches: `None` for a column that a machine
    /// does not have.
    columns: Vec<(Vec<u8>, Option<usize>)>,
    is_json: bool,
}

impl TextTable {
    /// The names of the columns, then rows; a gap is empty.
    pub fn separated(
        out: Box<dyn Write + Send>,
        schema: &SchemaRef,
        names: &[String],
        separator: &str,
    ) -> TextTable {
        let before = |place: usize| if place == 0 { "" } else { separator }.as_bytes().to_vec();
        let of = |(place, name): (usize, &String)| (before(place), schema.index_of(name).ok());
        let columns = names.iter().enumerate().map(of).collect();
        let text = format!("{}\n", names.join(separator)).into_bytes();
        TextTable { out, text, columns, is_json: false }
    }

    /// The header, then objects; a gap is null.
    pub fn json_lines(
        out: Box<dyn Write + Send>,
        schema: &SchemaRef,
        names: &[String],
        header: Vec<u8>,
    ) -> TextTable {
        let of = |(place, name): (usize, &String)| {
            let before = format!("{}\"{name}\":", if place == 0 { '{' } else { ',' });
            (before.into_bytes(), schema.index_of(name).ok())
        };
        let columns = names.iter().enumerate().map(of).collect();
        TextTable { out, text: header, columns, is_json: true }
    }

    pub fn write(&mut self, batch: &RecordBatch) -> io::Result<()> {
        let (gap, end): (&[u8], &[u8]) =
            if self.is_json { (b"null", b"}\n") } else { (b"", b"\n") };
        for row in 0..batch.num_rows() {
            for (before, place) in &self.columns {
                self.text.extend_from_slice(before);
                let column = place.map(|place| batch.column(place));
                let column = column.filter(|column| column.is_valid(row));
                if !column.is_some_and(|of| push_value(&mut self.text, of, row, self.is_json)) {
                    self.text.extend_from_slice(gap);
                }
            }
            self.text.extend_from_slice(end);
        }
        self.finish()
    }

    /// Writes what is left.
    pub fn finish(&mut self) -> io::Result<()> {
        self.out.write_all(&self.text)?;
        self.text.clear();
        Ok(())
    }
}

/// Appends the value of a row; nothing, and false, for a number that is none.
fn push_value(out: &mut Vec<u8>, column: &dyn Array, row: usize, is_json: bool) -> bool {
    let word = match column.data_type() {
        DataType::Float64 => {
            return push_finite(out, column.as_primitive::<Float64Type>().value(row));
        }
        DataType::UInt32 => {
            push_integer(out, column.as_primitive::<UInt32Type>().value(row).into());
            return true;
        }
        DataType::Boolean => {
            let words: [&[u8]; 2] = if is_json { [b"false", b"true"] } else { [b"0", b"1"] };
            out.extend_from_slice(words[usize::from(column.as_boolean().value(row))]);
            return true;
        }
        DataType::Dictionary(key, _) if **key == DataType::Int8 => {
            let column = column.as_dictionary::<Int8Type>();
            column.values().as_string::<i32>().value(column.keys().value(row) as usize)
        }
        DataType::Dictionary(..) => {
            let column = column.as_dictionary::<Int16Type>();
            column.values().as_string::<i32>().value(column.keys().value(row) as usize)
        }
        _ => column.as_string::<i32>().value(row),
    };
    if is_json {
        push_text(out, word);
    } else if word.contains([',', '"', '\n', '\r']) {
        out.extend_from_slice(format!("\"{}\"", word.replace('"', "\"\"")).as_bytes());
    } else {
        out.extend_from_slice(word.as_bytes());
    }
    true
}

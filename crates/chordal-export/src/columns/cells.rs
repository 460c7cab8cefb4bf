//! Columns that grow: what a row does not say is a gap.

use std::sync::Arc;

use arrow_array::builder::StringBuilder;
use arrow_array::types::{Int8Type, Int16Type};
use arrow_array::{
    ArrayRef, BooleanArray, DictionaryArray, Float64Array, Int8Array, Int16Array, StringArray,
    UInt32Array,
};
use arrow_buffer::{NullBuffer, NullBufferBuilder};
use arrow_schema::ArrowError;
use chordal::SourceMap;

/// Values of which rows may have none.
#[derive(Debug)]
struct NullableColumn<T> {
    values: Vec<T>,
    nulls: NullBufferBuilder,
    /// What lies where there is none.
    gap: T,
}

impl<T: Copy> NullableColumn<T> {
    fn new(gap: T) -> NullableColumn<T> {
        NullableColumn { values: Vec::new(), nulls: NullBufferBuilder::new(0), gap }
    }

    /// The value of a row; rows before it that got none are gaps.
    #[inline]
    fn put(&mut self, row: usize, value: T) {
        self.fill(row);
        self.values.push(value);
        self.nulls.append_non_null();
    }

    /// All rows, and which of them are gaps.
    fn take(&mut self, rows: usize) -> (Vec<T>, Option<NullBuffer>) {
        self.fill(rows);
        (std::mem::take(&mut self.values), self.nulls.finish())
    }

    #[inline]
    fn fill(&mut self, rows: usize) {
        let gaps = rows - self.values.len();
        if gaps > 0 {
            self.values.resize(rows, self.gap);
            self.nulls.append_n_nulls(gaps);
        }
    }
}

/// Doubles. A gap is null, and NaN to who looks at the numbers alone.
#[derive(Debug)]
pub(super) struct NumberColumn(NullableColumn<f64>);

impl NumberColumn {
    pub fn new() -> NumberColumn {
        NumberColumn(NullableColumn::new(f64::NAN))
    }

    /// The value of a row, where it is a number.
    #[inline]
    pub fn put(&mut self, row: usize, value: f64) {
        if value.is_finite() {
            self.0.put(row, value);
        }
    }

    pub fn take(&mut self, rows: usize) -> ArrayRef {
        let (values, nulls) = self.0.take(rows);
        Arc::new(Float64Array::new(values.into(), nulls))
    }
}

/// Whole numbers from 0.
#[derive(Debug)]
pub(super) struct IntegerColumn(NullableColumn<u32>);

impl IntegerColumn {
    pub fn new() -> IntegerColumn {
        IntegerColumn(NullableColumn::new(0))
    }

    #[inline]
    pub fn put(&mut self, row: usize, value: u32) {
        self.0.put(row, value);
    }

    pub fn take(&mut self, rows: usize) -> ArrayRef {
        let (values, nulls) = self.0.take(rows);
        Arc::new(UInt32Array::new(values.into(), nulls))
    }
}

/// Words of a small set.
#[derive(Debug)]
pub(super) struct WordColumn {
    words: &'static [&'static str],
    keys: NullableColumn<i8>,
}

impl WordColumn {
    pub fn new(words: &'static [&'static str]) -> WordColumn {
        WordColumn { words, keys: NullableColumn::new(0) }
    }

    /// The word of a row, by its place in the set.
    #[inline]
    pub fn put(&mut self, row: usize, word: usize) {
        self.keys.put(row, word as i8);
    }

    /// The word itself; one that is not of the set leaves a gap.
    pub fn put_word(&mut self, row: usize, word: &str) {
        if let Some(place) = self.words.iter().position(|own| *own == word) {
            self.put(row, place);
        }
    }

    pub fn take(&mut self, rows: usize) -> Result<ArrayRef, ArrowError> {
        let (keys, nulls) = self.keys.take(rows);
        let keys = Int8Array::new(keys.into(), nulls);
        let words = Arc::new(StringArray::from(self.words.to_vec()));
        Ok(Arc::new(DictionaryArray::<Int8Type>::try_new(keys, words)?))
    }
}

/// Which text a row comes from.
#[derive(Debug)]
pub(super) struct FileColumn<'a> {
    sources: &'a SourceMap<'a>,
    keys: Vec<i16>,
}

impl<'a> FileColumn<'a> {
    pub fn of(job: &'a chordal::Job<'a>) -> FileColumn<'a> {
        FileColumn { sources: job.sources(), keys: Vec::new() }
    }

    #[inline]
    pub fn push(&mut self, file: chordal::diagnostics::FileId) {
        self.keys.push(file.0 as i16);
    }

    /// The names are those of the texts by now: a run may have come by more.
    pub fn take(&mut self) -> Result<ArrayRef, ArrowError> {
        let keys = Int16Array::from(std::mem::take(&mut self.keys));
        let texts = self.sources.iter().map(|(_, source)| source);
        let names = texts.chain(self.sources.appended()).map(|source| Some(source.name()));
        let names = Arc::new(names.collect::<StringArray>());
        Ok(Arc::new(DictionaryArray::<Int16Type>::try_new(keys, names)?))
    }
}

/// Yes and no.
#[derive(Debug)]
pub(super) struct FlagColumn(NullableColumn<bool>);

impl FlagColumn {
    pub fn new() -> FlagColumn {
        FlagColumn(NullableColumn::new(false))
    }

    #[inline]
    pub fn put(&mut self, row: usize, value: bool) {
        self.0.put(row, value);
    }

    pub fn take(&mut self, rows: usize) -> ArrayRef {
        let (values, nulls) = self.0.take(rows);
        Arc::new(BooleanArray::new(values.into(), nulls))
    }
}

/// Text.
#[derive(Debug)]
pub(super) struct TextColumn {
    builder: StringBuilder,
    rows: usize,
}

impl TextColumn {
    pub fn new() -> TextColumn {
        TextColumn { builder: StringBuilder::with_capacity(0, 0), rows: 0 }
    }

    pub fn put(&mut self, row: usize, text: &str) {
        self.fill(row);
        self.builder.append_value(text);
        self.rows += 1;
    }

    pub fn take(&mut self, rows: usize) -> ArrayRef {
        self.fill(rows);
        self.rows = 0;
        Arc::new(self.builder.finish())
    }

    fn fill(&mut self, rows: usize) {
        self.builder.append_nulls(rows - self.rows);
        self.rows = rows;
    }
}

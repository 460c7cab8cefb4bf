//! Parquet: the columns of the schemas that Chordal has, on the writers of columns of `parquet`.
//!
//! Its own writer of Arrow batches knows every type of Arrow, and reads as well; it was a tenth
//! of a first build. These are nine types, written the same to the byte.

use std::io::Write;
use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, UInt32Type, UInt64Type};
use arrow_array::{Array, ArrayRef, RecordBatch};
use arrow_ipc::writer::{DictionaryTracker, IpcDataGenerator, IpcWriteOptions};
use arrow_schema::{DataType, Field, Schema};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use bytes::Bytes;
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{
    BoolType, ByteArray, ByteArrayType, DataType as Stored, DoubleType, Int32Type, Int64Type,
};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{ColumnPath, Type};

/// Rows of a group: what a reader reads at once, some 10 MB.
const ROWS_OF_A_GROUP: usize = 1 << 17;

/// Writes batches of one schema, and holds the rows of one group.
pub(super) struct ParquetFile {
    file: SerializedFileWriter<Box<dyn Write + Send>>,
    batches: Vec<RecordBatch>,
    rows: usize,
}

impl ParquetFile {
    pub fn new(out: Box<dyn Write + Send>, schema: &Schema) -> Result<ParquetFile> {
        let fields = schema.fields().iter().map(|field| stored(field).map(Arc::new));
        let fields = fields.collect::<Result<Vec<_>>>()?;
        let root = Type::group_type_builder("arrow_schema").with_fields(fields).build()?;
        let properties = Arc::new(properties(schema));
        let file = SerializedFileWriter::new(out, Arc::new(root), properties)?;
        Ok(ParquetFile { file, batches: Vec::new(), rows: 0 })
    }

    pub fn write(&mut self, mut batch: RecordBatch) -> Result<()> {
        while self.rows + batch.num_rows() >= ROWS_OF_A_GROUP {
            let room = ROWS_OF_A_GROUP - self.rows;
            self.batches.push(batch.slice(0, room));
            batch = batch.slice(room, batch.num_rows() - room);
            self.write_group()?;
        }
        self.rows += batch.num_rows();
        self.batches.push(batch);
        Ok(())
    }

    pub fn finish(mut self) -> Result<()> {
        if self.rows > 0 {
            self.write_group()?;
        }
        self.file.finish()?;
        Ok(())
    }

    fn write_group(&mut self) -> Result<()> {
        self.rows = 0;
        let batches = std::mem::take(&mut self.batches);
        let Some(schema) = batches.first().map(RecordBatch::schema) else { return Ok(()) };
        let mut group = self.file.next_row_group()?;
        for (place, field) in schema.fields().iter().enumerate() {
            let leaves: Vec<Vec<ParquetLeaf>> =
                batches.iter().map(|batch| leaves(field, batch.column(place))).collect();
            for leaf in 0..leaves[0].len() {
                let missing = || ParquetError::General(format!("no column for {}", field.name()));
                let mut column = group.next_column()?.ok_or_else(missing)?;
                leaves.iter().try_for_each(|of_batch| of_batch[leaf].write(&mut column))?;
                column.close()?;
            }
        }
        group.close()?;
        Ok(())
    }
}

/// How a file is made: hardly two doubles of a movement are the same, all else repeats.
fn properties(schema: &Schema) -> WriterProperties {
    let mut about: Vec<(&String, &String)> = schema.metadata().iter().collect();
    about.sort();
    let about = about.into_iter().map(|(key, value)| KeyValue::new(key.clone(), value.clone()));
    let arrow = KeyValue::new("ARROW:schema".to_string(), encoded(schema));
    let mut properties = WriterProperties::builder()
        .set_created_by(concat!("chordal ", env!("CARGO_PKG_VERSION")).to_string())
        .set_compression(Compression::SNAPPY)
        .set_key_value_metadata(Some(about.chain([arrow]).collect()));
    for field in schema.fields() {
        let repeats = field.data_type() != &DataType::Float64;
        let path = ColumnPath::from(field.name().as_str());
        properties = properties.set_column_dictionary_enabled(path, repeats);
    }
    properties.build()
}

/// The schema as readers that know Arrow look for it: units, words of a small set.
fn encoded(schema: &Schema) -> String {
    let mut words = DictionaryTracker::new(true);
    let options = IpcWriteOptions::default();
    let message = IpcDataGenerator::default()
        .schema_to_bytes_with_dictionary_tracker(schema, &mut words, &options)
        .ipc_message;
    let mut framed = vec![0xFF; 4];
    framed.extend((message.len() as u32).to_le_bytes());
    framed.extend(message);
    BASE64_STANDARD.encode(framed)
}

/// A column as Parquet has it.
fn stored(field: &Field) -> Result<Type> {
    let name = field.name();
    let repetition = if field.is_nullable() { Repetition::OPTIONAL } else { Repetition::REQUIRED };
    let (physical, logical) = match field.data_type() {
        DataType::Boolean => (Physical::BOOLEAN, None),
        DataType::UInt32 => (Physical::INT32, Some(LogicalType::integer(32, false))),
        DataType::UInt64 => (Physical::INT64, Some(LogicalType::integer(64, false))),
        DataType::Float64 => (Physical::DOUBLE, None),
        DataType::Utf8 => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        DataType::Dictionary(_, word) if **word == DataType::Utf8 => {
            (Physical::BYTE_ARRAY, Some(LogicalType::String))
        }
        DataType::List(item) => {
            let list = Type::group_type_builder("list")
                .with_fields(vec![Arc::new(stored(item)?)])
                .with_repetition(Repetition::REPEATED);
            return Type::group_type_builder(name)
                .with_fields(vec![Arc::new(list.build()?)])
                .with_logical_type(Some(LogicalType::List))
                .with_repetition(repetition)
                .build();
        }
        DataType::Struct(fields) => {
            let fields = fields.iter().map(|field| stored(field).map(Arc::new));
            return Type::group_type_builder(name)
                .with_fields(fields.collect::<Result<_>>()?)
                .with_repetition(repetition)
                .build();
        }
        other => return Err(ParquetError::NYI(format!("a column of {other}"))),
    };
    Type::primitive_type_builder(name, physical)
        .with_logical_type(logical)
        .with_repetition(repetition)
        .build()
}

/// A place in a column of Parquet: how much of its path is there, at which level of its lists it
/// goes on, and the value's place where there is one.
#[derive(Clone, Copy)]
struct ParquetSlot {
    definition: i16,
    repetition: i16,
    value: Option<usize>,
}

/// The values of one column of Parquet, and where they lie.
struct ParquetLeaf {
    values: ArrayRef,
    definition: Option<Vec<i16>>,
    repetition: Option<Vec<i16>>,
    /// Which of the values are there; without it all of them.
    there: Option<Vec<usize>>,
}

/// A column as the columns of Parquet that it becomes: a struct is one for each field.
fn leaves(field: &Field, values: &ArrayRef) -> Vec<ParquetLeaf> {
    let rows = values.len();
    if let DataType::List(_) | DataType::Struct(_) = field.data_type() {
        let slot = |row| ParquetSlot { definition: 0, repetition: 0, value: Some(row) };
        let mut leaves = Vec::new();
        descend(field, values, (0..rows).map(slot).collect(), 0, &mut leaves);
        return leaves;
    }
    let mut leaf =
        ParquetLeaf { values: values.clone(), definition: None, repetition: None, there: None };
    if field.is_nullable() {
        let nulls = values.nulls().filter(|nulls| nulls.null_count() > 0);
        leaf.definition = Some(match nulls {
            Some(nulls) => nulls.iter().map(i16::from).collect(),
            None => vec![1; rows],
        });
        leaf.there = nulls.map(|nulls| nulls.valid_indices().collect());
    }
    vec![leaf]
}

/// Takes slots one step down, to the fields of what they hold.
fn descend(
    field: &Field,
    values: &ArrayRef,
    mut slots: Vec<ParquetSlot>,
    lists: i16,
    leaves: &mut Vec<ParquetLeaf>,
) {
    if field.is_nullable() {
        for slot in &mut slots {
            slot.value = slot.value.filter(|&value| values.is_valid(value));
            slot.definition += i16::from(slot.value.is_some());
        }
    }
    match field.data_type() {
        DataType::List(item) => {
            let list = values.as_list::<i32>();
            let offsets = list.value_offsets();
            let mut inside = Vec::new();
            for slot in slots {
                let range =
                    slot.value.map(|value| offsets[value] as usize..offsets[value + 1] as usize);
                let Some(range) = range.filter(|range| !range.is_empty()) else {
                    inside.push(ParquetSlot { value: None, ..slot });
                    continue;
                };
                let first = range.start;
                inside.extend(range.map(|value| ParquetSlot {
                    definition: slot.definition + 1,
                    repetition: if value == first { slot.repetition } else { lists + 1 },
                    value: Some(value),
                }));
            }
            descend(item, list.values(), inside, lists + 1, leaves);
        }
        DataType::Struct(fields) => {
            for (field, values) in fields.iter().zip(values.as_struct().columns()) {
                descend(field, values, slots.clone(), lists, leaves);
            }
        }
        _ => leaves.push(ParquetLeaf {
            values: values.clone(),
            definition: Some(slots.iter().map(|slot| slot.definition).collect()),
            repetition: (lists > 0).then(|| slots.iter().map(|slot| slot.repetition).collect()),
            there: Some(slots.iter().filter_map(|slot| slot.value).collect()),
        }),
    }
}

impl ParquetLeaf {
    fn write(&self, column: &mut SerializedColumnWriter<'_>) -> Result<()> {
        match self.values.data_type() {
            DataType::Boolean => {
                let values = self.values.as_boolean();
                self.put::<BoolType>(column, &self.there(|row| values.value(row)))
            }
            DataType::UInt32 => {
                let values = self.values.as_primitive::<UInt32Type>().values();
                self.put::<Int32Type>(column, &self.there(|row| values[row] as i32))
            }
            DataType::UInt64 => {
                let values = self.values.as_primitive::<UInt64Type>().values();
                self.put::<Int64Type>(column, &self.there(|row| values[row] as i64))
            }
            DataType::Float64 => {
                let values = self.values.as_primitive::<Float64Type>().values();
                if self.there.is_none() {
                    return self.put::<DoubleType>(column, values);
                }
                self.put::<DoubleType>(column, &self.there(|row| values[row]))
            }
            DataType::Utf8 => {
                let texts = texts(&self.values);
                self.put::<ByteArrayType>(column, &self.there(|row| texts[row].clone()))
            }
            _ => {
                let dictionary = self.values.as_any_dictionary();
                let (words, keys) = (texts(dictionary.values()), dictionary.normalized_keys());
                self.put::<ByteArrayType>(column, &self.there(|row| words[keys[row]].clone()))
            }
        }
    }

    fn there<T>(&self, value: impl Fn(usize) -> T) -> Vec<T> {
        match &self.there {
            Some(rows) => rows.iter().map(|&row| value(row)).collect(),
            None => (0..self.values.len()).map(value).collect(),
        }
    }

    fn put<T: Stored>(
        &self,
        column: &mut SerializedColumnWriter<'_>,
        values: &[T::T],
    ) -> Result<()> {
        let (definition, repetition) = (self.definition.as_deref(), self.repetition.as_deref());
        column.typed::<T>().write_batch(values, definition, repetition)?;
        Ok(())
    }
}

/// Texts without a copy for each.
fn texts(values: &ArrayRef) -> Vec<ByteArray> {
    let texts = values.as_string::<i32>();
    let bytes = Bytes::copy_from_slice(texts.value_data());
    let ends = texts.value_offsets().windows(2);
    ends.map(|ends| ByteArray::from(bytes.slice(ends[0] as usize..ends[1] as usize))).collect()
}

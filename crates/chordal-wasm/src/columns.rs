//! Record batches as parts of an answer: a part of plain numbers for each column, which JavaScript
//! sees as a typed array.

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int8Type, Int16Type, UInt32Type};
use arrow_array::{Array, RecordBatch, StringArray};
use arrow_schema::DataType;
use chordal_export::columns::Rows;
use serde_json::{Map, Value, json};

use crate::answer::{Answer, Failure};

/// Rows as an answer; `about` is what stands next to them.
pub fn table(rows: &mut impl Rows, mut about: Value) -> Result<Answer, Failure> {
    let batch = rows.take().map_err(|error| Failure::plain(error.to_string(), None))?;
    let mut parts = Parts(Vec::new());
    let schema = batch.schema();
    let mut metadata: Vec<(&String, &String)> = schema.metadata().iter().collect();
    metadata.sort();
    for (key, value) in metadata {
        about[key.strip_prefix("chordal.").unwrap_or(key)] = json!(value);
    }
    about["rows"] = json!(batch.num_rows());
    about["columns"] = columns(&batch, &mut parts);
    Ok(Answer { text: about.to_string(), parts: parts.0 })
}

fn columns(batch: &RecordBatch, parts: &mut Parts) -> Value {
    let schema = batch.schema();
    let columns = schema.fields().iter().zip(batch.columns()).map(|(field, column)| {
        let mut object = Map::new();
        object.insert("name".into(), json!(field.name()));
        object.insert("unit".into(), json!(field.metadata().get("unit")));
        values(column, parts, &mut object);
        let gaps = column.nulls().filter(|nulls| nulls.null_count() > 0);
        let valid = gaps.map(|nulls| parts.put(nulls.iter().map(|valid| [u8::from(valid)])));
        object.insert("valid".into(), json!(valid));
        Value::Object(object)
    });
    columns.collect()
}

/// The kind of a column, the part of its values, and its words.
fn values(column: &dyn Array, parts: &mut Parts, object: &mut Map<String, Value>) {
    let (kind, part, words) = match column.data_type() {
        DataType::Float64 => {
            let values = column.as_primitive::<Float64Type>().values();
            ("number", parts.put(values.iter().map(|value| value.to_ne_bytes())), None)
        }
        DataType::UInt32 => {
            let values = column.as_primitive::<UInt32Type>().values();
            ("integer", parts.put(values.iter().map(|value| value.to_ne_bytes())), None)
        }
        DataType::Boolean => {
            let values = column.as_boolean().values();
            ("flag", parts.put(values.iter().map(|value| [u8::from(value)])), None)
        }
        DataType::Dictionary(key, _) if **key == DataType::Int8 => {
            let column = column.as_dictionary::<Int8Type>();
            let keys = column.keys().values();
            let part = parts.put(keys.iter().map(|key| key.to_ne_bytes()));
            ("word", part, Some(texts(column.values().as_string())))
        }
        DataType::Dictionary(..) => {
            let column = column.as_dictionary::<Int16Type>();
            let keys = column.keys().values();
            let part = parts.put(keys.iter().map(|key| key.to_ne_bytes()));
            ("file", part, Some(texts(column.values().as_string())))
        }
        _ => ("text", None, Some(texts(column.as_string()))),
    };
    object.insert("kind".into(), json!(kind));
    object.insert("part".into(), json!(part));
    object.insert("words".into(), json!(words));
}

fn texts(column: &StringArray) -> Vec<Option<&str>> {
    column.iter().collect()
}

/// The parts of an answer, numbered from 1.
struct Parts(Vec<Vec<u8>>);

impl Parts {
    fn put<const N: usize>(
        &mut self,
        values: impl ExactSizeIterator<Item = [u8; N]>,
    ) -> Option<usize> {
        let mut bytes = Vec::with_capacity(values.len() * N);
        values.for_each(|value| bytes.extend_from_slice(&value));
        self.0.push(bytes);
        Some(self.0.len())
    }
}

//! Record batches as parts of an answer: a part of plain numbers for each column, which JavaScript
//! sees as a typed array.

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int8Type, Int16Type, UInt32Type};
use arrow_array::{Array, RecordBatch, StringArray};
use arrow_schema::DataType;
use chordal_export::columns::RowBatcher;
use serde_json::{Map, Value, json};

use crate::answer::{QuestionAnswer, QuestionFailure};

/// Rows as an answer; `about` is the object that the columns are added to.
pub fn table(
    rows: &mut impl RowBatcher,
    mut about: Value,
) -> Result<QuestionAnswer, QuestionFailure> {
    let batch = rows.take().map_err(|error| QuestionFailure::plain(error.to_string(), None))?;
    let mut parts = AnswerParts(Vec::new());
    let schema = batch.schema();
    let mut metadata: Vec<(&String, &String)> = schema.metadata().iter().collect();
    metadata.sort();
    for (key, value) in metadata {
        about[key.strip_prefix("chordal.").unwrap_or(key)] = json!(value);
    }
    about["rows"] = json!(batch.num_rows());
    about["columns"] = columns(&batch, &mut parts);
    Ok(QuestionAnswer { text: about.to_string(), parts: parts.0 })
}

fn columns(batch: &RecordBatch, parts: &mut AnswerParts) -> Value {
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
fn values(column: &dyn Array, parts: &mut AnswerParts, object: &mut Map<String, Value>) {
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

/// An answer as one JSON value: the columns of a table with their values in them. A text that is no JSON is a
/// string.
pub fn inline(answer: QuestionAnswer) -> Value {
    let QuestionAnswer { text, parts } = answer;
    let Ok(mut about) = serde_json::from_str::<Value>(&text) else { return Value::String(text) };
    let Some(columns) = about.get_mut("columns").and_then(Value::as_array_mut) else {
        return about;
    };
    if parts.is_empty() {
        return about;
    }
    for column in columns {
        let part = |key: &str| {
            let index = column[key].as_u64().and_then(|index| usize::try_from(index).ok());
            index.and_then(|index| parts.get(index.checked_sub(1)?)).map(Vec::as_slice)
        };
        let mut values = column_values(column, part("part"));
        if let Some(valid) = part("valid") {
            for (value, _) in values.iter_mut().zip(valid).filter(|(_, valid)| **valid == 0) {
                *value = Value::Null;
            }
        }
        let object = json!({ "name": column["name"], "unit": column["unit"], "values": values });
        *column = object;
    }
    about
}

/// The values of a column out of their bytes. A number that JSON does not have is null.
fn column_values(column: &Value, part: Option<&[u8]>) -> Vec<Value> {
    let words = column["words"].as_array();
    let Some(part) = part else { return words.cloned().unwrap_or_default() };
    let word = |key: usize| words.and_then(|words| words.get(key)).cloned().unwrap_or_default();
    match column["kind"].as_str() {
        Some("number") => {
            part.as_chunks().0.iter().map(|v| json!(f64::from_ne_bytes(*v))).collect()
        }
        Some("integer") => {
            part.as_chunks().0.iter().map(|v| json!(u32::from_ne_bytes(*v))).collect()
        }
        Some("flag") => part.iter().map(|flag| json!(*flag != 0)).collect(),
        Some("word") => part.iter().map(|key| word(usize::from(*key))).collect(),
        _ => {
            let keys = part.as_chunks().0.iter().map(|key| u16::from_ne_bytes(*key));
            keys.map(|key| word(usize::from(key))).collect()
        }
    }
}

/// The parts of an answer, numbered from 1.
struct AnswerParts(Vec<Vec<u8>>);

impl AnswerParts {
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

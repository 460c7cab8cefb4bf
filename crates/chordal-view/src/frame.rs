//! Binary frames: a short JSON header and columns of little-endian numbers.
//!
//! ```text
//! u32 length of the header │ header, JSON, padded with blanks │ columns, each from a multiple of 8
//! ```
//!
//! The header's `columns` object has the type of each column, its offset from the end of the header, and its count of
//! numbers. The length and the header together are a multiple of 8 bytes, so that a browser can use the columns in
//! place without a copy.

use serde_json::{Map, Value, json};

/// A frame being built.
#[derive(Debug, Default)]
pub struct ColumnFrame {
    columns: Map<String, Value>,
    data: Vec<u8>,
}

/// A number type for columns.
pub trait ColumnNumber: Copy {
    /// The name of the type in the header: `f32`.
    const WORD: &'static str;
    /// Appends the bytes of a column.
    fn put(column: &[Self], out: &mut Vec<u8>);
}

impl ColumnNumber for u8 {
    const WORD: &'static str = "u8";
    fn put(column: &[u8], out: &mut Vec<u8>) {
        out.extend_from_slice(column);
    }
}

macro_rules! cells {
    ($($cell:ty, $word:literal);*) => {$(
        impl ColumnNumber for $cell {
            const WORD: &'static str = $word;
            fn put(column: &[$cell], out: &mut Vec<u8>) {
                out.extend(column.iter().flat_map(|value| value.to_le_bytes()));
            }
        }
    )*};
}

cells!(u32, "u32"; f32, "f32"; f64, "f64");

impl ColumnFrame {
    pub fn column<C: ColumnNumber>(&mut self, name: &str, values: &[C]) {
        let place = json!({ "type": C::WORD, "offset": self.data.len(), "count": values.len() });
        self.columns.insert(name.into(), place);
        self.data.reserve(size_of_val(values) + 8);
        C::put(values, &mut self.data);
        self.data.resize(self.data.len().next_multiple_of(8), 0);
    }

    /// The frame, with the other entries of its header.
    pub fn finish(self, header: Value) -> Vec<u8> {
        let mut object = match header {
            Value::Object(object) => object,
            _ => Map::new(),
        };
        object.insert("columns".into(), self.columns.into());
        let mut text = Value::Object(object).to_string();
        let padded = (text.len() + 4).next_multiple_of(8) - 4;
        text.extend(std::iter::repeat_n(' ', padded - text.len()));
        let mut bytes = Vec::with_capacity(4 + text.len() + self.data.len());
        bytes.extend_from_slice(&(text.len() as u32).to_le_bytes());
        bytes.extend_from_slice(text.as_bytes());
        bytes.extend_from_slice(&self.data);
        bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_lie_where_the_header_says() {
        let mut frame = ColumnFrame::default();
        frame.column("kind", &[1u8, 2, 3]);
        frame.column("x", &[1.5f32, -2.0]);
        let bytes = frame.finish(json!({ "type": "path" }));
        let length = u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize;
        assert_eq!((length + 4) % 8, 0);
        let header: Value = serde_json::from_slice(&bytes[4..4 + length]).unwrap();
        assert_eq!(header["type"], "path");
        assert_eq!(header["columns"]["x"], json!({ "type": "f32", "offset": 8, "count": 2 }));
        let data = &bytes[4 + length..];
        assert_eq!(data[..3], [1, 2, 3]);
        assert_eq!(data[8..16], [1.5f32.to_le_bytes(), (-2f32).to_le_bytes()].concat());
    }
}

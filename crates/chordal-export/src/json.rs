//! JSON written straight into bytes: a million commands pass here, so no tree is built.

use crate::number::{push_integer, push_number};

/// The fields of one object. Names are the program's own and need no escaping.
pub(crate) struct JsonObject<'o> {
    out: &'o mut Vec<u8>,
    empty: bool,
}

impl<'o> JsonObject<'o> {
    /// Opens an object.
    pub fn open(out: &'o mut Vec<u8>) -> JsonObject<'o> {
        out.push(b'{');
        JsonObject { out, empty: true }
    }

    /// Closes it.
    pub fn close(self) {
        self.out.push(b'}');
    }

    fn name(&mut self, name: &str) -> &mut Vec<u8> {
        if !self.empty {
            self.out.push(b',');
        }
        self.empty = false;
        self.out.push(b'"');
        self.out.extend_from_slice(name.as_bytes());
        self.out.extend_from_slice(b"\":");
        self.out
    }

    /// A number; `null` where it is none.
    pub fn number(&mut self, name: &str, value: f64) {
        push_number(self.name(name), value);
    }

    /// A number that may be missing.
    pub fn optional(&mut self, name: &str, value: Option<f64>) {
        self.number(name, value.unwrap_or(f64::NAN));
    }

    /// A whole number.
    /// Numbers in a list.
    pub fn numbers(&mut self, name: &str, values: impl Iterator<Item = f64>) {
        let out = self.name(name);
        out.push(b'[');
        for (index, value) in values.enumerate() {
            if index > 0 {
                out.push(b',');
            }
            push_number(out, value);
        }
        out.push(b']');
    }

    pub fn integer(&mut self, name: &str, value: u64) {
        push_integer(self.name(name), value);
    }

    /// A whole number that may be missing.
    pub fn optional_integer(&mut self, name: &str, value: Option<u32>) {
        match value {
            Some(value) => self.integer(name, value.into()),
            None => self.name(name).extend_from_slice(b"null"),
        }
    }

    /// A truth.
    pub fn boolean(&mut self, name: &str, value: bool) {
        self.name(name).extend_from_slice(if value { b"true" } else { b"false" });
    }

    /// A word of this crate's own, which needs no escaping.
    pub fn word(&mut self, name: &str, value: &str) {
        let out = self.name(name);
        out.push(b'"');
        out.extend_from_slice(value.as_bytes());
        out.push(b'"');
    }

    /// Any text.
    pub fn text(&mut self, name: &str, value: &str) {
        push_text(self.name(name), value);
    }

    /// An object within the object.
    pub fn object(&mut self, name: &str, fill: impl FnOnce(&mut JsonObject)) {
        let mut inner = JsonObject::open(self.name(name));
        fill(&mut inner);
        inner.close();
    }

    /// A list of axis letters.
    pub fn letters(&mut self, name: &str, letters: impl Iterator<Item = char>) {
        let out = self.name(name);
        out.push(b'[');
        for (index, letter) in letters.enumerate() {
            if index > 0 {
                out.push(b',');
            }
            out.extend_from_slice(&[b'"', letter as u8, b'"']);
        }
        out.push(b']');
    }
}

/// Appends a text in quotes.
pub(crate) fn push_text(out: &mut Vec<u8>, text: &str) {
    out.push(b'"');
    for byte in text.bytes() {
        match byte {
            b'"' | b'\\' => out.extend_from_slice(&[b'\\', byte]),
            b'\n' => out.extend_from_slice(b"\\n"),
            b'\t' => out.extend_from_slice(b"\\t"),
            b'\r' => out.extend_from_slice(b"\\r"),
            0..0x20 => out.extend_from_slice(format!("\\u{byte:04x}").as_bytes()),
            _ => out.push(byte),
        }
    }
    out.push(b'"');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_read_back() {
        let text = "a \"b\" \\ \n\r\t\u{1} Ø\u{7f}";
        let mut out = Vec::new();
        push_text(&mut out, text);
        let read: String = serde_json::from_slice(&out).unwrap();
        assert_eq!(read, text);
    }
}

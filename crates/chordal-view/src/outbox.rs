//! Sends messages to a page: JSON objects and columns.

use std::fmt;
use std::sync::Arc;

use serde_json::{Value, json};

use crate::frame::ColumnFrame;

/// The connection to a page, usable from any thread. It may block the sender until there is room; messages to a
/// closed page are dropped.
pub trait PagePort: Send + Sync + 'static {
    /// Sends a JSON object.
    fn text(&self, text: String);

    /// Sends a [`ColumnFrame`].
    fn binary(&self, frame: Vec<u8>);

    /// Sends columns with low priority: the first picture does not need them.
    fn binary_later(&self, frame: Vec<u8>);
}

/// Sends messages to the page through its port.
#[derive(Clone)]
pub struct PageOutbox(Arc<dyn PagePort>);

impl fmt::Debug for PageOutbox {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Outbox")
    }
}

impl PageOutbox {
    /// Sends through a port.
    pub fn new(port: impl PagePort) -> PageOutbox {
        PageOutbox(Arc::new(port))
    }

    /// Sends a JSON object.
    pub fn json(&self, object: &Value) {
        self.0.text(object.to_string());
    }

    /// Sends a [`ColumnFrame`].
    pub fn binary(&self, frame: Vec<u8>) {
        self.0.binary(frame);
    }

    /// Sends columns with low priority: the first picture does not need them.
    pub fn binary_later(&self, frame: Vec<u8>) {
        self.0.binary_later(frame);
    }

    /// Sends the bytes of a file for the page to store.
    pub fn file(&self, name: &str, bytes: &[u8]) {
        let mut frame = ColumnFrame::default();
        frame.column("bytes", bytes);
        self.binary(frame.finish(json!({ "type": "file", "name": name })));
    }

    /// Reports that a request failed.
    pub fn refuse(&self, id: u64, message: &str, help: Option<&str>) {
        self.json(&json!({ "type": "error", "id": id, "message": message, "help": help }));
    }
}

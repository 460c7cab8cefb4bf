//! What goes to a page: objects and columns.

use std::fmt;
use std::sync::Arc;

use serde_json::{Value, json};

use crate::frame::ColumnFrame;

/// Sends to a page, from any thread. It may block the sender until there is room; what is for a page that has
/// been closed is dropped.
pub trait PagePort: Send + Sync + 'static {
    /// Takes a JSON object.
    fn text(&self, text: String);

    /// Takes a [`ColumnFrame`].
    fn binary(&self, frame: Vec<u8>);

    /// Takes columns that the first picture need not wait for.
    fn binary_later(&self, frame: Vec<u8>);
}

/// Takes what is for the page.
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

    /// Sends columns that the first picture need not wait for.
    pub fn binary_later(&self, frame: Vec<u8>) {
        self.0.binary_later(frame);
    }

    /// Sends the bytes of a file that the page is to keep.
    pub fn file(&self, name: &str, bytes: &[u8]) {
        let mut frame = ColumnFrame::default();
        frame.column("bytes", bytes);
        self.binary(frame.finish(json!({ "type": "file", "name": name })));
    }

    /// Sends that a request failed.
    pub fn refuse(&self, id: u64, message: &str, help: Option<&str>) {
        self.json(&json!({ "type": "error", "id": id, "message": message, "help": help }));
    }
}

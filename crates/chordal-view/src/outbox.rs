//! What goes to a page: objects and columns.

use std::fmt;
use std::sync::Arc;

use serde_json::{Value, json};

use crate::frame::Frame;

/// The way to a page, from any thread. It may hold up whoever sends until there is room; what is for a page that has
/// gone is lost.
pub trait Port: Send + Sync + 'static {
    /// Takes an object.
    fn text(&self, text: String);

    /// Takes columns.
    fn binary(&self, frame: Vec<u8>);

    /// Takes columns that the first picture need not wait for.
    fn binary_later(&self, frame: Vec<u8>);
}

/// Takes what is for the page.
#[derive(Clone)]
pub struct Outbox(Arc<dyn Port>);

impl fmt::Debug for Outbox {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Outbox")
    }
}

impl Outbox {
    /// By this way.
    pub fn new(port: impl Port) -> Outbox {
        Outbox(Arc::new(port))
    }

    /// Sends an object.
    pub fn json(&self, object: &Value) {
        self.0.text(object.to_string());
    }

    /// Sends columns.
    pub fn binary(&self, frame: Vec<u8>) {
        self.0.binary(frame);
    }

    /// Sends columns that the first picture need not wait for.
    pub fn binary_later(&self, frame: Vec<u8>) {
        self.0.binary_later(frame);
    }

    /// Sends the bytes of a file that the page is to keep.
    pub fn file(&self, name: &str, bytes: &[u8]) {
        let mut frame = Frame::default();
        frame.column("bytes", bytes);
        self.binary(frame.finish(json!({ "type": "file", "name": name })));
    }

    /// Sends that a request failed.
    pub fn refuse(&self, id: u64, message: &str, help: Option<&str>) {
        self.json(&json!({ "type": "error", "id": id, "message": message, "help": help }));
    }
}

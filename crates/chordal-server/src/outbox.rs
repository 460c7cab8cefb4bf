//! What goes to a page: objects and columns, sent from any thread.

use axum::extract::ws::Message;
use serde_json::{Value, json};
use tokio::sync::mpsc;

/// Takes what is for the page, from any thread.
#[derive(Clone, Debug)]
pub struct Outbox {
    /// What goes out in its order.
    pub soon: mpsc::Sender<Message>,
    /// What waits for the first picture.
    pub later: mpsc::Sender<Message>,
}

impl Outbox {
    /// Sends an object.
    pub fn json(&self, object: &Value) {
        self.send(Message::Text(object.to_string().into()));
    }

    /// Sends columns.
    pub fn binary(&self, frame: Vec<u8>) {
        self.send(Message::Binary(frame.into()));
    }

    /// Sends columns that the first picture need not wait for.
    pub fn binary_later(&self, frame: Vec<u8>) {
        let _ = self.later.blocking_send(Message::Binary(frame.into()));
    }

    /// Sends that a request failed.
    pub fn refuse(&self, id: u64, message: &str, help: Option<&str>) {
        self.json(&json!({ "type": "error", "id": id, "message": message, "help": help }));
    }

    fn send(&self, message: Message) {
        // A page that has gone is noticed where its requests are read.
        let _ = self.soon.blocking_send(message);
    }
}

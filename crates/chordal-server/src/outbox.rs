//! Sends messages for a page from any thread to its connection.

use axum::extract::ws::Message;
use chordal_view::PagePort;
use tokio::sync::mpsc;

/// The channels to the connection.
#[derive(Clone, Debug)]
pub struct PageChannels {
    /// Messages that are sent in order.
    pub soon: mpsc::Sender<Message>,
    /// Messages that are sent after the first columns of the path.
    pub later: mpsc::Sender<Message>,
}

// Errors of sending are ignored: a closed page is detected where its requests are read.
impl PagePort for PageChannels {
    fn text(&self, text: String) {
        let _ = self.soon.blocking_send(Message::Text(text.into()));
    }

    fn binary(&self, frame: Vec<u8>) {
        let _ = self.soon.blocking_send(Message::Binary(frame.into()));
    }

    fn binary_later(&self, frame: Vec<u8>) {
        let _ = self.later.blocking_send(Message::Binary(frame.into()));
    }
}

//! Passes messages for a page from any thread to its connection.

use axum::extract::ws::Message;
use chordal_view::PagePort;
use tokio::sync::mpsc;

/// The channels to the connection.
#[derive(Clone, Debug)]
pub struct PageChannels {
    /// What goes out in its order.
    pub soon: mpsc::Sender<Message>,
    /// What waits for the first picture.
    pub later: mpsc::Sender<Message>,
}

// A closed page is noticed where its requests are read.
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

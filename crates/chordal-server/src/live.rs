//! The one connection of a page: requests in, answers and columns out.

use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::ws::{CloseFrame, Message, WebSocket, close_code};
use chordal_view::{Outbox, Programs, Request};
use serde_json::json;
use tokio::sync::mpsc;

use crate::outbox::Channels;
use crate::session::Session;

/// The longest message that a page may send: what somebody may paste.
pub const LARGEST_MESSAGE: usize = 32 << 20;

/// Messages that wait for a page. A page that is slow makes the run wait, not the memory grow.
const WAITING: usize = 16;

/// How long a long text waits for the first lines of the path.
const HOLD: Duration = Duration::from_secs(1);

/// A page is asked so often, in the time that its connection may be idle, whether it is still there.
const LOOKS: u32 = 4;

/// Talks with a page until it goes.
pub async fn talk(mut socket: WebSocket, programs: Arc<dyn Programs>, idle: Duration) {
    let (soon, mut outgoing) = mpsc::channel(WAITING);
    let (later, mut outgoing_later) = mpsc::channel(1);
    let session = match Session::begin(programs, Outbox::new(Channels { soon, later })) {
        Ok(session) => session,
        Err(error) => {
            let told = json!({ "type": "error", "id": 0, "message": error.to_string() });
            let _ = socket.send(Message::Text(told.to_string().into())).await;
            return;
        }
    };
    let mut is_drawn = false;
    let mut hold = pin!(tokio::time::sleep(HOLD));
    let mut look = tokio::time::interval(idle / LOOKS);
    loop {
        tokio::select! {
            message = socket.recv() => {
                let refused = match message {
                    Some(Ok(Message::Text(text))) => take(&session, text.as_str()),
                    Some(Ok(Message::Binary(_))) => Err("requests are text, not bytes".to_string()),
                    Some(Ok(Message::Ping(_) | Message::Pong(_))) => Ok(()),
                    Some(Ok(Message::Close(_))) | None => break,
                    Some(Err(error)) => {
                        // Too long, or no WebSocket at all: there is no going on.
                        let reason = error.to_string().chars().take(100).collect::<String>().into();
                        let frame = CloseFrame { code: close_code::POLICY, reason };
                        let _ = socket.send(Message::Close(Some(frame))).await;
                        break;
                    }
                };
                if let Err(reason) = refused {
                    let told = json!({ "type": "error", "id": 0, "message": reason });
                    if socket.send(Message::Text(told.to_string().into())).await.is_err() {
                        break;
                    }
                }
            }
            message = outgoing.recv() => {
                let Some(message) = message else { break };
                is_drawn |= matches!(message, Message::Binary(_));
                if socket.send(message).await.is_err() {
                    break;
                }
            }
            Some(message) = outgoing_later.recv(), if is_drawn || hold.is_elapsed() => {
                if socket.send(message).await.is_err() {
                    break;
                }
            }
            () = &mut hold, if !hold.is_elapsed() => {}
            _ = look.tick() => {
                // Whoever does not answer is idle, and its connection ends.
                if socket.send(Message::Ping(Default::default())).await.is_err() {
                    break;
                }
            }
        }
    }
    session.end();
    // Whoever waits for room in the outbox is let go.
    outgoing.close();
    outgoing_later.close();
}

fn take(session: &Session, text: &str) -> Result<(), String> {
    let request: Request = serde_json::from_str(text)
        .map_err(|error| format!("the request cannot be read: {error}"))?;
    session.ask(request);
    Ok(())
}

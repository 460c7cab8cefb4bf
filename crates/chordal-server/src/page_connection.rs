//! The connection of a page: receives requests, and sends answers and columns.

use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::ws::{CloseFrame, Message, WebSocket, close_code};
use chordal_view::{PageOutbox, PageRequest, ProgramSource};
use serde_json::json;
use tokio::sync::mpsc;

use crate::outbox::PageChannels;
use crate::session::PageSession;

/// The longest message that a page may send, bytes: enough for a long pasted program.
pub const MAX_MESSAGE_BYTES: usize = 32 << 20;

/// The most messages that wait for a page. A slow page makes the run wait instead of using more memory.
const MAX_WAITING_MESSAGES: usize = 16;

/// How long the rest of a long text waits for the first columns.
const TEXT_DELAY: Duration = Duration::from_secs(1);

/// The number of pings that a page gets during the idle limit.
const PINGS_PER_IDLE_LIMIT: u32 = 4;

/// Serves a page until it is closed.
pub async fn serve_page(mut socket: WebSocket, programs: Arc<dyn ProgramSource>, idle: Duration) {
    let (soon, mut outgoing) = mpsc::channel(MAX_WAITING_MESSAGES);
    let (later, mut outgoing_later) = mpsc::channel(1);
    let session = match PageSession::begin(programs, PageOutbox::new(PageChannels { soon, later }))
    {
        Ok(session) => session,
        Err(error) => {
            let reply = json!({ "type": "error", "id": 0, "message": error.to_string() });
            let _ = socket.send(Message::Text(reply.to_string().into())).await;
            return;
        }
    };
    let mut is_drawn = false;
    let mut hold = pin!(tokio::time::sleep(TEXT_DELAY));
    let mut look = tokio::time::interval(idle / PINGS_PER_IDLE_LIMIT);
    loop {
        tokio::select! {
            message = socket.recv() => {
                let refused = match message {
                    Some(Ok(Message::Text(text))) => take(&session, text.as_str()),
                    Some(Ok(Message::Binary(_))) => Err("requests are text, not bytes".to_string()),
                    Some(Ok(Message::Ping(_) | Message::Pong(_))) => Ok(()),
                    Some(Ok(Message::Close(_))) | None => break,
                    Some(Err(error)) => {
                        // The message was too long or violated the protocol, so the connection cannot continue.
                        let reason = error.to_string().chars().take(100).collect::<String>().into();
                        let frame = CloseFrame { code: close_code::POLICY, reason };
                        let _ = socket.send(Message::Close(Some(frame))).await;
                        break;
                    }
                };
                if let Err(reason) = refused {
                    let reply = json!({ "type": "error", "id": 0, "message": reason });
                    if socket.send(Message::Text(reply.to_string().into())).await.is_err() {
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
                // A page that does not answer the pings becomes idle, and its connection ends.
                if socket.send(Message::Ping(Default::default())).await.is_err() {
                    break;
                }
            }
        }
    }
    session.end();
    // Closing the channels lets threads continue that wait for room in the outbox.
    outgoing.close();
    outgoing_later.close();
}

fn take(session: &PageSession, text: &str) -> Result<(), String> {
    let request: PageRequest = serde_json::from_str(text)
        .map_err(|error| format!("the request cannot be read: {error}"))?;
    session.send(request);
    Ok(())
}

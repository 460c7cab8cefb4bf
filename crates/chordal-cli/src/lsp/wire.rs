//! Messages of an editor over standard input and output.
//!
//! What cannot be read is answered with an error, and the next message is read: one wrong message is no reason to
//! end a server in the middle of somebody's work.

use std::io::{self, BufRead, Read, Write};
use std::thread::{self, JoinHandle};

use lsp_server::{Connection, ErrorCode, Message};
use serde_json::{Value, json};

/// Most bytes of a message: a text of a few million lines.
const MAX_MESSAGE_BYTES: usize = 1 << 28;
/// Most bytes of a line of a header.
const MAX_HEADER_BYTES: u64 = 1 << 13;

/// What came.
#[derive(Debug, PartialEq)]
enum WireEvent {
    /// A message, not looked at.
    Body(Vec<u8>),
    /// Something else, and what is wrong with it.
    Wrong(String),
    /// Nothing more.
    End,
}

/// Connects the server with standard input and output. The second is the thread that writes: it ends when the
/// connection is dropped, and says what could not be written.
pub fn connect() -> (Connection, JoinHandle<io::Result<()>>) {
    let (server, editor) = Connection::memory();
    let Connection { sender, receiver } = editor;
    // It ends with the input, or with the process.
    thread::spawn(move || {
        let mut input = io::stdin().lock();
        while let Some(message) = next(&mut input, &mut io::stdout()) {
            let is_exit = matches!(&message, Message::Notification(notification) if notification.method == "exit");
            if sender.send(message).is_err() || is_exit {
                return;
            }
        }
    });
    let writer = thread::spawn(move || {
        receiver.into_iter().try_for_each(|message| message.write(&mut io::stdout().lock()))
    });
    (server, writer)
}

/// The next message; what cannot be read is refused on the way. `None`: there are no more.
fn next(input: &mut impl BufRead, out: &mut impl Write) -> Option<Message> {
    loop {
        let (id, code, why) = match came(input) {
            Ok(WireEvent::Body(body)) => match serde_json::from_slice::<Value>(&body) {
                Ok(value) => {
                    let id = value.get("id").cloned().unwrap_or_default();
                    match serde_json::from_value(value) {
                        Ok(message) => return Some(message),
                        Err(error) => (id, ErrorCode::InvalidRequest, error.to_string()),
                    }
                }
                Err(error) => (Value::Null, ErrorCode::ParseError, error.to_string()),
            },
            Ok(WireEvent::Wrong(why)) => (Value::Null, ErrorCode::ParseError, why),
            Ok(WireEvent::End) | Err(_) => return None,
        };
        refuse(out, &id, code, &format!("the message cannot be read: {why}"));
    }
}

/// There is nobody to report to where that cannot be written.
fn refuse(out: &mut impl Write, id: &Value, code: ErrorCode, message: &str) {
    let error = json!({ "code": code as i32, "message": message });
    let text = json!({ "jsonrpc": "2.0", "id": id, "error": error }).to_string();
    let whole = format!("Content-Length: {}\r\n\r\n{text}", text.len());
    let _ = out.write_all(whole.as_bytes()).and_then(|()| out.flush());
}

/// A header and what follows it.
fn came(input: &mut impl BufRead) -> io::Result<WireEvent> {
    let mut size = None;
    let mut wrong = None;
    loop {
        let mut line = Vec::new();
        if input.take(MAX_HEADER_BYTES).read_until(b'\n', &mut line)? == 0 {
            return Ok(WireEvent::End);
        }
        let line = line.trim_ascii();
        if line.is_empty() {
            match (size, wrong) {
                (Some(size), _) => return body(input, size),
                (None, Some(wrong)) => return Ok(WireEvent::Wrong(wrong)),
                // Lines without anything between two messages.
                (None, None) => wrong = None,
            }
            continue;
        }
        let line = String::from_utf8_lossy(line);
        match line.split_once(':') {
            Some((name, value)) if name.eq_ignore_ascii_case("content-length") => {
                match value.trim().parse::<usize>() {
                    Ok(bytes) => size = Some(bytes),
                    Err(_) => wrong = Some(format!("{:?} is no number of bytes", value.trim())),
                }
            }
            Some(("Content-Type" | "content-type", _)) => {}
            _ => {
                let begin: String = line.chars().take(60).collect();
                wrong = Some(format!("{begin:?} is not a header"));
            }
        }
    }
}

fn body(input: &mut impl BufRead, size: usize) -> io::Result<WireEvent> {
    let mut rest = input.take(size as u64);
    if size > MAX_MESSAGE_BYTES {
        io::copy(&mut rest, &mut io::sink())?;
        return Ok(WireEvent::Wrong(format!("{size} bytes; at most {MAX_MESSAGE_BYTES} are read")));
    }
    let mut bytes = Vec::new();
    rest.read_to_end(&mut bytes)?;
    Ok(if bytes.len() < size { WireEvent::End } else { WireEvent::Body(bytes) })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn framed(body: &str) -> String {
        format!("Content-Length: {}\r\n\r\n{body}", body.len())
    }

    /// The methods that are heard, and what is refused: its `id` and its code.
    fn heard(input: &str) -> (Vec<String>, Vec<(Value, i64)>) {
        let (mut input, mut out) = (input.as_bytes(), Vec::new());
        let mut methods = Vec::new();
        while let Some(message) = next(&mut input, &mut out) {
            match message {
                Message::Request(request) => methods.push(request.method),
                Message::Notification(notification) => methods.push(notification.method),
                Message::Response(_) => methods.push(String::new()),
            }
        }
        let mut refused = Vec::new();
        let mut out = out.as_slice();
        while let Ok(WireEvent::Body(body)) = came(&mut out) {
            let answer: Value = serde_json::from_slice(&body).unwrap();
            let code = answer["error"]["code"].as_i64().unwrap();
            refused.push((answer["id"].clone(), code));
        }
        (methods, refused)
    }

    #[test]
    fn a_wrong_message_is_refused_and_the_next_is_heard() {
        let good = framed(r#"{"jsonrpc":"2.0","method":"initialized","params":{}}"#);
        let (parse, invalid) =
            (i64::from(ErrorCode::ParseError as i32), i64::from(ErrorCode::InvalidRequest as i32));
        for (wrong, id, code) in [
            (framed("{\"jsonrpc\":"), Value::Null, parse),
            (framed("\u{feff}\"é"), Value::Null, parse),
            (framed("[1,2]"), Value::Null, invalid),
            (framed(r#"{"jsonrpc":"2.0","id":7,"method":5}"#), json!(7), invalid),
            ("nonsense\r\n\r\n".into(), Value::Null, parse),
            ("Content-Length: many\r\n\r\n".into(), Value::Null, parse),
        ] {
            let (methods, refused) = heard(&format!("{good}{wrong}{good}"));
            assert_eq!(methods, ["initialized"; 2], "{wrong}");
            assert_eq!(refused, [(id, code)], "{wrong}");
        }
    }

    #[test]
    fn bytes_that_are_no_text_are_refused() {
        let mut input = b"Content-Length: 3\r\n\r\n\"\xff\"".as_slice();
        let mut out = Vec::new();
        assert!(next(&mut input, &mut out).is_none());
        assert!(String::from_utf8(out).unwrap().contains("the message cannot be read"));
    }

    #[test]
    fn headers_in_any_order_and_an_input_that_breaks_off() {
        let body = r#"{"jsonrpc":"2.0","method":"a"}"#;
        let typed = format!("Content-Type: x\r\ncontent-length:{}\r\n\r\n{body}", body.len());
        assert_eq!(heard(&typed).0, ["a"]);
        assert_eq!(heard("Content-Length: 10\r\n\r\n{\"a\""), (vec![], vec![]));
        assert_eq!(heard("Content-Length: 10\r\n"), (vec![], vec![]));
    }
}

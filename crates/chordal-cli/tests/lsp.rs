//! The language server as a process.

mod common;

use common::Folder;
use serde_json::{Value, json};

fn framed(body: &str) -> String {
    format!("Content-Length: {}\r\n\r\n{body}", body.len())
}

/// The messages in what the server has written.
fn messages(mut text: &str) -> Vec<Value> {
    let mut messages = Vec::new();
    while let Some((head, rest)) = text.split_once("\r\n\r\n") {
        let size: usize = head.trim_start_matches("Content-Length: ").parse().expect("a size");
        messages.push(serde_json::from_str(&rest[..size]).expect("JSON"));
        text = &rest[size..];
    }
    messages
}

#[test]
fn a_malformed_message_is_refused_and_the_session_goes_on() {
    let ask = |id: u32, method: &str, params: Value| {
        framed(
            &json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }).to_string(),
        )
    };
    let tell = |method: &str, params: Value| {
        framed(&json!({ "jsonrpc": "2.0", "method": method, "params": params }).to_string())
    };
    let document =
        json!({ "uri": "file:///part.nc", "languageId": "nc", "version": 1, "text": "G0 X1.\n" });
    let at = json!({ "textDocument": { "uri": "file:///part.nc" }, "position": { "line": 0, "character": 1 } });
    for wrong in ["{\"a\":", "[]", "{\"id\":{},\"method\":1}", "\u{0}"] {
        let session = [
            framed(wrong),
            ask(1, "initialize", json!({})),
            framed(wrong),
            tell("textDocument/didOpen", json!({ "textDocument": document })),
            "Garbage\r\n\r\n".into(),
            ask(2, "textDocument/hover", at.clone()),
            ask(3, "shutdown", Value::Null),
            tell("exit", Value::Null),
        ];
        let folder = Folder::new();
        let done = folder.run_with(&["lsp", "--machine", "haas-vf2"], session.concat().as_bytes());
        let told = messages(&done.out);
        let refused: Vec<&str> =
            told.iter().filter_map(|message| message["error"]["message"].as_str()).collect();
        assert_eq!(refused.len(), 3, "{wrong}: {told:?}");
        assert!(refused.iter().all(|why| why.starts_with("the message cannot be read: ")));
        let hover = told.iter().find(|message| message["id"] == 2).expect("an answer");
        assert!(hover["result"]["contents"].to_string().contains("G0"), "{hover}");
        assert_eq!((done.code, done.err.as_str()), (0, ""), "{wrong}");
    }
}

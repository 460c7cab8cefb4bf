//! The server without threads and without waiting: the caller passes messages and calls it to do work.

use crossbeam_channel::{Receiver, unbounded};
use lsp_server::{ErrorCode, Message, Response};
use lsp_types::request::{Initialize, Request as _, Shutdown};
use serde_json::Value;

use crate::SetupFinder;
use crate::server::{Server, about};
use crate::worker::{RunWorker, WorkQueue};

/// A server that runs in its caller's thread: each message from the editor is handled immediately, and programs are
/// run by [`work`](SteppedServer::work), one step at a time.
///
/// ```
/// use std::path::Path;
///
/// use chordal::Machine;
/// use chordal_editor::EditorSetup;
/// use chordal_lsp::{SetupFinder, SteppedServer};
/// use lsp_server::{Message, Notification, Request};
/// use serde_json::json;
///
/// struct Haas;
///
/// impl SetupFinder for Haas {
///     fn open(&self, _: Option<&Path>, _: &[u8], _: Option<&str>) -> Result<EditorSetup, String> {
///         Machine::from_builtin("haas-vf2").map(EditorSetup::of).map_err(|_| "no machine".into())
///     }
/// }
///
/// let mut server = SteppedServer::new(Box::new(Haas));
/// let begin = Request::new(1.into(), "initialize".into(), json!({ "capabilities": {} }));
/// let answers = server.hear(begin.into());
/// assert!(matches!(&answers[..], [Message::Response(_)]));
/// let text = json!({ "uri": "file:///part.nc", "languageId": "nc", "version": 1, "text": "G999" });
/// let opened = Notification::new("textDocument/didOpen".into(), json!({ "textDocument": text }));
/// server.hear(opened.into());
/// assert!(server.has_work());
/// let told = server.work();
/// assert!(matches!(&told[0], Message::Notification(told) if told.method.contains("publish")));
/// ```
pub struct SteppedServer {
    server: Option<Server<'static>>,
    opener: Option<Box<dyn SetupFinder>>,
    bench: Option<WorkQueue>,
    out: Option<Receiver<Message>>,
}

impl SteppedServer {
    /// A server that expects the editor's `initialize` request.
    pub fn new(opener: Box<dyn SetupFinder>) -> SteppedServer {
        SteppedServer { server: None, opener: Some(opener), bench: None, out: None }
    }

    /// Handles a message from the editor; returns the messages to the editor.
    pub fn hear(&mut self, message: Message) -> Vec<Message> {
        match (&mut self.server, message) {
            (None, Message::Request(request)) if request.method == Initialize::METHOD => {
                self.begin(&request.params);
                vec![Response::new_ok(request.id, about()).into()]
            }
            (None, Message::Request(request)) => {
                let early = "the first message is `initialize`".to_string();
                let code = ErrorCode::ServerNotInitialized as i32;
                vec![Response::new_err(request.id, code, early).into()]
            }
            (Some(_), Message::Request(request)) if request.method == Shutdown::METHOD => {
                vec![Response::new_ok(request.id, ()).into()]
            }
            (Some(server), message) => {
                server.hear(message);
                self.sent_messages()
            }
            (None, _) => Vec::new(),
        }
    }

    fn begin(&mut self, params: &Value) {
        let Some(opener) = self.opener.take() else { return };
        let (worker, bench) = RunWorker::with_bench();
        let (send, out) = unbounded();
        let settings = params.get("initializationOptions").cloned().unwrap_or_default();
        self.server = Some(Server::new(send, opener, worker, &settings));
        (self.bench, self.out) = (Some(bench), Some(out));
    }

    /// Whether there is a program to run.
    pub fn has_work(&self) -> bool {
        self.bench.as_ref().is_some_and(WorkQueue::has_work)
    }

    /// Runs a program if one is waiting; returns the messages to the editor.
    pub fn work(&mut self) -> Vec<Message> {
        if let (Some(bench), Some(server)) = (&mut self.bench, &mut self.server) {
            if bench.has_work() {
                bench.work();
            }
            server.take_found();
        }
        self.sent_messages()
    }

    /// Chooses the machines again because files that the opener reads have changed; returns the messages to the
    /// editor.
    pub fn files_changed(&mut self) -> Vec<Message> {
        if let Some(server) = &mut self.server {
            server.find_machines();
        }
        self.sent_messages()
    }

    fn sent_messages(&self) -> Vec<Message> {
        self.out.iter().flat_map(Receiver::try_iter).collect()
    }
}

//! The main loop: handles messages from the editor and results from the worker, one at a time.

use std::collections::HashMap;
use std::sync::Arc;

use chordal_editor::{EditorProgram, RunMoves};
use crossbeam_channel::{Sender, select};
use lsp_server::{Connection, ErrorCode, Message, Notification, Request, Response, ResponseError};
use lsp_types::notification::{self, Notification as _};
use lsp_types::request::{self, Request as _};
use lsp_types::*;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use crate::SetupFinder;
use crate::actions::{self, FIX_ALL, RENUMBER, actions, edit_of};
use crate::convert::{diagnostic, folds, lines, semantic_tokens, symbols, text_edits, token_types};
use crate::document::OpenDocument;
use crate::features;
use crate::file_uri::path_of;
use crate::panic_guard::caught;
use crate::place::{offset_of, range_of};
use crate::worker::{RunFindings, RunResult, RunTask, RunWorker};

/// Why the server ended without a request of the editor.
#[derive(Debug, thiserror::Error)]
pub enum ServeError {
    /// The editor violated the protocol or disconnected.
    #[error("the editor did not follow the protocol: {0}")]
    Protocol(#[from] lsp_server::ProtocolError),
    /// The connection was closed.
    #[error("the connection to the editor was closed")]
    Gone,
}

/// Serves an editor until it requests the end.
///
/// # Errors The editor violates the protocol or disconnects.
pub fn serve(connection: &Connection, opener: &dyn SetupFinder) -> Result<(), ServeError> {
    let (id, params) = connection.initialize_start()?;
    // Nothing else in the first message is used, so that mistakes of an editor in it do not matter. `initialized` is
    // not awaited either, because some editors send requests before it.
    let settings = params.get("initializationOptions").cloned().unwrap_or_default();
    connection.sender.send(Response::new_ok(id, about()).into()).map_err(|_| ServeError::Gone)?;
    let mut server =
        Server::new(connection.sender.clone(), Box::new(opener), RunWorker::start(), &settings);
    server.run(connection)
}

/// The answer to the `initialize` request.
pub(crate) fn about() -> Value {
    json!({
        "capabilities": capabilities(),
        "serverInfo": { "name": "chordal", "version": env!("CARGO_PKG_VERSION") },
    })
}

fn capabilities() -> ServerCapabilities {
    let options = SemanticTokensOptions {
        legend: SemanticTokensLegend { token_types: token_types(), token_modifiers: Vec::new() },
        range: Some(true),
        full: Some(SemanticTokensFullOptions::Bool(true)),
        ..SemanticTokensOptions::default()
    };
    let completions = CompletionOptions {
        trigger_characters: Some(["G", "M", "P", "T", "#", " "].map(String::from).into()),
        ..CompletionOptions::default()
    };
    let actions = CodeActionOptions {
        code_action_kinds: Some(vec![CodeActionKind::QUICKFIX, FIX_ALL, RENUMBER]),
        resolve_provider: Some(true),
        ..CodeActionOptions::default()
    };
    let rename = RenameOptions {
        prepare_provider: Some(true),
        work_done_progress_options: WorkDoneProgressOptions::default(),
    };
    ServerCapabilities {
        text_document_sync: Some(TextDocumentSyncKind::INCREMENTAL.into()),
        hover_provider: Some(true.into()),
        completion_provider: Some(completions),
        document_symbol_provider: Some(OneOf::Left(true)),
        folding_range_provider: Some(FoldingRangeProviderCapability::Simple(true)),
        definition_provider: Some(OneOf::Left(true)),
        references_provider: Some(OneOf::Left(true)),
        rename_provider: Some(OneOf::Right(rename)),
        document_formatting_provider: Some(OneOf::Left(true)),
        document_range_formatting_provider: Some(OneOf::Left(true)),
        code_action_provider: Some(actions.into()),
        inlay_hint_provider: Some(OneOf::Left(true)),
        semantic_tokens_provider: Some(options.into()),
        ..ServerCapabilities::default()
    }
}

/// The `machine` setting, which some editors nest in `chordal`; `None` when it is not set.
fn machine_of(settings: &Value) -> Option<String> {
    let own = settings.get("chordal").unwrap_or(settings);
    own.get("machine")?.as_str().filter(|name| !name.is_empty()).map(String::from)
}

pub(crate) struct Server<'a> {
    /// The channel for messages to the editor.
    out: Sender<Message>,
    opener: Box<dyn SetupFinder + 'a>,
    worker: RunWorker,
    documents: HashMap<String, (Uri, OpenDocument)>,
    /// Requests that wait for a run of the text.
    waiting: Vec<Request>,
    /// The machine in the editor's settings.
    machine: Option<String>,
}

/// The largest text whose tokens are sent all at once, bytes: the answer has ten times as many bytes.
const MAX_COLOURED_BYTES: usize = 4 << 20;
/// The most lines whose tokens are sent at once: more than a screen shows.
const MAX_COLOURED_LINES: u32 = 50_000;

/// The result of a request about a document.
type RequestAnswer = Result<Value, ResponseError>;

impl<'a> Server<'a> {
    pub(crate) fn new(
        out: Sender<Message>,
        opener: Box<dyn SetupFinder + 'a>,
        worker: RunWorker,
        settings: &Value,
    ) -> Server<'a> {
        let machine = machine_of(settings);
        Server { out, opener, worker, documents: HashMap::new(), waiting: Vec::new(), machine }
    }

    fn run(&mut self, connection: &Connection) -> Result<(), ServeError> {
        loop {
            select! {
                recv(connection.receiver) -> message => match message {
                    Err(_) => return Err(ServeError::Gone),
                    Ok(Message::Request(request)) if request.method == request::Shutdown::METHOD => {
                        return self.shut_down(connection, request);
                    }
                    Ok(message) => self.hear(message),
                },
                recv(self.worker.done) -> done => if let Ok(done) = done {
                    self.take(done);
                },
            }
        }
    }

    /// Handles a message from the editor.
    pub(crate) fn hear(&mut self, message: Message) {
        match message {
            Message::Request(request) if self.must_wait(&request) => self.waiting.push(request),
            Message::Request(request) => {
                let response = self.answer(request);
                self.send(response.into());
            }
            Message::Notification(notification) => {
                if let Err(message) = caught(|| self.notice(notification)) {
                    self.notify::<notification::ShowMessage>(ShowMessageParams {
                        typ: MessageType::ERROR,
                        message,
                    });
                }
            }
            Message::Response(_) => {}
        }
    }

    /// Handles the results that the worker has sent so far.
    pub(crate) fn take_found(&mut self) {
        while let Ok(done) = self.worker.done.try_recv() {
            self.take(done);
        }
    }

    /// Finds the machines of all open documents again, because other files may determine them now.
    pub(crate) fn find_machines(&mut self) {
        let all: Vec<String> = self.documents.keys().cloned().collect();
        all.iter().for_each(|uri| self.find_machine(uri));
    }

    /// Answers, then waits for `exit`. Messages that were already in transit may still arrive: responses and changes
    /// are ignored, requests are refused.
    fn shut_down(&self, connection: &Connection, request: Request) -> Result<(), ServeError> {
        self.send(Response::new_ok(request.id, ()).into());
        loop {
            match connection.receiver.recv().map_err(|_| ServeError::Gone)? {
                Message::Notification(note) if note.method == notification::Exit::METHOD => {
                    return Ok(());
                }
                Message::Request(late) => {
                    let refused = "the server is shutting down".into();
                    let code = ErrorCode::InvalidRequest as i32;
                    self.send(Response::new_err(late.id, code, refused).into());
                }
                Message::Notification(_) | Message::Response(_) => {}
            }
        }
    }

    /// Sends a message. When the editor has disconnected the message is lost, and the loop ends at its next
    /// iteration.
    fn send(&self, message: Message) {
        let _ = self.out.send(message);
    }

    fn notify<N: notification::Notification>(&self, params: N::Params)
    where
        N::Params: serde::Serialize,
    {
        self.send(Notification::new(N::METHOD.into(), params).into());
    }

    fn notice(&mut self, notification: Notification) {
        let Notification { method, params } = notification;
        match method.as_str() {
            notification::DidOpenTextDocument::METHOD => {
                if let Some(DidOpenTextDocumentParams { text_document }) = read(params) {
                    self.open(text_document);
                }
            }
            notification::DidChangeTextDocument::METHOD => {
                if let Some(params) = read::<DidChangeTextDocumentParams>(params) {
                    self.change(params);
                }
            }
            notification::DidSaveTextDocument::METHOD => {
                if let Some(DidSaveTextDocumentParams { text_document, .. }) = read(params) {
                    self.find_machine(text_document.uri.as_str());
                }
            }
            notification::DidCloseTextDocument::METHOD => {
                if let Some(DidCloseTextDocumentParams { text_document }) = read(params) {
                    let uri = text_document.uri.as_str();
                    self.documents.remove(uri);
                    self.give_up(uri);
                    let closed = RunTask { uri: uri.into(), version: 0, program: None };
                    let _ = self.worker.tasks.send(closed);
                    self.publish(text_document.uri, Vec::new(), None);
                }
            }
            notification::DidChangeConfiguration::METHOD => {
                if let Some(DidChangeConfigurationParams { settings }) = read(params) {
                    self.machine = machine_of(&settings);
                    self.find_machines();
                }
            }
            _ => {}
        }
    }

    fn open(&mut self, item: TextDocumentItem) {
        let key = item.uri.as_str().to_string();
        let document = OpenDocument::new(item.version, item.text.into_bytes());
        self.documents.insert(key.clone(), (item.uri, document));
        self.find_machine(&key);
    }

    /// Finds the machine and the subprograms of a document, and starts its run.
    fn find_machine(&mut self, key: &str) {
        self.give_up(key);
        let Some((uri, document)) = self.documents.get_mut(key) else { return };
        let path = path_of(uri.as_str());
        let name = path.as_ref().map_or_else(|| key.into(), |path| path.display().to_string());
        let opened = self.opener.open(path.as_deref(), document.text(), self.machine.as_deref());
        let mut why = None;
        let program = opened.and_then(|setup| {
            why = setup.why.as_ref().map(|why| format!("{name}: {why}"));
            let unknown =
                |errors| format!("the control does not know settings of the machine: {errors:?}");
            EditorProgram::set_up(name, document.text().to_vec(), setup).map_err(unknown)
        });
        match program {
            Ok(program) => {
                document.set_program(Some(program));
                self.start(key);
                if let Some(message) = why {
                    let params = LogMessageParams { typ: MessageType::INFO, message };
                    self.notify::<notification::LogMessage>(params);
                }
            }
            Err(problem) => {
                document.set_program(None);
                let problem = Diagnostic::new_simple(Range::default(), problem);
                let (uri, version) = (uri.clone(), document.version);
                self.publish(uri, vec![problem], Some(version));
            }
        }
    }

    fn change(&mut self, params: DidChangeTextDocumentParams) {
        let VersionedTextDocumentIdentifier { uri, version } = params.text_document;
        self.give_up(uri.as_str());
        if let Some((_, document)) = self.documents.get_mut(uri.as_str()) {
            document.change(version, params.content_changes);
            self.start(uri.as_str());
        }
    }

    fn start(&self, key: &str) {
        let Some((_, document)) = self.documents.get(key) else { return };
        if let Some(program) = &document.program {
            let (uri, version) = (key.into(), document.version);
            let program = Some(program.clone());
            // This cannot fail: the worker lives as long as the server.
            let _ = self.worker.tasks.send(RunTask { uri, version, program });
        }
    }

    /// Sends the results of a run if the text is still the same.
    fn take(&mut self, RunResult { uri: key, version, found }: RunResult) {
        let Some((uri, document)) = self.documents.get_mut(&key) else { return };
        let Some(program) = document.program.clone().filter(|_| document.version == version) else {
            return;
        };
        match found {
            RunFindings::Problems(problems) => {
                let uri = uri.clone();
                let diagnostics =
                    problems.iter().map(|problem| diagnostic(&program, &uri, problem));
                self.publish(uri.clone(), diagnostics.collect(), Some(version));
            }
            RunFindings::Failed(why) => {
                document.failed = Some(version);
                let (uri, failure) =
                    (uri.clone(), Diagnostic::new_simple(Range::default(), why.clone()));
                self.publish(uri, vec![failure], Some(version));
                for request in self.waiting_for(&key) {
                    let code = ErrorCode::InternalError as i32;
                    self.send(Response::new_err(request.id, code, why.clone()).into());
                }
            }
            RunFindings::Ran(ran) => {
                document.ran = Some((version, ran));
                // Makes the editor request the inlay hints again, because there are new ones.
                let id = lsp_server::RequestId::from(format!("hints-{version}"));
                let refresh = request::InlayHintRefreshRequest::METHOD.to_string();
                self.send(Request::new(id, refresh, Value::Null).into());
                for request in self.waiting_for(&key) {
                    let response = self.answer(request);
                    self.send(response.into());
                }
            }
        }
    }

    /// Whether a request needs the moves of the lines and the text is still running. It is then answered after the
    /// run, so that other requests need not wait for it.
    fn must_wait(&self, request: &Request) -> bool {
        let needs_run = matches!(
            request.method.as_str(),
            request::InlayHintRequest::METHOD | request::CodeActionRequest::METHOD
        );
        needs_run
            && document_of(request)
                .and_then(|uri| self.documents.get(uri))
                .is_some_and(|(_, document)| document.is_running())
    }

    /// Removes and returns the waiting requests about a document.
    fn waiting_for(&mut self, uri: &str) -> Vec<Request> {
        let of_this = |request: &Request| document_of(request) == Some(uri);
        let (own, others) = self.waiting.drain(..).partition(of_this);
        self.waiting = others;
        own
    }

    /// Refuses the waiting requests about a document, because its text was changed or closed.
    fn give_up(&mut self, uri: &str) {
        for request in self.waiting_for(uri) {
            let code = ErrorCode::ContentModified as i32;
            let response = Response::new_err(request.id, code, "the text has changed".into());
            self.send(response.into());
        }
    }

    fn publish(&self, uri: Uri, diagnostics: Vec<Diagnostic>, version: Option<i32>) {
        let params = PublishDiagnosticsParams { uri, diagnostics, version };
        self.notify::<notification::PublishDiagnostics>(params);
    }

    fn answer(&self, Request { id, method, params }: Request) -> Response {
        let answer = caught(|| self.answer_of(&method, params));
        match answer.unwrap_or_else(|why| Err(failed(ErrorCode::InternalError, why))) {
            Ok(result) => Response::new_ok(id, result),
            Err(error) => Response::new_err(id, error.code, error.message),
        }
    }

    fn answer_of(&self, method: &str, params: Value) -> RequestAnswer {
        match method {
            request::HoverRequest::METHOD => self.hover(params),
            request::Completion::METHOD => self.completion(params),
            request::DocumentSymbolRequest::METHOD => self.outline(params),
            request::FoldingRangeRequest::METHOD => self.folds(params),
            request::GotoDefinition::METHOD => self.definition(params),
            request::References::METHOD => self.references(params),
            request::PrepareRenameRequest::METHOD => self.prepare_rename(params),
            request::Rename::METHOD => self.rename(params),
            request::Formatting::METHOD => self.formatting(params),
            request::RangeFormatting::METHOD => self.range_formatting(params),
            request::CodeActionRequest::METHOD => self.actions(params),
            request::CodeActionResolveRequest::METHOD => self.resolve(params),
            request::InlayHintRequest::METHOD => self.hints(params),
            request::SemanticTokensFullRequest::METHOD => self.tokens(params),
            request::SemanticTokensRangeRequest::METHOD => self.range_tokens(params),
            other => Err(failed(ErrorCode::MethodNotFound, format!("there is no {other}"))),
        }
    }

    /// The program of an open document that has a machine.
    fn program(&self, uri: &Uri) -> Result<Arc<EditorProgram>, ResponseError> {
        let program = self.document(uri)?.program.clone();
        program.ok_or_else(|| failed(ErrorCode::RequestFailed, "the text has no machine".into()))
    }

    fn document(&self, uri: &Uri) -> Result<&OpenDocument, ResponseError> {
        let found = self.documents.get(uri.as_str()).map(|(_, document)| document);
        let unknown = || format!("{} is not open", uri.as_str());
        found.ok_or_else(|| failed(ErrorCode::InvalidParams, unknown()))
    }

    /// The program of a document and the run of its current text.
    fn ran(&self, uri: &Uri) -> Result<(Arc<EditorProgram>, Arc<RunMoves>), ResponseError> {
        let program = self.program(uri)?;
        let ran = self.document(uri)?.current().cloned();
        let none = || failed(ErrorCode::ContentModified, "the text has not run yet".into());
        Ok((program, ran.ok_or_else(none)?))
    }

    fn hover(&self, params: Value) -> RequestAnswer {
        let HoverParams { text_document_position_params: at, .. } = parse(params)?;
        let program = self.program(&at.text_document.uri)?;
        let ran = self.document(&at.text_document.uri)?.current();
        answer_value(features::hover(&program, ran.map(Arc::as_ref), at.position))
    }

    fn completion(&self, params: Value) -> RequestAnswer {
        let CompletionParams { text_document_position: at, .. } = parse(params)?;
        let program = self.program(&at.text_document.uri)?;
        answer_value(features::completions(&program, at.position))
    }

    fn outline(&self, params: Value) -> RequestAnswer {
        let DocumentSymbolParams { text_document, .. } = parse(params)?;
        let program = self.program(&text_document.uri)?;
        answer_value(symbols(&program, program.outline()))
    }

    fn folds(&self, params: Value) -> RequestAnswer {
        let FoldingRangeParams { text_document, .. } = parse(params)?;
        let program = self.program(&text_document.uri)?;
        answer_value(folds(&program, &program.outline()))
    }

    fn definition(&self, params: Value) -> RequestAnswer {
        let GotoDefinitionParams { text_document_position_params: at, .. } = parse(params)?;
        let uri = &at.text_document.uri;
        answer_value(features::definitions(&*self.program(uri)?, uri, at.position))
    }

    fn references(&self, params: Value) -> RequestAnswer {
        let ReferenceParams { text_document_position: at, context, .. } = parse(params)?;
        let (uri, all) = (&at.text_document.uri, context.include_declaration);
        answer_value(features::references(&*self.program(uri)?, uri, at.position, all))
    }

    fn prepare_rename(&self, params: Value) -> RequestAnswer {
        let TextDocumentPositionParams { text_document, position } = parse(params)?;
        answer_value(features::renamable(&*self.program(&text_document.uri)?, position))
    }

    fn rename(&self, params: Value) -> RequestAnswer {
        let RenameParams { text_document_position: at, new_name, .. } = parse(params)?;
        let uri = &at.text_document.uri;
        let program = self.program(uri)?;
        let offset = offset_of(program.source(), at.position);
        let renamed = program.rename(offset, &new_name);
        let renamed =
            renamed.map_err(|error| failed(ErrorCode::RequestFailed, error.to_string()))?;
        let edit = |range| TextEdit {
            range: range_of(program.source(), range),
            new_text: renamed.name.clone(),
        };
        let edits = renamed.places.iter().copied().map(edit).collect();
        answer_value(edit_of(uri, edits))
    }

    fn formatting(&self, params: Value) -> RequestAnswer {
        let DocumentFormattingParams { text_document, .. } = parse(params)?;
        self.spaced(&text_document.uri, 1, u32::MAX)
    }

    fn range_formatting(&self, params: Value) -> RequestAnswer {
        let DocumentRangeFormattingParams { text_document, range, .. } = parse(params)?;
        let (from, to) = lines(range);
        self.spaced(&text_document.uri, from, to)
    }

    fn spaced(&self, uri: &Uri, from: u32, to: u32) -> RequestAnswer {
        let program = self.program(uri)?;
        let edits = program.spaced(from, to);
        let edits = edits.map_err(|error| failed(ErrorCode::RequestFailed, error.to_string()))?;
        answer_value(text_edits(&program, edits))
    }

    fn actions(&self, params: Value) -> RequestAnswer {
        let params: CodeActionParams = parse(params)?;
        let (program, ran) = self.ran(&params.text_document.uri)?;
        answer_value(actions(&program, &ran, &params))
    }

    fn resolve(&self, params: Value) -> RequestAnswer {
        let action: CodeAction = parse(params)?;
        let uri: Option<Uri> = action.data.clone().and_then(|uri| serde_json::from_value(uri).ok());
        let Some(uri) = uri else { return answer_value(action) };
        let resolved = actions::resolved(&*self.program(&uri)?, &uri, action);
        answer_value(resolved.map_err(|problem| failed(ErrorCode::RequestFailed, problem))?)
    }

    fn hints(&self, params: Value) -> RequestAnswer {
        let InlayHintParams { text_document, range, .. } = parse(params)?;
        let (program, ran) = self.ran(&text_document.uri)?;
        let (from, to) = lines(range);
        answer_value(features::hints(&program, &ran, from, to))
    }

    fn tokens(&self, params: Value) -> RequestAnswer {
        let SemanticTokensParams { text_document, .. } = parse(params)?;
        // When the tokens of a long text are refused as a whole, editors request them for the visible lines.
        if self.document(&text_document.uri)?.text().len() > MAX_COLOURED_BYTES {
            return answer_value(Value::Null);
        }
        self.tokens_of(&text_document.uri, 1, u32::MAX)
    }

    fn range_tokens(&self, params: Value) -> RequestAnswer {
        let SemanticTokensRangeParams { text_document, range, .. } = parse(params)?;
        let (from, to) = lines(range);
        self.tokens_of(&text_document.uri, from, to.min(from.saturating_add(MAX_COLOURED_LINES)))
    }

    fn tokens_of(&self, uri: &Uri, from: u32, to: u32) -> RequestAnswer {
        let program = self.program(uri)?;
        let data = semantic_tokens(&program, &program.tokens(from, to));
        answer_value(SemanticTokens { result_id: None, data })
    }
}

fn failed(code: ErrorCode, message: String) -> ResponseError {
    ResponseError { code: code as i32, message, data: None }
}

fn answer_value(answer: impl serde::Serialize) -> RequestAnswer {
    serde_json::to_value(answer)
        .map_err(|error| failed(ErrorCode::InternalError, error.to_string()))
}

fn parse<T: DeserializeOwned>(params: Value) -> Result<T, ResponseError> {
    serde_json::from_value(params)
        .map_err(|error| failed(ErrorCode::InvalidParams, error.to_string()))
}

/// Parses the parameters of a notification; `None` when they are invalid, because a notification has no reply for
/// errors.
fn read<T: DeserializeOwned>(params: Value) -> Option<T> {
    serde_json::from_value(params).ok()
}

/// The URI of the document that a request is about.
fn document_of(request: &Request) -> Option<&str> {
    request.params.get("textDocument")?.get("uri")?.as_str()
}

//! The language server, step by step: JavaScript brings the messages of the editor and the files next to the
//! programs, and gives it time to run them.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use chordal_ask::setup_of;
use chordal_editor::EditorSetup;
use chordal_load::{FileAccess, Request};
use chordal_lsp::{SetupFinder, SteppedServer};
use lsp_server::Message;
use serde::{Deserialize, Serialize};

/// A step that JavaScript requests.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
enum LanguageStep {
    /// A message of the editor.
    Message(Message),
    /// Time to run a program.
    Work,
    /// All files that programs may need, by their paths: machine files, subprograms.
    Files(BTreeMap<PathBuf, String>),
}

/// The answer to a step.
#[derive(Serialize, Default)]
struct StepAnswer {
    /// Messages for the editor.
    messages: Vec<Message>,
    /// There are programs to run.
    more: bool,
    /// Why the step could not be read.
    problem: Option<String>,
}

/// Loads texts with the files that JavaScript has sent.
#[derive(Clone, Default)]
struct EditorFiles(Rc<RefCell<FileAccess>>);

impl SetupFinder for EditorFiles {
    fn open(
        &self,
        path: Option<&Path>,
        text: &[u8],
        machine: Option<&str>,
    ) -> Result<EditorSetup, String> {
        let request = Request { files: self.0.borrow().clone(), ..Request::default() };
        setup_of(path, text, machine, request)
    }
}

struct LanguageModule {
    files: EditorFiles,
    server: SteppedServer,
}

impl LanguageModule {
    fn new() -> LanguageModule {
        let files = EditorFiles(Rc::new(RefCell::new(FileAccess::in_memory([]))));
        LanguageModule { server: SteppedServer::new(Box::new(files.clone())), files }
    }

    fn take(&mut self, step: LanguageStep) -> Vec<Message> {
        match step {
            LanguageStep::Message(message) => self.server.hear(message),
            LanguageStep::Work => self.server.work(),
            LanguageStep::Files(files) => {
                let files = files.into_iter().map(|(path, text)| (path, text.into_bytes()));
                *self.files.0.borrow_mut() = FileAccess::in_memory(files);
                self.server.files_changed()
            }
        }
    }
}

thread_local! {
    static LANGUAGE: RefCell<LanguageModule> = RefCell::new(LanguageModule::new());
}

/// Takes a step, JSON; says in JSON what comes of it.
pub fn step(request: &[u8]) -> String {
    let answer = LANGUAGE.with_borrow_mut(|language| match serde_json::from_slice(request) {
        Ok(step) => {
            let messages = language.take(step);
            StepAnswer { messages, more: language.server.has_work(), problem: None }
        }
        Err(error) => StepAnswer {
            more: language.server.has_work(),
            problem: Some(format!("this is not a step: {error}")),
            ..StepAnswer::default()
        },
    });
    serde_json::to_string(&answer).unwrap_or_default()
}

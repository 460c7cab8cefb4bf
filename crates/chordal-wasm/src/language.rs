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

/// What JavaScript brings.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
enum Step {
    /// A message of the editor.
    Message(Message),
    /// Time to run a program.
    Work,
    /// All files that programs may need, by their paths: machine files, subprograms.
    Files(BTreeMap<PathBuf, String>),
}

/// What it gets.
#[derive(Serialize, Default)]
struct Told {
    /// Messages for the editor.
    messages: Vec<Message>,
    /// There are programs to run.
    more: bool,
    /// Why the step was not taken.
    problem: Option<String>,
}

/// Loads texts with the files that were brought.
#[derive(Clone, Default)]
struct Brought(Rc<RefCell<FileAccess>>);

impl SetupFinder for Brought {
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

struct Language {
    files: Brought,
    server: SteppedServer,
}

impl Language {
    fn new() -> Language {
        let files = Brought(Rc::new(RefCell::new(FileAccess::in_memory([]))));
        Language { server: SteppedServer::new(Box::new(files.clone())), files }
    }

    fn take(&mut self, step: Step) -> Vec<Message> {
        match step {
            Step::Message(message) => self.server.hear(message),
            Step::Work => self.server.work(),
            Step::Files(files) => {
                let files = files.into_iter().map(|(path, text)| (path, text.into_bytes()));
                *self.files.0.borrow_mut() = FileAccess::in_memory(files);
                self.server.files_changed()
            }
        }
    }
}

thread_local! {
    static LANGUAGE: RefCell<Language> = RefCell::new(Language::new());
}

/// Takes a step, JSON; says in JSON what comes of it.
pub fn step(request: &[u8]) -> String {
    let told = LANGUAGE.with_borrow_mut(|language| match serde_json::from_slice(request) {
        Ok(step) => {
            let messages = language.take(step);
            Told { messages, more: language.server.has_work(), problem: None }
        }
        Err(error) => Told {
            more: language.server.has_work(),
            problem: Some(format!("this is not a step: {error}")),
            ..Told::default()
        },
    });
    serde_json::to_string(&told).unwrap_or_default()
}

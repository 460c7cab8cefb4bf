//! Runs programs, the newest text of each document only: in a thread of its own, or piece by piece.

use std::collections::HashMap;
use std::sync::Arc;
use std::thread;

use chordal::Diagnostic;
use chordal_editor::{EditorProgram, PreviousCheck, RunMoves};
use crossbeam_channel::{Receiver, Sender, unbounded};

use crate::panic_guard::caught;

/// A program to run.
#[derive(Debug)]
pub struct RunTask {
    /// The document.
    pub uri: String,
    /// Its version.
    pub version: i32,
    /// The text with its machine; `None` when the document was closed.
    pub program: Option<Arc<EditorProgram>>,
}

/// A program that has run.
#[derive(Debug)]
pub struct RunResult {
    /// The document.
    pub uri: String,
    /// The version that ran.
    pub version: i32,
    /// What was found.
    pub found: RunFindings,
}

/// What a run found.
#[derive(Debug)]
pub enum RunFindings {
    /// The problems, which are reported first.
    Problems(Vec<Diagnostic>),
    /// What the lines did, too.
    Ran(Arc<RunMoves>),
    /// Nothing: Chordal itself failed, and why.
    Failed(String),
}

/// The thread, by its two ends. It ends when the tasks do.
#[derive(Debug)]
pub struct RunWorker {
    /// Takes tasks.
    pub tasks: Sender<RunTask>,
    /// Gives results.
    pub done: Receiver<RunResult>,
}

impl RunWorker {
    /// Starts the thread.
    #[allow(clippy::disallowed_methods, reason = "a shell: it may have threads")]
    pub fn start() -> RunWorker {
        let (worker, mut bench) = RunWorker::with_bench();
        thread::spawn(move || while bench.work().is_some() {});
        worker
    }

    /// For a caller that works at the bench itself.
    pub fn with_bench() -> (RunWorker, WorkQueue) {
        let (tasks, todo) = unbounded::<RunTask>();
        let (results, done) = unbounded();
        let bench = WorkQueue { todo, results, checked: HashMap::new(), due: Vec::new() };
        (RunWorker { tasks, done }, bench)
    }
}

/// What is worked on.
#[derive(Debug)]
pub struct WorkQueue {
    todo: Receiver<RunTask>,
    results: Sender<RunResult>,
    /// What the last check of each document remembers.
    checked: HashMap<String, PreviousCheck>,
    /// Programs whose problems were reported and of which it is not known yet what the lines do.
    due: Vec<(String, i32, Arc<EditorProgram>)>,
}

impl WorkQueue {
    /// There is something to do: a round does not wait.
    pub fn has_work(&self) -> bool {
        !(self.todo.is_empty() && self.due.is_empty())
    }

    /// One round; nothing when nobody wants more.
    pub fn work(&mut self) -> Option<()> {
        let mut waiting = Vec::new();
        if self.due.is_empty() {
            waiting.push(self.todo.recv().ok()?);
        }
        for task in self.todo.try_iter() {
            waiting.retain(|other: &RunTask| other.uri != task.uri);
            waiting.push(task);
        }
        for task in waiting {
            self.check(task)?;
        }
        let Some((uri, version, program)) = self.due.pop() else { return Some(()) };
        // Whoever types on wants the problems of the next text first.
        let todo = self.todo.clone();
        match caught(|| program.ran_unless(Arc::new(move || !todo.is_empty()))) {
            Ok(Some(ran)) => self.send(uri, version, RunFindings::Ran(Arc::new(ran))),
            Err(why) => self.send(uri, version, RunFindings::Failed(why)),
            Ok(None) => {
                self.due.push((uri, version, program));
                Some(())
            }
        }
    }

    fn check(&mut self, RunTask { uri, version, program }: RunTask) -> Option<()> {
        self.due.retain(|(other, ..)| *other != uri);
        let Some(program) = program else {
            self.checked.remove(&uri);
            return Some(());
        };
        let before = self.checked.entry(uri.clone()).or_default();
        match caught(|| program.check(before).diagnostics) {
            Ok(problems) => {
                self.due.push((uri.clone(), version, program));
                self.send(uri, version, RunFindings::Problems(problems))
            }
            Err(why) => {
                self.checked.remove(&uri);
                self.send(uri, version, RunFindings::Failed(why))
            }
        }
    }

    fn send(&self, uri: String, version: i32, found: RunFindings) -> Option<()> {
        self.results.send(RunResult { uri, version, found }).ok()
    }
}

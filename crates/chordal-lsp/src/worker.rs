//! Runs programs, only the newest text of each document: in a thread, or step by step.

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

/// A result of running a program.
#[derive(Debug)]
pub struct RunResult {
    /// The document.
    pub uri: String,
    /// The version that ran.
    pub version: i32,
    /// The result.
    pub found: RunFindings,
}

/// The result of a run.
#[derive(Debug)]
pub enum RunFindings {
    /// The problems, which are sent first.
    Problems(Vec<Diagnostic>),
    /// The moves of each line.
    Ran(Arc<RunMoves>),
    /// Chordal itself failed; the message says why.
    Failed(String),
}

/// The channels to the thread that runs programs. The thread ends when the sender of tasks is dropped.
#[derive(Debug)]
pub struct RunWorker {
    /// The sender for tasks.
    pub tasks: Sender<RunTask>,
    /// The receiver of results.
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

    /// The channels and the queue for a caller that executes the work itself.
    pub fn with_bench() -> (RunWorker, WorkQueue) {
        let (tasks, todo) = unbounded::<RunTask>();
        let (results, done) = unbounded();
        let bench = WorkQueue { todo, results, checked: HashMap::new(), due: Vec::new() };
        (RunWorker { tasks, done }, bench)
    }
}

/// The queue of programs to run.
#[derive(Debug)]
pub struct WorkQueue {
    todo: Receiver<RunTask>,
    results: Sender<RunResult>,
    /// The state of each document's last check, for a faster check of the next text.
    checked: HashMap<String, PreviousCheck>,
    /// Programs whose problems were sent and whose moves are not known yet.
    due: Vec<(String, i32, Arc<EditorProgram>)>,
}

impl WorkQueue {
    /// Whether there is work, so that [`WorkQueue::work`] does not wait.
    pub fn has_work(&self) -> bool {
        !(self.todo.is_empty() && self.due.is_empty())
    }

    /// Does one round of work and waits for a task if there is none; `None` when the channels are closed.
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
        // The run is interrupted when new text arrives, whose problems are more urgent.
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

//! Runs programs, the newest text of each document only: in a thread of its own, or piece by piece.

use std::collections::HashMap;
use std::sync::Arc;
use std::thread;

use chordal::Diagnostic;
use chordal_editor::{Checked, Program, Ran};
use crossbeam_channel::{Receiver, Sender, unbounded};

use crate::caught::caught;

/// A program to run.
#[derive(Debug)]
pub struct Task {
    /// The document.
    pub uri: String,
    /// Its version.
    pub version: i32,
    /// The text with its machine; `None` when the document was closed.
    pub program: Option<Arc<Program>>,
}

/// A program that has run.
#[derive(Debug)]
pub struct Done {
    /// The document.
    pub uri: String,
    /// The version that ran.
    pub version: i32,
    /// What was found.
    pub found: Found,
}

/// What a run found.
#[derive(Debug)]
pub enum Found {
    /// The problems, which are reported first.
    Problems(Vec<Diagnostic>),
    /// What the lines did, too.
    Ran(Arc<Ran>),
    /// Nothing: Chordal itself failed, and why.
    Failed(String),
}

/// The thread, by its two ends. It ends when the tasks do.
#[derive(Debug)]
pub struct Worker {
    /// Takes tasks.
    pub tasks: Sender<Task>,
    /// Gives results.
    pub done: Receiver<Done>,
}

impl Worker {
    /// Starts the thread.
    #[allow(clippy::disallowed_methods, reason = "a shell: it may have threads")]
    pub fn start() -> Worker {
        let (worker, mut bench) = Worker::with_bench();
        thread::spawn(move || while bench.work().is_some() {});
        worker
    }

    /// For a caller that works at the bench itself.
    pub fn with_bench() -> (Worker, Bench) {
        let (tasks, todo) = unbounded::<Task>();
        let (results, done) = unbounded();
        let bench = Bench { todo, results, checked: HashMap::new(), due: Vec::new() };
        (Worker { tasks, done }, bench)
    }
}

/// What is worked on.
#[derive(Debug)]
pub struct Bench {
    todo: Receiver<Task>,
    results: Sender<Done>,
    /// What the last check of each document remembers.
    checked: HashMap<String, Checked>,
    /// Programs whose problems were reported and of which it is not known yet what the lines do.
    due: Vec<(String, i32, Arc<Program>)>,
}

impl Bench {
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
            waiting.retain(|other: &Task| other.uri != task.uri);
            waiting.push(task);
        }
        for task in waiting {
            self.check(task)?;
        }
        let Some((uri, version, program)) = self.due.pop() else { return Some(()) };
        // Whoever types on wants the problems of the next text first.
        let todo = self.todo.clone();
        match caught(|| program.ran_unless(Arc::new(move || !todo.is_empty()))) {
            Ok(Some(ran)) => self.send(uri, version, Found::Ran(Arc::new(ran))),
            Err(why) => self.send(uri, version, Found::Failed(why)),
            Ok(None) => {
                self.due.push((uri, version, program));
                Some(())
            }
        }
    }

    fn check(&mut self, Task { uri, version, program }: Task) -> Option<()> {
        self.due.retain(|(other, ..)| *other != uri);
        let Some(program) = program else {
            self.checked.remove(&uri);
            return Some(());
        };
        let before = self.checked.entry(uri.clone()).or_default();
        match caught(|| program.check(before).diagnostics) {
            Ok(problems) => {
                self.due.push((uri.clone(), version, program));
                self.send(uri, version, Found::Problems(problems))
            }
            Err(why) => {
                self.checked.remove(&uri);
                self.send(uri, version, Found::Failed(why))
            }
        }
    }

    fn send(&self, uri: String, version: i32, found: Found) -> Option<()> {
        self.results.send(Done { uri, version, found }).ok()
    }
}

//! Runs programs in a thread of its own, the newest text of each document only.

use std::sync::Arc;
use std::thread;

use chordal::Diagnostic;
use chordal_editor::{Program, Ran};
use crossbeam_channel::{Receiver, Sender, unbounded};

/// A program to run.
#[derive(Debug)]
pub struct Task {
    /// The document.
    pub uri: String,
    /// Its version.
    pub version: i32,
    /// The text with its machine.
    pub program: Arc<Program>,
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
    /// The problems, which are told first.
    Problems(Vec<Diagnostic>),
    /// What the lines did, too.
    Ran(Arc<Ran>),
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
        let (tasks, todo) = unbounded::<Task>();
        let (results, done) = unbounded();
        thread::spawn(move || {
            while let Ok(first) = todo.recv() {
                let mut waiting = vec![first];
                for task in todo.try_iter() {
                    waiting.retain(|other| other.uri != task.uri);
                    waiting.push(task);
                }
                for Task { uri, version, program } in waiting {
                    let problems = Found::Problems(program.job().check().diagnostics);
                    let found = Done { uri: uri.clone(), version, found: problems };
                    if results.send(found).is_err() {
                        return;
                    }
                    // Whoever types on wants the problems of the next text first.
                    if todo.is_empty() {
                        let found = Found::Ran(Arc::new(program.ran()));
                        if results.send(Done { uri, version, found }).is_err() {
                            return;
                        }
                    }
                }
            }
        });
        Worker { tasks, done }
    }
}

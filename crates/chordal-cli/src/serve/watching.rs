//! Questions that are answered again when a file changes.

use std::time::{Duration, Instant};

use serde_json::Value;

use super::message::PendingQuestion;
use super::stamp::FileStamp;

/// A file that is being written is read when it has been left alone for so long.
const QUIET_TIME: Duration = Duration::from_millis(100);

/// The watched questions.
#[derive(Default)]
pub struct WatchList(Vec<WatchedQuestion>);

struct WatchedQuestion {
    question: PendingQuestion,
    /// The files as they were when they were read.
    read: Vec<FileStamp>,
    /// The files as they were at the last look, and since when.
    seen: Vec<FileStamp>,
    since: Instant,
}

impl WatchList {
    /// Nothing is watched.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Watches the files of a question.
    pub fn keep(&mut self, question: PendingQuestion, read: Vec<FileStamp>) {
        let (seen, since) = (read.clone(), Instant::now());
        self.0.push(WatchedQuestion { question, read, seen, since });
    }

    /// Watches no longer; false where nothing was watched.
    pub fn forget(&mut self, id: &Value) -> bool {
        let before = self.0.len();
        self.0.retain(|watched| watched.question.id != *id);
        self.0.len() < before
    }

    /// A question whose files have changed and are left alone since.
    pub fn changed(&mut self) -> Option<PendingQuestion> {
        let place = self.0.iter_mut().position(WatchedQuestion::has_changed)?;
        let mut question = self.0.remove(place).question;
        question.times += 1;
        Some(question)
    }
}

impl WatchedQuestion {
    fn has_changed(&mut self) -> bool {
        let now = self.question.stamps();
        if now != self.seen {
            (self.seen, self.since) = (now, Instant::now());
        }
        self.seen != self.read && self.since.elapsed() >= QUIET_TIME
    }
}

//! The blocks of a run in order, and the F that each of them uses.

use chordal::control::{FeedMode, Modal, Origin, Units};
use chordal::diagnostics::FileId;
use chordal::{Command, Diagnostic, Job, RunSink, Sink};

/// A block that ran.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RunVisit {
    /// The byte that it begins at, in the first text.
    pub block: Option<u32>,
    /// Its line.
    pub line: u32,
    /// The F that a move of it used, and what it counts.
    pub used: Option<(f64, FeedMode)>,
    /// F after it.
    pub modal: Option<f64>,
    pub units: Units,
}

/// All blocks that ran, in order.
#[derive(Debug, Default)]
pub(super) struct RunVisits {
    pub list: Vec<RunVisit>,
    used: Option<(f64, FeedMode)>,
}

impl RunVisits {
    pub fn of(job: &Job) -> RunVisits {
        let mut visits = RunVisits::default();
        job.run(&mut visits);
        visits
    }
}

impl Sink for RunVisits {
    fn command(&mut self, command: &Command) {
        if let Some(feed) = command.kind.feed() {
            self.used = Some((feed.value, feed.mode));
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for RunVisits {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, modal: &dyn Fn() -> Modal) {
        let modal = modal();
        let is_own = origin.span.file == FileId(0);
        self.list.push(RunVisit {
            block: is_own.then_some(origin.span.range.start),
            line: origin.line,
            used: self.used.take(),
            modal: modal.feed,
            units: modal.units,
        });
    }
}

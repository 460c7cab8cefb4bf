//! A run, recorded command by command.

use std::collections::BTreeSet;

use chordal::control::{AfterBlock, CallPath, Origin};
use chordal::diagnostics::FileId;
use chordal::{Command, Diagnostic, Job, Outcome, RunSink, Sink, Span};

/// What a run does, and which lines of the main program it carries out.
#[derive(Default)]
pub(super) struct RecordedRun {
    pub commands: Vec<Command>,
    /// The lines of the first text that are carried out, not through a call.
    pub main_lines: BTreeSet<u32>,
    pub outcomes: Vec<Outcome>,
}

impl RecordedRun {
    pub fn of(job: &Job) -> RecordedRun {
        let mut run = RecordedRun::default();
        let outcomes = job.run(&mut run);
        run.outcomes = outcomes;
        run
    }

    /// The blocks of the main program through which commands were reached, each once, in the order of their first run.
    pub fn callers(&self) -> Vec<Span> {
        let Some(outcome) = self.outcomes.first() else { return Vec::new() };
        let mut known = BTreeSet::new();
        let calls = self.commands.iter().map(|command| command.origin.call);
        let new_calls = calls.filter(|call| *call != CallPath::default() && known.insert(*call));
        let mut callers: Vec<Span> = Vec::new();
        for call in new_calls {
            // The chain ends with the block of the main program.
            let outermost = outcome.calls.resolve(call).last().copied();
            callers.extend(outermost.filter(|block| !callers.contains(block)));
        }
        callers
    }
}

/// Whether a block stands in the main program of the first text.
pub(super) fn is_main(origin: &Origin) -> bool {
    origin.call == CallPath::default() && origin.span.file == FileId(0)
}

impl Sink for RecordedRun {
    fn command(&mut self, command: &Command) {
        self.commands.push(command.clone());
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for RecordedRun {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, _: &AfterBlock) {
        if is_main(origin) {
            self.main_lines.insert(origin.line);
        }
    }
}

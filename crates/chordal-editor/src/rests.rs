//! What is active after a line. The text is run for it once, and rests are kept: the next
//! question begins at the one before its line.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use chordal::control::{CallPath, Interrupt, Modal, Origin, Rest};
use chordal::diagnostics::{FileId, TextRange};
use chordal::{Command, Diagnostic, Sink};

use crate::Program;

/// Text between two rests, in bytes, or one of [`MOST_RESTS`] parts of it.
const APART: usize = 32 << 10;

/// About as many rests at most.
const MOST_RESTS: usize = 256;

/// The rests of a run as far as it was needed.
#[derive(Debug, Default)]
pub(crate) struct Rests(Mutex<Known>);

#[derive(Clone, Debug, Default)]
struct Known {
    /// Where the text was left off, each with what was read elsewhere in the stretch before it.
    rests: Vec<(Arc<Rest>, Option<TextRange>)>,
}

impl Known {
    /// The first stretch that may carry a byte out.
    fn stretch_of(&self, byte: u32) -> Option<usize> {
        (0..self.rests.len()).find(|&index| {
            let from = self.start(index).map_or(0, |rest| rest.offset());
            let (end, looked) = &self.rests[index];
            let looked = looked.is_some_and(|looked| (looked.start..looked.end).contains(&byte));
            (from..end.offset()).contains(&byte) || looked
        })
    }

    /// The rest at which a stretch begins; none for the first.
    fn start(&self, index: usize) -> Option<&Rest> {
        index.checked_sub(1).map(|before| &*self.rests[before].0)
    }
}

impl Rests {
    fn known(&self) -> MutexGuard<'_, Known> {
        // Nothing is left half done where a panic could strike.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Program {
    /// What is active after a line when it runs for the first time; for a line that carries
    /// nothing out, after the last one before it that does.
    pub fn modal_behind(&self, line: u32) -> Option<Modal> {
        self.modal_of(line).or_else(|| self.modal_of(self.nearest(line)?))
    }

    /// What is active after a line, if it carries something out.
    fn modal_of(&self, line: u32) -> Option<Modal> {
        let known = self.rests.known().clone();
        let byte = self.source().line_start(line);
        let stretch = known.stretch_of(byte).unwrap_or(known.rests.len());
        let rest = known.start(stretch);
        let mut taking = Taking::new(line, rest.map_or(0, Rest::offset), self.apart());
        let job = self.job().interrupt(taking.interrupt());
        if !job.run_on(rest, &mut taking) {
            job.run(&mut taking);
            return taking.modal.map(|(_, _, modal)| modal);
        }
        if stretch == known.rests.len() {
            let mut now = self.rests.known();
            // Another question may have come as far.
            if now.rests.len() == known.rests.len() {
                now.rests.append(&mut taking.rests);
            }
        }
        taking.modal.map(|(_, _, modal)| modal)
    }

    /// The last line up to one that carries something out.
    fn nearest(&self, line: u32) -> Option<u32> {
        let known = self.rests.known().clone();
        let byte = self.source().line_start(line);
        let job = self.job();
        let last = known.stretch_of(byte).map_or(known.rests.len(), |index| index + 1);
        for index in (0..last).rev() {
            let end = known.rests.get(index).map_or(u32::MAX, |(rest, _)| rest.offset());
            let mut nearest = Nearest { line, best: None, end };
            if job.run_on(known.start(index), &mut nearest) && nearest.best.is_some() {
                return nearest.best;
            }
        }
        let mut nearest = Nearest { line, best: None, end: u32::MAX };
        job.run(&mut nearest);
        nearest.best
    }

    fn apart(&self) -> u32 {
        APART.max(self.text().len() / MOST_RESTS) as u32
    }
}

/// The last line up to one that carries something out, up to a rest.
struct Nearest {
    line: u32,
    best: Option<u32>,
    end: u32,
}

impl Sink for Nearest {
    fn command(&mut self, _: &Command) {}

    fn diagnostic(&mut self, _: Diagnostic) {}

    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, _: &dyn Fn() -> Modal) {
        if origin.span.file == FileId(0) && origin.line <= self.line {
            self.best = self.best.max(Some(origin.line));
        }
    }

    fn next_rest(&self) -> u32 {
        self.end
    }

    fn rest(&mut self, _: Rest, _: Option<TextRange>) -> ControlFlow<()> {
        ControlFlow::Break(())
    }
}

/// The state after a line's first run, which ends the run; the last block of the line counts.
struct Taking {
    line: u32,
    modal: Option<(u32, CallPath, Modal)>,
    /// The line has run: what follows is no longer wanted.
    over: Arc<AtomicBool>,
    apart: u32,
    next: u32,
    rests: Vec<(Arc<Rest>, Option<TextRange>)>,
}

impl Taking {
    fn new(line: u32, from: u32, apart: u32) -> Taking {
        let over = Arc::new(AtomicBool::new(false));
        Taking { line, modal: None, over, apart, next: from + apart, rests: Vec::new() }
    }

    fn interrupt(&self) -> Interrupt {
        let over = self.over.clone();
        Arc::new(move || over.load(Ordering::Relaxed))
    }
}

impl Sink for Taking {
    fn command(&mut self, _: &Command) {}

    fn diagnostic(&mut self, _: Diagnostic) {}

    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, modal: &dyn Fn() -> Modal) {
        if origin.span.file != FileId(0) || self.over.load(Ordering::Relaxed) {
            return;
        }
        let start = origin.span.range.start;
        match &self.modal {
            // What the line calls is other lines, too.
            Some((_, call, _)) if origin.line != self.line && origin.call == *call => {
                self.over.store(true, Ordering::Relaxed);
            }
            Some((last, ..)) if *last >= start => {}
            _ if origin.line == self.line => self.modal = Some((start, origin.call, modal())),
            _ => {}
        }
    }

    fn next_rest(&self) -> u32 {
        self.next
    }

    fn rest(&mut self, rest: Rest, looked: Option<TextRange>) -> ControlFlow<()> {
        if self.over.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        self.next = rest.offset().saturating_add(self.apart);
        self.rests.push((Arc::new(rest), looked));
        ControlFlow::Continue(())
    }
}

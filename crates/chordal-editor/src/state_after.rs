//! What is in force behind a line. The text is run for it once, and checkpoints are kept: the next
//! question begins at the one before its line.

use chordal::RunSink;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use chordal::control::{AfterBlock, CallPath, Checkpoint, InterruptCheck, Modal, Origin};
use chordal::diagnostics::{FileId, TextRange};
use chordal::{Command, Diagnostic, Sink};

use crate::EditorProgram;

/// Text between two checkpoints, in bytes, or one of [`MAX_CHECKPOINTS`] parts of it.
const CHECKPOINT_SPACING_BYTES: usize = 32 << 10;

/// About as many checkpoints at most.
const MAX_CHECKPOINTS: usize = 256;

impl EditorProgram {
    /// What is active after a line when it runs for the first time; for a line that carries
    /// nothing out, after the last one before it that does.
    pub fn modal_after(&self, line: u32) -> Option<Modal> {
        self.modal_of(line).or_else(|| self.modal_of(self.nearest(line)?))
    }

    /// What is active after a line, if it carries something out.
    fn modal_of(&self, line: u32) -> Option<Modal> {
        let known = self.checkpoints.known().clone();
        let byte = self.source().line_start(line);
        let section = known.segment_of(byte).unwrap_or(known.checkpoints.len());
        let checkpoint = known.start(section);
        let mut taking = StateRecorder::new(
            line,
            checkpoint.map_or(0, Checkpoint::offset),
            self.checkpoint_spacing(),
        );
        let job = self.job().interrupt(taking.interrupt());
        if !job.run_on(checkpoint, &mut taking) {
            job.run(&mut taking);
            return taking.modal.map(|(_, _, modal)| modal);
        }
        if section == known.checkpoints.len() {
            let mut now = self.checkpoints.known();
            // Another question may have come as far.
            if now.checkpoints.len() == known.checkpoints.len() {
                now.checkpoints.append(&mut taking.checkpoints);
            }
        }
        taking.modal.map(|(_, _, modal)| modal)
    }

    /// The last line up to one that carries something out.
    fn nearest(&self, line: u32) -> Option<u32> {
        let known = self.checkpoints.known().clone();
        let byte = self.source().line_start(line);
        let job = self.job();
        let last = known.segment_of(byte).map_or(known.checkpoints.len(), |index| index + 1);
        for index in (0..last).rev() {
            let end = known
                .checkpoints
                .get(index)
                .map_or(u32::MAX, |(checkpoint, _)| checkpoint.offset());
            let mut nearest = NearestLine { line, best: None, end };
            if job.run_on(known.start(index), &mut nearest) && nearest.best.is_some() {
                return nearest.best;
            }
        }
        let mut nearest = NearestLine { line, best: None, end: u32::MAX };
        job.run(&mut nearest);
        nearest.best
    }

    fn checkpoint_spacing(&self) -> u32 {
        CHECKPOINT_SPACING_BYTES.max(self.text().len() / MAX_CHECKPOINTS) as u32
    }
}

/// The last line up to one that carries something out, up to a checkpoint.
struct NearestLine {
    line: u32,
    best: Option<u32>,
    end: u32,
}

impl Sink for NearestLine {
    fn command(&mut self, _: &Command) {}

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for NearestLine {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, _: &AfterBlock) {
        if origin.span.file == FileId(0) && origin.line <= self.line {
            self.best = self.best.max(Some(origin.line));
        }
    }

    fn next_checkpoint(&self) -> u32 {
        self.end
    }

    fn checkpoint(&mut self, _: Checkpoint, _: Option<TextRange>) -> ControlFlow<()> {
        ControlFlow::Break(())
    }
}

/// The state after a line's first run, which ends the run; the last block of the line counts.
struct StateRecorder {
    line: u32,
    modal: Option<(u32, CallPath, Modal)>,
    /// The line has run: what follows is no longer wanted.
    over: Arc<AtomicBool>,
    spacing: u32,
    next: u32,
    checkpoints: Vec<(Arc<Checkpoint>, Option<TextRange>)>,
}

impl StateRecorder {
    fn new(line: u32, from: u32, separate: u32) -> StateRecorder {
        let over = Arc::new(AtomicBool::new(false));
        StateRecorder {
            line,
            modal: None,
            over,
            spacing: separate,
            next: from + separate,
            checkpoints: Vec::new(),
        }
    }

    fn interrupt(&self) -> InterruptCheck {
        let over = self.over.clone();
        Arc::new(move || over.load(Ordering::Relaxed))
    }
}

impl Sink for StateRecorder {
    fn command(&mut self, _: &Command) {}

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for StateRecorder {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, after: &AfterBlock) {
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
            _ if origin.line == self.line => {
                self.modal = Some((start, origin.call, (after.modal)()))
            }
            _ => {}
        }
    }

    fn next_checkpoint(&self) -> u32 {
        self.next
    }

    fn checkpoint(
        &mut self,
        checkpoint: Checkpoint,
        inspected: Option<TextRange>,
    ) -> ControlFlow<()> {
        if self.over.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        self.next = checkpoint.offset().saturating_add(self.spacing);
        self.checkpoints.push((Arc::new(checkpoint), inspected));
        ControlFlow::Continue(())
    }
}

//! What the blocks of a text did when it ran.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use chordal::control::{CallPath, Modal, Origin, Units};
use chordal::diagnostics::FileId;
use chordal::path::PathCommand;
use chordal::{Command, Diagnostic, Report, Segment, SegmentKind, Sink, Watch};

use crate::Program;

/// What the moves of one line did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineMoves {
    /// Line of the text, from 1.
    pub line: u32,
    /// Where the tool tip was behind the last of them, in program coordinates, mm and rad.
    pub to: [f64; 6],
    /// Length of the path of all of them, mm.
    pub length_mm: f64,
    /// How long the cuts take without acceleration, and rapids, s.
    pub seconds: f64,
    /// How many pieces of path.
    pub pieces: u32,
    /// One of them cuts.
    pub cuts: bool,
}

/// A run with what its lines did.
#[derive(Debug)]
pub struct Ran {
    /// The lines that moved, in order.
    pub lines: Vec<LineMoves>,
    /// Everything else.
    pub report: Report,
}

impl Ran {
    /// The units in which to speak of it.
    pub fn units(&self) -> Units {
        if self.report.summary.inch { Units::Inch } else { Units::Millimetre }
    }

    /// What a line did.
    pub fn line(&self, line: u32) -> Option<&LineMoves> {
        let index = self.lines.binary_search_by_key(&line, |moves| moves.line).ok()?;
        Some(&self.lines[index])
    }
}

struct Lines {
    /// By line; a line of length zero in `pieces` and no place did not move.
    lines: Vec<Option<LineMoves>>,
}

impl Lines {
    fn at(&mut self, origin: &Origin) -> Option<&mut LineMoves> {
        if origin.span.file != FileId(0) {
            return None;
        }
        let index = origin.line as usize;
        if index >= self.lines.len() {
            self.lines.resize(index + 1, None);
        }
        Some(self.lines[index].get_or_insert(LineMoves {
            line: origin.line,
            to: [0.0; 6],
            length_mm: 0.0,
            seconds: 0.0,
            pieces: 0,
            cuts: false,
        }))
    }
}

impl Watch for Lines {
    fn programmed(&mut self, command: &Command) {
        if let Some(motion) = command.kind.motion()
            && let Some(moves) = self.at(&command.origin)
        {
            moves.to = motion.to;
        }
    }

    fn path(&mut self, command: PathCommand<'_>, segments: &[Segment]) {
        if segments.is_empty() {
            return;
        }
        if let Some(moves) = self.at(&command.command.origin) {
            for segment in segments {
                moves.length_mm += segment.length_mm;
                moves.seconds += segment.duration_s;
                moves.pieces += 1;
                moves.cuts |= segment.kind != SegmentKind::Rapid;
            }
        }
    }
}

impl Program {
    /// Runs the text and tells what its lines did.
    pub fn ran(&self) -> Ran {
        let mut lines = Lines { lines: Vec::new() };
        let report = self.job().report_watched(&mut lines);
        Ran { lines: lines.lines.into_iter().flatten().collect(), report }
    }

    /// What is in force behind a line when it runs for the first time; for a line that carries
    /// nothing out, behind the last one before it that does.
    pub fn modal_behind(&self, line: u32) -> Option<Modal> {
        self.modal_of(line).or_else(|| {
            let mut nearest = Nearest { line, best: None };
            self.job().run(&mut nearest);
            self.modal_of(nearest.best?)
        })
    }

    /// What is in force behind a line, if it carries something out.
    fn modal_of(&self, line: u32) -> Option<Modal> {
        let over = Arc::new(AtomicBool::new(false));
        let asked = over.clone();
        let mut taking = Taking { line, modal: None, over };
        self.job().interrupt(Arc::new(move || asked.load(Ordering::Relaxed))).run(&mut taking);
        taking.modal.map(|(_, _, modal)| modal)
    }
}

/// The last line up to one that carries something out.
struct Nearest {
    line: u32,
    best: Option<u32>,
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
}

/// The state behind a line's first run, which ends the run; the last block of the line counts.
struct Taking {
    line: u32,
    modal: Option<(u32, CallPath, Modal)>,
    /// The line has run: what follows is no longer wanted.
    over: Arc<AtomicBool>,
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
}

//! What the blocks of a text did when it ran.

use chordal::control::{EndReason, InterruptCheck, Origin, Outcome, Units, number_text};
use chordal::diagnostics::FileId;
use chordal::machine::{AXES, PerAxis};
use chordal::path::PathCommand;
use chordal::{Command, Job, Report, RunWatch, Segment, SegmentKind};

use crate::EditorProgram;

/// What the moves of one line did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineMoves {
    /// Line of the text, from 1.
    pub line: u32,
    /// Where the tool tip was after the last of them, in program coordinates, mm and rad.
    pub to: PerAxis<f64>,
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
pub struct RunMoves {
    /// The lines that moved, in order.
    pub lines: Vec<LineMoves>,
    /// Everything else.
    pub report: Report,
}

impl LineMoves {
    /// How far the line moved and how long it takes.
    pub fn text(&self, units: Units) -> String {
        let pieces =
            if self.pieces > 1 { format!(" in {} pieces", self.pieces) } else { String::new() };
        let length = units.length_text(self.length_mm);
        let seconds = number_text(self.seconds, 2);
        format!("This line moves {length}{pieces}, {seconds} s.")
    }
}

impl RunMoves {
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

struct MovesByLine {
    /// By line; a line of length zero in `pieces` and no place did not move.
    lines: Vec<Option<LineMoves>>,
}

impl MovesByLine {
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
            to: [0.0; AXES],
            length_mm: 0.0,
            seconds: 0.0,
            pieces: 0,
            cuts: false,
        }))
    }
}

impl RunWatch for MovesByLine {
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

impl EditorProgram {
    /// Runs the text and says what its lines did.
    pub fn ran(&self) -> RunMoves {
        self.ran_by(&self.job())
    }

    /// The same, unless it is given up on the way.
    pub fn ran_unless(&self, interrupt: InterruptCheck) -> Option<RunMoves> {
        let ran = self.ran_by(&self.job().interrupt(interrupt));
        let provided_up = |outcome: &Outcome| outcome.end == EndReason::Interrupted;
        (!ran.report.outcomes.iter().any(provided_up)).then_some(ran)
    }

    fn ran_by(&self, job: &Job) -> RunMoves {
        let mut lines = MovesByLine { lines: Vec::new() };
        let report = job.report_watched(&mut lines);
        RunMoves { lines: lines.lines.into_iter().flatten().collect(), report }
    }
}

//! A run: its path goes out in batches while it is made, then what it came to.

use std::sync::Arc;

use chordal::control::{Command, CommandKind, Side, initial_offset};
use chordal::path::{Frame, PathBuilder};
use chordal::{Job, PathCommand, Segment, Watch};
use chordal_editor::Program;
use serde_json::{Value, json};

use crate::answer;
use crate::columns::Columns;
use crate::live::Outbox;
use crate::modal::ModalTrack;
use crate::wanted::Wanted;

/// Rows of the first batch: soon there, and most programs are no longer.
const FIRST_BATCH: usize = 4_096;

/// Rows of later batches, so that the page is not busy with any one of them for long.
const BATCH: usize = 32_768;

/// Most pieces of path that are sent. What comes after is run and judged, not drawn.
const MOST_ROWS: u32 = 8_000_000;

/// A run that is over, for questions about it.
#[derive(Debug)]
pub struct Ran {
    /// What was run.
    pub program: Arc<Program>,
    /// What was in force where.
    pub modal: ModalTrack,
}

/// Runs a job and sends everything that it shows, and says how long it takes without acceleration,
/// s; `None` when nobody wants it any more.
pub fn run(
    number: u64,
    program: &Arc<Program>,
    job: &Job,
    out: &Outbox,
    wanted: &Wanted,
) -> Option<(Ran, f64)> {
    let (offset, known) = initial_offset(job.machine(), job.control());
    let size = program.text().len();
    let mut sending = Sending {
        number,
        out,
        wanted,
        given_up: false,
        size: size.max(1) as f64,
        rows: Columns::default(),
        contour: Columns::default(),
        sent: 0,
        left_out: 0,
        programmed: PathBuilder::new(job.machine(), offset, known),
        compensated: false,
        modal: ModalTrack::new(job.control(), Frame::new(offset, known)),
    };
    let report = job.report_watched(&mut sending);
    if !wanted.is_wanted() {
        return None;
    }
    sending.send_path(1.0);
    sending.send_contour();
    let Sending { modal, sent, left_out, .. } = sending;
    let mut told = answer::report(&report, job);
    told["type"] = json!("report");
    told["run"] = json!(number);
    told["rows"] = json!(sent);
    told["rows_left_out"] = json!(left_out);
    told["places"] = modal.places();
    told["end"] = end_of(&report.outcomes);
    out.json(&told);
    Some((Ran { program: program.clone(), modal }, report.summary.total_time_s()))
}

/// How the programs of the file ended.
fn end_of(outcomes: &[chordal::Outcome]) -> Value {
    use chordal::control::EndReason;
    let word = |end| match end {
        EndReason::ProgramEnd => "program end",
        EndReason::EndOfText => "end of text",
        EndReason::Repeats => "repeats",
        EndReason::LostJump => "lost jump",
        EndReason::Alarm => "alarm",
        EndReason::Budget => "endless",
        EndReason::Interrupted => "interrupted",
    };
    outcomes
        .iter()
        .map(|outcome| json!({ "end": word(outcome.end), "blocks": outcome.blocks }))
        .collect()
}

/// Sends rows on as they come.
struct Sending<'m> {
    number: u64,
    out: &'m Outbox,
    wanted: &'m Wanted,
    given_up: bool,
    /// Bytes of the program's text.
    size: f64,
    rows: Columns,
    contour: Columns,
    sent: u32,
    left_out: u64,
    programmed: PathBuilder<'m>,
    /// Compensation is on, or about to end with the next move.
    compensated: bool,
    modal: ModalTrack,
}

impl Sending<'_> {
    fn send_path(&mut self, progress: f64) {
        let header = json!({
            "type": "path",
            "run": self.number,
            "first": self.sent - self.rows.rows() as u32,
            "progress": progress,
        });
        let frame = self.rows.take(&header);
        self.out.binary(frame);
    }

    fn send_contour(&mut self) {
        if self.contour.rows() > 0 {
            // In the frame of the path, so that the two lie over each other.
            let header = json!({ "type": "contour", "run": self.number });
            self.out.binary(self.contour.take(&header));
        }
    }

    fn push(&mut self, segment: &Segment, inserted: bool) {
        if self.sent >= MOST_ROWS {
            self.left_out += 1;
            return;
        }
        self.rows.push(segment, inserted);
        self.sent += 1;
        let full = if self.sent as usize <= FIRST_BATCH { FIRST_BATCH } else { BATCH };
        if self.rows.rows() >= full {
            self.given_up = !self.wanted.is_wanted();
            if !self.given_up {
                // Calls and loops go back in the text: the page shows the largest it has seen.
                let at = f64::from(segment.origin.span.range.end) / self.size;
                self.send_path(at.min(1.0));
            }
        }
    }
}

impl Watch for Sending<'_> {
    fn programmed(&mut self, command: &Command) {
        if self.given_up {
            return;
        }
        let was = self.compensated;
        let contour = &mut self.contour;
        let most = MOST_ROWS as usize;
        self.programmed.command(command, |segment| {
            if was && contour.rows() < most {
                contour.push(segment, false);
            }
        });
        match command.kind {
            CommandKind::Compensation { side, .. } => self.compensated = side != Side::Off,
            CommandKind::End => self.compensated = false,
            _ => {}
        }
    }

    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        if self.given_up {
            return;
        }
        self.modal.follow(&path, segments, self.sent);
        segments.iter().for_each(|segment| self.push(segment, path.inserted));
    }
}

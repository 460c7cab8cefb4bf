//! Runs a program: sends its path in batches while it is computed, then its report.

use std::sync::Arc;

use chordal::control::{Command, CommandKind, CompensationSide};
use chordal::path::{PathBuilder, ProgramFrame};
use chordal::{Job, PathCommand, RunWatch, Segment};
use chordal_editor::EditorProgram;
use serde_json::{Value, json};

use crate::answer;
use crate::cancel_token::CancelToken;
use crate::columns::PathRows;
use crate::machine_bodies::machine_bodies;
use crate::modal::ModalTrack;
use crate::outbox::PageOutbox;
use crate::stream::{MAX_ROWS, PathStream};

/// A finished run, for requests about it.
#[derive(Debug)]
pub struct FinishedRun {
    pub program: Arc<EditorProgram>,
    /// The modal state along the path.
    pub modal: ModalTrack,
    /// The number of the run in messages.
    pub number: u64,
    /// The number of path segments, including those that were not sent.
    pub rows: u64,
    /// The duration without acceleration, s.
    pub about_s: f64,
}

/// Runs a job and sends its path. Returns the finished run and its report for the page; `None` when it was canceled.
pub fn run(
    number: u64,
    program: &Arc<EditorProgram>,
    job: &Job,
    out: &PageOutbox,
    cancel: &CancelToken,
) -> Option<(FinishedRun, Value)> {
    let (offset, known) = job.initial_offset();
    let header = json!({ "type": "path", "run": number });
    let rows = PathRows::of(job);
    let mut sending = PathSender {
        number,
        out,
        rows: PathStream::new(header, program.text().len(), rows, out, cancel),
        contour: PathRows::without_power(job),
        programmed: job.path_builder(),
        compensated: false,
        modal: ModalTrack::new(job.configured_control(), ProgramFrame::new(offset, known)),
    };
    let report = job.report_watched(&mut sending);
    if !cancel.is_current() {
        return None;
    }
    sending.rows.send(1.0);
    sending.send_contour();
    let PathSender { modal, rows, .. } = sending;
    let (sent, left_out) = (rows.sent(), rows.left_out());
    let mut message = answer::report(&report, job);
    message["type"] = json!("report");
    message["run"] = json!(number);
    message["rows"] = json!(sent);
    message["rows_left_out"] = json!(left_out);
    message["places"] = modal.places();
    message["bodies"] = machine_bodies(job);
    message["end"] = end_of(&report.outcomes);
    let rows = u64::from(sent) + left_out;
    let about_s = report.summary.total_time_s();
    Some((FinishedRun { program: program.clone(), modal, number, rows, about_s }, message))
}

/// How each program of the file ended.
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
        EndReason::NotRun => "not run",
    };
    outcomes
        .iter()
        .map(|outcome| json!({ "end": word(outcome.end), "blocks": outcome.blocks }))
        .collect()
}

/// Sends the rows of a run while it executes.
struct PathSender<'m> {
    number: u64,
    out: &'m PageOutbox,
    rows: PathStream<'m>,
    contour: PathRows,
    programmed: PathBuilder<'m>,
    /// Whether compensation is on, or ends with the next move.
    compensated: bool,
    modal: ModalTrack,
}

impl PathSender<'_> {
    fn send_contour(&mut self) {
        if self.contour.rows() > 0 {
            // The contour is in the frame of the path, so that both are drawn in the same coordinates.
            let header = json!({ "type": "contour", "run": self.number });
            self.out.binary(self.contour.take(&header));
        }
    }
}

impl RunWatch for PathSender<'_> {
    fn programmed(&mut self, command: &Command) {
        if self.rows.is_canceled() {
            return;
        }
        let was = self.compensated;
        let contour = &mut self.contour;
        let most = MAX_ROWS as usize;
        self.programmed.command(command, |segment| {
            if was && contour.rows() < most {
                contour.push(segment, false);
            }
        });
        match command.kind {
            CommandKind::Compensation { side, .. } => {
                self.compensated = side != CompensationSide::Off
            }
            CommandKind::End => self.compensated = false,
            _ => {}
        }
    }

    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        if self.rows.is_canceled() {
            return;
        }
        self.modal.follow(&path, segments, self.rows.sent());
        segments.iter().for_each(|segment| self.rows.push(segment, path.inserted));
    }
}

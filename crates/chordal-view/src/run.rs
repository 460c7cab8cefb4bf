//! A run: its path goes out in batches while it is made, then what it came to.

use std::sync::Arc;

use chordal::control::{Command, CommandKind, CompensationSide, initial_offset};
use chordal::path::{PathBuilder, ProgramFrame};
use chordal::{Job, PathCommand, RunWatch, Segment};
use chordal_editor::EditorProgram;
use serde_json::{Value, json};

use crate::answer;
use crate::columns::Columns;
use crate::modal::ModalTrack;
use crate::outbox::Outbox;
use crate::stream::{MOST_ROWS, PathStream};
use crate::wanted::Wanted;

/// A run that is over, for questions about it.
#[derive(Debug)]
pub struct Ran {
    /// What was run.
    pub program: Arc<EditorProgram>,
    /// What was active where.
    pub modal: ModalTrack,
    /// Its number.
    pub number: u64,
    /// Pieces of path.
    pub rows: u64,
    /// How long it takes without acceleration, s.
    pub about_s: f64,
}

/// Runs a job and sends its path; gives what else the page is to be reported; `None` when nobody wants it any more.
pub fn run(
    number: u64,
    program: &Arc<EditorProgram>,
    job: &Job,
    out: &Outbox,
    wanted: &Wanted,
) -> Option<(Ran, Value)> {
    let (offset, known) = initial_offset(job.machine(), job.control());
    let header = json!({ "type": "path", "run": number });
    let rows = Columns::new(job.control().parameters.rules.spindle_by_hand);
    let mut sending = Sending {
        number,
        out,
        rows: PathStream::new(header, program.text().len(), rows, out, wanted),
        contour: Columns::default(),
        programmed: job.path_builder(),
        compensated: false,
        modal: ModalTrack::new(job.control(), ProgramFrame::new(offset, known)),
    };
    let report = job.report_watched(&mut sending);
    if !wanted.is_wanted() {
        return None;
    }
    sending.rows.send(1.0);
    sending.send_contour();
    let Sending { modal, rows, .. } = sending;
    let (sent, left_out) = (rows.sent(), rows.left_out());
    let mut told = answer::report(&report, job);
    told["type"] = json!("report");
    told["run"] = json!(number);
    told["rows"] = json!(sent);
    told["rows_left_out"] = json!(left_out);
    told["places"] = modal.places();
    told["end"] = end_of(&report.outcomes);
    let rows = u64::from(sent) + left_out;
    let about_s = report.summary.total_time_s();
    Some((Ran { program: program.clone(), modal, number, rows, about_s }, told))
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
        EndReason::NotRun => "not run",
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
    rows: PathStream<'m>,
    contour: Columns,
    programmed: PathBuilder<'m>,
    /// Compensation is on, or about to end with the next move.
    compensated: bool,
    modal: ModalTrack,
}

impl Sending<'_> {
    fn send_contour(&mut self) {
        if self.contour.rows() > 0 {
            // In the frame of the path, so that the two lie over each other.
            let header = json!({ "type": "contour", "run": self.number });
            self.out.binary(self.contour.take(&header));
        }
    }
}

impl RunWatch for Sending<'_> {
    fn programmed(&mut self, command: &Command) {
        if self.rows.is_given_up() {
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
            CommandKind::Compensation { side, .. } => {
                self.compensated = side != CompensationSide::Off
            }
            CommandKind::End => self.compensated = false,
            _ => {}
        }
    }

    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        if self.rows.is_given_up() {
            return;
        }
        self.modal.follow(&path, segments, self.rows.sent());
        segments.iter().for_each(|segment| self.rows.push(segment, path.inserted));
    }
}

//! Compares the shown program with another one: sends the other path and the differences.

use std::sync::Arc;

use chordal::diagnostics::FileId;
use chordal::{Job, PathCommand, RunWatch, Segment};
use chordal_compare::{
    BlockLocation, BlockRange, Comparison, ComparisonOptions, Difference, compare,
};
use chordal_editor::EditorProgram;
use chordal_export::numbers::SummaryUnits;
use chordal_export::{comparison_headline, comparison_names, difference_words};
use serde_json::{Value, json};

use crate::answer;
use crate::cancel_token::CancelToken;
use crate::columns::PathRows;
use crate::content_hash::ContentHash;
use crate::outbox::PageOutbox;
use crate::program::{ComparedProgram, ProgramRefusal, ProgramSource};
use crate::request::ComparedWith;
use crate::run::FinishedRun;
use crate::stream::PathStream;

/// The most moves of both programs that are compared in a page: each temporarily takes about 350 bytes.
const MAX_COMPARED_MOVES: u64 = 4_000_000;

/// The most characters of a block that are sent.
const MAX_BLOCK_CHARACTERS: usize = 200;

/// The origin of the other program. An equal one is not sent again.
#[derive(Clone, Debug, PartialEq)]
enum ComparedSource {
    File(ContentHash),
    Own { run: u64, on: ComparedWith },
}

/// The other program that the page shows.
struct OpenComparison {
    origin: ComparedSource,
    program: Arc<EditorProgram>,
    version: u64,
    rows: u64,
}

/// Shows the other program and compares it.
pub struct ComparisonSession {
    programs: Arc<dyn ProgramSource>,
    out: PageOutbox,
    shown: Option<OpenComparison>,
    /// Whether the page knows of another program.
    pub is_shown: bool,
}

impl ComparisonSession {
    /// A session that shows no other program yet.
    pub fn new(programs: Arc<dyn ProgramSource>, out: PageOutbox) -> ComparisonSession {
        ComparisonSession { programs, out, shown: None, is_shown: false }
    }

    /// The other program that is shown.
    pub fn program(&self) -> Option<Arc<EditorProgram>> {
        self.shown.as_ref().map(|shown| shown.program.clone())
    }

    /// Removes the other program from the page. `version` is the number of the comparison, as in all messages.
    pub fn clear(&mut self, version: u64) {
        self.shown = None;
        if !std::mem::take(&mut self.is_shown) {
            return;
        }
        self.out.json(&json!({
            "type": "compared_program",
            "version": version,
            "other": ComparedWith::Nothing,
        }));
    }

    /// Shows the other program, unless it is already shown.
    pub fn show(&mut self, finished: &FinishedRun, other: &ComparedWith, cancel: &CancelToken) {
        self.is_shown = true;
        match self.open(finished, other) {
            Ok(None) => {}
            Ok(Some((origin, program))) => {
                self.shown = self.send(origin, Arc::new(program), other, cancel);
            }
            Err(refusal) => {
                self.shown = None;
                self.out.json(&json!({
                    "type": "compared_program_refused",
                    "version": cancel.number,
                    "other": other,
                    "message": refusal.message,
                    "help": refusal.help,
                }));
            }
        }
    }

    /// Compares a run with the other program that is shown, and sends the result.
    pub fn compare(
        &self,
        finished: &FinishedRun,
        other: &ComparedWith,
        tolerance_mm: f64,
        cancel: &CancelToken,
    ) {
        let Some(shown) = self.shown.as_ref().filter(|_| cancel.is_current()) else { return };
        let moves = finished.rows + shown.rows;
        if moves > MAX_COMPARED_MOVES {
            return self.out.json(&json!({
                "type": "no_comparison",
                "run": finished.number,
                "version": shown.version,
                "message": format!(
                    "the two programs have {moves} moves; at most {MAX_COMPARED_MOVES} are compared here; \
                     `chordal compare` has no such limit"
                ),
            }));
        }
        let options = ComparisonOptions { tolerance_mm, ..self.options(other) };
        let jobs =
            [&finished.program, &shown.program].map(|it| it.job().interrupt(cancel.interrupt()));
        let found = compare(&jobs[0], &jobs[1], &options);
        if cancel.is_current() {
            let names = [&finished.program, &shown.program].map(|program| program.name());
            let mut message = comparison(&found, names, [&jobs[0], &jobs[1]], tolerance_mm);
            message["run"] = json!(finished.number);
            message["version"] = json!(shown.version);
            self.out.json(&message);
        }
    }

    fn options(&self, other: &ComparedWith) -> ComparisonOptions {
        let compared = self.programs.compared_program().filter(|_| *other == ComparedWith::Named);
        compared.map(|compared| compared.options.clone()).unwrap_or_default()
    }

    /// Opens the other program; `None` when it is already shown.
    fn open(
        &self,
        finished: &FinishedRun,
        other: &ComparedWith,
    ) -> Result<Option<(ComparedSource, EditorProgram)>, ProgramRefusal> {
        let is_new =
            |origin: &ComparedSource| self.shown.as_ref().is_none_or(|it| it.origin != *origin);
        let named = self.programs.compared_program().filter(|_| *other == ComparedWith::Named);
        if let Some(ComparedProgram { programs, own_text: false, .. }) = named.as_deref() {
            let bytes = programs.read()?;
            let origin = ComparedSource::File(ContentHash::of(&bytes));
            if !is_new(&origin) {
                return Ok(None);
            }
            return Ok(Some((origin, programs.open(bytes, None)?)));
        }
        let origin = ComparedSource::Own { run: finished.number, on: other.clone() };
        if !is_new(&origin) {
            return Ok(None);
        }
        let text = finished.program.text().to_vec();
        let program = match (named, other) {
            (Some(named), _) => named.programs.open(text, None)?,
            (None, ComparedWith::Machine(name)) => self.programs.open(text, name.as_deref())?,
            (None, _) => self.programs.open(text, None)?,
        };
        Ok(Some((origin, program)))
    }

    /// Sends the path of the other program; `None` when canceled.
    fn send(
        &self,
        origin: ComparedSource,
        program: Arc<EditorProgram>,
        other: &ComparedWith,
        cancel: &CancelToken,
    ) -> Option<OpenComparison> {
        let version = cancel.number;
        let job = program.job().interrupt(cancel.interrupt());
        self.out.json(&json!({
            "type": "compared_program",
            "version": version,
            "other": other,
            "own_text": matches!(origin, ComparedSource::Own { .. }),
            "name": program.name(),
            "machine": answer::machine(&job),
            "why": program.setup().why,
        }));
        let header = json!({ "type": "compared_path", "version": version });
        let size = program.text().len();
        let mut rows = PathForwarder(PathStream::new(
            header,
            size,
            PathRows::without_power(&job),
            &self.out,
            cancel,
        ));
        job.report_watched(&mut rows);
        if !cancel.is_current() {
            return None;
        }
        rows.0.send(1.0);
        let PathForwarder(path) = rows;
        let rows = u64::from(path.sent()) + path.left_out();
        self.out.json(&json!({
            "type": "compared_path_end",
            "version": version,
            "rows": path.sent(),
            "rows_left_out": path.left_out(),
        }));
        Some(OpenComparison { origin, program: program.clone(), version, rows })
    }
}

/// Forwards the path of a run and ignores everything else.
struct PathForwarder<'m>(PathStream<'m>);

impl RunWatch for PathForwarder<'_> {
    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        if !self.0.is_canceled() {
            segments.iter().for_each(|segment| self.0.push(segment, path.inserted));
        }
    }
}

/// The message with the result of a comparison.
fn comparison(found: &Comparison, names: [&str; 2], jobs: [&Job; 2], tolerance_mm: f64) -> Value {
    let units = SummaryUnits::of(found.reports[0].summary.inch);
    let called = comparison_names(names, jobs);
    let sides = [0, 1].map(|side: usize| {
        json!({
            "name": called[side],
            "moves": found.moves[side],
            "errors": found.reports[side].counts.errors,
        })
    });
    let differences = found.differences.iter().map(|one| difference(one, jobs, units));
    json!({
        "type": "comparison",
        "verdict": found.verdict,
        "tolerance_mm": tolerance_mm,
        "headline": comparison_headline(found, units, tolerance_mm).trim_end(),
        "max_distance_mm": found.max_distance_mm,
        "farthest": found.farthest.map(|at| json!({
            "places": at.map(place),
            "at_mm": found.farthest_at_mm,
        })),
        "sides": sides,
        "differences": differences.collect::<Vec<Value>>(),
        "dropped": found.dropped,
    })
}

fn difference(one: &Difference, jobs: [&Job; 2], units: SummaryUnits) -> Value {
    let words = difference_words(one, jobs, units);
    let sides = [0, 1].map(|side: usize| {
        let side_words = &words.sides[side];
        json!({
            "blocks": one.blocks[side].as_ref().map(blocks),
            "steps": one.steps[side],
            "value": side_words.value,
            "words": side_words.words.chars().take(MAX_BLOCK_CHARACTERS).collect::<String>(),
            "lacks": side_words.lacks,
        })
    });
    json!({
        "category": one.category,
        "head": words.head,
        "distance_mm": one.distance_mm,
        "at_mm": one.at_mm,
        "sides": sides,
    })
}

fn blocks(at: &BlockRange) -> Value {
    let (from, to) = at.lines();
    json!({ "file": at.first.span.file.0, "from": from, "to": to })
}

fn place(at: BlockLocation) -> Value {
    json!({ "file": at.span.file.0, "line": at.line })
}

/// The lines of the other program around a line, for display.
pub fn text_around(program: &EditorProgram, file: u32, line: u32) -> Value {
    /// The number of lines before and after.
    const CONTEXT_LINES: usize = 2_000;
    const MAX_TEXT_BYTES: usize = 1 << 20;
    let file = FileId(file);
    let text = String::from_utf8_lossy(program.file_text(file));
    let line = line.max(1) as usize;
    let first = line.saturating_sub(CONTEXT_LINES).max(1);
    let mut shown = String::new();
    for each in text.lines().skip(first - 1).take(2 * CONTEXT_LINES) {
        if shown.len() + each.len() > MAX_TEXT_BYTES {
            break;
        }
        shown += each;
        shown.push('\n');
    }
    json!({
        "type": "other_text",
        "file": program.file_name(file),
        "line": line,
        "first_line": first,
        "text": shown,
    })
}

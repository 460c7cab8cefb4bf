//! The other program, which the shown one is compared with: its path, and the differences.

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
use crate::columns::Columns;
use crate::content::Content;
use crate::outbox::Outbox;
use crate::program::{Against, Programs, Refusal};
use crate::request::Other;
use crate::run::Ran;
use crate::stream::PathStream;
use crate::wanted::Wanted;

/// Moves of both programs that are compared in a page: each takes about 350 bytes meanwhile.
const MOST_MOVES: u64 = 4_000_000;

/// Characters of a block that are sent.
const MOST_WORDS: usize = 200;

/// Of what the other program was made: the same need not be sent again.
#[derive(Clone, Debug, PartialEq)]
enum Origin {
    File(Content),
    Own { run: u64, on: Other },
}

/// The other program as the page shows it.
struct Shown {
    origin: Origin,
    program: Arc<EditorProgram>,
    version: u64,
    rows: u64,
}

/// Shows the other program, and says what differs.
pub struct Comparing {
    programs: Arc<dyn Programs>,
    out: Outbox,
    shown: Option<Shown>,
    /// The page was told of another program.
    pub is_told: bool,
}

impl Comparing {
    /// Nothing is shown yet.
    pub fn new(programs: Arc<dyn Programs>, out: Outbox) -> Comparing {
        Comparing { programs, out, shown: None, is_told: false }
    }

    /// The other program that is shown.
    pub fn program(&self) -> Option<Arc<EditorProgram>> {
        self.shown.as_ref().map(|shown| shown.program.clone())
    }

    /// There is no other program any more. `version` is the number of the comparison, here and everywhere.
    pub fn nothing(&mut self, version: u64) {
        self.shown = None;
        if !std::mem::take(&mut self.is_told) {
            return;
        }
        self.out.json(&json!({
            "type": "against",
            "version": version,
            "other": Other::Nothing,
        }));
    }

    /// Shows the other program, where it is another than before.
    pub fn show(&mut self, ran: &Ran, other: &Other, wanted: &Wanted) {
        self.is_told = true;
        match self.open(ran, other) {
            Ok(None) => {}
            Ok(Some((origin, program))) => {
                self.shown = self.send(origin, Arc::new(program), other, wanted);
            }
            Err(refusal) => {
                self.shown = None;
                self.out.json(&json!({
                    "type": "against_refused",
                    "version": wanted.number,
                    "other": other,
                    "message": refusal.message,
                    "help": refusal.help,
                }));
            }
        }
    }

    /// Holds a run against the other program that is shown.
    pub fn compare(&self, ran: &Ran, other: &Other, tolerance_mm: f64, wanted: &Wanted) {
        let Some(shown) = self.shown.as_ref().filter(|_| wanted.is_wanted()) else { return };
        let moves = ran.rows + shown.rows;
        if moves > MOST_MOVES {
            return self.out.json(&json!({
                "type": "no_comparison",
                "run": ran.number,
                "version": shown.version,
                "message": format!(
                    "the two programs have {moves} moves; at most {MOST_MOVES} are compared here; \
                     `chordal compare` has no such limit"
                ),
            }));
        }
        let options = ComparisonOptions { tolerance_mm, ..self.options(other) };
        let jobs = [&ran.program, &shown.program].map(|it| it.job().interrupt(wanted.interrupt()));
        let found = compare(&jobs[0], &jobs[1], &options);
        if wanted.is_wanted() {
            let names = [&ran.program, &shown.program].map(|program| program.name());
            let mut told = comparison(&found, names, [&jobs[0], &jobs[1]], tolerance_mm);
            told["run"] = json!(ran.number);
            told["version"] = json!(shown.version);
            self.out.json(&told);
        }
    }

    fn options(&self, other: &Other) -> ComparisonOptions {
        let against = self.programs.against().filter(|_| *other == Other::Named);
        against.map(|against| against.options.clone()).unwrap_or_default()
    }

    /// The other program; nothing where it is the one that is shown.
    fn open(&self, ran: &Ran, other: &Other) -> Result<Option<(Origin, EditorProgram)>, Refusal> {
        let is_new = |origin: &Origin| self.shown.as_ref().is_none_or(|it| it.origin != *origin);
        let named = self.programs.against().filter(|_| *other == Other::Named);
        if let Some(Against { programs, own_text: false, .. }) = named.as_deref() {
            let bytes = programs.read()?;
            let origin = Origin::File(Content::of(&bytes));
            if !is_new(&origin) {
                return Ok(None);
            }
            return Ok(Some((origin, programs.open(bytes, None)?)));
        }
        let origin = Origin::Own { run: ran.number, on: other.clone() };
        if !is_new(&origin) {
            return Ok(None);
        }
        let text = ran.program.text().to_vec();
        let program = match (named, other) {
            (Some(named), _) => named.programs.open(text, None)?,
            (None, Other::Machine(name)) => self.programs.open(text, name.as_deref())?,
            (None, _) => self.programs.open(text, None)?,
        };
        Ok(Some((origin, program)))
    }

    /// Sends the path; nothing where it is given up.
    fn send(
        &self,
        origin: Origin,
        program: Arc<EditorProgram>,
        other: &Other,
        wanted: &Wanted,
    ) -> Option<Shown> {
        let version = wanted.number;
        let job = program.job().interrupt(wanted.interrupt());
        self.out.json(&json!({
            "type": "against",
            "version": version,
            "other": other,
            "own_text": matches!(origin, Origin::Own { .. }),
            "name": program.name(),
            "machine": answer::machine(&job),
            "why": program.setup().why,
        }));
        let header = json!({ "type": "against_path", "version": version });
        let size = program.text().len();
        let mut rows = Rows(PathStream::new(header, size, Columns::default(), &self.out, wanted));
        job.report_watched(&mut rows);
        if !wanted.is_wanted() {
            return None;
        }
        rows.0.send(1.0);
        let Rows(path) = rows;
        let rows = u64::from(path.sent()) + path.left_out();
        self.out.json(&json!({
            "type": "against_end",
            "version": version,
            "rows": path.sent(),
            "rows_left_out": path.left_out(),
        }));
        Some(Shown { origin, program: program.clone(), version, rows })
    }
}

/// The path alone.
struct Rows<'m>(PathStream<'m>);

impl RunWatch for Rows<'_> {
    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        if !self.0.is_given_up() {
            segments.iter().for_each(|segment| self.0.push(segment, path.inserted));
        }
    }
}

/// What came out, for people.
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
        let told = &words.sides[side];
        json!({
            "blocks": one.blocks[side].as_ref().map(blocks),
            "steps": one.steps[side],
            "value": told.value,
            "words": told.words.chars().take(MOST_WORDS).collect::<String>(),
            "lacks": told.lacks,
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

/// Lines of the other program around one, to be read.
pub fn text_around(program: &EditorProgram, file: u32, line: u32) -> Value {
    /// Lines before and after that are sent.
    const BESIDE: usize = 2_000;
    /// Bytes that are sent.
    const MOST_TEXT: usize = 1 << 20;
    let file = FileId(file);
    let text = String::from_utf8_lossy(program.file_text(file));
    let line = line.max(1) as usize;
    let first = line.saturating_sub(BESIDE).max(1);
    let mut shown = String::new();
    for each in text.lines().skip(first - 1).take(2 * BESIDE) {
        if shown.len() + each.len() > MOST_TEXT {
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

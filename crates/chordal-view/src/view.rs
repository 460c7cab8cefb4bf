//! The state of one page: its text, its machine, and the answers to its requests.
//!
//! | work | does |
//! |---|---|
//! | `Run` | runs the newest text, sends path and diagnostics |
//! | `Plan` | plans the newest run, sends its motion |
//! | `Compare` | compares the newest run with the other program |
//! | `Cut` | cuts the stock with the newest run, sends what is lowered when and what is touched |
//!
//! Work that is no longer the newest of its kind is canceled, so that typing never waits for it. Work of different
//! kinds may run at the same time.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use chordal::stock::StockRunError;
use chordal_editor::EditorProgram;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::cancel_token::CancelToken;
use crate::comparison::{ComparisonSession, text_around};
use crate::content_hash::ContentHash;
use crate::document::EditedText;
use crate::frame::ColumnFrame;
use crate::outbox::PageOutbox;
use crate::program::ProgramSource;
use crate::request::{ChordRequest, ComparedWith, PageRequest, RequestKind};
use crate::run::{FinishedRun, run};
use crate::stock::{DEFAULT_COLUMNS, StockCutting};
use crate::{answer, chords, reading, text_answers, times};

/// The approximate size of the text in one message, bytes, limited because a page processes each message without
/// interruption.
const TEXT_PIECE_BYTES: usize = 1 << 20;

/// The version of the messages between a page and its view. It increases whenever a key or a type is renamed or
/// removed.
const PROTOCOL_VERSION: u32 = 2;

/// A long computation, with a number that shows whether it is the newest of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum WorkItem {
    /// Run the text.
    Run(u64),
    /// Plan the motion of the run of this number.
    Plan(u64),
    /// Compare the newest run with the other program.
    Compare(u64),
    /// Cut the stock with the newest run.
    Cut(u64),
}

impl WorkItem {
    /// Its number among the items of its kind.
    pub fn number(self) -> u64 {
        match self {
            WorkItem::Run(number)
            | WorkItem::Plan(number)
            | WorkItem::Compare(number)
            | WorkItem::Cut(number) => number,
        }
    }
}

/// Receives the work items that the owner of the view must execute.
pub type WorkSink<'w> = &'w mut dyn FnMut(WorkItem);

/// The text of a page, its machine, and the work on them.
pub struct ProgramView {
    pub(crate) programs: Arc<dyn ProgramSource>,
    pub(crate) out: PageOutbox,
    /// The number of the newest run; older ones are canceled.
    pub(crate) newest_run: Arc<AtomicU64>,
    /// The number of the newest comparison; older ones are canceled.
    pub(crate) newest_comparison: Arc<AtomicU64>,
    /// The number of the newest stock; older ones are canceled.
    pub(crate) newest_stock: Arc<AtomicU64>,
    closed: Arc<AtomicBool>,
    pub(crate) state: Mutex<PageState>,
    pub(crate) comparison: Mutex<ComparisonSession>,
}

pub(crate) struct PageState {
    pub(crate) document: EditedText,
    /// The number of changes of the text so far.
    edits: u64,
    /// The content of the file when it was last read or written.
    on_disk: ContentHash,
    pub(crate) machine: Option<String>,
    /// The program of the newest run, with its machine.
    pub(crate) opened: Option<Arc<EditorProgram>>,
    /// The current text as a program, for requests about its words; `None` after each change.
    pub(crate) text_program: Option<Arc<EditorProgram>>,
    pub(crate) finished_run: Option<Arc<FinishedRun>>,
    /// The newest run, when views in other workers do the work ([`crate::WorkOrder`]); `None` when this view does it.
    pub(crate) remote_run: Option<RemoteRun>,
    /// The other program of the comparison.
    pub(crate) other: ComparedWith,
    /// The distance within which paths are equal, mm.
    pub(crate) tolerance_mm: f64,
    /// The approximate number of columns of the stock.
    pub(crate) columns: u32,
    /// The other program that is shown; `None` without one.
    compared_program: Option<Arc<EditorProgram>>,
}

/// The report of a run by a view in another worker.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct RemoteRun {
    /// The number of the run in messages.
    pub number: u64,
    /// The number of path segments, including those that were not sent.
    pub rows: u64,
    /// The duration without acceleration, s; `None` when it is not finite.
    pub about_s: Option<f64>,
    /// Whether the machine's setup or a comment of the program defines a stock.
    pub stock: bool,
}

impl RemoteRun {
    /// The report of a finished run.
    pub fn of(finished: &FinishedRun) -> RemoteRun {
        RemoteRun {
            number: finished.number,
            rows: finished.rows,
            about_s: Some(finished.about_s).filter(|seconds| seconds.is_finite()),
            stock: finished.program.job().has_stock(),
        }
    }
}

impl PageState {
    /// Selects another machine, and the previous one for comparison. There is no comparison with it when the command
    /// line names another program to compare with, nor when the machine answers the question about the reading,
    /// because the previous one was only assumed.
    fn run_on(&mut self, machine: Option<String>, is_answer: bool) {
        let before = std::mem::replace(&mut self.machine, machine);
        if self.other != ComparedWith::Named && !is_answer {
            self.other = ComparedWith::Machine(before);
        }
    }
}

impl ProgramView {
    /// A view of a program that is not read yet.
    pub fn new(programs: Arc<dyn ProgramSource>, out: PageOutbox) -> ProgramView {
        let compared = programs.compared_program();
        let state = PageState {
            document: EditedText::read(b""),
            edits: 0,
            on_disk: ContentHash::of(b""),
            machine: None,
            opened: None,
            text_program: None,
            finished_run: None,
            remote_run: None,
            other: if compared.is_some() { ComparedWith::Named } else { ComparedWith::Nothing },
            tolerance_mm: compared.as_ref().map_or(0.0, |compared| compared.options.tolerance_mm),
            columns: DEFAULT_COLUMNS,
            compared_program: None,
        };
        ProgramView {
            comparison: Mutex::new(ComparisonSession::new(programs.clone(), out.clone())),
            programs,
            out,
            newest_run: Arc::default(),
            newest_comparison: Arc::default(),
            newest_stock: Arc::default(),
            closed: Arc::default(),
            state: Mutex::new(state),
        }
    }

    /// Sends the page a `hello`, reads the file and requests its run. After `true` the caller must call
    /// [`ProgramView::send_text`]; `false` means that the file cannot be read.
    pub fn begin(&self, want: WorkSink<'_>) -> bool {
        self.send_hello();
        self.read(0, want)
    }

    /// Cancels all work because the page was closed.
    pub fn close(&self) {
        self.closed.store(true, Ordering::Relaxed);
    }

    /// Whether the page was closed.
    pub fn is_closed(&self) -> bool {
        self.closed.load(Ordering::Relaxed)
    }

    /// The outbox for answers and columns.
    pub fn out(&self) -> &PageOutbox {
        &self.out
    }

    /// Executes a work item unless it is outdated; passes follow-up work to `want`.
    pub fn work(&self, work: WorkItem, want: WorkSink<'_>) {
        match work {
            WorkItem::Run(number) => self.run(number, want),
            WorkItem::Plan(number) => self.plan(number),
            WorkItem::Compare(number) => self.compare_now(number),
            WorkItem::Cut(number) => self.cut_now(number),
        }
    }

    /// Whether the content of the file differs from when it was last read or written.
    pub fn is_changed(&self, bytes: &[u8]) -> bool {
        ContentHash::of(bytes) != self.state().on_disk
    }

    /// Requests a new comparison because the file of the other program has changed.
    pub fn other_changed(&self, want: WorkSink<'_>) {
        if self.state().other == ComparedWith::Named {
            self.compare(want);
        }
    }

    pub(crate) fn state(&self) -> MutexGuard<'_, PageState> {
        // After a panic the state is still consistent: no statement that may panic leaves it half changed.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The current text as a program, for requests about its words; `None` before the first run.
    fn text_program(&self) -> Option<Arc<EditorProgram>> {
        let mut state = self.state();
        if state.text_program.is_none() {
            let text = state.document.text().as_bytes().to_vec();
            if let Some(opened) = &state.opened {
                state.text_program = Some(Arc::new(opened.with_text(text)));
            } else if state.remote_run.is_some() {
                // The worker that runs the program reports why it cannot be opened.
                let opened = self.programs.open(text, state.machine.as_deref()).ok().map(Arc::new);
                (state.opened, state.text_program) = (opened.clone(), opened);
            }
        }
        state.text_program.clone()
    }

    fn answer_about_text(&self, id: u64, answer_of: impl FnOnce(&EditorProgram) -> Value) {
        let Some(program) = self.text_program() else {
            return self.out.refuse(id, "no program has run yet", None);
        };
        let mut reply = answer_of(&program);
        reply["id"] = json!(id);
        self.out.json(&reply);
    }

    fn cancel_token(&self, newest: &Arc<AtomicU64>, number: u64) -> CancelToken {
        CancelToken { newest: newest.clone(), closed: self.closed.clone(), number }
    }

    fn send_hello(&self) {
        let machines = self.programs.machines();
        let machines: Vec<_> = machines
            .iter()
            .map(|machine| json!({ "name": machine.name, "title": machine.title }))
            .collect();
        let compared = self.programs.compared_program().map(|compared| compared.to_json());
        self.out.json(&json!({
            "type": "hello",
            "protocol": PROTOCOL_VERSION,
            "name": self.programs.name(),
            "writable": self.programs.is_writable(),
            "machines": machines,
            "compared": compared,
            "tolerance_mm": self.state().tolerance_mm,
        }));
    }

    /// Answers a request immediately; passes follow-up work to `want`.
    pub fn answer(&self, request: PageRequest, want: WorkSink<'_>) {
        let id = request.id;
        match request.kind {
            RequestKind::Edit { changes } => {
                let applied = {
                    let mut state = self.state();
                    state.text_program = None;
                    state.edits += 1;
                    state.document.apply(&changes)
                };
                match applied {
                    Ok(()) => self.start(want),
                    Err(error) => {
                        self.out.refuse(id, &error.to_string(), Some("the text is sent again"));
                        self.send_text();
                    }
                }
            }
            RequestKind::Machine { name, is_answer } => {
                self.state().run_on(name, is_answer);
                self.start(want);
            }
            RequestKind::CompareWith { other } => self.compare_with(id, other, want),
            RequestKind::Tolerance { tolerance_mm } => self.tolerance(id, tolerance_mm, want),
            RequestKind::Stock { columns } => {
                self.state().columns = columns;
                self.cut(want);
            }
            RequestKind::OtherText { file, line } => {
                let Some(compared) = self.state().compared_program.clone() else {
                    return self.out.refuse(id, "there is no other program", None);
                };
                let mut reply = text_around(&compared, file, line);
                reply["id"] = json!(id);
                self.out.json(&reply);
            }
            RequestKind::Chords(request) => self.chords(id, &request),
            RequestKind::State { done, line } => {
                let finished = self.state().finished_run.clone();
                let mut state = finished.map(|finished| finished.modal.at(done, line));
                let after = self.text_program().and_then(|program| program.modal_after(line));
                if let (Some(state), Some(after)) = (&mut state, after) {
                    state["codes"] = json!(after.codes);
                }
                self.out.json(&json!({ "type": "state", "id": id, "state": state }));
            }
            RequestKind::Tokens { from, to } => {
                self.answer_about_text(id, |program| text_answers::tokens(program, from, to));
            }
            RequestKind::Hover { line, column } => {
                self.answer_about_text(id, |program| text_answers::hover(program, line, column));
            }
            RequestKind::Definition { line, column } => {
                self.answer_about_text(id, |program| {
                    text_answers::definition(program, line, column)
                });
            }
            RequestKind::Outline => self.answer_about_text(id, text_answers::outline),
            RequestKind::Save { force } => self.save(id, force),
            RequestKind::Reload => self.load(id, want),
        }
    }

    /// Requests the next run and cancels the previous one.
    fn start(&self, want: WorkSink<'_>) {
        let number = self.newest_run.fetch_add(1, Ordering::Relaxed) + 1;
        // A current comparison or stock is outdated as well; the new run requests the next ones.
        self.newest_comparison.fetch_add(1, Ordering::Relaxed);
        self.newest_stock.fetch_add(1, Ordering::Relaxed);
        want(WorkItem::Run(number));
    }

    /// Requests the next comparison and cancels the previous one.
    fn compare(&self, want: WorkSink<'_>) {
        let number = self.newest_comparison.fetch_add(1, Ordering::Relaxed) + 1;
        want(WorkItem::Compare(number));
    }

    /// Requests the next stock and cancels the previous one.
    fn cut(&self, want: WorkSink<'_>) {
        let number = self.newest_stock.fetch_add(1, Ordering::Relaxed) + 1;
        want(WorkItem::Cut(number));
    }

    /// Changes the other program of the comparison, or ends comparing.
    fn compare_with(&self, id: u64, other: ComparedWith, want: WorkSink<'_>) {
        if other == ComparedWith::Named && self.programs.compared_program().is_none() {
            let help = Some("start `chordal view` with --against to name one");
            return self.out.refuse(id, "the command line names no other program", help);
        }
        self.state().other = other;
        self.compare(want);
    }

    fn tolerance(&self, id: u64, tolerance_mm: f64, want: WorkSink<'_>) {
        if !(tolerance_mm >= 0.0 && tolerance_mm.is_finite()) {
            let message = format!("{tolerance_mm} mm is not a tolerance");
            return self.out.refuse(id, &message, Some("give a length of zero or more"));
        }
        self.state().tolerance_mm = tolerance_mm;
        self.compare(want);
    }

    /// Reads the file and requests its run; `false` when it cannot be read.
    fn read(&self, id: u64, want: WorkSink<'_>) -> bool {
        let bytes = match self.programs.read() {
            Ok(bytes) => bytes,
            Err(refusal) => {
                self.out.refuse(id, &refusal.message, refusal.help.as_deref());
                return false;
            }
        };
        {
            let mut state = self.state();
            state.document = EditedText::read(&bytes);
            state.on_disk = ContentHash::of(&bytes);
            state.text_program = None;
            state.edits += 1;
        }
        self.start(want);
        true
    }

    /// Reads the file again and sends its text.
    fn load(&self, id: u64, want: WorkSink<'_>) {
        // The run is requested first, so that its path is computed while the text is transferred.
        if self.read(id, want) {
            self.send_text();
        }
    }

    /// Sends the text to the page in pieces of about a megabyte.
    pub fn send_text(&self) {
        let (text, mixed, binary) = {
            let state = self.state();
            let document = &state.document;
            (document.text().to_string(), document.form().mixed, document.binary)
        };
        let mut rest = text.as_str();
        loop {
            let is_first = rest.len() == text.len();
            let mut end = rest.len().min(TEXT_PIECE_BYTES);
            while !rest.is_char_boundary(end) {
                end += 1;
            }
            let (piece, more) = rest.split_at(end);
            let mut frame = ColumnFrame::default();
            frame.column("text", piece.as_bytes());
            let message = frame.finish(json!({
                "type": "text",
                "first": is_first,
                "last": more.is_empty(),
                "mixed_endings": mixed,
                "binary": binary,
            }));
            match is_first && more.is_empty() {
                true => self.out.binary(message),
                false => self.out.binary_later(message),
            }
            rest = more;
            if rest.is_empty() {
                return;
            }
        }
    }

    fn save(&self, id: u64, force: bool) {
        if !self.programs.is_writable() {
            return self.out.refuse(
                id,
                "the program came from standard input: there is no file to write",
                None,
            );
        }
        let mut state = self.state();
        if state.document.binary {
            return self.out.refuse(
                id,
                "the file holds binary data, not an NC program: it is not written",
                None,
            );
        }
        let bytes = match state.document.bytes() {
            Ok(bytes) => bytes,
            Err(error) => {
                return self.out.refuse(
                    id,
                    &error.to_string(),
                    Some("remove that character, then save"),
                );
            }
        };
        let now = self.programs.read().ok().map(|bytes| ContentHash::of(&bytes));
        if !force && now.is_some_and(|now| now != state.on_disk) {
            self.out.json(&json!({ "type": "conflict", "id": id }));
            return;
        }
        match self.programs.write(&bytes) {
            Ok(()) => {
                state.on_disk = ContentHash::of(&bytes);
                self.out.json(&json!({ "type": "saved", "id": id }));
            }
            Err(refusal) => self.out.refuse(id, &refusal.message, refusal.help.as_deref()),
        }
    }

    fn chords(&self, id: u64, request: &ChordRequest) {
        let Some(finished) = self.state().finished_run.clone() else {
            return self.out.refuse(id, "no program has run yet", None);
        };
        match chords::chords(&finished.program.job(), request) {
            Ok(frame) => self.out.binary(frame),
            Err(error) => {
                self.out.refuse(id, &error.to_string(), Some("give a tolerance above zero"))
            }
        }
    }

    fn run(&self, number: u64, want: WorkSink<'_>) {
        let cancel = self.cancel_token(&self.newest_run, number);
        if !cancel.is_current() {
            return;
        }
        let (text, machine, edits) = {
            let state = self.state();
            (state.document.text().as_bytes().to_vec(), state.machine.clone(), state.edits)
        };
        let program = match self.programs.open(text, machine.as_deref()) {
            Ok(program) => Arc::new(program),
            Err(refusal) => {
                return self.out.json(&json!({
                    "type": "refused",
                    "run": number,
                    "message": refusal.message,
                    "help": refusal.help,
                }));
            }
        };
        {
            let mut state = self.state();
            state.opened = Some(program.clone());
            state.text_program = (state.edits == edits).then(|| program.clone());
        }
        if let Some(reply) = self.run_one(number, &program, &cancel) {
            self.run_finished(reply, want);
        }
    }

    /// Runs the program and sends its report; `None` when the run was canceled.
    fn run_one(
        &self,
        number: u64,
        program: &Arc<EditorProgram>,
        cancel: &CancelToken,
    ) -> Option<RemoteRun> {
        let job = program.job().interrupt(cancel.interrupt());
        self.out.json(&json!({
            "type": "run",
            "run": number,
            "machine": answer::machine(&job),
            "why": program.setup().why,
            "readings": reading::question(program.setup().readings.as_ref(), job.sources()),
        }));
        let (finished, reply) = run(number, program, &job, &self.out, cancel)?;
        let about = RemoteRun::of(&finished);
        // Stored before the report is sent, because the page may then send requests about the run.
        self.state().finished_run = Some(Arc::new(finished));
        self.out.json(&reply);
        if !about.stock {
            self.out.json(&answer::no_stock(number, &StockRunError::NoStock));
        }
        Some(about)
    }

    /// Requests the work that follows a run.
    pub(crate) fn run_finished(&self, about: RemoteRun, want: WorkSink<'_>) {
        if self.state().other != ComparedWith::Nothing {
            self.compare(want);
        }
        if about.stock {
            self.cut(want);
        }
        want(WorkItem::Plan(about.number));
    }

    fn compare_now(&self, number: u64) {
        let cancel = self.cancel_token(&self.newest_comparison, number);
        let (finished, other, tolerance_mm) = {
            let state = self.state();
            (state.finished_run.clone(), state.other.clone(), state.tolerance_mm)
        };
        let mut comparing = self.comparison.lock().unwrap_or_else(PoisonError::into_inner);
        if other == ComparedWith::Nothing {
            self.state().compared_program = None;
            return comparing.clear(number);
        }
        let Some(finished) = finished.filter(|_| cancel.is_current()) else { return };
        // The other program is stored after its path is sent; until then requests about its text are refused.
        comparing.show(&finished, &other, &cancel);
        self.state().compared_program = comparing.program();
        comparing.compare(&finished, &other, tolerance_mm, &cancel);
    }

    fn plan(&self, number: u64) {
        let cancel = self.cancel_token(&self.newest_run, number);
        let finished =
            self.state().finished_run.clone().filter(|finished| finished.number == number);
        let Some(finished) = finished.filter(|_| cancel.is_current()) else { return };
        let job = finished.program.job().interrupt(cancel.interrupt());
        match times::times(number, &job, &finished, &cancel) {
            Ok(Some((frame, reply))) => {
                self.out.binary(frame);
                self.out.json(&reply);
            }
            Ok(None) => {}
            Err(error) => self.out.json(&json!({
                "type": "no_times",
                "run": number,
                "message": error.to_string(),
            })),
        }
    }

    fn cut_now(&self, number: u64) {
        let cancel = self.cancel_token(&self.newest_stock, number);
        let (finished, columns) = {
            let state = self.state();
            (state.finished_run.clone(), state.columns)
        };
        if let Some(finished) = finished.filter(|_| cancel.is_current()) {
            StockCutting::new(&finished, columns).run(&*self.programs, &self.out, &cancel);
        }
    }
}

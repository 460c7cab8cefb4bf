//! What one page shows: its text, its machine, and the answers to what it asks.
//!
//! | work | does |
//! |---|---|
//! | `Run` | runs the newest text, sends path and diagnostics |
//! | `Plan` | plans the newest run, sends its motion |
//! | `Compare` | compares the newest run with the other program |
//! | `Cut` | cuts the stock with the newest run, sends what is lowered when and what is touched |
//!
//! Work that is no longer the newest of its kind is given up, so that typing never waits for it. Different kinds may be
//! done at the same time.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use chordal::stock::StockRunError;
use chordal_editor::EditorProgram;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::content::Content;
use crate::document::Document;
use crate::frame::Frame;
use crate::other::{Comparing, text_around};
use crate::outbox::Outbox;
use crate::program::Programs;
use crate::request::{Ask, AskedChords, Other, Request};
use crate::run::{Ran, run};
use crate::stock::{Cutting, USUAL_COLUMNS};
use crate::wanted::Wanted;
use crate::{answer, chords, reading, times, words};

/// Bytes of text that are sent in one message, about: a page is busy with each without a break.
const TEXT_PIECE: usize = 1 << 20;

/// What takes long, and the number that says whether it is the newest of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Work {
    /// The text is run.
    Run(u64),
    /// The run of this number is planned.
    Plan(u64),
    /// The newest run is compared with the other program.
    Compare(u64),
    /// The newest run cuts the stock.
    Cut(u64),
}

impl Work {
    /// Its number among those of its kind.
    pub fn number(self) -> u64 {
        match self {
            Work::Run(number) | Work::Plan(number) | Work::Compare(number) | Work::Cut(number) => {
                number
            }
        }
    }
}

/// Takes work that is to be done, by whoever holds the view.
pub type Want<'w> = &'w mut dyn FnMut(Work);

/// A page's text, machine and questions.
pub struct View {
    pub(crate) programs: Arc<dyn Programs>,
    pub(crate) out: Outbox,
    /// The number of the newest run that somebody wants.
    pub(crate) newest: Arc<AtomicU64>,
    /// The number of the newest comparison that somebody wants.
    pub(crate) compared: Arc<AtomicU64>,
    /// The number of the newest stock that somebody wants.
    pub(crate) stocked: Arc<AtomicU64>,
    over: Arc<AtomicBool>,
    pub(crate) held: Mutex<Held>,
    pub(crate) comparing: Mutex<Comparing>,
}

pub(crate) struct Held {
    pub(crate) document: Document,
    /// How often its text has changed.
    edits: u64,
    /// What the file held when it was last read or written.
    on_disk: Content,
    pub(crate) machine: Option<String>,
    /// What was opened last; it decides the machine.
    pub(crate) opened: Option<Arc<EditorProgram>>,
    /// The text as an editor asks of it, until it changes.
    pub(crate) words: Option<Arc<EditorProgram>>,
    pub(crate) ran: Option<Arc<Ran>>,
    /// The work is done by views elsewhere ([`crate::Handed`]): what is known of the newest run.
    pub(crate) elsewhere: Option<RanElsewhere>,
    /// What the program is compared with.
    pub(crate) other: Other,
    /// What the two paths may be apart, mm.
    pub(crate) tolerance_mm: f64,
    /// Columns of the stock, about.
    pub(crate) columns: u32,
    /// The other program as it is shown.
    beside: Option<Arc<EditorProgram>>,
}

/// A run that another view has done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct RanElsewhere {
    /// Its number.
    pub number: u64,
    /// Pieces of path.
    pub rows: u64,
    /// How long it takes without acceleration, s, where that is a number.
    pub about_s: Option<f64>,
    /// The machine's setup or a comment of the program has a stock.
    pub stock: bool,
}

impl RanElsewhere {
    /// Of a run.
    pub fn of(ran: &Ran) -> RanElsewhere {
        RanElsewhere {
            number: ran.number,
            rows: ran.rows,
            about_s: Some(ran.about_s).filter(|seconds| seconds.is_finite()),
            stock: ran.program.job().has_stock(),
        }
    }
}

impl Held {
    /// Runs on another machine, and is compared with the one before unless the command line names what to hold
    /// it against, or the machine answers as what the program is read: the one before was only assumed.
    fn run_on(&mut self, machine: Option<String>, is_answer: bool) {
        let before = std::mem::replace(&mut self.machine, machine);
        if self.other != Other::Named && !is_answer {
            self.other = Other::Machine(before);
        }
    }
}

impl View {
    /// A view of a program that was not read yet.
    pub fn new(programs: Arc<dyn Programs>, out: Outbox) -> View {
        let against = programs.against();
        let held = Held {
            document: Document::read(b""),
            edits: 0,
            on_disk: Content::of(b""),
            machine: None,
            opened: None,
            words: None,
            ran: None,
            elsewhere: None,
            other: if against.is_some() { Other::Named } else { Other::Nothing },
            tolerance_mm: against.as_ref().map_or(0.0, |against| against.options.tolerance_mm),
            columns: USUAL_COLUMNS,
            beside: None,
        };
        View {
            comparing: Mutex::new(Comparing::new(programs.clone(), out.clone())),
            programs,
            out,
            newest: Arc::default(),
            compared: Arc::default(),
            stocked: Arc::default(),
            over: Arc::default(),
            held: Mutex::new(held),
        }
    }

    /// Introduces itself and reads the file, whose run is wanted; then [`View::send_text`] is due, unless it cannot be read.
    pub fn begin(&self, want: Want<'_>) -> bool {
        self.tell_hello();
        self.read(0, want)
    }

    /// The page has gone: whatever is done for it is given up.
    pub fn end(&self) {
        self.over.store(true, Ordering::Relaxed);
    }

    /// Nobody waits for an answer any more.
    pub fn is_over(&self) -> bool {
        self.over.load(Ordering::Relaxed)
    }

    /// Where answers and columns go.
    pub fn out(&self) -> &Outbox {
        &self.out
    }

    /// Does what takes long, unless nobody wants it any more; says what is to be done next.
    pub fn work(&self, work: Work, want: Want<'_>) {
        match work {
            Work::Run(number) => self.run(number, want),
            Work::Plan(number) => self.plan(number),
            Work::Compare(number) => self.compare_now(number),
            Work::Cut(number) => self.cut_now(number),
        }
    }

    /// The file holds something else than was read or written last.
    pub fn is_changed(&self, bytes: &[u8]) -> bool {
        Content::of(bytes) != self.held().on_disk
    }

    /// The file of the other program holds something else.
    pub fn other_changed(&self, want: Want<'_>) {
        if self.held().other == Other::Named {
            self.compare(want);
        }
    }

    pub(crate) fn held(&self) -> MutexGuard<'_, Held> {
        // Nothing is left half done where a panic could strike.
        self.held.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The text as an editor asks of it; `None` before the first run.
    fn words(&self) -> Option<Arc<EditorProgram>> {
        let mut held = self.held();
        if held.words.is_none() {
            let text = held.document.text().as_bytes().to_vec();
            if let Some(opened) = &held.opened {
                held.words = Some(Arc::new(opened.with_text(text)));
            } else if held.elsewhere.is_some() {
                // Why a program cannot be opened was said elsewhere.
                let opened = self.programs.open(text, held.machine.as_deref()).ok().map(Arc::new);
                (held.opened, held.words) = (opened.clone(), opened);
            }
        }
        held.words.clone()
    }

    fn answer_words(&self, id: u64, tell: impl FnOnce(&EditorProgram) -> Value) {
        let Some(program) = self.words() else {
            return self.out.refuse(id, "no program has run yet", None);
        };
        let mut told = tell(&program);
        told["id"] = json!(id);
        self.out.json(&told);
    }

    fn wanted(&self, newest: &Arc<AtomicU64>, number: u64) -> Wanted {
        Wanted { newest: newest.clone(), over: self.over.clone(), number }
    }

    fn tell_hello(&self) {
        let machines = self.programs.machines();
        let machines: Vec<_> = machines
            .iter()
            .map(|machine| json!({ "name": machine.name, "title": machine.title }))
            .collect();
        let against = self.programs.against().map(|against| against.told());
        self.out.json(&json!({
            "type": "hello",
            "name": self.programs.name(),
            "writable": self.programs.is_writable(),
            "machines": machines,
            "against": against,
            "tolerance_mm": self.held().tolerance_mm,
        }));
    }

    /// Answers a request, at once; says what is to be done for it.
    pub fn answer(&self, request: Request, want: Want<'_>) {
        let id = request.id;
        match request.ask {
            Ask::Edit { changes } => {
                let applied = {
                    let mut held = self.held();
                    held.words = None;
                    held.edits += 1;
                    held.document.apply(&changes)
                };
                match applied {
                    Ok(()) => self.start(want),
                    Err(error) => {
                        self.out.refuse(id, &error.to_string(), Some("the text is sent again"));
                        self.send_text();
                    }
                }
            }
            Ask::Machine { name, is_answer } => {
                self.held().run_on(name, is_answer);
                self.start(want);
            }
            Ask::Against { other } => self.against(id, other, want),
            Ask::Tolerance { tolerance_mm } => self.tolerance(id, tolerance_mm, want),
            Ask::Stock { columns } => {
                self.held().columns = columns;
                self.cut(want);
            }
            Ask::OtherText { file, line } => {
                let Some(beside) = self.held().beside.clone() else {
                    return self.out.refuse(id, "there is no other program", None);
                };
                let mut told = text_around(&beside, file, line);
                told["id"] = json!(id);
                self.out.json(&told);
            }
            Ask::Chords(asked) => self.chords(id, &asked),
            Ask::State { done, line } => {
                let ran = self.held().ran.clone();
                let mut state = ran.map(|ran| ran.modal.at(done, line));
                let behind = self.words().and_then(|program| program.modal_after(line));
                if let (Some(state), Some(behind)) = (&mut state, behind) {
                    state["codes"] = json!(behind.codes);
                }
                self.out.json(&json!({ "type": "state", "id": id, "state": state }));
            }
            Ask::Tokens { from, to } => {
                self.answer_words(id, |program| words::tokens(program, from, to));
            }
            Ask::Hover { line, column } => {
                self.answer_words(id, |program| words::hover(program, line, column));
            }
            Ask::Definition { line, column } => {
                self.answer_words(id, |program| words::definition(program, line, column));
            }
            Ask::Outline => self.answer_words(id, words::outline),
            Ask::Save { force } => self.save(id, force),
            Ask::Reload => self.load(id, want),
        }
    }

    /// The next run is wanted, and none before it.
    fn start(&self, want: Want<'_>) {
        let number = self.newest.fetch_add(1, Ordering::Relaxed) + 1;
        // What is compared now is of the text before; the run asks for the next.
        self.compared.fetch_add(1, Ordering::Relaxed);
        self.stocked.fetch_add(1, Ordering::Relaxed);
        want(Work::Run(number));
    }

    /// The next comparison is wanted, and none before it.
    fn compare(&self, want: Want<'_>) {
        let number = self.compared.fetch_add(1, Ordering::Relaxed) + 1;
        want(Work::Compare(number));
    }

    /// The next stock is wanted, and none before it.
    fn cut(&self, want: Want<'_>) {
        let number = self.stocked.fetch_add(1, Ordering::Relaxed) + 1;
        want(Work::Cut(number));
    }

    /// Another program, or none, is to be shown, too.
    fn against(&self, id: u64, other: Other, want: Want<'_>) {
        if other == Other::Named && self.programs.against().is_none() {
            let help = Some("start `chordal view` with --against to name one");
            return self.out.refuse(id, "the command line names no other program", help);
        }
        self.held().other = other;
        self.compare(want);
    }

    fn tolerance(&self, id: u64, tolerance_mm: f64, want: Want<'_>) {
        if !(tolerance_mm >= 0.0 && tolerance_mm.is_finite()) {
            let message = format!("{tolerance_mm} mm is not a tolerance");
            return self.out.refuse(id, &message, Some("give a length of zero or more"));
        }
        self.held().tolerance_mm = tolerance_mm;
        self.compare(want);
    }

    /// Reads the file and has it run.
    fn read(&self, id: u64, want: Want<'_>) -> bool {
        let bytes = match self.programs.read() {
            Ok(bytes) => bytes,
            Err(refusal) => {
                self.out.refuse(id, &refusal.message, refusal.help.as_deref());
                return false;
            }
        };
        {
            let mut held = self.held();
            held.document = Document::read(&bytes);
            held.on_disk = Content::of(&bytes);
            held.words = None;
            held.edits += 1;
        }
        self.start(want);
        true
    }

    /// Reads the file again and sends its text.
    fn load(&self, id: u64, want: Want<'_>) {
        // The run first: its picture is made while the text goes over.
        if self.read(id, want) {
            self.send_text();
        }
    }

    /// Sends the text.
    pub fn send_text(&self) {
        let (text, mixed, binary) = {
            let held = self.held();
            let document = &held.document;
            (document.text().to_string(), document.form().mixed, document.binary)
        };
        let mut rest = text.as_str();
        loop {
            let is_first = rest.len() == text.len();
            let mut end = rest.len().min(TEXT_PIECE);
            while !rest.is_char_boundary(end) {
                end += 1;
            }
            let (piece, more) = rest.split_at(end);
            let mut frame = Frame::default();
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
        let mut held = self.held();
        if held.document.binary {
            return self.out.refuse(
                id,
                "the file holds binary data, not an NC program: it is not written",
                None,
            );
        }
        let bytes = match held.document.bytes() {
            Ok(bytes) => bytes,
            Err(error) => {
                return self.out.refuse(
                    id,
                    &error.to_string(),
                    Some("remove that character, then save"),
                );
            }
        };
        let now = self.programs.read().ok().map(|bytes| Content::of(&bytes));
        if !force && now.is_some_and(|now| now != held.on_disk) {
            self.out.json(&json!({ "type": "conflict", "id": id }));
            return;
        }
        match self.programs.write(&bytes) {
            Ok(()) => {
                held.on_disk = Content::of(&bytes);
                self.out.json(&json!({ "type": "saved", "id": id }));
            }
            Err(refusal) => self.out.refuse(id, &refusal.message, refusal.help.as_deref()),
        }
    }

    fn chords(&self, id: u64, asked: &AskedChords) {
        let Some(ran) = self.held().ran.clone() else {
            return self.out.refuse(id, "no program has run yet", None);
        };
        match chords::chords(&ran.program.job(), asked) {
            Ok(frame) => self.out.binary(frame),
            Err(error) => {
                self.out.refuse(id, &error.to_string(), Some("give a tolerance above zero"))
            }
        }
    }

    fn run(&self, number: u64, want: Want<'_>) {
        let wanted = self.wanted(&self.newest, number);
        if !wanted.is_wanted() {
            return;
        }
        let (text, machine, edits) = {
            let held = self.held();
            (held.document.text().as_bytes().to_vec(), held.machine.clone(), held.edits)
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
            let mut held = self.held();
            held.opened = Some(program.clone());
            held.words = (held.edits == edits).then(|| program.clone());
        }
        if let Some(told) = self.run_one(number, &program, &wanted) {
            self.ran(told, want);
        }
    }

    /// Runs and reports, where the run was not given up.
    fn run_one(
        &self,
        number: u64,
        program: &Arc<EditorProgram>,
        wanted: &Wanted,
    ) -> Option<RanElsewhere> {
        let job = program.job().interrupt(wanted.interrupt());
        self.out.json(&json!({
            "type": "run",
            "run": number,
            "machine": answer::machine(&job),
            "why": program.setup().why,
            "readings": reading::question(program.setup().readings.as_ref(), job.sources()),
        }));
        let (ran, told) = run(number, program, &job, &self.out, wanted)?;
        let about = RanElsewhere::of(&ran);
        // Whoever knows of the run may ask about it.
        self.held().ran = Some(Arc::new(ran));
        self.out.json(&told);
        if !about.stock {
            self.out.json(&answer::no_stock(number, &StockRunError::NoStock));
        }
        Some(about)
    }

    /// What follows a run.
    pub(crate) fn ran(&self, about: RanElsewhere, want: Want<'_>) {
        if self.held().other != Other::Nothing {
            self.compare(want);
        }
        if about.stock {
            self.cut(want);
        }
        want(Work::Plan(about.number));
    }

    fn compare_now(&self, number: u64) {
        let wanted = self.wanted(&self.compared, number);
        let (ran, other, tolerance_mm) = {
            let held = self.held();
            (held.ran.clone(), held.other.clone(), held.tolerance_mm)
        };
        let mut comparing = self.comparing.lock().unwrap_or_else(PoisonError::into_inner);
        if other == Other::Nothing {
            self.held().beside = None;
            return comparing.nothing(number);
        }
        let Some(ran) = ran.filter(|_| wanted.is_wanted()) else { return };
        // What the page may ask of a program is there before the page hears of it.
        comparing.show(&ran, &other, &wanted);
        self.held().beside = comparing.program();
        comparing.compare(&ran, &other, tolerance_mm, &wanted);
    }

    fn plan(&self, number: u64) {
        let wanted = self.wanted(&self.newest, number);
        let ran = self.held().ran.clone().filter(|ran| ran.number == number);
        let Some(ran) = ran.filter(|_| wanted.is_wanted()) else { return };
        let job = ran.program.job().interrupt(wanted.interrupt());
        match times::times(number, &job, ran.about_s, &wanted) {
            Ok(Some((frame, told))) => {
                self.out.binary(frame);
                self.out.json(&told);
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
        let wanted = self.wanted(&self.stocked, number);
        let (ran, columns) = {
            let held = self.held();
            (held.ran.clone(), held.columns)
        };
        if let Some(ran) = ran.filter(|_| wanted.is_wanted()) {
            Cutting::new(&ran, columns).run(&*self.programs, &self.out, &wanted);
        }
    }
}

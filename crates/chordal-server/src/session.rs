//! What one page does: its text, its machine, and the threads that run and answer.
//!
//! | thread | does |
//! |---|---|
//! | `answers` | requests in their order; an edit sets off a run |
//! | `paths` | runs the newest text, sends path and diagnostics |
//! | `times` | plans the newest run, sends its motion |
//! | `others` | holds the newest run against the other program |
//! | `stocks` | cuts the stock with the newest run, sends what is lowered when and what is touched |
//! | `watch` | looks whether a file has changed |
//!
//! A run and a comparison that are no longer the newest are given up, so that typing never waits for one.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use chordal_editor::Program;
use serde_json::{Value, json};

use crate::document::Document;
use crate::file::{self, Content, Stamp};
use crate::other::{Comparing, text_around};
use crate::outbox::Outbox;
use crate::program::Programs;
use crate::request::{Ask, Other, Request};
use crate::run::{Ran, run};
use crate::stock::{Cutting, USUAL_COLUMNS};
use crate::wanted::Wanted;
use crate::{answer, chords, times, words};

/// How often the file is looked at.
const LOOK_EVERY: Duration = Duration::from_millis(400);

/// Bytes of text that are sent in one message, about: a page is busy with each without a break.
const TEXT_PIECE: usize = 1 << 20;

/// The page's end of the threads.
pub struct Session {
    shared: Arc<Shared>,
    requests: Sender<Request>,
}

struct Shared {
    programs: Arc<dyn Programs>,
    out: Outbox,
    /// The number of the newest run that somebody wants.
    newest: Arc<AtomicU64>,
    /// The number of the newest comparison that somebody wants.
    compared: Arc<AtomicU64>,
    /// The number of the newest stock that somebody wants.
    stocked: Arc<AtomicU64>,
    over: Arc<AtomicBool>,
    held: Mutex<Held>,
}

/// What is wanted of the other threads.
#[derive(Clone)]
struct Queues {
    runs: Sender<u64>,
    comparisons: Sender<u64>,
    stocks: Sender<u64>,
}

struct Held {
    document: Document,
    /// What the file held when it was last read or written.
    on_disk: Content,
    machine: Option<String>,
    /// What was opened last; it decides the machine.
    opened: Option<Arc<Program>>,
    /// The text as an editor asks of it, until it changes.
    words: Option<Arc<Program>>,
    ran: Option<Arc<Ran>>,
    /// What the program is compared with.
    other: Other,
    /// What the two paths may be apart, mm.
    tolerance_mm: f64,
    /// Columns of the stock, about.
    columns: u32,
    /// The other program as it is shown.
    beside: Option<Arc<Program>>,
}

impl Held {
    /// Runs on another machine, and is compared with the one before unless the command line names what to hold
    /// it against.
    fn run_on(&mut self, machine: Option<String>) {
        let before = std::mem::replace(&mut self.machine, machine);
        if self.other != Other::Named {
            self.other = Other::Machine(before);
        }
    }
}

/// A run whose time is to be planned.
struct ToPlan {
    number: u64,
    program: Arc<Program>,
    about_s: f64,
}

impl Session {
    /// Starts the threads, which begin with the file as it is.
    ///
    /// # Errors
    /// When the system gives no threads.
    pub fn begin(programs: Arc<dyn Programs>, out: Outbox) -> std::io::Result<Session> {
        let against = programs.against();
        let held = Held {
            document: Document::read(b""),
            on_disk: Content::of(b""),
            machine: None,
            opened: None,
            words: None,
            ran: None,
            other: if against.is_some() { Other::Named } else { Other::Nothing },
            tolerance_mm: against.map_or(0.0, |against| against.options.tolerance_mm),
            columns: USUAL_COLUMNS,
            beside: None,
        };
        let shared = Arc::new(Shared {
            programs,
            out,
            newest: Arc::default(),
            compared: Arc::default(),
            stocked: Arc::default(),
            over: Arc::default(),
            held: Mutex::new(held),
        });
        // Before anything is read: what changes from here on is a change.
        let watched = shared.watched();
        let (requests, asked) = channel();
        let (runs, to_run) = channel();
        let (plans, to_plan) = channel();
        let (comparisons, to_compare) = channel();
        let (stocks, to_cut) = channel();
        let queues = Queues { runs, comparisons: comparisons.clone(), stocks };
        let after_runs = queues.clone();
        spawn("answers", &shared, move |shared| shared.answer_all(&asked, &queues))?;
        spawn("paths", &shared, move |shared| shared.run_all(&to_run, &plans, &after_runs))?;
        spawn("times", &shared, move |shared| shared.plan_all(&to_plan))?;
        spawn("others", &shared, move |shared| shared.compare_all(&to_compare))?;
        spawn("stocks", &shared, move |shared| shared.cut_all(&to_cut))?;
        spawn("watch", &shared, move |shared| shared.watch(watched, &comparisons))?;
        Ok(Session { shared, requests })
    }

    /// Hands a request on.
    pub fn ask(&self, request: Request) {
        // The thread that answers ends with the session only.
        let _ = self.requests.send(request);
    }

    /// The page has gone.
    pub fn end(self) {
        self.shared.over.store(true, Ordering::Relaxed);
    }
}

/// The files that may change, as they were at the beginning.
struct Watched {
    path: Option<PathBuf>,
    other: Option<PathBuf>,
    seen: Option<Stamp>,
    other_seen: Option<Stamp>,
}

fn stamp(path: &Option<PathBuf>) -> Option<Stamp> {
    path.as_deref().and_then(Stamp::of)
}

fn spawn(
    name: &str,
    shared: &Arc<Shared>,
    work: impl FnOnce(&Shared) + Send + 'static,
) -> std::io::Result<()> {
    let shared = shared.clone();
    thread::Builder::new().name(name.into()).spawn(move || {
        // A defect of ours must not leave a page that waits forever without a word.
        if catch_unwind(AssertUnwindSafe(|| work(&shared))).is_err() {
            shared.out.refuse(
                0,
                "a defect in Chordal ended this view",
                Some("load the page again"),
            );
        }
    })?;
    Ok(())
}

/// The newest of what waits, or the next that comes; `None` when nothing can come.
fn newest<T>(queue: &Receiver<T>) -> Option<T> {
    let first = queue.recv().ok()?;
    Some(queue.try_iter().last().unwrap_or(first))
}

impl Shared {
    fn held(&self) -> MutexGuard<'_, Held> {
        // Nothing is left half done where a panic could strike.
        self.held.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn is_over(&self) -> bool {
        self.over.load(Ordering::Relaxed)
    }

    /// The text as an editor asks of it; `None` before the first run.
    fn words(&self) -> Option<Arc<Program>> {
        let mut held = self.held();
        if held.words.is_none() {
            let text = held.document.text().as_bytes().to_vec();
            held.words = Some(Arc::new(held.opened.as_ref()?.with_text(text)));
        }
        held.words.clone()
    }

    fn answer_words(&self, id: u64, tell: impl FnOnce(&Program) -> Value) {
        let Some(program) = self.words() else {
            return self.out.refuse(id, "no program has run yet", None);
        };
        let mut told = tell(&program);
        told["id"] = json!(id);
        self.out.json(&told);
    }

    fn wanted(&self, number: u64) -> Wanted {
        Wanted { newest: self.newest.clone(), over: self.over.clone(), number }
    }

    fn answer_all(&self, asked: &Receiver<Request>, queues: &Queues) {
        self.tell_hello();
        self.load(0, queues);
        while let Ok(request) = asked.recv() {
            self.answer(request, queues);
        }
    }

    fn tell_hello(&self) {
        let machines = self.programs.machines();
        let machines: Vec<_> = machines
            .iter()
            .map(|machine| json!({ "name": machine.name, "title": machine.title }))
            .collect();
        let against = self.programs.against();
        self.out.json(&json!({
            "type": "hello",
            "name": self.programs.name(),
            "writable": self.programs.path().is_some(),
            "machines": machines,
            "against": against.map(|against| json!({
                "name": against.programs.name(),
                "own_text": against.own_text,
            })),
            "tolerance_mm": self.held().tolerance_mm,
        }));
    }

    fn answer(&self, request: Request, queues: &Queues) {
        let id = request.id;
        match request.ask {
            Ask::Edit { changes } => {
                let applied = {
                    let mut held = self.held();
                    held.words = None;
                    held.document.apply(&changes)
                };
                match applied {
                    Ok(()) => self.start(queues),
                    Err(error) => {
                        self.out.refuse(id, &error.to_string(), Some("the text is sent again"));
                        self.send_text();
                    }
                }
            }
            Ask::Machine { name } => {
                self.held().run_on(name);
                self.start(queues);
            }
            Ask::Against { other } => self.against(id, other, queues),
            Ask::Tolerance { tolerance_mm } => self.tolerance(id, tolerance_mm, queues),
            Ask::Stock { columns } => {
                self.held().columns = columns;
                self.cut(&queues.stocks);
            }
            Ask::OtherText { file, line } => {
                let Some(beside) = self.held().beside.clone() else {
                    return self.out.refuse(id, "there is no other program", None);
                };
                let mut told = text_around(&beside, file, line);
                told["id"] = json!(id);
                self.out.json(&told);
            }
            Ask::Chords { tolerance_mm, balanced } => self.chords(id, tolerance_mm, balanced),
            Ask::State { done, line } => {
                let ran = self.held().ran.clone();
                let mut state = ran.map(|ran| ran.modal.at(done, line));
                let behind = self.words().and_then(|program| program.modal_behind(line));
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
            Ask::Reload => self.load(id, queues),
        }
    }

    /// The next run is wanted, and none before it.
    fn start(&self, queues: &Queues) {
        let number = self.newest.fetch_add(1, Ordering::Relaxed) + 1;
        // What is compared now is of the text before; the run asks for the next.
        self.compared.fetch_add(1, Ordering::Relaxed);
        self.stocked.fetch_add(1, Ordering::Relaxed);
        let _ = queues.runs.send(number);
    }

    /// The next comparison is wanted, and none before it.
    fn compare(&self, comparisons: &Sender<u64>) {
        let number = self.compared.fetch_add(1, Ordering::Relaxed) + 1;
        let _ = comparisons.send(number);
    }

    /// The next stock is wanted, and none before it.
    fn cut(&self, stocks: &Sender<u64>) {
        let number = self.stocked.fetch_add(1, Ordering::Relaxed) + 1;
        let _ = stocks.send(number);
    }

    /// Another program, or none, is to be shown, too.
    fn against(&self, id: u64, other: Other, queues: &Queues) {
        if other == Other::Named && self.programs.against().is_none() {
            let help = Some("start `chordal view` with --against to name one");
            return self.out.refuse(id, "the command line names no other program", help);
        }
        self.held().other = other;
        self.compare(&queues.comparisons);
    }

    fn tolerance(&self, id: u64, tolerance_mm: f64, queues: &Queues) {
        if !(tolerance_mm >= 0.0 && tolerance_mm.is_finite()) {
            let message = format!("{tolerance_mm} mm is not a tolerance");
            return self.out.refuse(id, &message, Some("give a length of zero or more"));
        }
        self.held().tolerance_mm = tolerance_mm;
        self.compare(&queues.comparisons);
    }

    /// Reads the file, runs it and sends its text.
    fn load(&self, id: u64, queues: &Queues) {
        let bytes = match self.programs.read() {
            Ok(bytes) => bytes,
            Err(refusal) => {
                return self.out.refuse(id, &refusal.message, refusal.help.as_deref());
            }
        };
        {
            let mut held = self.held();
            held.document = Document::read(&bytes);
            held.on_disk = Content::of(&bytes);
            held.words = None;
        }
        // The run first: its picture is made while the text goes over.
        self.start(queues);
        self.send_text();
    }

    fn send_text(&self) {
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
            let mut frame = crate::frame::Frame::default();
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
        let Some(path) = self.programs.path() else {
            return self.out.refuse(
                id,
                "the program came from standard input: there is no file to write",
                None,
            );
        };
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
        match file::write(&path, &bytes) {
            Ok(()) => {
                held.on_disk = Content::of(&bytes);
                self.out.json(&json!({ "type": "saved", "id": id }));
            }
            Err(error) => {
                let message = format!("cannot write {}: {error}", path.display());
                self.out.refuse(id, &message, Some("the file was not changed"));
            }
        }
    }

    fn chords(&self, id: u64, tolerance_mm: f64, balanced: bool) {
        let Some(ran) = self.held().ran.clone() else {
            return self.out.refuse(id, "no program has run yet", None);
        };
        match chords::chords(&ran.program.job(), tolerance_mm, balanced) {
            Ok(frame) => self.out.binary(frame),
            Err(error) => {
                self.out.refuse(id, &error.to_string(), Some("give a tolerance above zero"))
            }
        }
    }

    fn run_all(&self, to_run: &Receiver<u64>, plans: &Sender<ToPlan>, queues: &Queues) {
        while let Some(number) = newest(to_run) {
            let wanted = self.wanted(number);
            if !wanted.is_wanted() {
                continue;
            }
            let (text, machine) = {
                let held = self.held();
                (held.document.text().as_bytes().to_vec(), held.machine.clone())
            };
            let program = match self.programs.open(text, machine.as_deref()) {
                Ok(program) => {
                    let program = Arc::new(program);
                    let mut held = self.held();
                    (held.opened, held.words) = (Some(program.clone()), None);
                    program
                }
                Err(refusal) => {
                    self.out.json(&json!({
                        "type": "refused",
                        "run": number,
                        "message": refusal.message,
                        "help": refusal.help,
                    }));
                    continue;
                }
            };
            if let Some(about_s) = self.run_one(number, &program, &wanted) {
                self.compare(&queues.comparisons);
                self.cut(&queues.stocks);
                let _ = plans.send(ToPlan { number, program, about_s });
            }
        }
    }

    /// Runs and reports; the time without acceleration where the run was not given up, s.
    fn run_one(&self, number: u64, program: &Arc<Program>, wanted: &Wanted) -> Option<f64> {
        let job = program.job().interrupt(wanted.interrupt());
        self.out.json(&json!({
            "type": "run",
            "run": number,
            "machine": answer::machine(&job),
            "why": program.setup().why,
        }));
        let (ran, told, about_s) = run(number, program, &job, &self.out, wanted)?;
        // Whoever knows of the run may ask about it.
        self.held().ran = Some(Arc::new(ran));
        self.out.json(&told);
        Some(about_s)
    }

    fn compare_all(&self, to_compare: &Receiver<u64>) {
        let mut comparing = Comparing::new(self.programs.clone(), self.out.clone());
        let mut was_something = false;
        while let Some(number) = newest(to_compare) {
            let wanted = Wanted { newest: self.compared.clone(), over: self.over.clone(), number };
            let (ran, other, tolerance_mm) = {
                let held = self.held();
                (held.ran.clone(), held.other.clone(), held.tolerance_mm)
            };
            let is_something = other != Other::Nothing;
            // What the page may ask of a program is there before the page hears of it.
            match ran.filter(|_| wanted.is_wanted()) {
                Some(ran) if is_something => {
                    comparing.show(&ran, &other, &wanted);
                    self.held().beside = comparing.program();
                    comparing.compare(&ran, &other, tolerance_mm, &wanted);
                }
                _ if !is_something && was_something => {
                    self.held().beside = None;
                    comparing.nothing();
                }
                _ => continue,
            }
            was_something = is_something;
        }
    }

    fn plan_all(&self, to_plan: &Receiver<ToPlan>) {
        while let Some(ToPlan { number, program, about_s }) = newest(to_plan) {
            let wanted = self.wanted(number);
            let job = program.job().interrupt(wanted.interrupt());
            match times::times(number, &job, about_s, &wanted) {
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
    }

    fn cut_all(&self, to_cut: &Receiver<u64>) {
        while let Some(number) = newest(to_cut) {
            let wanted = Wanted { newest: self.stocked.clone(), over: self.over.clone(), number };
            let (ran, columns) = {
                let held = self.held();
                (held.ran.clone(), held.columns)
            };
            if let Some(ran) = ran.filter(|_| wanted.is_wanted()) {
                Cutting::new(&ran, columns).run(&*self.programs, &self.out, &wanted);
            }
        }
    }

    fn watched(&self) -> Watched {
        let path = self.programs.path();
        let against = self.programs.against().filter(|against| !against.own_text);
        let other = against.and_then(|against| against.programs.path());
        let (seen, other_seen) = (stamp(&path), stamp(&other));
        Watched { path, other, seen, other_seen }
    }

    /// Says when the file holds something else than was read or written last, and compares anew when the
    /// other one does.
    fn watch(&self, watched: Watched, comparisons: &Sender<u64>) {
        let Watched { path, other, mut seen, mut other_seen } = watched;
        if path.is_none() && other.is_none() {
            return;
        }
        while !self.is_over() {
            thread::sleep(LOOK_EVERY);
            let other_now = stamp(&other);
            if other_now != other_seen {
                other_seen = other_now;
                if self.held().other == Other::Named {
                    self.compare(comparisons);
                }
            }
            let now = stamp(&path);
            if now == seen {
                continue;
            }
            seen = now;
            let Ok(bytes) = self.programs.read() else {
                self.out.json(&json!({ "type": "gone" }));
                continue;
            };
            if Content::of(&bytes) != self.held().on_disk {
                self.out.json(&json!({ "type": "changed" }));
            }
        }
    }
}

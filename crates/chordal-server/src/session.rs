//! What one page does: its text, its machine, and the threads that run and answer.
//!
//! | thread | does |
//! |---|---|
//! | `answers` | requests in their order; an edit sets off a run |
//! | `paths` | runs the newest text, sends path and diagnostics |
//! | `times` | plans the newest run, sends its motion |
//! | `watch` | looks whether the file has changed |
//!
//! A run that is no longer the newest is given up, so that typing never waits for one.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use chordal_editor::Program;
use serde_json::{Value, json};

use crate::document::Document;
use crate::file::{self, Content, Stamp};
use crate::live::Outbox;
use crate::program::Programs;
use crate::request::{Ask, Request};
use crate::run::{Ran, run};
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
    over: Arc<AtomicBool>,
    held: Mutex<Held>,
}

struct Held {
    document: Document,
    /// What the file held when it was last read or written.
    on_disk: Content,
    machine: Option<String>,
    /// What was opened last, which tells the machine.
    opened: Option<Arc<Program>>,
    /// The text as an editor asks of it, until it changes.
    words: Option<Arc<Program>>,
    ran: Option<Arc<Ran>>,
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
        let held = Held {
            document: Document::read(b""),
            on_disk: Content::of(b""),
            machine: None,
            opened: None,
            words: None,
            ran: None,
        };
        let shared = Arc::new(Shared {
            programs,
            out,
            newest: Arc::default(),
            over: Arc::default(),
            held: Mutex::new(held),
        });
        let (requests, asked) = channel();
        let (runs, to_run) = channel();
        let (plans, to_plan) = channel();
        spawn("answers", &shared, move |shared| shared.answer_all(&asked, &runs))?;
        spawn("paths", &shared, move |shared| shared.run_all(&to_run, &plans))?;
        spawn("times", &shared, move |shared| shared.plan_all(&to_plan))?;
        spawn("watch", &shared, Shared::watch)?;
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
            return self.out.refuse(id, "nothing has been run yet", None);
        };
        let mut told = tell(&program);
        told["id"] = json!(id);
        self.out.json(&told);
    }

    fn wanted(&self, number: u64) -> Wanted {
        Wanted { newest: self.newest.clone(), over: self.over.clone(), number }
    }

    fn answer_all(&self, asked: &Receiver<Request>, runs: &Sender<u64>) {
        self.tell_hello();
        self.load(0, runs);
        while let Ok(request) = asked.recv() {
            self.answer(request, runs);
        }
    }

    fn tell_hello(&self) {
        let machines = self.programs.machines();
        let machines: Vec<_> = machines
            .iter()
            .map(|machine| json!({ "name": machine.name, "title": machine.title }))
            .collect();
        self.out.json(&json!({
            "type": "hello",
            "name": self.programs.name(),
            "writable": self.programs.path().is_some(),
            "machines": machines,
        }));
    }

    fn answer(&self, request: Request, runs: &Sender<u64>) {
        let id = request.id;
        match request.ask {
            Ask::Edit { changes } => {
                let applied = {
                    let mut held = self.held();
                    held.words = None;
                    held.document.apply(&changes)
                };
                match applied {
                    Ok(()) => self.start(runs),
                    Err(error) => {
                        self.out.refuse(id, &error.to_string(), Some("the text is sent again"));
                        self.send_text();
                    }
                }
            }
            Ask::Machine { name } => {
                self.held().machine = name;
                self.start(runs);
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
            Ask::Reload => self.load(id, runs),
        }
    }

    /// The next run is wanted, and none before it.
    fn start(&self, runs: &Sender<u64>) {
        let number = self.newest.fetch_add(1, Ordering::Relaxed) + 1;
        let _ = runs.send(number);
    }

    /// Reads the file, runs it and sends its text.
    fn load(&self, id: u64, runs: &Sender<u64>) {
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
        self.start(runs);
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
                    Some("take that character out, then save"),
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
                self.out.refuse(id, &message, Some("the file is as it was"));
            }
        }
    }

    fn chords(&self, id: u64, tolerance_mm: f64, balanced: bool) {
        let Some(ran) = self.held().ran.clone() else {
            return self.out.refuse(id, "nothing has been run yet", None);
        };
        match chords::chords(&ran.program.job(), tolerance_mm, balanced) {
            Ok(frame) => self.out.binary(frame),
            Err(error) => {
                self.out.refuse(id, &error.to_string(), Some("give a tolerance above zero"))
            }
        }
    }

    fn run_all(&self, to_run: &Receiver<u64>, plans: &Sender<ToPlan>) {
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
                let _ = plans.send(ToPlan { number, program, about_s });
            }
        }
    }

    /// Runs and tells; the time without acceleration where the run was not given up, s.
    fn run_one(&self, number: u64, program: &Arc<Program>, wanted: &Wanted) -> Option<f64> {
        let job = program.job().interrupt(wanted.interrupt());
        self.out.json(&json!({
            "type": "run",
            "run": number,
            "machine": answer::machine(&job),
            "why": program.setup().why,
        }));
        let (ran, about_s) = run(number, program, &job, &self.out, wanted)?;
        self.held().ran = Some(Arc::new(ran));
        Some(about_s)
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

    /// Tells when the file holds something else than was read or written last.
    fn watch(&self) {
        let Some(path) = self.programs.path() else { return };
        let mut seen = Stamp::of(&path);
        while !self.is_over() {
            thread::sleep(LOOK_EVERY);
            let now = Stamp::of(&path);
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

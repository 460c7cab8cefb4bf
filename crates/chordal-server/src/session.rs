//! The threads of one page: they answer and do the work of its view.
//!
//! | thread | does |
//! |---|---|
//! | `answers` | requests in their order; an edit sets off a run |
//! | `paths`, `times`, `others`, `stocks` | one kind of work each: run, plan, compare, cut |
//! | `watch` | looks whether a file has changed |

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::Duration;

use chordal_view::{Outbox, Programs, Request, View, Work};
use serde_json::json;

use crate::file::Stamp;

/// How often the file is looked at.
const LOOK_EVERY: Duration = Duration::from_millis(400);

/// The page's end of the threads.
pub struct Session {
    view: Arc<View>,
    requests: Sender<Request>,
}

/// Where work goes, by its kind. A thread has no way to itself: it ends when nobody else can send it work.
#[derive(Clone)]
struct Queues {
    runs: Option<Sender<Work>>,
    plans: Sender<Work>,
    comparisons: Sender<Work>,
    stocks: Sender<Work>,
}

impl Queues {
    fn put(&self, work: Work) {
        let queue = match work {
            Work::Run(_) => self.runs.as_ref(),
            Work::Plan(_) => Some(&self.plans),
            Work::Compare(_) => Some(&self.comparisons),
            Work::Cut(_) => Some(&self.stocks),
        };
        if let Some(queue) = queue {
            // The thread behind it ends with the session only.
            let _ = queue.send(work);
        }
    }
}

impl Session {
    /// Starts the threads, which begin with the file as it is.
    ///
    /// # Errors
    /// When the system gives no threads.
    pub fn begin(programs: Arc<dyn Programs>, out: Outbox) -> std::io::Result<Session> {
        // Before anything is read: what changes from here on is a change.
        let watched = Watched::of(&*programs);
        let view = Arc::new(View::new(programs.clone(), out));
        let (requests, asked) = channel();
        let (runs, to_run) = channel();
        let (plans, to_plan) = channel();
        let (comparisons, to_compare) = channel();
        let (stocks, to_cut) = channel();
        let after_runs = Queues { runs: None, plans, comparisons, stocks };
        let queues = Queues { runs: Some(runs), ..after_runs.clone() };
        let on_change = after_runs.comparisons.clone();
        spawn("answers", &view, move |view| answer_all(view, &asked, &queues))?;
        spawn("paths", &view, move |view| work_all(view, &to_run, |next| after_runs.put(next)))?;
        for (name, queue) in [("times", to_plan), ("others", to_compare), ("stocks", to_cut)] {
            spawn(name, &view, move |view| work_all(view, &queue, |_| {}))?;
        }
        spawn("watch", &view, move |view| watch(view, &*programs, watched, &on_change))?;
        Ok(Session { view, requests })
    }

    /// Hands a request on.
    pub fn ask(&self, request: Request) {
        // The thread that answers ends with the session only.
        let _ = self.requests.send(request);
    }

    /// The page has gone.
    pub fn end(self) {
        self.view.end();
    }
}

fn spawn(
    name: &str,
    view: &Arc<View>,
    work: impl FnOnce(&View) + Send + 'static,
) -> std::io::Result<()> {
    let view = view.clone();
    thread::Builder::new().name(name.into()).spawn(move || {
        // What one question or one run fails on is caught where it is answered. Should a thread end even so, the
        // page must not wait forever without a word.
        if catch_unwind(AssertUnwindSafe(|| work(&view))).is_err() {
            view.out().refuse(
                0,
                "a defect in Chordal ended this view",
                Some("load the page again"),
            );
        }
    })?;
    Ok(())
}

fn answer_all(view: &View, asked: &Receiver<Request>, queues: &Queues) {
    let mut want = |work| queues.put(work);
    // The run first: its picture is made while the text goes over.
    let begun = caught(|| {
        if view.begin(&mut want) {
            view.send_text();
        }
    });
    if let Err(why) = begun {
        view.failed_to_answer(0, &why);
    }
    while let Ok(request) = asked.recv() {
        let id = request.id;
        if let Err(why) = caught(|| view.answer(request, &mut want)) {
            view.failed_to_answer(id, &why);
        }
    }
}

/// A failure of ours ends one answer, not the view: the words of the panic.
fn caught(work: impl FnOnce()) -> Result<(), String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|told| {
        let words = told.downcast_ref::<String>().map(String::as_str);
        words.or_else(|| told.downcast_ref::<&str>().copied()).unwrap_or("a panic").to_string()
    })
}

fn work_all(view: &View, queue: &Receiver<Work>, mut want: impl FnMut(Work)) {
    while let Some(work) = newest(queue) {
        if let Err(why) = caught(|| view.work(work, &mut want)) {
            view.failed(work, &why);
        }
    }
}

/// The newest of what waits, or the next that comes; `None` when nothing can come.
fn newest<T>(queue: &Receiver<T>) -> Option<T> {
    let first = queue.recv().ok()?;
    Some(queue.try_iter().last().unwrap_or(first))
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

impl Watched {
    fn of(programs: &dyn Programs) -> Watched {
        let path = programs.path();
        let against = programs.against().filter(|against| !against.own_text);
        let other = against.and_then(|against| against.programs.path());
        let (seen, other_seen) = (stamp(&path), stamp(&other));
        Watched { path, other, seen, other_seen }
    }
}

/// Says when the file holds something else than was read or written last, and compares anew when the
/// other one does.
fn watch(view: &View, programs: &dyn Programs, watched: Watched, comparisons: &Sender<Work>) {
    let Watched { path, other, mut seen, mut other_seen } = watched;
    if path.is_none() && other.is_none() {
        return;
    }
    while !view.is_over() {
        thread::sleep(LOOK_EVERY);
        let other_now = stamp(&other);
        if other_now != other_seen {
            other_seen = other_now;
            view.other_changed(&mut |work| {
                let _ = comparisons.send(work);
            });
        }
        let now = stamp(&path);
        if now == seen {
            continue;
        }
        seen = now;
        match programs.read() {
            Ok(bytes) if view.is_changed(&bytes) => view.out().json(&json!({ "type": "changed" })),
            Ok(_) => {}
            Err(_) => view.out().json(&json!({ "type": "gone" })),
        }
    }
}

//! The threads of one page, which answer requests and do the work of its view.
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

use chordal_view::{PageOutbox, PageRequest, ProgramSource, ProgramView, WorkItem};
use serde_json::json;

use crate::file::ServedFileStamp;

/// How often the file is checked for changes.
const POLL_INTERVAL: Duration = Duration::from_millis(400);

/// The connection's handle to the threads of a page.
pub struct PageSession {
    view: Arc<ProgramView>,
    requests: Sender<PageRequest>,
}

/// A queue for each kind of work. A thread has no sender to its own queue, so that it ends when all other senders are
/// dropped.
#[derive(Clone)]
struct WorkQueues {
    runs: Option<Sender<WorkItem>>,
    plans: Sender<WorkItem>,
    comparisons: Sender<WorkItem>,
    stocks: Sender<WorkItem>,
}

impl WorkQueues {
    fn put(&self, work: WorkItem) {
        let queue = match work {
            WorkItem::Run(_) => self.runs.as_ref(),
            WorkItem::Plan(_) => Some(&self.plans),
            WorkItem::Compare(_) => Some(&self.comparisons),
            WorkItem::Cut(_) => Some(&self.stocks),
        };
        if let Some(queue) = queue {
            // This cannot fail: the receiving thread ends only with the session.
            let _ = queue.send(work);
        }
    }
}

impl PageSession {
    /// Starts the threads, which first read the file.
    ///
    /// # Errors The system cannot start a thread.
    pub fn begin(
        programs: Arc<dyn ProgramSource>,
        out: PageOutbox,
    ) -> std::io::Result<PageSession> {
        // The stamps are taken before anything is read, so that no later change is missed.
        let watched = WatchedFiles::of(&*programs);
        let view = Arc::new(ProgramView::new(programs.clone(), out));
        let (requests, incoming) = channel();
        let (runs, to_run) = channel();
        let (plans, to_plan) = channel();
        let (comparisons, to_compare) = channel();
        let (stocks, to_cut) = channel();
        let after_runs = WorkQueues { runs: None, plans, comparisons, stocks };
        let queues = WorkQueues { runs: Some(runs), ..after_runs.clone() };
        let on_change = after_runs.comparisons.clone();
        spawn("answers", &view, move |view| answer_all(view, &incoming, &queues))?;
        spawn("paths", &view, move |view| work_all(view, &to_run, |next| after_runs.put(next)))?;
        for (name, queue) in [("times", to_plan), ("others", to_compare), ("stocks", to_cut)] {
            spawn(name, &view, move |view| work_all(view, &queue, |_| {}))?;
        }
        spawn("watch", &view, move |view| watch(view, &*programs, watched, &on_change))?;
        Ok(PageSession { view, requests })
    }

    /// Sends a request to the answering thread.
    pub fn send(&self, request: PageRequest) {
        // This cannot fail: the answering thread ends only with the session.
        let _ = self.requests.send(request);
    }

    /// Ends the work because the page was closed.
    pub fn end(self) {
        self.view.close();
    }
}

fn spawn(
    name: &str,
    view: &Arc<ProgramView>,
    work: impl FnOnce(&ProgramView) + Send + 'static,
) -> std::io::Result<()> {
    let view = view.clone();
    thread::Builder::new().name(name.into()).spawn(move || {
        // A panic of a single request or run is caught where it is answered. If a thread ends nevertheless, the page
        // must get a message and not wait forever.
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

fn answer_all(view: &ProgramView, incoming: &Receiver<PageRequest>, queues: &WorkQueues) {
    let mut want = |work| queues.put(work);
    // The run is requested first, so that its path is computed while the text is transferred.
    let begun = catch_panic(|| {
        if view.begin(&mut want) {
            view.send_text();
        }
    });
    if let Err(why) = begun {
        view.answer_failed(0, &why);
    }
    while let Ok(request) = incoming.recv() {
        let id = request.id;
        if let Err(why) = catch_panic(|| view.answer(request, &mut want)) {
            view.answer_failed(id, &why);
        }
    }
}

/// Catches a panic, so that it ends one answer and not the view; returns its message.
fn catch_panic(work: impl FnOnce()) -> Result<(), String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|payload| {
        let words = payload.downcast_ref::<String>().map(String::as_str);
        words.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("a panic").to_string()
    })
}

fn work_all(view: &ProgramView, queue: &Receiver<WorkItem>, mut want: impl FnMut(WorkItem)) {
    while let Some(work) = newest(queue) {
        if let Err(why) = catch_panic(|| view.work(work, &mut want)) {
            view.work_failed(work, &why);
        }
    }
}

/// The newest waiting item, or the next one that arrives; `None` when all senders are dropped.
fn newest<T>(queue: &Receiver<T>) -> Option<T> {
    let first = queue.recv().ok()?;
    Some(queue.try_iter().last().unwrap_or(first))
}

/// The watched files with their stamps at the beginning.
struct WatchedFiles {
    path: Option<PathBuf>,
    other: Option<PathBuf>,
    stamp: Option<ServedFileStamp>,
    other_stamp: Option<ServedFileStamp>,
}

fn stamp_of(path: &Option<PathBuf>) -> Option<ServedFileStamp> {
    path.as_deref().and_then(ServedFileStamp::of)
}

impl WatchedFiles {
    fn of(programs: &dyn ProgramSource) -> WatchedFiles {
        let path = programs.path();
        let compared = programs.compared_program().filter(|compared| !compared.own_text);
        let other = compared.and_then(|compared| compared.programs.path());
        let (last_stamp, last_other_stamp) = (stamp_of(&path), stamp_of(&other));
        WatchedFiles { path, other, stamp: last_stamp, other_stamp: last_other_stamp }
    }
}

/// Reports when the content of the file differs from when it was last read or written, and compares again when the
/// other program's file changes.
fn watch(
    view: &ProgramView,
    programs: &dyn ProgramSource,
    watched: WatchedFiles,
    comparisons: &Sender<WorkItem>,
) {
    let WatchedFiles { path, other, stamp: mut last_stamp, other_stamp: mut last_other_stamp } =
        watched;
    if path.is_none() && other.is_none() {
        return;
    }
    while !view.is_closed() {
        thread::sleep(POLL_INTERVAL);
        let other_now = stamp_of(&other);
        if other_now != last_other_stamp {
            last_other_stamp = other_now;
            view.other_changed(&mut |work| {
                let _ = comparisons.send(work);
            });
        }
        let now = stamp_of(&path);
        if now == last_stamp {
            continue;
        }
        last_stamp = now;
        match programs.read() {
            Ok(bytes) if view.is_changed(&bytes) => view.out().json(&json!({ "type": "changed" })),
            Ok(_) => {}
            Err(_) => view.out().json(&json!({ "type": "gone" })),
        }
    }
}

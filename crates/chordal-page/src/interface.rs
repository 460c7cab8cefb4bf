//! The functions that JavaScript calls, and those of JavaScript that are called.
//!
//! Messages lie in memory as `chordal-memory` says. `page_open()` begins the view of a page, which from then on takes requests
//! (`page_request()`) and reports of runs (`page_run_finished()`). Work for other workers goes out through `want`; `page_dispatch()`
//! gives what another worker needs for it, which takes `page_serve()` and then `page_execute()`. Answers and columns go
//! out through `send`, while it works.

#![allow(unsafe_code, reason = "names that JavaScript calls, and the functions that it offers")]

use std::cell::RefCell;
use std::sync::Arc;

use chordal_memory::{MemoryMessage, put_output, take_input};
use chordal_view::{
    PageOutbox, PagePort, PageRequest, ProgramView, WorkItem, WorkOrder, builtin_machines,
};
use serde_json::json;

use crate::opened_files::OpenedProgram;

thread_local! {
    static VIEW: RefCell<Option<Arc<ProgramView>>> = const { RefCell::new(None) };
    static OPENED: RefCell<Option<Arc<OpenedProgram>>> = const { RefCell::new(None) };
}

#[cfg(target_family = "wasm")]
#[link(wasm_import_module = "chordal")]
unsafe extern "C" {
    /// Takes a text (0), columns (1), or columns that the first picture need not wait for (2).
    fn send(kind: u32, bytes: *const u8, length: usize);
    /// Takes work that is to be done: its kind and its number.
    fn want(kind: u32, number: f64);
}

/// In native builds, for tests, there is no receiver.
#[cfg(not(target_family = "wasm"))]
mod nobody {
    pub unsafe fn send(_kind: u32, _bytes: *const u8, _length: usize) {}
    pub unsafe fn want(_kind: u32, _number: f64) {}
}
#[cfg(not(target_family = "wasm"))]
use nobody::{send, want};

/// Sends to the page through JavaScript.
struct JavaScriptPort;

fn send_bytes(kind: u32, bytes: &[u8]) {
    // SAFETY: JavaScript copies so many bytes at the pointer before it returns.
    unsafe { send(kind, bytes.as_ptr(), bytes.len()) }
}

impl PagePort for JavaScriptPort {
    fn text(&self, text: String) {
        send_bytes(0, text.as_bytes());
    }

    fn binary(&self, frame: Vec<u8>) {
        send_bytes(1, &frame);
    }

    fn binary_later(&self, frame: Vec<u8>) {
        send_bytes(2, &frame);
    }
}

/// Passes a work item on to JavaScript.
fn request_work(work: WorkItem) {
    let kind = match work {
        WorkItem::Run(_) => 0,
        WorkItem::Plan(_) => 1,
        WorkItem::Compare(_) => 2,
        WorkItem::Cut(_) => 3,
    };
    // SAFETY: two numbers.
    unsafe { want(kind, work.number() as f64) }
}

fn work_of(kind: u32, number: f64) -> WorkItem {
    // Whole numbers that `tell_work` gave.
    let number = number as u64;
    match kind {
        0 => WorkItem::Run(number),
        1 => WorkItem::Plan(number),
        2 => WorkItem::Compare(number),
        _ => WorkItem::Cut(number),
    }
}

fn view() -> Option<Arc<ProgramView>> {
    VIEW.with_borrow(Clone::clone)
}

/// Sends the page an error.
fn refuse(id: u64, message: &str, help: Option<&str>) {
    PageOutbox::new(JavaScriptPort).refuse(id, message, help);
}

fn open_view() -> Option<Arc<ProgramView>> {
    let out = PageOutbox::new(JavaScriptPort);
    match OpenedProgram::read(take_input(), out.clone()) {
        Ok(opened) => {
            let opened = Arc::new(opened);
            let view = Arc::new(ProgramView::new(opened.clone(), out));
            OPENED.set(Some(opened));
            VIEW.set(Some(view.clone()));
            Some(view)
        }
        Err(error) => {
            refuse(0, &format!("the message {error}"), Some("load the page again"));
            None
        }
    }
}

/// Prepares what every program needs, before one is opened.
#[unsafe(no_mangle)]
pub extern "C" fn page_prepare() {
    builtin_machines();
}

/// Begins the view of a page: the message is a [`crate::open_message::OpenMessage`] with a program. 1 where `page_text()` is due next.
#[unsafe(no_mangle)]
pub extern "C" fn page_open() -> u32 {
    let Some(view) = open_view() else { return 0 };
    view.delegate_work();
    u32::from(view.begin(&mut request_work))
}

/// Sends the page the text.
#[unsafe(no_mangle)]
pub extern "C" fn page_text() {
    if let Some(view) = view() {
        view.send_text();
    }
}

/// Other files lie next to the program from now on: the message is a [`crate::open_message::OpenMessage`] without a program.
#[unsafe(no_mangle)]
pub extern "C" fn page_files() {
    let opened = OPENED.with_borrow(Clone::clone);
    if let Some(Err(error)) = opened.map(|opened| opened.renew(take_input())) {
        refuse(0, &format!("the message {error}"), Some("load the page again"));
    }
}

/// Begins a view that works for another one: the message is a [`crate::open_message::OpenMessage`] without a program.
#[unsafe(no_mangle)]
pub extern "C" fn page_serve() {
    open_view();
}

/// Answers the request of a page.
#[unsafe(no_mangle)]
pub extern "C" fn page_request() {
    let text = take_input();
    let Some(view) = view() else { return refuse(0, "no program is open", None) };
    match serde_json::from_slice::<PageRequest>(&text) {
        Ok(request) => view.answer(request, &mut request_work),
        Err(error) => refuse(0, &format!("the request cannot be read: {error}"), None),
    }
}

/// Another worker has run the program: the message is the output of its `page_execute`.
#[unsafe(no_mangle)]
pub extern "C" fn page_run_finished() {
    let report = String::from_utf8_lossy(&take_input()).into_owned();
    if let Some(view) = view()
        && let Err(error) = view.remote_run_finished(&report, &mut request_work)
    {
        refuse(0, &error.to_string(), None);
    }
}

/// What another worker needs for a work item: parts 0 and 1 go into its message. Returns 0 if the item is out of date.
#[unsafe(no_mangle)]
pub extern "C" fn page_dispatch(kind: u32, number: f64) -> u32 {
    let order = view().and_then(|view| view.dispatch(work_of(kind, number)));
    let Some((order, text)) = order else { return 0 };
    let order = json!(order).to_string().into_bytes();
    put_output(vec![order, text.into_bytes()]);
    1
}

/// Does the work of another view: the message is a [`WorkOrder`] and the text. Part 0, if it is not empty, is for its `page_run_finished`.
#[unsafe(no_mangle)]
pub extern "C" fn page_execute() {
    let message = take_input();
    let Some(view) = view() else { return };
    let (order, text) = match MemoryMessage::read::<WorkOrder>(message) {
        Ok((order, rest)) => (order, String::from_utf8(rest.rest())),
        Err(error) => return refuse(0, &format!("the message {error}"), None),
    };
    let Ok(text) = text else { return refuse(0, "the text is not UTF-8", None) };
    match view.execute(order, text) {
        Ok(report) => put_output(vec![report.unwrap_or_default().into_bytes()]),
        Err(refusal) => refuse(0, &refusal.message, refusal.help.as_deref()),
    }
}

/// Panics, so that the tests can see how the page goes on after one.
#[unsafe(no_mangle)]
pub extern "C" fn page_panic() {
    panic!("asked to panic");
}

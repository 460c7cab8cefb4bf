//! What JavaScript calls, and what it hears.
//!
//! Messages lie in memory as `chordal-memory` says. The view of a page takes `page_begin()`, from then on its requests
//! (`page_ask()`), and is told of runs (`page_ran()`). What is to be done elsewhere goes out through `want`; `page_hand_over()`
//! gives what a view elsewhere needs for it, which takes `page_serve()` and then `page_take_over()`. Answers and columns go
//! out through `send`, while it works.

#![allow(unsafe_code, reason = "names that JavaScript calls, and the functions that it offers")]

use std::cell::RefCell;
use std::sync::Arc;

use chordal_memory::{Message, input, leave};
use chordal_view::{Handed, Outbox, Port, Request, View, Work, builtin_machines};
use serde_json::json;

use crate::given::Given;

thread_local! {
    static VIEW: RefCell<Option<Arc<View>>> = const { RefCell::new(None) };
    static GIVEN: RefCell<Option<Arc<Given>>> = const { RefCell::new(None) };
}

#[cfg(target_family = "wasm")]
#[link(wasm_import_module = "chordal")]
unsafe extern "C" {
    /// Takes a text (0), columns (1), or columns that the first picture need not wait for (2).
    fn send(kind: u32, bytes: *const u8, length: usize);
    /// Takes work that is to be done: its kind and its number.
    fn want(kind: u32, number: f64);
}

/// Natively nobody listens.
#[cfg(not(target_family = "wasm"))]
mod nobody {
    pub unsafe fn send(_kind: u32, _bytes: *const u8, _length: usize) {}
    pub unsafe fn want(_kind: u32, _number: f64) {}
}
#[cfg(not(target_family = "wasm"))]
use nobody::{send, want};

/// The way to the page.
struct Page;

fn send_bytes(kind: u32, bytes: &[u8]) {
    // SAFETY: JavaScript copies so many bytes at the pointer before it returns.
    unsafe { send(kind, bytes.as_ptr(), bytes.len()) }
}

impl Port for Page {
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

/// Says what is to be done.
fn tell_work(work: Work) {
    let kind = match work {
        Work::Run(_) => 0,
        Work::Plan(_) => 1,
        Work::Compare(_) => 2,
        Work::Cut(_) => 3,
    };
    // SAFETY: two numbers.
    unsafe { want(kind, work.number() as f64) }
}

fn work_of(kind: u32, number: f64) -> Work {
    // Whole numbers that `tell_work` gave.
    let number = number as u64;
    match kind {
        0 => Work::Run(number),
        1 => Work::Plan(number),
        2 => Work::Compare(number),
        _ => Work::Cut(number),
    }
}

fn view() -> Option<Arc<View>> {
    VIEW.with_borrow(Clone::clone)
}

/// Says that something went wrong, where the page sees it.
fn refuse(id: u64, message: &str, help: Option<&str>) {
    Outbox::new(Page).refuse(id, message, help);
}

fn made() -> Option<Arc<View>> {
    let out = Outbox::new(Page);
    match Given::read(input(), out.clone()) {
        Ok(given) => {
            let given = Arc::new(given);
            let view = Arc::new(View::new(given.clone(), out));
            GIVEN.set(Some(given));
            VIEW.set(Some(view.clone()));
            Some(view)
        }
        Err(error) => {
            refuse(0, &format!("the message {error}"), Some("load the page again"));
            None
        }
    }
}

/// Does what every program needs before there is one.
#[unsafe(no_mangle)]
pub extern "C" fn page_prepare() {
    builtin_machines();
}

/// Begins the view of a page: the message is a [`crate::begin::Begin`] with a program. 1 where `page_text()` is due next.
#[unsafe(no_mangle)]
pub extern "C" fn page_begin() -> u32 {
    let Some(view) = made() else { return 0 };
    view.works_elsewhere();
    u32::from(view.begin(&mut tell_work))
}

/// Sends the page the text.
#[unsafe(no_mangle)]
pub extern "C" fn page_text() {
    if let Some(view) = view() {
        view.send_text();
    }
}

/// Other files lie next to the program from now on: the message is a [`crate::begin::Begin`] without a program.
#[unsafe(no_mangle)]
pub extern "C" fn page_files() {
    let given = GIVEN.with_borrow(Clone::clone);
    if let Some(Err(error)) = given.map(|given| given.renew(input())) {
        refuse(0, &format!("the message {error}"), Some("load the page again"));
    }
}

/// Begins a view that works for another one: the message is a [`crate::begin::Begin`] without a program.
#[unsafe(no_mangle)]
pub extern "C" fn page_serve() {
    made();
}

/// Answers the request of a page.
#[unsafe(no_mangle)]
pub extern "C" fn page_ask() {
    let text = input();
    let Some(view) = view() else { return refuse(0, "no program is open", None) };
    match serde_json::from_slice::<Request>(&text) {
        Ok(request) => view.answer(request, &mut tell_work),
        Err(error) => refuse(0, &format!("the request cannot be read: {error}"), None),
    }
}

/// A view elsewhere has run the program: the message is the output of its `page_take_over`.
#[unsafe(no_mangle)]
pub extern "C" fn page_ran() {
    let told = String::from_utf8_lossy(&input()).into_owned();
    if let Some(view) = view()
        && let Err(error) = view.ran_elsewhere(&told, &mut tell_work)
    {
        refuse(0, &error.to_string(), None);
    }
}

/// What a view elsewhere needs to do this work: parts 0 and 1 go into its message. 0 where nobody wants it any more.
#[unsafe(no_mangle)]
pub extern "C" fn page_hand_over(kind: u32, number: f64) -> u32 {
    let handed = view().and_then(|view| view.hand_over(work_of(kind, number)));
    let Some((handed, text)) = handed else { return 0 };
    let handed = json!(handed).to_string().into_bytes();
    leave(vec![handed, text.into_bytes()]);
    1
}

/// Does the work of another view: the message is a [`Handed`] and the text. Part 0 is for its `page_ran`, where it has bytes.
#[unsafe(no_mangle)]
pub extern "C" fn page_take_over() {
    let message = input();
    let Some(view) = view() else { return };
    let (handed, text) = match Message::read::<Handed>(message) {
        Ok((handed, rest)) => (handed, String::from_utf8(rest.rest())),
        Err(error) => return refuse(0, &format!("the message {error}"), None),
    };
    let Ok(text) = text else { return refuse(0, "the text is not UTF-8", None) };
    match view.take_over(handed, text) {
        Ok(told) => leave(vec![told.unwrap_or_default().into_bytes()]),
        Err(refusal) => refuse(0, &refusal.message, refusal.help.as_deref()),
    }
}

/// Panics, so that the tests can see how the page goes on after one.
#[unsafe(no_mangle)]
pub extern "C" fn page_panic() {
    panic!("asked to panic");
}

//! How requests and answers lie in memory.
//!
//! `chordal_input(n)` gives the place for a request of so many bytes, `chordal_ask()` answers it: 0, or 1
//! where there is no answer but a reason. `chordal_language()`, where it is there, is asked in the same way. `chordal_part(i)` and `chordal_part_length(i)` give the places of the answer: 0 is
//! its text, from 1 on its columns. They stay until the next request or `chordal_forget()`.
//! Pointers only go out: nothing here reads memory by a number that JavaScript gives.

#![allow(unsafe_code, reason = "names that JavaScript calls, and the one function that it offers")]

use std::cell::RefCell;
use std::panic;

use chordal_ask::{Answer, ask};

use crate::memory;

thread_local! {
    static REQUEST: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<Answer> = const { RefCell::new(Answer { text: String::new(), parts: Vec::new() }) };
}

#[cfg(target_family = "wasm")]
#[link(wasm_import_module = "chordal")]
unsafe extern "C" {
    /// Takes the words of a panic, before the module ends.
    fn panicked(text: *const u8, length: usize);
}

/// Gives the words of a panic to JavaScript.
fn tell_of_panics() {
    #[cfg(target_family = "wasm")]
    panic::set_hook(Box::new(|info| {
        let text = info.to_string();
        // SAFETY: JavaScript reads so many bytes at the pointer before it returns.
        unsafe { panicked(text.as_ptr(), text.len()) }
    }));
    #[cfg(not(target_family = "wasm"))]
    drop(panic::take_hook());
}

/// The place for a request; null where there is no memory for it.
#[unsafe(no_mangle)]
pub extern "C" fn chordal_input(length: usize) -> *mut u8 {
    tell_of_panics();
    chordal_forget();
    REQUEST.with_borrow_mut(|request| {
        if request.try_reserve_exact(length).is_err() {
            return std::ptr::null_mut();
        }
        request.resize(length, 0);
        request.as_mut_ptr()
    })
}

/// Answers the request: 0 with an answer, 1 with the reason why there is none.
#[unsafe(no_mangle)]
pub extern "C" fn chordal_ask() -> u32 {
    // The bytes are not needed any more once they are read.
    let request = memory::read(&REQUEST.take());
    let (answer, failed) = match request.and_then(ask) {
        Ok(answer) => (answer, 0),
        Err(failure) => (Answer::text(failure.json().to_string()), 1),
    };
    ANSWER.set(answer);
    failed
}

/// Takes the request as a step of the language server, and answers it.
#[cfg(feature = "language")]
#[unsafe(no_mangle)]
pub extern "C" fn chordal_language() -> u32 {
    ANSWER.set(Answer::text(crate::language::step(&REQUEST.take())));
    0
}

/// How many parts the answer has, its text included.
#[unsafe(no_mangle)]
pub extern "C" fn chordal_parts() -> usize {
    ANSWER.with_borrow(|answer| 1 + answer.parts.len())
}

/// Where a part of the answer lies.
#[unsafe(no_mangle)]
pub extern "C" fn chordal_part(index: usize) -> *const u8 {
    with_part(index, <[u8]>::as_ptr)
}

/// How many bytes it has.
#[unsafe(no_mangle)]
pub extern "C" fn chordal_part_length(index: usize) -> usize {
    with_part(index, <[u8]>::len)
}

/// Gives the memory of request and answer back.
#[unsafe(no_mangle)]
pub extern "C" fn chordal_forget() {
    REQUEST.take();
    ANSWER.take();
}

fn with_part<T>(index: usize, look: impl FnOnce(&[u8]) -> T) -> T {
    ANSWER.with_borrow(|answer| match index.checked_sub(1) {
        None => look(answer.text.as_bytes()),
        Some(part) => look(answer.parts.get(part).map_or(&[][..], Vec::as_slice)),
    })
}

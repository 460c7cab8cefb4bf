//! How messages lie in the memory of a module of WebAssembly; the other half is `npm/src/memory.ts`.
//!
//! `memory_input(n)` gives the place for a message of so many bytes. A function of the module takes it ([`take_input`]) and
//! leaves what comes of it ([`put_output`]), which JavaScript finds part by part: `memory_parts()`, `memory_part(i)` and
//! `memory_part_length(i)`. The parts stay until the next message or `memory_forget()`.
//! Pointers only go out: nothing here reads memory by a number that JavaScript gives.

#![allow(unsafe_code, reason = "names that JavaScript calls, and the one function that it offers")]

mod message;

use std::cell::RefCell;
use std::panic;

pub use message::{MemoryMessage, TornMessage};

thread_local! {
    static INPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static OUTPUT: RefCell<Vec<Vec<u8>>> = const { RefCell::new(Vec::new()) };
}

/// The message that JavaScript has written; it is taken once.
#[must_use]
pub fn take_input() -> Vec<u8> {
    INPUT.take()
}

/// Leaves what came of a message.
pub fn put_output(parts: Vec<Vec<u8>>) {
    OUTPUT.set(parts);
}

#[cfg(target_family = "wasm")]
#[link(wasm_import_module = "chordal")]
unsafe extern "C" {
    /// Takes the words of a panic, before the module ends.
    fn panicked(text: *const u8, length: usize);
}

/// Gives the words of a panic to JavaScript.
fn report_panics() {
    #[cfg(target_family = "wasm")]
    panic::set_hook(Box::new(|info| {
        let text = info.to_string();
        // SAFETY: JavaScript reads so many bytes at the pointer before it returns.
        unsafe { panicked(text.as_ptr(), text.len()) }
    }));
    #[cfg(not(target_family = "wasm"))]
    drop(panic::take_hook());
}

/// The place for a message; null where there is no memory for it.
#[unsafe(no_mangle)]
pub extern "C" fn memory_input(length: usize) -> *mut u8 {
    report_panics();
    memory_forget();
    INPUT.with_borrow_mut(|input| {
        if input.try_reserve_exact(length).is_err() {
            return std::ptr::null_mut();
        }
        input.resize(length, 0);
        input.as_mut_ptr()
    })
}

/// How many parts there are.
#[unsafe(no_mangle)]
pub extern "C" fn memory_parts() -> usize {
    OUTPUT.with_borrow(Vec::len)
}

/// Where a part lies.
#[unsafe(no_mangle)]
pub extern "C" fn memory_part(index: usize) -> *const u8 {
    OUTPUT.with_borrow(|parts| parts.get(index).map_or(std::ptr::null(), Vec::as_ptr))
}

/// How many bytes it has.
#[unsafe(no_mangle)]
pub extern "C" fn memory_part_length(index: usize) -> usize {
    OUTPUT.with_borrow(|parts| parts.get(index).map_or(0, Vec::len))
}

/// Gives the memory of message and parts back.
#[unsafe(no_mangle)]
pub extern "C" fn memory_forget() {
    INPUT.take();
    OUTPUT.take();
}

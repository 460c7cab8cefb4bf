//! What JavaScript calls. A request is a message in memory (`chordal-memory`); of the answer part 0 is the text, from 1 on
//! its columns.

#![allow(unsafe_code, reason = "names that JavaScript calls")]

use chordal_ask::{Answer, ask};

use crate::request;

fn leave(answer: Answer) {
    let Answer { text, mut parts } = answer;
    parts.insert(0, text.into_bytes());
    chordal_memory::leave(parts);
}

/// Answers the request: 0 with an answer, 1 with the reason why there is none.
#[unsafe(no_mangle)]
pub extern "C" fn chordal_ask() -> u32 {
    let (answer, failed) = match request::read(chordal_memory::input()).and_then(ask) {
        Ok(answer) => (answer, 0),
        Err(failure) => (Answer::text(failure.json().to_string()), 1),
    };
    leave(answer);
    failed
}

/// Takes the request as a step of the language server, and answers it.
#[cfg(feature = "language")]
#[unsafe(no_mangle)]
pub extern "C" fn chordal_language() {
    leave(Answer::text(crate::language::step(&chordal_memory::input())));
}

//! What JavaScript calls. A request is a message in memory (`chordal-memory`); of the answer part 0 is the text, from 1 on
//! its columns.

#![allow(unsafe_code, reason = "names that JavaScript calls")]

use chordal_ask::QuestionAnswer;

use crate::request;

fn leave(answer: QuestionAnswer) {
    let QuestionAnswer { text, mut parts } = answer;
    parts.insert(0, text.into_bytes());
    chordal_memory::put_output(parts);
}

/// Answers the request: 0 with an answer, 1 with the reason why there is none.
#[unsafe(no_mangle)]
pub extern "C" fn chordal_answer() -> u32 {
    let (answer, failed) =
        match request::read(chordal_memory::take_input()).and_then(chordal_ask::answer) {
            Ok(answer) => (answer, 0),
            Err(failure) => (QuestionAnswer::text(failure.json().to_string()), 1),
        };
    leave(answer);
    failed
}

/// Takes the request as a step of the language server, and answers it.
#[cfg(feature = "language")]
#[unsafe(no_mangle)]
pub extern "C" fn chordal_language() {
    leave(QuestionAnswer::text(crate::language::step(&chordal_memory::take_input())));
}

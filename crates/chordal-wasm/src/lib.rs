//! Chordal as WebAssembly: the compiled half of the npm package `@chordal/core`.
//!
//! JavaScript writes a request ([`request`]) into the memory of the module (`chordal-memory`), calls it ([`interface`]), and
//! reads an answer: text, and columns of numbers. No file, clock or thread is used; files that a program needs come with
//! the request. The questions and their answers are in `chordal-ask`.
//!
//! With the feature `language` it contains the language server as well, for an editor in the browser.
//!
//! A panic ends the module, not the page: JavaScript makes a new one for the next question.

mod interface;
#[cfg(feature = "language")]
mod language;
mod request;

//! Chordal as WebAssembly: the compiled half of the npm package `@chordal/core`.
//!
//! JavaScript writes a request ([`request`]) into the memory of the module (`chordal-memory`), asks ([`interface`]), and
//! reads an answer: text, and columns of numbers. No file, clock or thread is used; files that a program needs come with
//! the request. What is asked and answered is `chordal-ask`.
//!
//! With the feature `language` it holds the language server as well, for an editor in the browser.
//!
//! A panic ends the module, not the page: JavaScript makes a new one for the next question.

mod interface;
#[cfg(feature = "language")]
mod language;
mod request;

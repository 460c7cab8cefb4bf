//! Chordal as WebAssembly: the compiled half of the npm package `@chordal/core`.
//!
//! JavaScript writes a request into the memory of the module ([`request`]), asks, and reads an answer
//! ([`answer`]): text, and columns of numbers. No file, clock or thread is used; files that a
//! program needs come with the request. The texts are those that the command prints, by the same
//! writers. What is here in addition is only how requests and answers lie in memory ([`interface`]).
//!
//! A panic ends the module, not the page: JavaScript makes a new one for the next question.

mod answer;
mod ask;
mod columns;
mod interface;
mod loading;
mod motion;
mod options;
mod programs;
mod request;
mod words;

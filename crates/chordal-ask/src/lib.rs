//! Questions about programs and their answers: what the shells that exchange messages have in common, the npm package
//! and `chordal serve`.
//!
//! A [`QuestionRequest`] names the question, the programs and options; a [`QuestionAnswer`] is text, and columns of
//! numbers. The texts are those that the command prints, by the same writers. No file, clock or thread is used but
//! for the files of a request that are on the disk.

mod answer;
mod columns;
mod load_request;
mod meanings;
mod motion;
mod options;
mod programs;
mod questions;
mod request;

pub use answer::{QuestionAnswer, QuestionFailure};
pub use chordal_load::FileAccess;
pub use columns::inline;
pub use load_request::setup_of;
pub use questions::answer;
pub use request::{ProgramOptions, QuestionProgram, QuestionRequest, options};

//! Questions about programs and their answers: what shells that speak in messages have in common, the npm package
//! and `chordal serve`.
//!
//! A [`Request`] names the question, the programs and what else is said; an [`Answer`] is text, and columns of
//! numbers. The texts are those that the command prints, by the same writers. No file, clock or thread is used but
//! for the files of a request that are on the disk.

mod answer;
mod ask;
mod columns;
mod loading;
mod motion;
mod options;
mod programs;
mod request;
mod words;

pub use answer::{Answer, Failure};
pub use ask::ask;
pub use chordal_load::FileAccess;
pub use columns::inline;
pub use loading::setup_of;
pub use request::{Program, ProgramOptions, Request, options};

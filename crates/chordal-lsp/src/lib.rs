//! The language server: a synchronous loop that answers an editor, and one thread that runs the
//! programs as they change.
//!
//! What is answered comes from `chordal-editor`; this crate knows the protocol and nothing of
//! programs. How a file gets its machine and its subprograms is the caller's [`Opener`].

#![forbid(unsafe_code)]

mod actions;
mod convert;
mod document;
mod features;
mod place;
mod server;
mod worker;

use std::path::Path;

use chordal::{Machine, control::RunOptions};

pub use server::{ServeError, serve};

/// What a text needs to run.
#[derive(Debug)]
pub struct Opened {
    /// The machine.
    pub machine: Machine,
    /// Why this one, in a line, where the user did not say it.
    pub why: Option<String>,
    /// Budgets.
    pub options: RunOptions,
    /// The one program of the text to run, where only one is wanted.
    pub program: Option<u32>,
    /// Texts in which subprograms may be, by name.
    pub beside: Vec<(String, Vec<u8>)>,
}

/// Finds what a text needs to run.
pub trait Opener {
    /// For a text that lies, or will lie, at a path. `machine` is what the editor's settings
    /// say: a built-in name or a file.
    ///
    /// # Errors
    /// A sentence for people.
    fn open(
        &self,
        path: Option<&Path>,
        text: &[u8],
        machine: Option<&str>,
    ) -> Result<Opened, String>;
}

//! The language server: a synchronous loop that answers an editor, and one thread that runs the
//! programs as they change. Where there are no threads, the caller takes its steps ([`SteppedServer`]).
//!
//! What is answered comes from `chordal-editor`; this crate knows the protocol and nothing of
//! programs. How a file gets its machine and its subprograms is the caller's [`SetupFinder`].
//!
//! ```
//! use std::path::Path;
//!
//! use chordal::Machine;
//! use chordal_editor::EditorSetup;
//! use chordal_lsp::SetupFinder;
//!
//! /// Every text is for one machine, unless the editor says another.
//! struct OneMachine;
//!
//! impl SetupFinder for OneMachine {
//!     fn open(&self, _: Option<&Path>, _: &[u8], machine: Option<&str>) -> Result<EditorSetup, String> {
//!         let machine = Machine::from_builtin(machine.unwrap_or("haas-vf2"));
//!         machine.map(EditorSetup::of).map_err(|errors| errors[0].message.clone())
//!     }
//! }
//!
//! assert!(OneMachine.open(None, b"M30", Some("fanuc-30i")).is_ok());
//! // let (connection, threads) = lsp_server::Connection::stdio();
//! // chordal_lsp::serve(&connection, &OneMachine)?;
//! ```

#![forbid(unsafe_code)]

mod actions;
mod convert;
mod document;
mod features;
mod file_uri;
mod panic_guard;
mod place;
mod server;
mod stepwise;
mod worker;

use std::path::Path;

use chordal_editor::EditorSetup;

pub use server::{ServeError, serve};
pub use stepwise::SteppedServer;

/// Finds what a text needs to run.
pub trait SetupFinder {
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
    ) -> Result<EditorSetup, String>;
}

impl<T: SetupFinder + ?Sized> SetupFinder for &T {
    fn open(
        &self,
        path: Option<&Path>,
        text: &[u8],
        machine: Option<&str>,
    ) -> Result<EditorSetup, String> {
        (**self).open(path, text, machine)
    }
}

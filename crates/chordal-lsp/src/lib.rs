//! The language server: a synchronous loop that answers an editor, and one thread that runs the programs when they
//! change. Without threads, the caller executes it step by step ([`SteppedServer`]).
//!
//! The answers come from `chordal-editor`; this crate knows only the protocol. The caller's [`SetupFinder`] finds the
//! machine and the subprograms of a file.
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

/// Finds the machine and the subprograms that a text needs to run.
pub trait SetupFinder {
    /// Finds the setup of a text. `path` is where it is or will be saved; `None` for a text without a file. `machine`
    /// is the machine in the editor's settings, a built-in name or a file; `None` when they do not name one.
    ///
    /// # Errors A sentence that is shown to the user.
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

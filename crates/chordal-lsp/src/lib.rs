//! The language server: a synchronous loop that answers an editor, and one thread that runs the
//! programs as they change. Where there are no threads, the caller takes its steps ([`Stepwise`]).
//!
//! What is answered comes from `chordal-editor`; this crate knows the protocol and nothing of
//! programs. How a file gets its machine and its subprograms is the caller's [`Opener`].
//!
//! ```
//! use std::path::Path;
//!
//! use chordal::Machine;
//! use chordal_editor::Setup;
//! use chordal_lsp::Opener;
//!
//! /// Every text is for one machine, unless the editor says another.
//! struct OneMachine;
//!
//! impl Opener for OneMachine {
//!     fn open(&self, _: Option<&Path>, _: &[u8], machine: Option<&str>) -> Result<Setup, String> {
//!         let machine = Machine::from_builtin(machine.unwrap_or("haas-vf2"));
//!         machine.map(Setup::of).map_err(|errors| errors[0].message.clone())
//!     }
//! }
//!
//! assert!(OneMachine.open(None, b"M30", Some("fanuc-30i")).is_ok());
//! // let (connection, threads) = lsp_server::Connection::stdio();
//! // chordal_lsp::serve(&connection, &OneMachine)?;
//! ```

#![forbid(unsafe_code)]

mod actions;
mod caught;
mod convert;
mod document;
mod features;
mod file_uri;
mod place;
mod server;
mod stepwise;
mod worker;

use std::path::Path;

use chordal_editor::Setup;

pub use server::{ServeError, serve};
pub use stepwise::Stepwise;

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
    ) -> Result<Setup, String>;
}

impl<T: Opener + ?Sized> Opener for &T {
    fn open(
        &self,
        path: Option<&Path>,
        text: &[u8],
        machine: Option<&str>,
    ) -> Result<Setup, String> {
        (**self).open(path, text, machine)
    }
}

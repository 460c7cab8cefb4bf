//! Loads programs for all front ends (command line, editor, Python, browser): their texts, the machines they run on
//! and the subprograms in the same folder.
//!
//! A [`Request`] overrides what the folder's `chordal.toml` or the text itself specifies. [`file`] and [`text`] load
//! one program, a [`Loader`] many programs with the same request; [`find`] lists the programs in folders. The result
//! is a [`Loaded`]: the program, its machine and the reason for this machine ([`MachineReason`]). Every failure is a
//! [`LoadError`].
//!
//! ```
//! use chordal_load::{RequestedMachine, Request, text};
//!
//! let request = Request {
//!     machine: Some(RequestedMachine::Name("haas-vf2".into())),
//!     set: vec!["tools.5.diameter=\"0.5 in\"".into()],
//!     ..Request::default()
//! };
//! let program = b"G21 G90 S900 M3\nG1 X0 Y0 F100.\nX10.\nM30\n";
//! let loaded = text("part.nc", program.to_vec(), &request)?;
//! assert_eq!(loaded.machine().title, "Haas VF-2");
//! assert_eq!(loaded.job()?.report().summary.lines, 2);
//! # Ok::<(), chordal_load::LoadError>(())
//! ```

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a shell: files are its business, so that they are nobody else's"
)]

mod assumption;
mod disk;
mod error;
mod files;
mod head;
mod input;
pub mod ledger;
mod loader;
pub mod machine;
mod machine_reason;
mod neighbours;
mod not_a_program;
mod program_load;
mod readings;
mod request;
mod text;
mod variables;

use std::path::Path;

pub use assumption::MovedAxes;
pub use error::{LoadError, reason};
pub use files::FileAccess;
pub use input::{ProgramInput, find, has_other_ending, looks_like_program};
pub use loader::Loader;
pub use machine_reason::MachineReason;
pub use neighbours::without_called;
pub use program_load::Loaded;
pub use readings::{ReadingDifference, ReadingGroup, ReadingPremise};
pub use request::{BlockDeleteSwitch, Request, RequestedMachine};
pub use text::ProgramText;

/// Loads a file.
///
/// # Errors The file cannot be read, the machine cannot be used, or the requested program number does not exist.
pub fn file(path: &Path, request: &Request) -> Result<Loaded, LoadError> {
    let input = ProgramInput { path: Some(path.to_path_buf()), root: None };
    Loader::new(request.clone())?.load_text(ProgramText::read(&input)?, &input)
}

/// Loads a text under a name that messages show. Unlike a file, a text that does not look like a program is not
/// refused.
///
/// # Errors The machine cannot be used, or the requested program number does not exist.
pub fn text(name: &str, bytes: Vec<u8>, request: &Request) -> Result<Loaded, LoadError> {
    let input = ProgramInput { path: None, root: None };
    Loader::new(request.clone())?.load_unsaved(ProgramText::of(name, bytes)?, &input)
}

/// Loads an unsaved text from an editor; `path` is where it is or will be saved. It is not refused when it does not
/// look like a program, because it may be half written.
///
/// # Errors The machine cannot be used, or the requested program number does not exist.
pub fn unsaved(
    path: Option<&Path>,
    bytes: Vec<u8>,
    request: &Request,
) -> Result<Loaded, LoadError> {
    let input = ProgramInput { path: path.map(Path::to_path_buf), root: None };
    let text = ProgramText::of(&input.name(), bytes)?;
    Loader::new(request.clone())?.load_unsaved(text, &input)
}

//! What an editor asks about a program: what a word means here, what is active after a block,
//! the outline, names and where they stand, completions, format.
//!
//! Plain data out; protocols and sockets are the business of the shells. Places are bytes of the
//! program's text, half open; lines count from 1.

#![forbid(unsafe_code)]

mod complete;
mod elsewhere;
mod format;
mod grammar;
mod hover;
pub mod meaning;
mod moves;
mod names;
mod outline;
mod place;
mod program;
mod rests;
mod scan;
mod setup;
mod tokens;

pub use complete::{Completion, CompletionKind};
pub use elsewhere::Found;
pub use format::{Edit, FormatError, Numbering};
pub use grammar::grammar;
pub use hover::{Hover, diagnostic_markdown};
pub use moves::{LineMoves, Ran};
pub use names::{Name, Occurrence, RenameError, Renamed, Role};
pub use outline::{Entry, EntryKind};
pub use place::{byte_of, line_and_column};
pub use program::Program;
pub use setup::{Checked, Setup};
pub use tokens::{Class, Token};

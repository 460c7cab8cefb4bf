//! What an editor asks about a program: what a word means here, what is active after a block,
//! the outline, names and where they stand, completions, format.
//!
//! Plain data out; protocols and sockets are the business of the shells. Places are bytes of the
//! program's text, half open; lines count from 1.
//!
//! ```
//! use chordal::Machine;
//! use chordal_editor::EditorProgram;
//!
//! let machine = Machine::from_builtin("haas-vf2").unwrap();
//! let text = b"T1 M6 (DRILL)\nG83 Z-1. R.1 Q.2 F5.\nM30\n".to_vec();
//! let program = EditorProgram::new("part.nc", text, machine).unwrap();
//! assert!(program.hover(15, None).unwrap().text.contains("deep drilling"));
//! assert!(!program.outline().is_empty());
//! ```

#![forbid(unsafe_code)]

mod check;
mod checkpoints;
mod edit_proof;
pub mod explain;
mod grammar;
mod hover;
pub mod meaning;
mod modal_text;
mod moves;
mod other_files;
mod outline;
mod place;
mod program;
mod questions;
pub mod reference;
mod setup;
mod state_after;
mod word_address;

pub use check::PreviousCheck;
pub use chordal::control::{Token, TokenClass};
pub use edit_proof::{FormatEdit, FormatError};
pub use grammar::grammar;
pub use hover::{Hover, diagnostic_markdown};
pub use moves::{LineMoves, RunMoves};
pub use other_files::OccurrenceInFile;
pub use outline::{EntryKind, OutlineEntry};
pub use place::{LineColumnIndex, byte_of, line_and_column};
pub use program::EditorProgram;
pub use setup::EditorSetup;
pub use word_address::{
    Completion, CompletionKind, NameOccurrence, NameRole, NumberingOptions, RenameError,
    RenamedVariable, SymbolName,
};

//! The word-address language: reads text into blocks and carries them out with the kernel.
//!
//! [`Library`] finds the programs of a text, [`run`] carries one out: its blocks in order, calls, loops, macro
//! statements. The tables of `chordal-dialect` define what a code does on a control; the kernel makes the moves.
//!
//! ```
//! use chordal_diagnostics::{Source, SourceMap};
//! use chordal_dialect::Control;
//! use chordal_gcode::WordAddress;
//! use chordal_kernel::{ProgramSet, RunOptions};
//! use chordal_machine::Machine;
//!
//! let mut sources = SourceMap::new();
//! sources.add(Source::new("part.nc", b"%\nO0007\nG0 X1.\nM30\n%\n".as_slice()));
//! let machine = Machine::from_builtin("haas-vf2").unwrap();
//! let (control, _) = Control::of(&machine).unwrap();
//! let options = RunOptions::default();
//! let language = WordAddress::new(&sources, &machine, &control, &options);
//! assert_eq!(language.programs()[0].number(), Some(7));
//! // The meaning of the word at byte 8: G0.
//! assert!(language.meaning(8).unwrap().1.starts_with("G0: "));
//! ```

#![forbid(unsafe_code)]

mod called_subroutines;
mod firmware;
mod initial_offsets;
mod interpreter;
mod library;
mod macro_alone;
mod macros;
mod marks;
mod recognize;
mod tokens;
mod word_address;

pub use called_subroutines::called_subs;
pub use interpreter::{run, run_from, subroutine_head};
pub use library::{Library, Program, referenced_programs};
pub use marks::{StatementMark, marks};
pub use recognize::{candidates, not_read};
pub use tokens::{block_tokens, class_of};
pub use word_address::{WordAddress, WordAddressControl, WordAddressLanguage};

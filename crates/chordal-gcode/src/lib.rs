//! The word-address language: text into blocks, blocks into what the kernel does.
//!
//! [`Library`] finds the programs of a text, [`run`] carries one out: blocks one after the other,
//! calls, loops, macro statements. What a code does on a control stands in its table
//! (`chordal-dialect`); how the machine moves is the kernel's business.

#![forbid(unsafe_code)]

mod called_subroutines;
mod interpreter;
mod library;
mod macros;
mod marks;
mod recognize;
mod shop;
mod tokens;
mod word_address;

pub use called_subroutines::called_subs;
pub use interpreter::{
    Interrupt, RunOptions, initial_offset, initial_work_offset, run, run_from, subroutine_head,
};
pub use library::{Library, Program, referenced_programs};
pub use marks::{Mark, marks};
pub use recognize::{Recognition, recognize};
pub use shop::{ShopAnswer, ShopCall, ShopCode, ShopCodes, ShopRecord};
pub use tokens::{block_tokens, class_of};
pub use word_address::WordAddress;

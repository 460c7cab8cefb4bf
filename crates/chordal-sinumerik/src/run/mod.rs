//! Runs part programs.
//!
//! `interpreter` reads blocks and follows jumps, loops and calls; `collect` turns statements into words; `modes`, `frames`,
//! `tools` set what the following blocks use; `motion`, `arcs`, `corners` move; `drilling` and
//! `milling` carry out cycles.

mod arcs;
mod calls;
mod collect;
mod drilling;
mod flow;
mod frames;
mod interpreter;
mod milling;
mod modes;
mod motion;
mod problems;
mod program_texts;
mod programmable_frame;
mod programs;
mod run_state;
mod tools;
mod variables;
mod words;

pub use programs::SinumerikPrograms;

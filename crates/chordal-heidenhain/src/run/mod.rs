//! Runs programs.
//!
//! `interpreter` reads blocks in their order and `dispatch` carries them out; `flow` follows labels, calls and jumps;
//! `assignments` and `block_values` give words their values; `contours` turns path functions into lines and arcs, which
//! `motion` moves along; `blank` checks rapids, `corners` and `compensation` look ahead for what changes them; `functions` and `tools` set what the
//! following blocks use; `iso` is for the blocks of
//! DIN/ISO programs, `frames`, `transformations` and `tilting` are the coordinates, `cycles` the cycles. `restart` writes a
//! program so that it begins at a line.

mod approaches;
mod assignments;
mod blank;
mod blank_record;
mod block_values;
mod compensation;
mod contour_programs;
mod contours;
mod corners;
mod cycle_moves;
mod cycles;
mod datums;
mod dispatch;
mod flow;
mod frames;
mod free_contours;
mod free_values;
mod functions;
mod interpreter;
mod iso;
mod iso_modes;
mod motion;
mod problems;
mod program_texts;
mod programs;
mod restart;
mod run_state;
mod tilting;
mod tools;
mod transformations;

pub use program_texts::{called_program_names, program_head};
pub use programs::KlartextPrograms;

//! Runs part programs.
//!
//! `interpreter` reads blocks and follows jumps, loops and calls; `collect` turns statements into words; `modes`, `frames`,
//! `tools` set what the following blocks use; `motion`, `arcs` and `space_arcs` move; `spindles` and `transformations` are for
//! live tools; `drilling`, `milling`, `contour_milling` and `turning` carry out cycles; `unknown_values` tells what depends on
//! values that nobody gave.

mod active_codes;
mod approach;
mod arcs;
mod block_checks;
mod calls;
mod collect;
mod contour_milling;
mod contours;
mod drilling;
mod flow;
mod frame_chain;
mod frames;
mod interpreter;
mod iso_mode;
mod macros;
mod milling;
mod modes;
mod motion;
mod plain_lines;
mod problems;
mod program_texts;
mod programmable_frame;
mod programs;
mod run_state;
mod scope;
mod similar_names;
mod space_arcs;
mod spindles;
mod swivel;
mod system_variables;
mod system_writes;
mod tables;
mod threads;
mod tool_edges;
mod tools;
mod transformations;
mod turning;
mod unknown_values;
mod variables;
mod words;

pub use frame_chain::{axis_of, shift_of_chain};
pub use programs::SinumerikPrograms;
pub use system_variables::{ToolDatum, settable_name};
pub use words::CENTER_NAMES;

//! The conversational language of HEIDENHAIN controls (Klartext): reads programs and drives the kernel.
//!
//! `syntax` reads the text into blocks and never fails; `values` are those of parameters and formulas; `geometry` has
//! tangent arcs, approaches and departures as pure functions; `cycles` says what the cycles do; `run` carries a program
//! out, `writer` writes one from what a program does.

#![forbid(unsafe_code)]

mod alarms;
mod blank_form;
mod control;
pub mod cycles;
mod datum_table;
mod defined_tools;
mod editing;
pub mod geometry;
mod recognition;
mod run;
mod settings;
pub mod syntax;
mod table;
mod tool_table;
pub mod values;
mod writer;

pub use control::{HeidenhainControl, HeidenhainLanguage};
pub use run::KlartextPrograms;
pub use settings::HeidenhainSettings;
pub use writer::KlartextWriter;

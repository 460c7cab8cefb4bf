//! The language of Sinumerik 840D and 828D: reads part programs and drives the kernel.
//!
//! `syntax` reads the text into blocks and never fails; `values` are those of variables and expressions; `cycles` says
//! what the standard cycles do; `run` carries a program out, `writer` writes one from
//! what a program of another language does.

#![forbid(unsafe_code)]

mod alarms;
mod control;
pub mod cycles;
mod machine_tables;
mod run;
mod settings;
pub mod syntax;
pub mod values;
mod vocabulary;
mod writer;

pub use control::{SinumerikControl, SinumerikLanguage};
pub use run::SinumerikPrograms;
pub use settings::SinumerikSettings;
pub use writer::PartProgramWriter;

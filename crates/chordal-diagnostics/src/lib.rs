//! Spans, sources and diagnostics as plain data, and the registry of codes.
//!
//! Nothing here draws, reads or writes: a [`Diagnostic`] says *where* (spans into a
//! [`SourceMap`]), *what* (a message with the measured numbers), what the user's own
//! control would show, and what to do about it. How it looks is the business of a shell.

#![forbid(unsafe_code)]

mod appended;
mod collect;
mod diagnostic;
mod registry;
mod shift;
mod source;
mod span;

pub use collect::{Collector, Counts};
pub use diagnostic::{Applicability, Diagnostic, Fix, Label, Severity};
pub use registry::{Code, CodeInfo};
pub use shift::Shift;
pub use source::{LineColumn, Source, SourceMap};
pub use span::{FileId, Span, TextRange};

//! Spans, sources and diagnostics as plain data, and the registry of codes.
//!
//! Nothing here displays, reads or writes: a [`Diagnostic`] says *where* (spans into a [`SourceMap`]), *what* (a
//! message with the measured numbers), what the user's own control would show, and what to do about it. Front ends
//! decide how it looks.
//!
//! ```
//! use chordal_diagnostics::{Code, Diagnostic, Severity, Source, SourceMap, Span, TextRange};
//!
//! let mut sources = SourceMap::new();
//! let file = sources.add(Source::new("part.nc", b"G21\nG1 X1..5\n".as_slice()));
//! let span = Span { file, range: TextRange { start: 7, end: 12 } };
//! let problem = Diagnostic::new(Code::BadNumber, span, "two decimal points")
//!     .help("leave one of them out");
//! assert_eq!(problem.severity, Severity::Error);
//! assert_eq!(sources.words(span), "X1..5");
//! assert_eq!(sources.get(file).unwrap().line_column(span.range.start).line, 2);
//! ```

#![forbid(unsafe_code)]

mod collect;
mod diagnostic;
mod registry;
mod severity;
mod shift;
mod source;
mod source_map;
mod span;
mod text_store;

pub use collect::{Collector, SeverityCounts};
pub use diagnostic::{Applicability, Diagnostic, Fix, Label};
pub use registry::{Code, CodeInfo};
pub use severity::Severity;
pub use shift::TextShift;
pub use source::{LineColumn, Source, line_end_length, line_ends};
pub use source_map::SourceMap;
pub use span::{FileId, Span, TextRange};

//! The report of a program: what a shop prints, mails and keeps at the machine.
//!
//! [`gather`] runs a program once and gathers a [`Document`]: plain data, millimetres, seconds and
//! degrees. [`html`] makes one page of it that needs nothing else, in the program's own units, and
//! [`json`] the same as data. Whatever the program, both are of bounded size: rows beyond a table's
//! most are counted. The same program on the same machine gives the same bytes.
//!
//! ```
//! use chordal::{Job, Machine, Source, SourceMap};
//! use chordal_report::{ReportContext, gather, html};
//!
//! let mut sources = SourceMap::new();
//! sources.add(Source::new("part.nc", b"G21 G90 T1 M6\nS900 M3\nG1 X10. F100.\nM30\n".as_slice()));
//! let job = Job::new(sources, Machine::from_builtin("haas-vf2").unwrap()).unwrap();
//! let about = ReportContext { file: "part.nc", date: Some("2024-05-17"), ..ReportContext::default() };
//! let found = gather(&job, &about);
//! assert!(html(&found.document).contains("part.nc"));
//! ```

#![forbid(unsafe_code)]

mod data;
mod gather;
mod page;

pub use data::{
    AxisRange, AxisValue, CalledProgram, CappedRows, Document, FeedRange, MachineTravel,
    MoveCounts, Operation, OperatorStop, PathPicture, PathPictures, PlannedTime, Register,
    ReportHead, ReportedBlock, ReportedProblem, ReportedStock, ReportedTool, ReportedWorkOffset,
    SkippedBlocks, StockTool, StopKind, ToolSign, Travel, VolumeBounds, WaitTime,
};
pub use gather::{GatheredReport, ReportContext, gather, title};
pub use page::html;

use chordal::{Diagnostic, SourceMap};

/// One problem as a piece of a page: a `div` of the classes `problem` and its severity, which the page
/// styles.
pub fn problem_html(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    page::problem(&gather::problems::problem(diagnostic, sources)).into_string()
}

/// The document as one JSON object, schema `chordal.report/1`.
pub fn json(document: &Document) -> String {
    // Plain data without maps: nothing in it can fail.
    chordal_export::pretty_json(serde_json::to_value(document).unwrap_or_default())
}

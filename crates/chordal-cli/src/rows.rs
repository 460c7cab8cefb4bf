//! A command that writes rows of one program: where they go, in which format, and what is reported
//! next to them.

use std::io;
use std::path::{Path, PathBuf};

use chordal::{Job, Report, Severity};
use chordal_export::format::{FormatList, OutputFormat};
use chordal_export::report::{self, ReportDetail};
use chordal_load::Loaded;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_of;
use crate::options::CommonArgs;
use crate::out::{RowOutput, trouble};
use crate::programs::{load_one, recognized};
use crate::terminal::TerminalSupport;

/// Where rows go and how they are written.
pub struct RowTarget<'p> {
    path: Option<&'p Path>,
    format: OutputFormat,
}

impl<'p> RowTarget<'p> {
    /// As the command line says; `streamed` is the format of standard output, `rows` says what is
    /// written, for messages.
    pub fn of(
        list: &FormatList,
        path: Option<&'p Path>,
        requested: Option<OutputFormat>,
        streamed: OutputFormat,
        rows: &str,
    ) -> Result<RowTarget<'p>, CommandFailure> {
        Ok(RowTarget { path, format: format_of(list, requested, path, streamed, rows)? })
    }

    /// Runs a program and writes its rows. The output is opened before the program is read, and
    /// comes to its place when all rows are in it.
    pub fn write(
        &self,
        program: &PathBuf,
        common: &CommonArgs,
        terminal: TerminalSupport,
        rows: impl FnOnce(&Job<'_>, RowOutput, OutputFormat) -> io::Result<(Report, RowOutput)>,
    ) -> Result<ExitVerdict, CommandFailure> {
        self.write_if(program, common, terminal, |_| Ok(()), rows)
    }

    /// The same where `goes` finds no reason against it.
    pub fn write_if(
        &self,
        program: &PathBuf,
        common: &CommonArgs,
        terminal: TerminalSupport,
        goes: impl FnOnce(&Job<'_>) -> Result<(), CommandFailure>,
        rows: impl FnOnce(&Job<'_>, RowOutput, OutputFormat) -> io::Result<(Report, RowOutput)>,
    ) -> Result<ExitVerdict, CommandFailure> {
        let out = RowOutput::open(self.path, program, self.format)?;
        let loaded = load_one(program, common)?;
        let job = loaded.job()?;
        goes(&job)?;
        let written = rows(&job, out, self.format);
        let (report, out) = written.map_err(|error| trouble(self.path, error))?;
        out.put()?;
        Ok(print_problems(&report, &loaded, &job, terminal))
    }
}

/// What was recognized, and the problems, on standard error, where they are in nobody's way.
pub fn print_problems(
    report: &Report,
    loaded: &Loaded,
    job: &Job,
    terminal: TerminalSupport,
) -> ExitVerdict {
    terminal.write_error(&recognized(loaded));
    terminal.write_error(&report::text(
        report,
        job.sources(),
        terminal.err,
        ReportDetail::default(),
    ));
    if report.worst() == Some(Severity::Error) { ExitVerdict::Problems } else { ExitVerdict::Clean }
}

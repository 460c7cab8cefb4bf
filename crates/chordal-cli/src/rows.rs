//! A command that writes rows of one program: where they go, in which format, and what is reported
//! next to them.

use std::io;
use std::path::{Path, PathBuf};

use chordal::{Job, Report, Severity};
use chordal_export::report::{self, Detail};
use chordal_load::Loaded;

use crate::failure::{Failure, Verdict};
use crate::options::Common;
use crate::out::{Format, Out, format_of, trouble};
use crate::programs::{load_one, recognized};
use crate::terminal::Terminal;

/// Where rows go and how they are written.
pub struct Output<'p, F> {
    path: Option<&'p Path>,
    format: F,
}

impl<'p, F: Format> Output<'p, F> {
    /// As the command line says; `streamed` is the format of standard output, `rows` says what is
    /// written, for messages.
    pub fn of(
        path: Option<&'p Path>,
        said: Option<F>,
        streamed: F,
        rows: &str,
    ) -> Result<Output<'p, F>, Failure> {
        Ok(Output { path, format: format_of(said, path, streamed, rows)? })
    }

    /// Runs a program and writes its rows. The output is opened before the program is read, and
    /// comes to its place when all rows are in it.
    pub fn write(
        &self,
        program: &PathBuf,
        common: &Common,
        terminal: Terminal,
        rows: impl FnOnce(&Job<'_>, Out, F) -> io::Result<(Report, Out)>,
    ) -> Result<Verdict, Failure> {
        self.write_if(program, common, terminal, |_| Ok(()), rows)
    }

    /// The same where `goes` finds no reason against it.
    pub fn write_if(
        &self,
        program: &PathBuf,
        common: &Common,
        terminal: Terminal,
        goes: impl FnOnce(&Job<'_>) -> Result<(), Failure>,
        rows: impl FnOnce(&Job<'_>, Out, F) -> io::Result<(Report, Out)>,
    ) -> Result<Verdict, Failure> {
        let out = Out::open(self.path, program, self.format)?;
        let loaded = load_one(program, common)?;
        let job = loaded.job()?;
        goes(&job)?;
        let written = rows(&job, out, self.format);
        let (report, out) = written.map_err(|error| trouble(self.path, error))?;
        out.put()?;
        Ok(tell(&report, &loaded, &job, terminal))
    }
}

/// What was recognized, and the problems, on standard error, where they are in nobody's way.
pub fn tell(report: &Report, loaded: &Loaded, job: &Job, terminal: Terminal) -> Verdict {
    terminal.tell(&recognized(loaded));
    terminal.tell(&report::text(report, job.sources(), terminal.err, Detail::default()));
    if report.worst() == Some(Severity::Error) { Verdict::Problems } else { Verdict::Clean }
}

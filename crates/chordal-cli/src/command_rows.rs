//! Rows of commands, as programmed or of the tool centre, in the formats that both have.

use std::io;

use chordal::{Command, Job, PathCommand};
use chordal_export::columns::{ColumnFile, CommandColumns};
use chordal_export::{CommandCsv, CommandJsonLines};

use crate::out::{FileFormat, RowFormat, RowOutput};

/// Writes rows of commands.
pub enum CommandRows<'a> {
    Jsonl(Box<CommandJsonLines<'a, RowOutput>>),
    Csv(Box<CommandCsv<RowOutput>>),
    Columns(Box<ColumnFile<RowOutput, CommandColumns<'a>>>),
}

impl<'a> CommandRows<'a> {
    /// Rows of the commands of a job, or of those of the tool centre.
    pub fn new(
        out: RowOutput,
        format: RowFormat,
        job: &'a Job<'a>,
        of_path: bool,
    ) -> io::Result<CommandRows<'a>> {
        if let Some(columns) = format.columns() {
            let rows =
                if of_path { CommandColumns::of_path(job) } else { CommandColumns::new(job) };
            let file = ColumnFile::new(out, columns, rows)?;
            return Ok(CommandRows::Columns(Box::new(file)));
        }
        if format == RowFormat::Jsonl {
            let rows = CommandJsonLines::new(out, job)?;
            return Ok(CommandRows::Jsonl(Box::new(rows)));
        }
        let csv = if of_path { CommandCsv::of_path(out, job) } else { CommandCsv::new(out, job) };
        csv.map(Box::new).map(CommandRows::Csv)
    }

    /// Takes a command as programmed.
    pub fn command(&mut self, command: &Command) -> io::Result<()> {
        match self {
            CommandRows::Jsonl(out) => out.command(command),
            CommandRows::Csv(out) => out.command(command),
            CommandRows::Columns(out) => out.put(|rows| rows.command(command)),
        }
    }

    /// Takes a command of the tool centre.
    pub fn path_command(&mut self, path: PathCommand<'_>) -> io::Result<()> {
        match self {
            CommandRows::Jsonl(out) => out.path_command(path),
            CommandRows::Csv(out) => out.path_command(path),
            CommandRows::Columns(out) => out.put(|rows| rows.path_command(path)),
        }
    }

    /// The output, with all rows in it.
    pub fn finish(self) -> io::Result<RowOutput> {
        match self {
            CommandRows::Jsonl(out) => out.finish(),
            CommandRows::Csv(out) => out.finish(),
            CommandRows::Columns(out) => out.finish(),
        }
    }
}

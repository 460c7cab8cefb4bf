//! Commands, as programmed or of the tool centre, in every format that they are written in.

use std::io::{self, Write};

use chordal::{Command, Job, PathCommand};

use crate::canon::CanonWriter;
use crate::columns::{ColumnFile, CommandColumns};
use crate::command_json::CommandJsonLines;
use crate::format::OutputFormat;

/// Writes commands one after the other.
#[derive(Debug)]
pub enum CommandWriter<'a, W> {
    /// JSON lines.
    Jsonl(Box<CommandJsonLines<'a, W>>),
    /// LinuxCNC's canonical text.
    Canon(Box<CanonWriter<'a, W>>),
    /// Tables, of text or of columns.
    Table(Box<ColumnFile<W, CommandColumns<'a>>>),
}

impl<'a, W: Write + Send + 'static> CommandWriter<'a, W> {
    /// For the commands of a job, or those of the tool centre.
    ///
    /// # Errors
    /// Those of the output, and a format that has no commands.
    pub fn new(out: W, format: OutputFormat, job: &'a Job<'a>, of_path: bool) -> io::Result<Self> {
        Ok(match format {
            OutputFormat::Jsonl => Self::Jsonl(Box::new(CommandJsonLines::new(out, job)?)),
            OutputFormat::Canon => Self::Canon(Box::new(CanonWriter::new(out, job)?)),
            table => {
                let rows = CommandColumns::of(job, of_path);
                let rows = if table.is_binary() { rows } else { rows.for_text() };
                Self::Table(Box::new(ColumnFile::new(out, table, rows)?))
            }
        })
    }

    /// Writes a command as programmed.
    ///
    /// # Errors
    /// Those of the output.
    pub fn command(&mut self, command: &Command) -> io::Result<()> {
        match self {
            CommandWriter::Jsonl(out) => out.command(command),
            CommandWriter::Canon(out) => out.command(command),
            CommandWriter::Table(out) => out.put(|rows| rows.command(command)),
        }
    }

    /// Writes a command of the tool centre.
    ///
    /// # Errors
    /// Those of the output.
    pub fn path_command(&mut self, path: PathCommand<'_>) -> io::Result<()> {
        match self {
            CommandWriter::Jsonl(out) => out.path_command(path),
            CommandWriter::Canon(out) => out.command(path.command),
            CommandWriter::Table(out) => out.put(|rows| rows.path_command(path)),
        }
    }

    /// Writes what is left and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(self) -> io::Result<W> {
        match self {
            CommandWriter::Jsonl(out) => out.finish(),
            CommandWriter::Canon(out) => out.finish(),
            CommandWriter::Table(out) => out.finish(),
        }
    }
}

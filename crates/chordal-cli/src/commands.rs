//! `chordal commands`: the canonical commands of a program.

use std::io;
use std::path::PathBuf;

use chordal::{Command, Job};
use chordal_export::CanonWriter;
use chordal_export::columns::ColumnFormat;
use clap::ValueEnum;

use crate::command_rows::CommandRows;
use crate::failure::{CommandFailure, ExitVerdict};
use crate::options::CommonArgs;
use crate::out::{self, RowFormat, RowOutput, keep};
use crate::rows::RowTarget;
use crate::terminal::TerminalSupport;

const EXAMPLES: &str = "\
Examples:
  chordal commands part.nc                        JSON, one object per line
  chordal commands part.nc --format canon         as LinuxCNC's rs274 prints them
  chordal commands part.nc | jq 'select(.kind == \"arc\")'
  chordal commands part.nc --machine fadal-4020 > fadal.jsonl
  chordal commands part.nc -o part.parquet        columns (.parquet, .arrow; docs/columns.md)

Lengths are millimetres, angles degrees, feeds mm/min, whatever the program's units; positions
are program coordinates at the tool tip; `line` is the line of the file. Problems go to standard
error; the exit code is 1 when there are errors.";

/// Prints the canonical commands that the control makes from a program
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Writes a file in the format of its extension; without it, standard output
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Format of the commands if no file extension gives it; JSON lines on standard output
    #[arg(long, value_enum)]
    format: Option<CommandFormat>,

    #[command(flatten)]
    common: CommonArgs,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum CommandFormat {
    /// JSON lines: a header, then one object per command
    Jsonl,
    /// LinuxCNC's canonical text
    Canon,
    /// Comma-separated, one row per command
    Csv,
    /// Apache Parquet
    Parquet,
    /// Arrow IPC file (Feather)
    Arrow,
}

impl CommandFormat {
    /// The format that a path has, too; `None` for canonical text.
    fn rows(self) -> Option<RowFormat> {
        match self {
            CommandFormat::Jsonl => Some(RowFormat::Jsonl),
            CommandFormat::Canon => None,
            CommandFormat::Csv => Some(RowFormat::Csv),
            CommandFormat::Parquet => Some(RowFormat::Parquet),
            CommandFormat::Arrow => Some(RowFormat::Arrow),
        }
    }
}

impl out::FileFormat for CommandFormat {
    fn columns(self) -> Option<ColumnFormat> {
        self.rows().and_then(out::FileFormat::columns)
    }
}

#[allow(clippy::large_enum_variant, reason = "there is one of it in a run")]
enum CommandRowWriter<'a> {
    Rows(CommandRows<'a>),
    Canon(CanonWriter<'a, RowOutput>),
}

impl<'a> CommandRowWriter<'a> {
    fn new(
        out: RowOutput,
        format: CommandFormat,
        job: &'a Job<'a>,
    ) -> io::Result<CommandRowWriter<'a>> {
        match format.rows() {
            Some(format) => CommandRows::new(out, format, job, false).map(CommandRowWriter::Rows),
            None => CanonWriter::new(out, job).map(CommandRowWriter::Canon),
        }
    }

    fn command(&mut self, command: &Command) -> io::Result<()> {
        match self {
            CommandRowWriter::Rows(out) => out.command(command),
            CommandRowWriter::Canon(out) => out.command(command),
        }
    }

    fn finish(self) -> io::Result<RowOutput> {
        match self {
            CommandRowWriter::Rows(out) => out.finish(),
            CommandRowWriter::Canon(out) => out.finish(),
        }
    }
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let output =
        RowTarget::of(args.output.as_deref(), args.format, CommandFormat::Jsonl, "commands")?;
    output.write(&args.file, &args.common, terminal, |job, out, format| {
        let mut writer = CommandRowWriter::new(out, format, job)?;
        let mut done = Ok(());
        let report = job.report_of_commands(|command| keep(&mut done, || writer.command(command)));
        done?;
        Ok((report, writer.finish()?))
    })
}

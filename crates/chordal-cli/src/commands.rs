//! `chordal commands`: the canonical commands of a program.

use std::io;
use std::path::PathBuf;

use chordal::{Command, Job};
use chordal_export::Canon;
use chordal_export::columns::ColumnFormat;
use clap::ValueEnum;

use crate::command_rows::CommandRows;
use crate::failure::{Failure, Verdict};
use crate::options::Common;
use crate::out::{self, Out, RowFormat, keep};
use crate::rows::Output;
use crate::terminal::Terminal;

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
    format: Option<Format>,

    #[command(flatten)]
    common: Common,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Format {
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

impl Format {
    /// The format that a path has, too; `None` for canonical text.
    fn rows(self) -> Option<RowFormat> {
        match self {
            Format::Jsonl => Some(RowFormat::Jsonl),
            Format::Canon => None,
            Format::Csv => Some(RowFormat::Csv),
            Format::Parquet => Some(RowFormat::Parquet),
            Format::Arrow => Some(RowFormat::Arrow),
        }
    }
}

impl out::Format for Format {
    fn columns(self) -> Option<ColumnFormat> {
        self.rows().and_then(out::Format::columns)
    }
}

#[allow(clippy::large_enum_variant, reason = "there is one of it in a run")]
enum Writer<'a> {
    Rows(CommandRows<'a>),
    Canon(Canon<'a, Out>),
}

impl<'a> Writer<'a> {
    fn new(out: Out, format: Format, job: &'a Job<'a>) -> io::Result<Writer<'a>> {
        match format.rows() {
            Some(format) => CommandRows::new(out, format, job, false).map(Writer::Rows),
            None => Canon::new(out, job).map(Writer::Canon),
        }
    }

    fn command(&mut self, command: &Command) -> io::Result<()> {
        match self {
            Writer::Rows(out) => out.command(command),
            Writer::Canon(out) => out.command(command),
        }
    }

    fn finish(self) -> io::Result<Out> {
        match self {
            Writer::Rows(out) => out.finish(),
            Writer::Canon(out) => out.finish(),
        }
    }
}

pub fn run(args: &Args, terminal: Terminal) -> Result<Verdict, Failure> {
    let output = Output::of(args.output.as_deref(), args.format, Format::Jsonl, "commands")?;
    output.write(&args.file, &args.common, terminal, |job, out, format| {
        let mut writer = Writer::new(out, format, job)?;
        let mut done = Ok(());
        let report = job.report_of_commands(|command| keep(&mut done, || writer.command(command)));
        done?;
        Ok((report, writer.finish()?))
    })
}

use std::io;
use std::path::PathBuf;

use chordal::{Command, Job, Report, Severity};
use chordal_export::columns::{ColumnFile, ColumnFormat, CommandColumns};
use chordal_export::{Canon, CommandCsv, CommandJsonLines, report};
use clap::ValueEnum;

use crate::failure::{Failure, Verdict};
use crate::options::Common;
use crate::out::{self, Out, keep, trouble};
use crate::session::{Loaded, load_one};
use crate::terminal::Terminal;

const EXAMPLES: &str = "\
Examples:
  chordal commands part.nc                        JSON, one object a line
  chordal commands part.nc --format canon         as LinuxCNC's rs274 prints them
  chordal commands part.nc | jq 'select(.kind == \"arc\")'
  chordal commands part.nc --machine fadal-4020 > fadal.jsonl
  chordal commands part.nc -o part.parquet        columns (.parquet, .arrow; docs/columns.md)

Lengths are millimetres, angles degrees, feeds mm/min, whatever the program's units; positions
are program coordinates at the tool tip; `line` is the line of the file. Problems go to standard
error; the exit code is 1 when there are errors.";

/// Prints the canonical commands that the control makes of a program
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Writes a file, its format by its ending; without it, standard output
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// How commands are written, where no ending says it; JSON lines to standard output
    #[arg(long, value_enum)]
    format: Option<Format>,

    #[command(flatten)]
    common: Common,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Format {
    /// JSON lines: a header, then one object a command
    Jsonl,
    /// LinuxCNC's canonical text
    Canon,
    /// Comma-separated, one row a command
    Csv,
    /// Apache Parquet
    Parquet,
    /// Arrow IPC file (Feather)
    Arrow,
}

impl out::Format for Format {
    fn columns(self) -> Option<ColumnFormat> {
        match self {
            Format::Jsonl | Format::Canon | Format::Csv => None,
            Format::Parquet => Some(ColumnFormat::Parquet),
            Format::Arrow => Some(ColumnFormat::Arrow),
        }
    }
}

enum Writer<'a> {
    Jsonl(CommandJsonLines<'a, Out>),
    Canon(Canon<'a, Out>),
    Csv(Box<CommandCsv<Out>>),
    Columns(Box<ColumnFile<Out, CommandColumns<'a>>>),
}

impl<'a> Writer<'a> {
    fn new(out: Out, format: Format, job: &'a Job<'a>) -> io::Result<Writer<'a>> {
        let columns = |out, format| {
            let file = ColumnFile::new(out, format, CommandColumns::new(job))?;
            Ok(Writer::Columns(Box::new(file)))
        };
        match format {
            Format::Jsonl => Ok(Writer::Jsonl(CommandJsonLines::new(out, job)?)),
            Format::Canon => Ok(Writer::Canon(Canon::new(out, job)?)),
            Format::Csv => Ok(Writer::Csv(Box::new(CommandCsv::new(out, job)?))),
            Format::Parquet => columns(out, ColumnFormat::Parquet),
            Format::Arrow => columns(out, ColumnFormat::Arrow),
        }
    }

    fn command(&mut self, command: &Command) -> io::Result<()> {
        match self {
            Writer::Jsonl(out) => out.command(command),
            Writer::Canon(out) => out.command(command),
            Writer::Csv(out) => out.command(command),
            Writer::Columns(out) => out.put(|rows| rows.command(command)),
        }
    }

    fn finish(self) -> io::Result<Out> {
        match self {
            Writer::Jsonl(out) => out.finish(),
            Writer::Canon(out) => out.finish(),
            Writer::Csv(out) => out.finish(),
            Writer::Columns(out) => out.finish(),
        }
    }
}

pub fn run(args: &Args, terminal: Terminal) -> Result<Verdict, Failure> {
    let path = args.output.as_deref();
    let format = out::format_of(args.format, path, Format::Jsonl, "commands")?;
    let out = Out::open(path, &args.file, format)?;
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    let told = |error| trouble(path, error);
    let mut writer = Writer::new(out, format, &job).map_err(told)?;
    let mut done = Ok(());
    let report = job.report_of_commands(|command| keep(&mut done, || writer.command(command)));
    done.and_then(|()| writer.finish()).map_err(told)?.put()?;
    Ok(tell(&report, &loaded, &job, terminal))
}

/// What was recognized, and the problems, on standard error, where they are in nobody's way.
pub fn tell(report: &Report, loaded: &Loaded, job: &Job, terminal: Terminal) -> Verdict {
    let told = loaded.chosen.told(loaded.name(), job.control().table.title);
    terminal.tell(&told.unwrap_or_default());
    terminal.tell(&report::text(report, job.sources(), terminal.err));
    if report.worst() == Some(Severity::Error) { Verdict::Problems } else { Verdict::Clean }
}

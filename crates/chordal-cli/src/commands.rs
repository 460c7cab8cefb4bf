use std::io::{self, BufWriter, Stdout, Write};
use std::path::PathBuf;

use chordal::{Command, Job, Report, Severity};
use chordal_export::{Canon, CommandCsv, CommandJsonLines, report};
use clap::ValueEnum;

use crate::failure::{Failure, Verdict};
use crate::options::Common;
use crate::session::{Loaded, load_one};
use crate::terminal::Terminal;

const EXAMPLES: &str = "\
Examples:
  chordal commands part.nc                        JSON, one object a line
  chordal commands part.nc --format canon         as LinuxCNC's rs274 prints them
  chordal commands part.nc | jq 'select(.kind == \"arc\")'
  chordal commands part.nc --machine fadal-4020 > fadal.jsonl

Lengths are millimetres, angles degrees, feeds mm/min, whatever the program's units; positions
are program coordinates at the tool tip; `line` is the line of the file. Problems go to standard
error; the exit code is 1 when there are errors.";

/// Prints the canonical commands that the control makes of a program
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// How commands are written
    #[arg(long, value_enum, default_value = "jsonl")]
    format: Format,

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
}

enum Writer<'a> {
    Jsonl(CommandJsonLines<'a, Buffered>),
    Canon(Canon<'a, Buffered>),
    Csv(Box<CommandCsv<Buffered>>),
}

impl<'a> Writer<'a> {
    fn new(format: Format, job: &'a Job<'a>) -> io::Result<Writer<'a>> {
        let out = buffered();
        Ok(match format {
            Format::Jsonl => Writer::Jsonl(CommandJsonLines::new(out, job)?),
            Format::Canon => Writer::Canon(Canon::new(out, job)?),
            Format::Csv => Writer::Csv(Box::new(CommandCsv::new(out, job)?)),
        })
    }

    fn command(&mut self, command: &Command) -> io::Result<()> {
        match self {
            Writer::Jsonl(out) => out.command(command),
            Writer::Canon(out) => out.command(command),
            Writer::Csv(out) => out.command(command),
        }
    }

    fn finish(self) -> io::Result<()> {
        match self {
            Writer::Jsonl(out) => out.finish()?,
            Writer::Canon(out) => out.finish()?,
            Writer::Csv(out) => out.finish()?,
        }
        .flush()
    }
}

pub fn run(args: &Args, terminal: Terminal) -> Result<Verdict, Failure> {
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    let mut writer = Writer::new(args.format, &job)?;
    let mut done = Ok(());
    let report = job.report_of_commands(|command| keep(&mut done, || writer.command(command)));
    done?;
    writer.finish()?;
    Ok(tell(&report, &loaded, &job, terminal))
}

/// Standard output of a run that streams. A run cannot be stopped from within, and what
/// streams has nothing to clean up: when nobody reads any more (`| head`) the process ends
/// here, quietly, however the writers above would wrap the error.
pub struct Stream(Stdout);

impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes).inspect_err(end_if_closed)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush().inspect_err(end_if_closed)
    }
}

fn end_if_closed(error: &io::Error) {
    if error.kind() == io::ErrorKind::BrokenPipe {
        std::process::exit(0);
    }
}

/// Standard output for many small writes.
pub type Buffered = BufWriter<Stream>;

/// Standard output for many small writes.
pub fn buffered() -> Buffered {
    BufWriter::with_capacity(1 << 16, Stream(io::stdout()))
}

/// Another failure of the output, as a full disk, is for the end of the run: the first counts.
pub fn keep(first: &mut io::Result<()>, next: impl FnOnce() -> io::Result<()>) {
    if first.is_ok() {
        *first = next();
    }
}

/// What was recognized, and the problems, on standard error, where they are in nobody's way.
pub fn tell(report: &Report, loaded: &Loaded, job: &Job, terminal: Terminal) -> Verdict {
    let told = loaded.chosen.told(loaded.name(), job.control().table.title);
    terminal.tell(&told.unwrap_or_default());
    terminal.tell(&report::text(report, job.sources(), terminal.err));
    if report.worst() == Some(Severity::Error) { Verdict::Problems } else { Verdict::Clean }
}

use std::io::{self, Write};
use std::path::PathBuf;

use chordal::{Job, PathCommand};
use chordal_export::{CommandCsv, CommandJsonLines};
use clap::ValueEnum;

use crate::commands::{Buffered, buffered, keep, tell};
use crate::failure::{Failure, Verdict};
use crate::options::Common;
use crate::session::load_one;
use crate::terminal::Terminal;

const EXAMPLES: &str = "\
Examples:
  chordal path part.nc                            JSON, one object a line
  chordal path part.nc --format csv > path.csv
  chordal path part.nc --set tools.1.diameter=\"10 mm\"
  chordal path part.nc -m haas-vf2 --set \"settings.Setting 58=yasnac\"
  chordal path part.nc | jq 'select(.inserted)'   what compensation adds

The objects are those of `chordal commands`, after cutter radius compensation: positions are
those of the tool centre. Every feed move says its `compensation` (left, right, off) and its
`cutter_radius`; links and corner arcs that compensation makes say `inserted` and bear the line
of the block before. Problems go to standard error; the exit code is 1 when there are errors.";

/// Prints the path of the tool centre, after cutter radius compensation
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// How the path is written
    #[arg(long, value_enum, default_value = "jsonl")]
    format: Format,

    #[command(flatten)]
    common: Common,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Format {
    /// JSON lines: a header, then one object a command
    Jsonl,
    /// Comma-separated, one row a command
    Csv,
}

enum Writer<'a> {
    Jsonl(CommandJsonLines<'a, Buffered>),
    Csv(Box<CommandCsv<Buffered>>),
}

impl<'a> Writer<'a> {
    fn new(format: Format, job: &'a Job<'a>) -> io::Result<Writer<'a>> {
        let out = buffered();
        Ok(match format {
            Format::Jsonl => Writer::Jsonl(CommandJsonLines::new(out, job)?),
            Format::Csv => Writer::Csv(Box::new(CommandCsv::of_path(out, job)?)),
        })
    }

    fn command(&mut self, path: PathCommand<'_>) -> io::Result<()> {
        match self {
            Writer::Jsonl(out) => out.path_command(path),
            Writer::Csv(out) => out.path_command(path),
        }
    }

    fn finish(self) -> io::Result<()> {
        match self {
            Writer::Jsonl(out) => out.finish()?,
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
    let report = job.report_of_path(|path, _| keep(&mut done, || writer.command(path)));
    done?;
    writer.finish()?;
    Ok(tell(&report, &loaded, &job, terminal))
}

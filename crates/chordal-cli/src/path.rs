use std::io;
use std::path::PathBuf;

use chordal::{Job, PathCommand};
use chordal_export::columns::{ColumnFile, ColumnFormat, CommandColumns};
use chordal_export::{CommandCsv, CommandJsonLines};

use crate::commands::tell;
use crate::failure::{Failure, Verdict};
use crate::options::Common;
use crate::out::{Out, RowFormat, format_of, keep, trouble};
use crate::session::load_one;
use crate::terminal::Terminal;

const EXAMPLES: &str = "\
Examples:
  chordal path part.nc                            JSON, one object a line
  chordal path part.nc -o path.csv
  chordal path part.nc -o path.parquet            columns (.parquet, .arrow; docs/columns.md)
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

    /// Writes a file, its format by its ending; without it, standard output
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// How the path is written, where no ending says it; JSON lines to standard output
    #[arg(long, value_enum)]
    format: Option<RowFormat>,

    #[command(flatten)]
    common: Common,
}

enum Writer<'a> {
    Jsonl(CommandJsonLines<'a, Out>),
    Csv(Box<CommandCsv<Out>>),
    Columns(Box<ColumnFile<Out, CommandColumns<'a>>>),
}

impl<'a> Writer<'a> {
    fn new(out: Out, format: RowFormat, job: &'a Job<'a>) -> io::Result<Writer<'a>> {
        let columns = |out, format| {
            let file = ColumnFile::new(out, format, CommandColumns::of_path(job))?;
            Ok(Writer::Columns(Box::new(file)))
        };
        match format {
            RowFormat::Jsonl => Ok(Writer::Jsonl(CommandJsonLines::new(out, job)?)),
            RowFormat::Csv => Ok(Writer::Csv(Box::new(CommandCsv::of_path(out, job)?))),
            RowFormat::Parquet => columns(out, ColumnFormat::Parquet),
            RowFormat::Arrow => columns(out, ColumnFormat::Arrow),
        }
    }

    fn command(&mut self, path: PathCommand<'_>) -> io::Result<()> {
        match self {
            Writer::Jsonl(out) => out.path_command(path),
            Writer::Csv(out) => out.path_command(path),
            Writer::Columns(out) => out.put(|rows| rows.path_command(path)),
        }
    }

    fn finish(self) -> io::Result<Out> {
        match self {
            Writer::Jsonl(out) => out.finish(),
            Writer::Csv(out) => out.finish(),
            Writer::Columns(out) => out.finish(),
        }
    }
}

pub fn run(args: &Args, terminal: Terminal) -> Result<Verdict, Failure> {
    let path = args.output.as_deref();
    let format = format_of(args.format, path, RowFormat::Jsonl, "a path")?;
    let out = Out::open(path, &args.file, format)?;
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    let told = |error| trouble(path, error);
    let mut writer = Writer::new(out, format, &job).map_err(told)?;
    let mut done = Ok(());
    let report = job.report_of_path(|path, _| keep(&mut done, || writer.command(path)));
    done.and_then(|()| writer.finish()).map_err(told)?.put()?;
    Ok(tell(&report, &loaded, &job, terminal))
}

//! `chordal path`: the commands of the tool centre.

use std::path::PathBuf;

use chordal_export::format::ROW_FORMATS;
use chordal_export::{CommandWriter, OutputFormat, write_unless_failed};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::options::CommonArgs;
use crate::rows::RowTarget;
use crate::terminal::TerminalSupport;

const EXAMPLES: &str = "\
Examples:
  chordal path part.nc                            JSON, one object per line
  chordal path part.nc -o path.csv
  chordal path part.nc -o path.parquet            columns (.parquet, .arrow; docs/columns.md)
  chordal path part.nc --set tools.1.diameter=\"10 mm\"
  chordal path part.nc -m haas-vf2 --set \"settings.Setting 58=yasnac\"
  chordal path part.nc | jq 'select(.inserted)'   what compensation adds

The objects are those of `chordal commands`, after cutter radius compensation: positions are
those of the tool centre. Every feed move has its `compensation` (left, right, off) and its
`cutter_radius`; links and corner arcs that compensation makes have `inserted` and the line
of the block before. Problems go to standard error; the exit code is 1 when there are errors.";

/// Prints the path of the tool centre, after cutter radius compensation
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Writes a file in the format of its extension; without it, standard output
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Format of the path if no file extension gives it; JSON lines on standard output
    #[arg(long, value_parser = format_parser(&ROW_FORMATS))]
    format: Option<OutputFormat>,

    #[command(flatten)]
    common: CommonArgs,
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let output = RowTarget::of(
        &ROW_FORMATS,
        args.output.as_deref(),
        args.format,
        OutputFormat::Jsonl,
        "a path",
    )?;
    output.write(&args.file, &args.common, terminal, |job, out, format| {
        let mut writer = CommandWriter::new(out, format, job, true)?;
        let mut done = Ok(());
        let report = job
            .report_of_path(|path, _| write_unless_failed(&mut done, || writer.path_command(path)));
        done?;
        Ok((report, writer.finish()?))
    })
}

//! `chordal commands`: the canonical commands of a program.

use std::path::PathBuf;

use chordal_export::format::COMMAND_FORMATS;
use chordal_export::{CommandWriter, OutputFormat, write_unless_failed};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::options::CommonArgs;
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
    #[arg(long, value_parser = format_parser(&COMMAND_FORMATS))]
    format: Option<OutputFormat>,

    #[command(flatten)]
    common: CommonArgs,
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let output = RowTarget::of(
        &COMMAND_FORMATS,
        args.output.as_deref(),
        args.format,
        OutputFormat::Jsonl,
        "commands",
    )?;
    output.write(&args.file, &args.common, terminal, |job, out, format| {
        let mut writer = CommandWriter::new(out, format, job, false)?;
        let mut done = Ok(());
        let report = job.report_of_commands(|command| {
            write_unless_failed(&mut done, || writer.command(command))
        });
        done?;
        Ok((report, writer.finish()?))
    })
}

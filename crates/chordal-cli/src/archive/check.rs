//! `chordal archive check`: its arguments and what it prints.

use std::path::{Path, PathBuf};

use chordal_archive::{
    ArchiveError, ArchiveOptions, ArchiveTotals, DiskFiles, TableJournal, check_all, walk,
};

use super::progress::ProgressMeter;
use super::{ArchiveMachines, jobs};
use crate::failure::{CommandFailure, ExitVerdict};
use crate::numbers::{counted, grouped};
use crate::terminal::{BOLD, TerminalSupport, style};

const EXAMPLES: &str = "\
Examples:
  chordal archive check archive/ --out results.parquet
  chordal archive check released/ returned/ --out results.parquet --machine haas-vf2
  chordal archive check archive/ --out results.parquet --jobs 4 --no-plan
  chordal archive check archive/ --out results.parquet --stock --setup op1.toml

Every file of the folders gets a row, and so does every program of a file that holds several. If it is
interrupted, start it again with the same --out: it continues. The same archive gives the same table,
byte for byte, with any number of jobs. docs/archives.md lists the columns.

Exit code: 0 clean, 1 problems in a program, 2 wrong use or a table that cannot be written.";

/// Checks every program of folder trees and writes one table
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Folders of programs, or programs
    #[arg(required = true, value_name = "DIR")]
    folders: Vec<PathBuf>,

    /// The table, a Parquet file; written completely or not at all
    #[arg(long, short, value_name = "FILE.parquet")]
    out: PathBuf,

    /// How many files are processed at the same time; default: the number of processors
    #[arg(long, short, value_name = "N")]
    jobs: Option<usize>,

    /// Leaves out the times with acceleration and jerk; this is faster
    #[arg(long)]
    no_plan: bool,

    /// Cuts the stock of each program's setup as well: what is left, and what rapids, shank and holder touch
    #[arg(long)]
    stock: bool,

    /// The machine, the stock and the tools of all programs; without it those of `chordal.toml` in their folders
    #[arg(long, value_name = "SETUP.toml", conflicts_with_all = ["machine", "control"], requires = "stock")]
    setup: Option<PathBuf>,

    /// Shows the progress on standard error, even if that is not a terminal
    #[arg(long)]
    progress: bool,

    #[command(flatten)]
    machines: ArchiveMachines,
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    for argument in &args.folders {
        // What is not there at all is a slip; what is there and cannot be read gets its row.
        argument
            .metadata()
            .map_err(|error| CommandFailure::read(argument.to_string_lossy(), &error))?;
    }
    keep_programs(&args.out)?;
    let disk = DiskFiles::new(args.machines.request(args.setup.as_deref()), &args.folders)?;
    let found = walk(&args.folders, &[args.out.clone(), TableJournal::folder_of(&args.out)]);
    if found.is_empty() {
        return Err(CommandFailure::wrong(
            "there is no file in the folders",
            "name a folder of programs",
        ));
    }
    let meter = ProgressMeter::new(found.len(), args.progress, terminal);
    let options = ArchiveOptions { plan: !args.no_plan, stock: args.stock };
    let jobs = jobs(args.jobs);
    let done = check_all(&found, &args.out, jobs, options, || disk.again(), &meter);
    meter.finish();
    let done = done.map_err(failure)?;
    terminal.write_error(&text(&done, &args.out, terminal));
    let is_clean = done.with_errors + done.with_warnings + done.not_proved + done.failed == 0;
    Ok(if is_clean { ExitVerdict::Clean } else { ExitVerdict::Problems })
}

/// The table must be a Parquet file, so that a typing error does not overwrite a program.
pub fn keep_programs(out: &Path) -> Result<(), CommandFailure> {
    let ending = out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("parquet"));
    if ending && !out.is_dir() {
        return Ok(());
    }
    let message = format!("the table cannot be {}", out.display());
    Err(CommandFailure::wrong(message, "give it a name that ends in .parquet"))
}

pub fn failure(error: ArchiveError) -> CommandFailure {
    match error {
        ArchiveError::Write { path, error } => {
            CommandFailure::write(path.to_string_lossy(), &error)
        }
        other => CommandFailure::Use { message: other.to_string(), help: None },
    }
}

fn text(done: &ArchiveTotals, out: &Path, terminal: TerminalSupport) -> String {
    let parts = [
        (done.with_errors, "with errors"),
        (done.with_warnings, "with warnings"),
        (done.not_proved, "whose stock is not proved clean"),
        (done.failed, "that could not be run"),
        (done.skipped, "other files"),
        (done.resumed, "files done before"),
    ];
    let parts = parts.iter().filter(|(count, _)| *count > 0);
    let parts: Vec<String> =
        parts.map(|(count, what)| format!("{} {what}", grouped(*count))).collect();
    let programs = style(terminal.err, BOLD, counted(done.programs, "program", "programs"));
    let files = counted(done.files, "file", "files");
    let more = if parts.is_empty() { String::new() } else { format!(": {}", parts.join(", ")) };
    format!("{programs} in {files}{more}\n{}\n", out.display())
}

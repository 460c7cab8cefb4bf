//! `chordal diff`: its arguments and its exit code.

mod render;

use std::path::PathBuf;

use chordal_archive::DiskFiles;
use chordal_archive::diff::{DiffOptions, DiffRow, FileStatus, compare_all, write_table};
use chordal_export::OutputFormat;
use chordal_export::format::ARCHIVE_DIFF_FORMATS;
use clap::ValueEnum;

use super::check::keep_programs;
use super::progress::ProgressMeter;
use super::{ArchiveMachines, jobs};
use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::output;
use crate::terminal::{TerminalSupport, say};

const EXAMPLES: &str = "\
Examples:
  chordal diff before/ after/
  chordal diff released/ returned/ --format json > changes.json
  chordal diff before/ after/ --format markdown --fail-on problems > summary.md
  chordal diff released/ returned/ --out changes.parquet --tolerance 0.001

Files with the same path below the two folders are compared. `text`, `functions` and `feeds` are proved
to have the same motion, curve for curve; for `path` the distance between the two paths, as sets of
points, is given exactly within the tolerance. Problems are new where the second program has more of
a code than the first.

Exit code: 0 clean, 1 changes or new problems (--fail-on), 2 wrong use.";

/// Says what changed between two folders of programs: motion, times, problems
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder of programs before: released, or of the old post
    #[arg(value_name = "BEFORE")]
    released: PathBuf,

    /// The folder of programs after: returned, or of the new post
    #[arg(value_name = "AFTER")]
    returned: PathBuf,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&ARCHIVE_DIFF_FORMATS), default_value = "text")]
    format: OutputFormat,

    /// What makes the exit code 1
    #[arg(long, value_enum, default_value = "changes", value_name = "WHAT")]
    fail_on: ArchiveFailOn,

    /// Writes the comparison as a Parquet table; written completely or not at all
    #[arg(long, short, value_name = "FILE.parquet")]
    out: Option<PathBuf>,

    /// Accuracy of the distances, mm
    #[arg(long, value_name = "MM", default_value_t = 0.001)]
    tolerance: f64,

    /// Leaves out the times with acceleration and jerk; this is faster
    #[arg(long)]
    no_plan: bool,

    /// Also lists files that are the same
    #[arg(long)]
    all: bool,

    /// How many files are processed at the same time; default: the number of processors
    #[arg(long, short, value_name = "N")]
    jobs: Option<usize>,

    #[command(flatten)]
    machines: ArchiveMachines,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum ArchiveFailOn {
    /// Any file that does not do the same: motion, feeds, functions, a file missing or new
    Changes,
    /// New errors and warnings, and a file that is missing or cannot be read
    Problems,
    /// Nothing
    Never,
}

impl ArchiveFailOn {
    fn verdict(self, rows: &[DiffRow]) -> ExitVerdict {
        let fails = match self {
            ArchiveFailOn::Changes => |row: &DiffRow| {
                !matches!(row.status, FileStatus::Same | FileStatus::Text) || has_new_problems(row)
            },
            ArchiveFailOn::Problems => |row: &DiffRow| {
                has_new_problems(row)
                    || matches!(row.status, FileStatus::Unreadable | FileStatus::Missing)
            },
            ArchiveFailOn::Never => |_: &DiffRow| false,
        };
        if rows.iter().any(fails) { ExitVerdict::Problems } else { ExitVerdict::Clean }
    }
}

/// Notes are no problems to fail for. The gravest are listed, so that one of them is an error or a
/// warning if any is.
fn has_new_problems(row: &DiffRow) -> bool {
    row.problems.iter().any(|problem| problem.severity != "note")
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    for folder in [&args.released, &args.returned] {
        if !folder.is_dir() {
            let message = format!("{} is not a folder", folder.display());
            let help = "name two folders, the one before and the one after; two programs are \
                        compared by chordal compare";
            return Err(CommandFailure::wrong(message, help));
        }
    }
    if !(args.tolerance > 0.0 && args.tolerance.is_finite()) {
        let message = format!("a tolerance of {} mm is not above zero", args.tolerance);
        return Err(CommandFailure::wrong(message, "0.001 is a thousandth of a millimetre"));
    }
    if let Some(out) = &args.out {
        keep_programs(out)?;
    }
    let roots = [args.released.clone(), args.returned.clone()];
    let disk = DiskFiles::new(args.machines.request(None), &roots)?;
    let meter = ProgressMeter::new(0, false, terminal);
    let options = DiffOptions { tolerance_mm: args.tolerance, plan: !args.no_plan };
    let (released, returned) = (&args.released, &args.returned);
    let rows = compare_all(released, returned, jobs(args.jobs), options, || disk.again(), &meter);
    if let Some(out) = &args.out {
        let table = write_table(&rows, Vec::new());
        let table = table.map_err(|error| CommandFailure::write(out.to_string_lossy(), &error))?;
        output::write_whole(out, &table)?;
    }
    match args.format {
        OutputFormat::Text => say(&render::text(&rows, args.all))?,
        OutputFormat::Json => say(&render::json(&rows))?,
        _ => say(&render::markdown(&rows, args.all))?,
    }
    Ok(args.fail_on.verdict(&rows))
}

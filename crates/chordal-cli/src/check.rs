//! `chordal check`: the problems of programs in five formats.

use std::path::PathBuf;

use chordal::stock::StockOptions;
use chordal::{EVERY_PLACE, Report, Severity};
use chordal_export::OutputFormat;
use chordal_export::format::PROBLEM_FORMATS;
use chordal_export::report::{self, GitlabReport, SarifReport};
use chordal_load::Loaded;
use clap::ValueEnum;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::numbers::{counted, grouped};
use crate::options::{CommonArgs, ProblemDisplay, length};
use crate::programs::ProgramList;
use crate::readings;
use crate::stock;
use crate::terminal::{BOLD, TerminalSupport, style};

const EXAMPLES: &str = "\
Examples:
  chordal check part.nc
  chordal check part.nc --machine fanuc-30i --fail-on error
  chordal check archive/ > problems.txt
  chordal check archive/ --format sarif > chordal.sarif
  chordal check archive/ --stock --setup op1.toml
  chordal check . --changed-since origin/main --format github
  chordal check - < part.nc

A folder means all programs in it and below it; programs are recognized by their content, not by the
file extension. Exit code: 0 clean, 1 problems, 2 wrong use or a file that cannot be read (the others
are still checked).";

/// Reports the problems of programs and nothing else
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Programs, or folders of programs; `-` is standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,

    /// Format of the problems
    #[arg(long, value_parser = format_parser(&PROBLEM_FORMATS), default_value = "text")]
    format: OutputFormat,

    /// The lowest severity that makes the exit code 1
    #[arg(long, value_enum, default_value = "warning", value_name = "SEVERITY")]
    fail_on: FailSeverity,

    /// Cuts the stock of the setup with each program as well, and reports what rapids, shank and holder touch;
    /// what is not proved makes the exit code 1
    #[arg(long)]
    stock: bool,

    /// The machine, the stock and the tools
    #[arg(long, value_name = "SETUP.toml", conflicts_with = "machine", requires = "stock")]
    setup: Option<PathBuf>,

    /// Side of a column of the stock, with its unit; without it, from the size of the stock
    #[arg(long, value_name = "LENGTH", requires = "stock", value_parser = length)]
    resolution: Option<f64>,

    /// Only files that changed since this commit, or since the branch left it; asks git
    ///
    /// A program is not checked again because a subprogram, a machine file or `chordal.toml` changed.
    #[arg(long, value_name = "COMMIT")]
    changed_since: Option<String>,

    #[command(flatten)]
    showing: ProblemDisplay,

    #[command(flatten)]
    common: CommonArgs,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum FailSeverity {
    Error,
    Warning,
    Note,
    Never,
}

impl FailSeverity {
    fn verdict(self, worst: Option<Severity>) -> ExitVerdict {
        let limit = match self {
            FailSeverity::Error => Severity::Error,
            FailSeverity::Warning => Severity::Warning,
            FailSeverity::Note => Severity::Note,
            FailSeverity::Never => return ExitVerdict::Clean,
        };
        if worst >= Some(limit) { ExitVerdict::Problems } else { ExitVerdict::Clean }
    }
}

pub fn run(args: Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let Args {
        files,
        format,
        fail_on,
        stock,
        setup,
        resolution,
        changed_since,
        showing,
        mut common,
    } = args;
    common.set_up(setup.as_deref());
    let options = StockOptions { resolution_mm: resolution, ..StockOptions::default() };
    let kept = if format == OutputFormat::Json { EVERY_PLACE } else { showing.kept() };
    let programs = ProgramList::changed(&files, &common, terminal, changed_since.as_deref())?;
    let called = programs.called();
    let mut totals = CheckTotals::default();
    let mut objects = Vec::new();
    let (mut sarif, mut gitlab) = (SarifReport::new(), GitlabReport::new());
    let mut handle = |programs: &ProgramList, loaded: &Loaded| {
        let job = loaded.job()?;
        let (report, is_proved) = if stock {
            let found = stock::left(&job, &options, setup.as_deref())?;
            (found.report().clone(), found.is_clean())
        } else {
            (job.check_keeping(kept), true)
        };
        totals.add(&report);
        match format {
            OutputFormat::Text => {
                let problems = report.worst().is_some();
                if problems {
                    programs.say(&readings::head(loaded))?;
                } else if programs.inputs().len() == 1 {
                    // Of a clean program nothing goes to standard output, for scripts.
                    terminal.write_error(&readings::head(loaded));
                }
                if problems {
                    let detail = showing.detail();
                    programs.say(&report::text(&report, job.sources(), terminal.out, detail))?;
                }
            }
            OutputFormat::Github => programs.say(&report::github(&report, job.sources()))?,
            OutputFormat::Json => {
                let reading = loaded.reading();
                objects.push(report::json(&report, job.sources(), loaded.name(), &reading));
            }
            OutputFormat::Sarif => sarif.add(&report, job.sources()),
            _ => gitlab.add(&report, job.sources()),
        }
        let verdict = fail_on.verdict(report.worst());
        Ok(if is_proved || fail_on == FailSeverity::Never {
            verdict
        } else {
            ExitVerdict::Problems
        })
    };
    let verdict = programs.each(|programs, _, loaded| handle(programs, loaded))?;
    totals.called = called;
    match format {
        OutputFormat::Text => match &changed_since {
            Some(commit) if totals.files == 0 && verdict == ExitVerdict::Clean => {
                terminal.write_error(&format!("no program has changed since {commit}\n"));
            }
            _ => terminal.write_error(&totals.text(terminal)),
        },
        OutputFormat::Json => {
            crate::terminal::say(&report::files_json("chordal.check/1", &objects))?
        }
        OutputFormat::Sarif => crate::terminal::say(&sarif.finish())?,
        OutputFormat::Gitlab => crate::terminal::say(&gitlab.finish())?,
        _ => {}
    }
    Ok(verdict)
}

/// All files together.
#[derive(Default)]
struct CheckTotals {
    files: u64,
    with_problems: u64,
    errors: u64,
    warnings: u64,
    notes: u64,
    /// Files that hold only subprograms and were run where they are called.
    called: u64,
}

impl CheckTotals {
    fn add(&mut self, report: &Report) {
        self.files += 1;
        self.with_problems += u64::from(report.worst() >= Some(Severity::Warning));
        self.errors += report.counts.errors;
        self.warnings += report.counts.warnings;
        self.notes += report.counts.notes;
    }

    /// The last line, `2 errors, 1 warning in 1 of 12 programs`; a single program with problems
    /// has reported its own.
    fn text(&self, terminal: TerminalSupport) -> String {
        let counts: Vec<String> = [
            (self.errors, "error", "errors"),
            (self.warnings, "warning", "warnings"),
            (self.notes, "note", "notes"),
        ]
        .into_iter()
        .filter(|(number, ..)| *number > 0)
        .map(|(number, one, many)| counted(number, one, many))
        .collect();
        let counts = counts.join(", ");
        let programs = counted(self.files, "program", "programs");
        let text = match (self.files, self.with_problems) {
            (0, _) => return String::new(),
            (1, _) if !counts.is_empty() => return String::new(),
            (1, _) => "no problems".to_string(),
            (_, 0) if counts.is_empty() => format!("no problems in {programs}"),
            (_, 0) => format!("no problems in {programs}, {counts}"),
            (_, some) => format!("{counts}; {} of {programs} with problems", grouped(some)),
        };
        let called = match self.called {
            0 => String::new(),
            some => format!(
                " ({} with only subprograms, run where they are called)",
                counted(some, "file", "files")
            ),
        };
        format!("{}{called}\n", style(terminal.err, BOLD, text))
    }
}

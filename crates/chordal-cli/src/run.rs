//! `chordal run`: the summary of a program and its picture.

use std::path::{Path, PathBuf};

use chordal::motion::MotionOptions;
use chordal::stock::{StockLeft, StockOptions};
use chordal::time::{TimedRun, max_summarized_moves};
use chordal::{Job, Report, Severity};
use chordal_export::format::{RUN_FILES, SUMMARY_FORMATS};
use chordal_export::{OutputFormat, PlotOptions, report, stock_left_text};
use chordal_load::Loaded;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::options::{CommonArgs, ProblemDisplay};
use crate::output::{self, RunOutputs};
use crate::programs::ProgramList;
use crate::stock;
use crate::summary;
use crate::terminal::{BOLD, TerminalSupport, say, style};

const EXAMPLES: &str = "\
Examples:
  chordal run part.nc                        summary and problems
  chordal run part.nc -o part.svg -o part.dxf
  chordal run archive/ -o pictures/          a picture of every program
  chordal run archive/ -o 'out/*.dxf'        * is the program's name
  chordal run part.nc --machine mill.toml --set tools.5.diameter=\"0.5 in\"
  chordal run part.nc --setup op1.toml -o part.png   with the stock that is left
  chordal run part.nc --format json          summary and problems for other programs
  chordal run all-prog.txt --program 9013    one program of a control's memory

Outputs by file extension:
";

const SUBPROGRAMS: &str = "
Subprograms are also looked for in the program's folder, by file name (O1000, 1000.nc) and by
the number in the file. The exit code is 1 when there is an error: the control would stop; with --setup also
when the stock is not proved clean.";

/// Runs a program and summarizes what it does
#[derive(clap::Args)]
#[command(after_help = format!("{EXAMPLES}{}{SUBPROGRAMS}", RUN_FILES.help_lines()))]
pub struct Args {
    /// Programs, or folders of programs; `-` is standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,

    /// Writes a file in the format of its extension; may be repeated
    #[arg(long = "output", short, value_name = "OUT")]
    outputs: Vec<PathBuf>,

    /// Format of the summary and the problems
    #[arg(long, value_parser = format_parser(&SUMMARY_FORMATS), default_value = "text")]
    format: OutputFormat,

    /// The machine, the stock and the tools: cuts the stock as well, draws what is left of it in pictures, and
    /// reports what rapids, shank and holder touch; what is not proved makes the exit code 1
    #[arg(long, value_name = "SETUP.toml", conflicts_with = "machine")]
    setup: Option<PathBuf>,

    #[command(flatten)]
    showing: ProblemDisplay,

    #[command(flatten)]
    common: CommonArgs,
}

pub fn run(mut args: Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    args.common.set_up(args.setup.as_deref());
    let programs = ProgramList::new(&args.files, &args.common, terminal)?;
    let plan = output::plan(&args.outputs, programs.inputs())?;
    let mut objects = Vec::new();
    let mut first = true;
    let verdict = programs.each(|programs, index, loaded| {
        let job = loaded.job()?;
        let done = carry_out(loaded, &job, args.setup.as_deref(), &plan[index])?;
        match args.format {
            OutputFormat::Text => {
                programs.say(if first { "" } else { "\n" })?;
                programs.say(&text(loaded, &job, &done, args.showing, terminal))?;
                first = false;
            }
            _ => {
                let ReportedRun { report, timed, stock, .. } = &done;
                let reading = loaded.reading();
                let run =
                    report::SummarizedRun { report, timed: timed.as_ref(), stock: stock.as_ref() };
                let object = report::summary_json(&run, &job, loaded.name(), &reading);
                objects.push(object);
            }
        }
        let failed = done.report.worst() == Some(Severity::Error)
            || !done.stock.as_ref().is_none_or(StockLeft::is_clean);
        Ok(if failed { ExitVerdict::Problems } else { ExitVerdict::Clean })
    })?;
    if args.format == OutputFormat::Json {
        say(&report::files_json("chordal.run/1", &objects))?;
    }
    Ok(verdict)
}

/// What a run came to, and the files it wrote.
struct ReportedRun {
    /// With the problems of the stock.
    report: Report,
    timed: Option<TimedRun>,
    stock: Option<StockLeft>,
    written: Vec<PathBuf>,
}

fn carry_out(
    loaded: &Loaded,
    job: &Job,
    setup: Option<&Path>,
    targets: &[output::OutputTarget],
) -> Result<ReportedRun, CommandFailure> {
    let mut outputs = RunOutputs::open(targets, job)?;
    let most = max_summarized_moves(loaded.size());
    let (report, timed) = job.report_timed(&MotionOptions::default(), most, &mut outputs);
    // Limits nothing can be planned with are reported by `chordal time`.
    let timed = timed.ok().flatten();
    let options = PlotOptions {
        title: loaded.name().to_string(),
        subtitle: summary::subtitle(job, &report, timed.as_ref()),
        ..PlotOptions::default()
    };
    let mut stock = match setup {
        Some(_) => Some(stock::left(job, &StockOptions::default(), setup)?),
        None => None,
    };
    let written = outputs.finish(&report, stock.as_ref(), &options)?;
    let mut report = report;
    if let Some(found) = &mut stock {
        report = found.report().clone();
        if let Some(timed) = &timed {
            found.take_times(&timed.time.tools);
        }
    }
    Ok(ReportedRun { report, timed, stock, written })
}

fn text(
    loaded: &Loaded,
    job: &Job,
    done: &ReportedRun,
    showing: ProblemDisplay,
    terminal: TerminalSupport,
) -> String {
    let ReportedRun { report, timed, stock, written } = done;
    let mut text = summary::text(loaded, job, report, timed.as_ref(), terminal.out);
    if let Some(found) = stock {
        text.push('\n');
        text.push_str(&indented(&stock_left_text(found)));
    }
    for path in written {
        let row = style(terminal.out, BOLD, "written   ");
        // A program in inches is drawn in mm, too, and not every reader looks for the unit in the file.
        let is_dxf = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("dxf"));
        let unit = if is_dxf { ", in millimetres" } else { "" };
        text.push_str(&format!("  {row:10}{}{unit}\n", path.display()));
    }
    if report.worst().is_some() {
        text.push('\n');
        let detail = showing.detail();
        text.push_str(&report::text(report, job.sources(), terminal.out, detail));
    }
    text
}

/// Lines below the heading of a summary.
fn indented(text: &str) -> String {
    text.lines().map(|line| format!("  {line}\n")).collect()
}

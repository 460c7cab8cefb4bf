//! `chordal report`: the setup sheet.

use std::io::Write;
use std::path::PathBuf;

use chordal::stock::{StockLeft, StockOptions};
use chordal_export::OutputFormat;
use chordal_export::format::SETUP_SHEET_FORMATS;
use chordal_report::{ReportContext, gather, html, json};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::{format_of, format_parser};
use crate::options::CommonArgs;
use crate::out::{RowOutput, trouble};
use crate::programs::load_one;
use crate::rows::print_problems;
use crate::stock;
use crate::terminal::TerminalSupport;

const EXAMPLES: &str = "\
Examples:
  chordal report part.nc -o setup.html       a page to print, to mail or to keep at the machine
  chordal report part.nc --machine vf2.toml -o setup.html
  chordal report part.nc --setup op1.toml -o setup.html   with the stock that is left
  chordal report part.nc -o setup.html --date 2026-11-21
  chordal report part.nc -o setup.json       the same as data
  chordal report part.nc --format json | jq '.tools.rows[].number'

The page needs nothing else: no network, no scripts. For a PDF, print it from the browser. It has
no date unless you give one: the same program gives the same bytes. A program with errors gets a
report, too; it says so at the top. Problems go to standard error, and the exit code is 1 when
there are errors.";

/// Writes a setup sheet: path, offsets, tools, times, travel, stops and problems on one page
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Writes a file in the format of its extension; without it, standard output
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Format of the report if no file extension gives it; a page on standard output
    #[arg(long, value_parser = format_parser(&SETUP_SHEET_FORMATS))]
    format: Option<OutputFormat>,

    /// A date, or any text, to print at the top
    #[arg(long, value_name = "TEXT")]
    date: Option<String>,

    /// The machine, the stock and the tools: what is left of the stock is in the report, and what rapids, shank and
    /// holder touch
    #[arg(long, value_name = "SETUP.toml", conflicts_with = "machine")]
    setup: Option<PathBuf>,

    #[command(flatten)]
    common: CommonArgs,
}

pub fn run(args: &mut Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    args.common.set_up(args.setup.as_deref());
    let path = args.output.as_deref();
    let format = format_of(&SETUP_SHEET_FORMATS, args.format, path, OutputFormat::Html, "reports")?;
    let mut out = RowOutput::open(path, &args.file, format)?;
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    let recognized = loaded.why();
    let stock = match &args.setup {
        Some(setup) => Some(stock::left(&job, &StockOptions::default(), Some(setup))?),
        None => None,
    };
    let about = ReportContext {
        file: loaded.name(),
        program: loaded.program,
        recognized: recognized.as_deref(),
        date: args.date.as_deref(),
        stock: stock.as_ref(),
    };
    let gathered = gather(&job, &about);
    let text = match format {
        OutputFormat::Json => json(&gathered.document),
        _ => html(&gathered.document),
    };
    out.write_all(text.as_bytes()).map_err(|error| trouble(path, error))?;
    out.put()?;
    let verdict = print_problems(&gathered.report, &loaded, &job, terminal);
    Ok(if stock.as_ref().is_none_or(StockLeft::is_clean) { verdict } else { ExitVerdict::Problems })
}

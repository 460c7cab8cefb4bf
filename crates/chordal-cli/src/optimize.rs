//! `chordal optimize`: feeds by what the tool meets, with a proof.

use std::io::Write;
use std::path::{Path, PathBuf};

use chordal::machine::QuantityDimension;
use chordal::motion::MotionOptions;
use chordal::stock::{EngagementOptions, StockOptions};
use chordal_export::format::ANSWER_FORMATS;
use chordal_export::{OutputFormat, optimized_json, optimized_text};
use chordal_rewrite::{ChipLimit, OptimizeError, OptimizeOptions, optimize};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::options::{CommonArgs, quantity};
use crate::out::{RowOutput, trouble};
use crate::programs::{load_one, recognized};
use crate::setup_files;
use crate::stock_failure::failure_of;
use crate::terminal::{TerminalSupport, say};

const EXAMPLES: &str = "\
Examples:
  chordal optimize part.nc --setup op1.toml                       what would change
  chordal optimize part.nc --setup op1.toml -o new.nc             only lower feeds
  chordal optimize part.nc --setup op1.toml --faster 2 -o new.nc  up to twice the programmed feed
  chordal optimize part.nc --setup op1.toml --faster 2 --split -o new.nc
  chordal optimize part.nc --setup op1.toml --chip 0.05mm -o new.nc

The setup file is that of `chordal stock`, with `teeth` of the tools. F words are changed so that no chip is
thicker than the limit, and nothing else: both programs are run, every command must be the same but for
feeds, and the stock that is left the same to the bit. With --split, long lines and arcs are also written in
parts, each with its own F, at points that the digits of the program say exactly. Threads, taps, cycles, G93 and G95 keep their feeds.

Exit code: 0 proved, 1 refused, 2 wrong use.";

/// Changes the feeds of a program so that its chips stay at a thickness, and proves that nothing else changes
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// The machine, the stock and the tools
    #[arg(long, value_name = "SETUP.toml", conflicts_with = "machine")]
    setup: Option<PathBuf>,

    /// The thickest chip: a length, or `best`, as thick as in the program's own best passes
    #[arg(long, value_name = "CHIP", default_value = "best", value_parser = chip)]
    chip: ChipLimit,

    /// Feeds may become so many times the programmed ones; without it, they only become lower
    #[arg(long, value_name = "TIMES", default_value = "1", hide_default_value = true, value_parser = times)]
    faster: f64,

    /// Writes lines and arcs in parts, each with its own F, where the cut changes along them and that saves time
    #[arg(long)]
    split: bool,

    /// Side of a column, with its unit; without it, from the size of the stock
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    resolution: Option<f64>,

    /// Most memory for the columns, MiB
    #[arg(long, value_name = "MIB", default_value_t = 1024)]
    memory: u64,

    /// Writes the new program to this file, `-` to standard output; without it, nothing is written
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&ANSWER_FORMATS), default_value = "text")]
    format: OutputFormat,

    #[command(flatten)]
    common: CommonArgs,
}

fn length(text: &str) -> Result<f64, String> {
    match quantity(text, QuantityDimension::Length)? {
        mm if mm > 0.0 => Ok(mm),
        _ => Err("the length must be above zero".to_string()),
    }
}

fn chip(text: &str) -> Result<ChipLimit, String> {
    if text.eq_ignore_ascii_case("best") {
        return Ok(ChipLimit::Best);
    }
    length(text).map(ChipLimit::Thickness)
}

fn times(text: &str) -> Result<f64, String> {
    /// More is a mistake: nobody programs a tenth of what a cut allows.
    const MAX_FASTER: f64 = 10.0;
    match text.parse::<f64>() {
        Ok(times) if (1.0..=MAX_FASTER).contains(&times) => Ok(times),
        _ => Err("give a number from 1 to 10".to_string()),
    }
}

pub fn run(args: &mut Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    args.common.set_up(args.setup.as_deref());
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    terminal.write_error(&recognized(&loaded));
    let stock = StockOptions {
        resolution_mm: args.resolution,
        budget: args.memory.saturating_mul(1 << 20),
        ..StockOptions::default()
    };
    let options = OptimizeOptions {
        engagement: EngagementOptions { stock, ..EngagementOptions::default() },
        limit: args.chip,
        faster: args.faster,
        split: args.split,
        motion: MotionOptions::default(),
    };
    let streams = args.output.as_deref() == Some(Path::new("-"));
    let done = match optimize(&job, &options, &setup_files::files) {
        Ok(done) => done,
        Err(error) => return refused(error, args, loaded.name(), terminal),
    };
    let path = args.output.as_deref();
    if path.is_some() {
        let out_path = path.filter(|_| !streams);
        let mut out = RowOutput::open(out_path, &args.file, OutputFormat::Text)?;
        out.write_all(&done.text).map_err(|error| trouble(out_path, error))?;
        out.put()?;
    }
    let written = path.filter(|_| !streams).map(|path| path.display().to_string());
    let answer = match args.format {
        OutputFormat::Text => {
            let inch = job.report().summary.inch;
            let last = match &written {
                Some(written) => format!("written: {written}\n"),
                None if streams => String::new(),
                None => "nothing is written: give -o\n".to_string(),
            };
            optimized_text(&done, !inch) + &last
        }
        _ => optimized_json(&done, loaded.name(), written.as_deref()),
    };
    if streams {
        terminal.write_error(&answer)
    } else {
        say(&answer)?
    }
    Ok(ExitVerdict::Clean)
}

/// Says why nothing is written.
fn refused(
    error: OptimizeError,
    args: &Args,
    name: &str,
    terminal: TerminalSupport,
) -> Result<ExitVerdict, CommandFailure> {
    let text = match error {
        OptimizeError::Stock(error) => return Err(failure_of(error, args.setup.as_deref())),
        OptimizeError::Limits(error) => {
            return Err(CommandFailure::wrong(error.to_string(), "correct it in the machine file"));
        }
        OptimizeError::Refused(refusal) => {
            let words = match refusal.text.as_str() {
                "" => String::new(),
                words => format!("  | {words}\n"),
            };
            format!(
                "refused: {name}:{}: {}\n{words}  {}\n",
                refusal.line, refusal.what, refusal.help
            )
        }
        OptimizeError::NotKnown { what, help } => format!("refused: {name}: {what}\n  {help}\n"),
        OptimizeError::NotProved(what) => {
            format!("refused: {name}: the new feeds are not proved: {what}\n")
        }
    };
    let text = text + "nothing is written\n";
    if args.output.as_deref() == Some(Path::new("-")) {
        terminal.write_error(&text)
    } else {
        say(&text)?
    }
    Ok(ExitVerdict::Problems)
}

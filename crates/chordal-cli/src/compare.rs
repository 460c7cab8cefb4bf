//! `chordal compare`: two programs, or one on two machines.

use std::path::{Path, PathBuf};

use chordal::Job;
use chordal::machine::QuantityDimension;
use chordal_compare::{Category, ComparisonOptions, ComparisonVerdict as Answer, compare};
use chordal_export::format::ANSWER_FORMATS;
use chordal_export::{
    OutputFormat, Plot, PlotOptions, comparison_headline, comparison_json, comparison_names,
    comparison_text,
};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::{format_parser, picture_format};
use crate::numbers::SummaryUnits;
use crate::options::{CommonArgs, quantity};
use crate::output::write_whole;
use crate::programs::{load_one, recognized};
use crate::terminal::{TerminalSupport, say};

const EXAMPLES: &str = "\
Examples:
  chordal compare released.nc returned.nc
  chordal compare old.nc new.nc --tolerance 0.01mm      up to 0.01 mm apart is not a difference
  chordal compare part.nc --as fadal-4020 --as haas-vf2  one program on two machines
  chordal compare fadal.nc haas.nc --as fadal-4020 --as haas-vf2
  chordal compare old.nc new.nc -o both.svg             both paths in one picture
  chordal compare old.nc new.nc --ignore feed --ignore spindle
  chordal compare old.nc new.nc --format json | jq .max_distance_mm

Chordal compares what the programs do, not their text: block numbers, spaces, subprograms, units, and
how lines and arcs are divided make no difference. The distance is the largest one between two points
that move along both paths from start to end, cuts and rapids in their order. Which tool is made ready is not
compared.

Exit code: 0 the same, or within the tolerance, 1 different, 2 wrong use.";

/// Compares the motion of two programs, or of one program on two machines
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program
    a: PathBuf,

    /// The other program; without it, the same program on another machine
    b: Option<PathBuf>,

    /// The machine of a program: give it once for each program, in their order
    #[arg(long = "as", value_name = "NAME|FILE.toml", conflicts_with = "machine")]
    machines: Vec<String>,

    /// Paths this far apart count as the same, such as 0.01mm or 0.0005in
    #[arg(long, value_name = "LENGTH", value_parser = length_mm, default_value = "0mm")]
    tolerance: f64,

    /// Feeds and speeds that differ by this fraction count as the same
    #[arg(long, value_name = "PART", default_value_t = 1e-6)]
    feed_tolerance: f64,

    /// The time of all cuts and dwells that differs by this fraction counts as the same
    #[arg(long, value_name = "PART", default_value_t = 1e-3)]
    time_tolerance: f64,

    /// Differences to ignore: feed, spindle, coolant, …
    #[arg(long, value_name = "CATEGORY", value_parser = category)]
    ignore: Vec<Category>,

    /// Draws both paths in one picture, .svg or .png: the first as a band, the second as a line
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&ANSWER_FORMATS), default_value = "text")]
    format: OutputFormat,

    #[command(flatten)]
    common: CommonArgs,
}

fn category(text: &str) -> Result<Category, String> {
    Category::ALL.into_iter().find(|category| category.word() == text).ok_or_else(|| {
        let words: Vec<&str> = Category::ALL.iter().map(|category| category.word()).collect();
        format!("write one of {}", words.join(", "))
    })
}

/// A length of zero or more with its unit, or in mm without.
pub fn length_mm(text: &str) -> Result<f64, String> {
    let bare = text.trim().parse().map_err(|_| ());
    let mm: f64 = bare.or_else(|()| quantity(text, QuantityDimension::Length))?;
    if mm >= 0.0 && mm.is_finite() { Ok(mm) } else { Err("write a length of zero or more".into()) }
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let Some([a, b]) = sides(&args.a, args.b.as_ref(), &args.machines, &args.common)? else {
        return Err(CommandFailure::wrong(
            "there is one program and nothing to compare it with",
            "name another program, or another machine with --as",
        ));
    };
    let (a, b) = (load_one(a.0, &a.1)?, load_one(b.0, &b.1)?);
    let jobs = [a.job()?, b.job()?];
    let jobs = [&jobs[0], &jobs[1]];
    for loaded in [&a, &b] {
        terminal.write_error(&recognized(loaded));
    }
    let options = ComparisonOptions {
        tolerance_mm: args.tolerance,
        feed_tolerance: args.feed_tolerance,
        speed_tolerance: args.feed_tolerance,
        time_tolerance: args.time_tolerance,
        ignored: args.ignore.clone(),
        ..ComparisonOptions::default()
    };
    let found = compare(jobs[0], jobs[1], &options);
    let names = comparison_names([a.name(), b.name()], jobs);
    if let Some(path) = &args.output {
        let units = SummaryUnits::of(found.reports[0].summary.inch);
        let about = comparison_headline(&found, units, args.tolerance);
        picture(path, jobs, names.clone(), &about)?;
    }
    match args.format {
        OutputFormat::Text => {
            say(&comparison_text(
                &found,
                names.each_ref().map(String::as_str),
                jobs,
                args.tolerance,
            ))?;
        }
        _ => say(&comparison_json(&found, jobs, args.tolerance))?,
    }
    Ok(if matches!(found.verdict, Answer::Different | Answer::NotVerified) {
        ExitVerdict::Problems
    } else {
        ExitVerdict::Clean
    })
}

/// Writes both paths in one picture, under their names and a line about them.
pub fn picture(
    path: &Path,
    jobs: [&Job; 2],
    names: [String; 2],
    subtitle: &str,
) -> Result<(), CommandFailure> {
    let format = picture_format(path)?;
    let options = PlotOptions {
        title: format!("{} and {}", names[0], names[1]),
        subtitle: subtitle.trim_end().to_string(),
        ..PlotOptions::default()
    };
    let plot = Plot::overlay(jobs, names);
    let content = match format {
        OutputFormat::Svg => plot.svg(&options).into_bytes(),
        _ => plot
            .png(&options)
            .map_err(|error| CommandFailure::wrong(error.to_string(), "write an .svg"))?,
    };
    write_whole(path, &content)
}

/// The two programs, each with its options; nothing where there is one program on one machine.
pub fn sides<'a>(
    a: &'a PathBuf,
    b: Option<&'a PathBuf>,
    machines: &[String],
    common: &CommonArgs,
) -> Result<Option<[(&'a PathBuf, CommonArgs); 2]>, CommandFailure> {
    let on = |machine: Option<&String>| {
        let machine = machine.or(common.machine.as_ref()).cloned();
        CommonArgs { machine, ..common.clone() }
    };
    match (b, machines) {
        (Some(b), [] | [_, _]) => Ok(Some([(a, on(machines.first())), (b, on(machines.get(1)))])),
        (None, [first, second]) => Ok(Some([(a, on(Some(first))), (a, on(Some(second)))])),
        (None, [second]) => Ok(Some([(a, on(None)), (a, on(Some(second)))])),
        (None, []) => Ok(None),
        (Some(_), [_]) => Err(CommandFailure::wrong(
            "--as is given once for two programs",
            "give it twice, in the order of the programs, or give --machine for both",
        )),
        (_, [_, _, _, ..]) => Err(CommandFailure::wrong(
            "--as is given more than twice",
            "give it once for each program",
        )),
    }
}

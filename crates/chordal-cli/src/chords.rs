use std::io::Write;
use std::path::PathBuf;

use chordal::geometry::Placement;
use chordal::machine::{Dimension, parse_quantity};
use chordal_export::ChordWriter;
use clap::ValueEnum;

use crate::commands::{buffered, keep, tell};
use crate::failure::{Failure, Verdict};
use crate::options::Common;
use crate::session::load_one;
use crate::terminal::Terminal;

const EXAMPLES: &str = "\
Examples:
  chordal chords part.nc --tolerance 0.01mm
  chordal chords part.nc --tolerance 0.0005in --placement balanced
  chordal chords part.nc --format jsonl > chords.jsonl

A tolerance is the largest distance between the exact curve and its chord. Inscribed chords have
their ends on the curve; balanced ones lie as far outside as inside, and are √2 times fewer.";

/// Prints the straight chords that a control unit would send for the path
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Largest distance of a chord from the curve, with its unit
    #[arg(long, value_name = "LENGTH", default_value = "0.01mm", value_parser = tolerance)]
    tolerance: f64,

    /// Where the ends of the chords lie
    #[arg(long, value_enum, default_value = "inscribed")]
    placement: Lie,

    /// How chords are written
    #[arg(long, value_enum, default_value = "csv")]
    format: Format,

    #[command(flatten)]
    common: Common,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Lie {
    /// On the curve
    Inscribed,
    /// The tolerance outside it, the middles inside by the same
    Balanced,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Format {
    /// Comma-separated, one row a chord
    Csv,
    /// JSON lines, one object a chord
    Jsonl,
}

fn tolerance(text: &str) -> Result<f64, String> {
    match parse_quantity(text, Dimension::Length) {
        Ok(mm) if mm > 0.0 => Ok(mm),
        Ok(_) => Err("a tolerance is above zero".to_string()),
        Err(error) => Err(match error.help() {
            Some(help) => format!("{error}; {help}"),
            None => error.to_string(),
        }),
    }
}

pub fn run(args: &Args, terminal: Terminal) -> Result<Verdict, Failure> {
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    let placement = match args.placement {
        Lie::Inscribed => Placement::Inscribed,
        Lie::Balanced => Placement::Balanced,
    };
    let mut writer = match args.format {
        Format::Csv => ChordWriter::csv(buffered(), args.tolerance, placement),
        Format::Jsonl => ChordWriter::jsonl(buffered(), args.tolerance, placement),
    }?;
    let mut done = Ok(());
    let report = job.report_with(|_, segments| {
        keep(&mut done, || segments.iter().try_for_each(|segment| writer.segment(segment)));
    });
    done?;
    writer.finish()?.flush()?;
    Ok(tell(&report, &loaded, &job, terminal))
}

//! `chordal comp-range`: the offsets that each compensated contour allows.

use std::path::PathBuf;

use chordal::ContourRange;
use chordal_export::format::ANSWER_FORMATS;
use chordal_export::{OutputFormat, contour_ranges_json, contour_ranges_text};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::options::CommonArgs;
use crate::programs::load_one;

const EXAMPLES: &str = "\
Examples:
  chordal comp-range part.nc
  chordal comp-range part.nc --machine mitsubishi-m700
  chordal comp-range part.nc --format json | jq '.contours[].largest'

For every contour from G41 or G42 to G40: the offsets (radii) with which it runs. Largest offset for
`control`: without an alarm of this control; `gouge`: without a cut into a wall, which a control may
not see; `edges`: the tool touches every edge, 0 at a sharp inside corner; `leads`: allowed by the
lead-in and the lead-out. Exit code 1 when an offset of the table lies outside.";

/// Reports with which offsets each compensated contour runs, and the block that limits them
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Format of the ranges
    #[arg(long, value_parser = format_parser(&ANSWER_FORMATS), default_value = "text")]
    format: OutputFormat,

    #[command(flatten)]
    common: CommonArgs,
}

pub fn run(args: &Args) -> Result<ExitVerdict, CommandFailure> {
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    let found = job.contour_ranges();
    let text = match args.format {
        OutputFormat::Text => contour_ranges_text(&found, &job),
        _ => contour_ranges_json(&found),
    };
    anstream::print!("{text}");
    let outside = found.ranges.iter().any(|range: &ContourRange| !range.fits());
    Ok(if outside { ExitVerdict::Problems } else { ExitVerdict::Clean })
}

//! `chordal chords`: the path as straight chords.

use std::path::PathBuf;

use chordal::control::AxisMask;
use chordal::geometry::Placement;
use chordal::{Job, Segment, SegmentKind};
use chordal_export::format::ROW_FORMATS;
use chordal_export::{
    ChordWriter, OutputFormat, left_out_texts, not_named_texts, write_unless_failed,
};
use clap::ValueEnum;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::options::{CommonArgs, length};
use crate::rows::RowTarget;
use crate::terminal::TerminalSupport;

const EXAMPLES: &str = "\
Examples:
  chordal chords part.nc --tolerance 0.01mm
  chordal chords part.nc --tolerance 0.0005in --placement balanced
  chordal chords sign.nc --as-control             as GRBL cuts arcs into segments
  chordal chords part.nc -o chords.jsonl          by the extension: .csv, .jsonl, .parquet, .arrow

The tolerance is the largest distance between the exact curve and its chord. Inscribed chords have
their ends on the curve; balanced chords lie as far outside as inside, and √2 times fewer are needed.
A coordinate that is not known is blank.";

/// Prints the straight chords that a control unit would send for the path
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Largest distance of a chord from the curve, with its unit
    #[arg(long, value_name = "LENGTH", default_value = "0.01mm", value_parser = length)]
    tolerance: f64,

    /// Where the ends of the chords are
    #[arg(long, value_enum, default_value = "inscribed")]
    placement: ChordPlacement,

    /// The segments that the control itself cuts arcs into (GRBL: $12)
    #[arg(long, conflicts_with_all = ["tolerance", "placement"])]
    as_control: bool,

    /// Writes a file in the format of its extension; without it, standard output
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Format of the chords if no file extension gives it; CSV on standard output
    #[arg(long, value_parser = format_parser(&ROW_FORMATS))]
    format: Option<OutputFormat>,

    #[command(flatten)]
    common: CommonArgs,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum ChordPlacement {
    /// On the curve
    Inscribed,
    /// Outside it by the tolerance, their middles inside by the same
    Balanced,
}

impl ChordPlacement {
    fn inside(self) -> Placement {
        match self {
            ChordPlacement::Inscribed => Placement::Inscribed,
            ChordPlacement::Balanced => Placement::Balanced,
        }
    }
}

/// The axes of which a cut has no place at one of its ends. The way to the first place is never known; that is no loss.
fn unknown_in(segment: &Segment) -> AxisMask {
    if segment.kind == SegmentKind::Rapid {
        return AxisMask::NONE;
    }
    let [from, to] = segment.places();
    AxisMask::LINEAR.without(from.and(to).or(segment.not_named.all()))
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let output = RowTarget::of(
        &ROW_FORMATS,
        args.output.as_deref(),
        args.format,
        OutputFormat::Csv,
        "chords",
    )?;
    let goes = |job: &Job| {
        if !args.as_control || job.own_chords().is_some() {
            return Ok(());
        }
        let title = job.profile().title;
        let message = format!("{title} is not known to cut arcs into segments");
        Err(CommandFailure::wrong(message, "say --tolerance instead of --as-control"))
    };
    let mut remarks = Vec::new();
    let verdict =
        output.write_if(&args.file, &args.common, terminal, goes, |job, out, format| {
            let own = job.own_chords().filter(|_| args.as_control);
            let cut = own.unwrap_or((args.tolerance, args.placement.inside()));
            let mut writer = ChordWriter::new(out, format, job, cut)?;
            let mut done = Ok(());
            let mut blank = AxisMask::NONE;
            let report = job.report_with(|_, segments| {
                write_unless_failed(&mut done, || {
                    segments.iter().try_for_each(|segment| writer.segment(segment))
                });
                segments.iter().for_each(|segment| blank = blank.or(unknown_in(segment)));
            });
            done?;
            remarks = not_named_texts(job.not_named_axes());
            remarks
                .extend(left_out_texts(&report.summary.unrelated_zeros, job.profile().work_names));
            if blank != AxisMask::NONE {
                let letters: Vec<String> =
                    blank.iter().map(|axis| axis.letter().to_string()).collect();
                remarks.push(format!(
                    "cuts at unknown places are blank there: {}",
                    letters.join(", ")
                ));
            }
            Ok((report, writer.finish()?))
        })?;
    remarks.iter().for_each(|remark| terminal.write_error(&format!("  {remark}\n")));
    Ok(verdict)
}

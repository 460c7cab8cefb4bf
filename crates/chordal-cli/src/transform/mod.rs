//! `chordal transform`: a program changed in place, with a proof.

mod heights;
mod split;

use std::io::Write;
use std::path::PathBuf;

use chordal::Job;
use chordal::control::Units as TextUnits;
use chordal::machine::QuantityDimension;
use chordal_compare::ComparisonOptions;
use chordal_export::format::ANSWER_FORMATS;
use chordal_export::{OutputFormat, comparison_text, refusal_json, transformed_json};
use chordal_load::Loaded;
use chordal_rewrite::{
    ArcForm, SplitBy, TransformRefusal, TransformStep, TransformedProgram, transform,
};
use clap::ValueEnum;

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::numbers::{SummaryUnits, counted};
use crate::options::{CommonArgs, quantity};
use crate::out::RowOutput;
use crate::programs::{load_one, recognized};
use crate::terminal::{TerminalSupport, say};
use crate::unified::unified;
use crate::view::{self, GeneratedProgram};

const EXAMPLES: &str = "\
Examples:
  chordal transform part.nc --shift X5 Y-2.5 Z.1        shows what would change
  chordal transform part.nc --shift X5 -o moved.nc      and writes it if it is proved
  chordal transform part.nc --shift X5 --view           both paths in one picture
  chordal transform part.nc --rotate 30 --about 1,2 -o turned.nc
  chordal transform part.nc --mirror x -o left.nc       swaps G2 and G3, G41 and G42
  chordal transform part.nc --units mm --feed 90% -o metric.nc
  chordal transform surface.nc --fit 0.01mm -o arcs.nc  chords as tangent arcs and lines
  chordal transform part.nc --heights probed.csv -o bent.nc   onto a surface that was measured
  chordal transform part.nc --shrink 8000 -o small.nc   for a control with little memory
  chordal transform part.nc --split 32k -o part.nc      part-1.nc, part-2.nc, …: each runs by itself

Steps are made in the order: units, mirror, rotate, scale, shift, feed and speed, chords, simplify,
fit, arcs, comments, numbers, shrink, heights, split. Lengths without a unit are in the units of the program.
Each word is changed by its meaning in its block. The new program is run and compared with the old path
after the same changes; if they differ, nothing is written.

Exit code: 0 proved, 1 refused or not proved, 2 wrong use.";

/// Moves, rotates, mirrors, scales or rewrites a program, and proves that the motion is as intended
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program
    file: PathBuf,

    /// Writes every length in this unit
    #[arg(long, value_enum)]
    units: Option<TargetUnit>,

    /// Changes the sign of X or of Y
    #[arg(long, value_name = "x|y", value_enum, ignore_case = true)]
    mirror: Option<MirrorAxis>,

    /// Rotates the path about Z, in degrees, counter-clockwise
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    rotate: Option<f64>,

    /// The point about which it is rotated
    #[arg(long, value_name = "X,Y", requires = "rotate", allow_hyphen_values = true)]
    about: Option<String>,

    /// Multiplies every length
    #[arg(long, value_name = "FACTOR", value_parser = factor)]
    scale: Option<f64>,

    /// Moves the path: `X1 Y2 Z3`, with a unit such as `X1in`, or in the program's units
    #[arg(long, value_name = "AXIS", num_args = 1..=3)]
    shift: Vec<String>,

    /// Multiplies the feeds of cuts, such as 90% or 0.9
    #[arg(long, value_name = "PART", value_parser = factor)]
    feed: Option<f64>,

    /// Multiplies spindle speeds, and with them the feeds of taps
    #[arg(long, value_name = "PART", value_parser = factor)]
    speed: Option<f64>,

    /// Writes arcs by R or by I J K
    #[arg(long, value_name = "FORM", value_enum)]
    arcs: Option<ArcFormArg>,

    /// Writes arcs and spirals as chords within this length
    #[arg(long, value_name = "LENGTH")]
    chords: Option<String>,

    /// Writes sequences of chords as tangent arcs and lines within this length
    #[arg(long, value_name = "LENGTH")]
    fit: Option<String>,

    /// Chords whose feeds differ by at most this part become one line or arc of --fit, at the slowest of them
    #[arg(long, value_name = "PART", requires = "fit", default_value = "1%", value_parser = part)]
    feed_tolerance: f64,

    /// Raises every cut by the heights of a measured map: a CSV file with X, Y and Z of a full grid of points
    #[arg(long, value_name = "MAP")]
    heights: Option<PathBuf>,

    #[command(flatten)]
    map: heights::MapArgs,

    /// Removes chords, as long as the path stays within this length
    #[arg(long, value_name = "LENGTH")]
    simplify: Option<String>,

    /// Renumbers the blocks that have numbers: `10`, or `100,5` for the first number and the step
    #[arg(long, value_name = "FIRST[,STEP]", num_args = 0..=1, default_missing_value = "10,10")]
    renumber: Option<String>,

    /// Removes block numbers that nothing jumps to
    #[arg(long)]
    no_numbers: bool,

    /// Removes comments
    #[arg(long)]
    strip_comments: bool,

    /// Makes the text no longer than this many bytes: removes blanks, digits, numbers and comments as far as needed
    #[arg(long, value_name = "BYTES")]
    shrink: Option<usize>,

    /// Writes the program in parts of at most this many bytes (32000 or 32k), or one part for each tool (`tool`)
    #[arg(long, value_name = "BYTES|tool", value_parser = parted)]
    split: Option<SplitBy>,

    /// Writes the new program; without it, only the difference is shown
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Shows the difference and writes nothing
    #[arg(long)]
    dry_run: bool,

    /// Shows both paths in one picture in the browser, as they are, until Ctrl-C
    #[arg(long, conflicts_with = "split")]
    view: bool,

    /// Writes the new program even if the proof fails
    #[arg(long)]
    unproved: bool,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&ANSWER_FORMATS), default_value = "text")]
    format: OutputFormat,

    #[command(flatten)]
    common: CommonArgs,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum TargetUnit {
    Mm,
    Inch,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum MirrorAxis {
    X,
    Y,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum ArcFormArg {
    Radius,
    Center,
}

/// `90%` and `0.9` as the same number.
fn share(text: &str) -> Option<f64> {
    let (number, part) = text.strip_suffix('%').map_or((text, 1.0), |number| (number, 100.0));
    number.trim().parse::<f64>().ok().map(|value| value / part)
}

/// `90%`, `0.9`: above zero.
fn factor(text: &str) -> Result<f64, String> {
    share(text)
        .filter(|value| *value > 0.0 && value.is_finite())
        .ok_or_else(|| "write a factor above zero, such as 0.9 or 90%".into())
}

/// `1%`, `0.01`: from nothing to less than the whole.
fn part(text: &str) -> Result<f64, String> {
    share(text)
        .filter(|value| (0.0..1.0).contains(value))
        .ok_or_else(|| "write a part from 0 to less than 1, such as 1% or 0.01".into())
}

/// `32000`, `32k`, `tool`.
fn parted(text: &str) -> Result<SplitBy, String> {
    let lower = text.trim().to_ascii_lowercase();
    if lower == "tool" {
        return Ok(SplitBy::Tool);
    }
    let (number, times) =
        lower.strip_suffix('k').map_or((lower.as_str(), 1), |number| (number, 1000));
    match number.trim().parse::<usize>().ok().and_then(|number| number.checked_mul(times)) {
        Some(bytes) if bytes > 0 => Ok(SplitBy::Bytes(bytes)),
        _ => Err("write a number of bytes, such as 32000 or 32k, or the word `tool`".into()),
    }
}

/// A length with its unit, or in those of the program.
fn length(text: &str, units: SummaryUnits) -> Result<f64, CommandFailure> {
    let bare = text.trim().parse::<f64>().map(|value| value * units.length_mm()).map_err(|_| ());
    bare.or_else(|()| quantity(text, QuantityDimension::Length)).map_err(|error| {
        CommandFailure::wrong(
            format!("`{text}` is not a length: {error}"),
            "write it like 5, 5mm or 0.2in",
        )
    })
}

/// `X,Y`, each with its unit, or in those of the program; mm.
fn position(text: &str, units: SummaryUnits) -> Result<[f64; 2], CommandFailure> {
    let Some((x, y)) = text.split_once(',') else {
        return Err(CommandFailure::wrong(
            format!("`{text}` is not a position"),
            "write X and Y with a comma between them, such as 1.5,-2",
        ));
    };
    Ok([length(x, units)?, length(y, units)?])
}

fn steps(args: &Args, units: SummaryUnits) -> Result<Vec<TransformStep>, CommandFailure> {
    let mut steps = Vec::new();
    steps.extend(args.units.map(|unit| {
        TransformStep::Units(if unit == TargetUnit::Mm {
            TextUnits::Millimetre
        } else {
            TextUnits::Inch
        })
    }));
    steps.extend(args.mirror.map(|mirror| match mirror {
        MirrorAxis::X => TransformStep::MirrorX,
        MirrorAxis::Y => TransformStep::MirrorY,
    }));
    if let Some(degrees) = args.rotate {
        let mut about = [0.0; 2];
        if let Some(text) = &args.about {
            about = position(text, units)?;
        }
        steps.push(TransformStep::Rotate { angle: degrees.to_radians(), about });
    }
    steps.extend(args.scale.map(TransformStep::Scale));
    let shift = shift(&args.shift, units)?;
    steps.extend(shift.map(TransformStep::Shift));
    if args.feed.is_some() || args.speed.is_some() {
        let (feed, speed) = (args.feed.unwrap_or(1.0), args.speed.unwrap_or(1.0));
        steps.push(TransformStep::Rates { feed, speed });
    }
    let tolerance = |text: &Option<String>| -> Result<Option<f64>, CommandFailure> {
        let Some(text) = text else { return Ok(None) };
        match length(text, units)? {
            mm if mm > 0.0 => Ok(Some(mm)),
            _ => Err(CommandFailure::wrong(
                format!("`{text}` is not a tolerance"),
                "write a length above zero, such as 0.01mm",
            )),
        }
    };
    steps.extend(tolerance(&args.chords)?.map(TransformStep::Chords));
    steps.extend(tolerance(&args.simplify)?.map(TransformStep::Simplify));
    steps.extend(
        tolerance(&args.fit)?
            .map(|tolerance| TransformStep::Fit { tolerance, feed_tolerance: args.feed_tolerance }),
    );
    steps.extend(args.arcs.map(|form| {
        TransformStep::Arcs(if form == ArcFormArg::Radius {
            ArcForm::Radius
        } else {
            ArcForm::Center
        })
    }));
    steps.extend(args.strip_comments.then_some(TransformStep::StripComments));
    steps.extend(args.no_numbers.then_some(TransformStep::NoNumbers));
    if let Some(text) = &args.renumber {
        let (first, step) = text.split_once(',').unwrap_or((text, "10"));
        let (Ok(first), Ok(step)) = (first.trim().parse(), step.trim().parse()) else {
            return Err(CommandFailure::wrong(
                format!("`{text}` is not a numbering"),
                "write the first number and the step, such as 100,5",
            ));
        };
        steps.push(TransformStep::Renumber { first, step });
    }
    steps.extend(args.shrink.map(TransformStep::Shrink));
    if steps.is_empty() && args.split.is_none() && args.heights.is_none() {
        return Err(CommandFailure::wrong(
            "there is nothing to do",
            "give a change, such as --shift X5; `chordal transform --help` lists them",
        ));
    }
    Ok(steps)
}

fn shift(words: &[String], units: SummaryUnits) -> Result<Option<[f64; 3]>, CommandFailure> {
    let mut by = [0.0; 3];
    for word in words {
        let axis = word.chars().next().and_then(|axis| "XYZ".find(axis.to_ascii_uppercase()));
        let Some(axis) = axis else {
            return Err(CommandFailure::wrong(
                format!("`{word}` has no axis letter"),
                "write the axis before the distance, such as X5 or Z-0.1in",
            ));
        };
        by[axis] = length(&word[1..], units)?;
    }
    Ok((!words.is_empty()).then_some(by))
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    terminal.write_error(&recognized(&loaded));
    let units = SummaryUnits::of(job.report().summary.inch);
    let steps = steps(args, units)?;
    let bent =
        args.heights.as_ref().map(|path| heights::HeightMapInput::read(path, &args.map, units));
    let bent = bent.transpose()?;
    if let (Some(by), true, None) = (args.split, steps.is_empty(), &bent) {
        return split::run(&job, by, &TransformRequest { args, loaded: &loaded }, None);
    }
    let changed = match (&bent, steps.is_empty()) {
        (Some(bent), true) => bent.warp(&job),
        (Some(bent), false) => transform(&job, &steps).and_then(|done| bent.warp_on(&job, done)),
        (None, _) => transform(&job, &steps),
    };
    let done = match changed {
        Ok(done) => done,
        Err(refusal) => {
            match args.format {
                OutputFormat::Text => say(&refused(&refusal, loaded.name()))?,
                _ => say(&refusal_json(&refusal, loaded.name()))?,
            }
            return Ok(ExitVerdict::Problems);
        }
    };
    let holds = done.certificate.holds();
    if let (Some(by), true) = (args.split, holds || args.unproved) {
        let new = job.with_text(done.text.clone());
        return split::run(
            &new,
            by,
            &TransformRequest { args, loaded: &loaded },
            Some((&done, &job)),
        );
    }
    let is_written = !args.dry_run && (holds || args.unproved);
    let out = args.output.as_ref().filter(|_| is_written);
    if let Some(path) = out {
        let mut out = RowOutput::open(Some(path), &args.file, OutputFormat::Text)?;
        out.write_all(&done.text)?;
        out.put()?;
    }
    let new = job.with_text(done.text.clone());
    match args.format {
        OutputFormat::Text => say(&text(&done, &loaded, [&job, &new], args, is_written))?,
        _ => {
            let written = out.map(|path| path.display().to_string());
            say(&transformed_json(&done, [&job, &new], written.as_deref()))?;
        }
    }
    if args.view {
        let machine = loaded.machine().clone();
        let (file, options) = (out.map(PathBuf::as_path), ComparisonOptions::default());
        let made = GeneratedProgram { how: "changed", file, text: done.text, machine, options };
        view::show_pair(&args.file, loaded.text(), &args.common, made, terminal)?;
    }
    Ok(if holds { ExitVerdict::Clean } else { ExitVerdict::Problems })
}

/// What was asked for, of which program.
struct TransformRequest<'a> {
    args: &'a Args,
    loaded: &'a Loaded,
}

fn refused(refusal: &TransformRefusal, name: &str) -> String {
    let words = match refusal.text.as_str() {
        "" => String::new(),
        words => format!("  | {words}\n"),
    };
    format!(
        "refused: {name}:{}: {}\n{words}  {}\nnothing is written\n",
        refusal.line, refusal.what, refusal.help
    )
}

fn text(
    done: &TransformedProgram,
    loaded: &Loaded,
    jobs: [&Job; 2],
    args: &Args,
    is_written: bool,
) -> String {
    let mut text = difference(done, loaded, jobs);
    let certificate = &done.certificate;
    text += &match (&args.output, is_written, certificate.holds()) {
        (None, _, true) => "nothing is written: give a file with -o\n".to_string(),
        (Some(path), true, true) => format!("written: {}\n", path.display()),
        (Some(path), true, false) => format!("written, but not proved: {}\n", path.display()),
        (_, _, false) => "nothing is written: the proof failed (--unproved writes it)\n".into(),
        (Some(_), false, true) => "nothing is written: --dry-run\n".into(),
    };
    text
}

/// What changes, and the proof.
fn difference(done: &TransformedProgram, loaded: &Loaded, jobs: [&Job; 2]) -> String {
    let difference = unified(loaded.name(), loaded.text(), &done.text);
    let mut text = if difference.is_empty() { "nothing changes\n".into() } else { difference };
    text += &format!("\n{}", counted(done.changes.len() as u64, "change", "changes"));
    text += &format!(
        ", {} to {} bytes\n",
        crate::numbers::grouped(loaded.size() as u64),
        crate::numbers::grouped(done.text.len() as u64)
    );
    for note in &done.notes {
        text += &format!("note: {note}\n");
    }
    let certificate = &done.certificate;
    text += "proof: the new program against the intended path\n";
    text +=
        &comparison_text(&certificate.comparison, ["meant", "new"], jobs, certificate.tolerance_mm);
    text
}

//! Programs that mill threads.

use std::path::PathBuf;

use chordal::machine::ControlName;
use chordal_calc::{
    AnswerUnit, MillingDirection, RampSweep, ThreadHand, ThreadLocation, ThreadMill,
    ThreadMillCutter, thread_mill,
};
use chordal_export::format::{CALCULATION_FORMATS, PICTURE_FILES};
use chordal_export::{OutputFormat, worked_json, worked_text};
use clap::ValueEnum;

use super::answer::{draw, refused};
use super::quantity::{UnitsName, WrittenQuantity, feed, length, spindle};
use super::thread::{ThreadRequest, ThreadSizeArgs};
use crate::failure::CommandFailure;
use crate::formats::format_parser;
use crate::output::write_whole;
use crate::terminal::say;

const EXAMPLES: &str = "\
Examples:
  chordal calc thread-mill 1.5-8 --tool 0.75in --depth 0.5in --feed 10in/min \\
      --spindle 1200 --control haas -o thread.nc
  chordal calc thread-mill M30x2 --outside --hand left --cutter single --tool 12mm \\
      --depth 24mm --feed 400mm/min --spindle 2500 --control fanuc -o thread.nc -o thread.svg

Without -o for it, the program goes to standard output. The path is that of the tool centre;
the teeth cut to the major diameter inside, and to the root diameter outside. A right-hand thread
is climb cut upwards in a hole (G3) and downwards on a boss (G2), with the spindle turning with M3.";

/// Writes a program that mills a thread
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    size: ThreadSizeArgs,

    /// The control that runs the program: fadal, haas, fanuc, mitsubishi, linuxcnc
    #[arg(long, value_parser = control)]
    control: ControlName,

    /// On a boss instead of in a hole
    #[arg(long, conflicts_with = "inside")]
    outside: bool,

    /// In a hole
    #[arg(long)]
    inside: bool,

    /// Hand of the thread; right if neither this nor LH in its name gives it
    #[arg(long, value_enum)]
    hand: Option<HandName>,

    /// The tool: a hob cuts the whole thread in one turn, a single point needs one turn for each pitch
    #[arg(long, value_enum, default_value = "hob")]
    cutter: CutterName,

    /// Conventional instead of climb cutting
    #[arg(long)]
    conventional: bool,

    /// Part of a turn for the lead-in and for the lead-out, with the same part of the pitch
    #[arg(long, value_parser = ramp, value_name = "1/8|1/4")]
    ramp: Option<RampSweep>,

    /// Diameter over the teeth of the tool
    #[arg(long, short, value_name = "DIAMETER", value_parser = length)]
    tool: WrittenQuantity,

    /// How far the thread reaches below Z0
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    depth: WrittenQuantity,

    /// Feed at the cutting diameter; the feed of the tool centre is computed
    #[arg(long, value_name = "FEED", value_parser = feed)]
    feed: WrittenQuantity,

    /// Spindle speed
    #[arg(long, value_name = "RPM", value_parser = spindle)]
    spindle: f64,

    /// Root diameter of an outside thread, if it is not that of the basic profile
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    root: Option<WrittenQuantity>,

    /// Writes G41 or G42 with D for the wear of the tool
    #[arg(long)]
    compensation: bool,

    /// Largest wear that D may hold; default: 0.01 in or 0.25 mm
    #[arg(long, value_name = "LENGTH", value_parser = length, requires = "compensation")]
    wear: Option<WrittenQuantity>,

    /// Height of rapids above Z0; default: 0.1 in or 2.5 mm
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    clearance: Option<WrittenQuantity>,

    /// Number of the tool, of its H and its D
    #[arg(long, value_name = "N", default_value = "1", value_parser = clap::value_parser!(u32).range(1..=99))]
    tool_number: u32,

    /// Number of the program
    #[arg(long, value_name = "N", default_value = "1001", value_parser = clap::value_parser!(u32).range(1..=9999))]
    number: u32,

    /// Units of the program, and of numbers without a unit
    #[arg(long, value_enum)]
    units: Option<UnitsName>,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&CALCULATION_FORMATS), default_value = "text")]
    format: OutputFormat,

    /// Writes the program (.nc, .tap, …), or its figure (.svg, .png); may be repeated
    #[arg(short, long = "output", value_name = "FILE")]
    outputs: Vec<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum HandName {
    /// Right
    Right,
    /// Left
    Left,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum CutterName {
    /// Many rows of teeth, at the pitch
    Hob,
    /// One row of teeth
    Single,
}

fn control(text: &str) -> Result<ControlName, String> {
    text.parse().map_err(|error| {
        let names =
            ControlName::ALL.iter().map(|name| name.as_str()).collect::<Vec<_>>().join(", ");
        format!("{error}; the controls are {names}")
    })
}

fn ramp(text: &str) -> Result<RampSweep, String> {
    match text {
        "1/8" => Ok(RampSweep::Eighth),
        "1/4" => Ok(RampSweep::Quarter),
        _ => Err("a ramp is 1/8 or 1/4 of a turn".to_string()),
    }
}

pub fn run(args: &Args) -> Result<(), CommandFailure> {
    let requested = args.size.read(args.units)?;
    let mut program = thread_mill(&ask(args, &requested)?).map_err(refused)?;
    if let Some(name) = &requested.name {
        program.worked.notes.extend(name.notes.iter().cloned());
    }
    let mut written = Vec::new();
    let mut program_written = false;
    for path in &args.outputs {
        match PICTURE_FILES.of_file(path) {
            Some(kind) => draw(&program.worked, path, kind)?,
            None => {
                write_whole(path, program.text.as_bytes())?;
                program_written = true;
            }
        }
        written.push(path);
    }
    match args.format {
        OutputFormat::Json => say(&worked_json(&program.worked, Some(&program.text))),
        OutputFormat::Text if program_written => {
            let mut text = worked_text(&program.worked);
            for path in written {
                text.push_str(&format!("\n  written {}", path.display()));
            }
            text.push('\n');
            say(&text)
        }
        _ => say(&program.text),
    }
}

/// The hand of `--hand` or of the name, which have to agree.
fn hand(args: &Args, requested: &ThreadRequest) -> Result<ThreadHand, CommandFailure> {
    let stated = args.hand.map(|hand| match hand {
        HandName::Right => ThreadHand::Right,
        HandName::Left => ThreadHand::Left,
    });
    let named = requested.name.as_ref().and_then(|name| name.hand);
    match (stated, named) {
        (Some(chosen), Some(named)) if chosen != named => Err(CommandFailure::wrong(
            "the name of the thread and --hand give different hands",
            "leave out --hand, or LH or RH",
        )),
        _ => Ok(stated.or(named).unwrap_or(ThreadHand::Right)),
    }
}

fn ask(args: &Args, requested: &ThreadRequest) -> Result<ThreadMill, CommandFailure> {
    let numbers = &requested.numbers;
    let inch = numbers.units == AnswerUnit::Inch;
    let usual = |inches: f64, mm: f64| if inch { inches * 25.4 } else { mm };
    let wear = numbers.maybe(args.wear.as_ref())?.unwrap_or(usual(0.01, 0.25));
    Ok(ThreadMill {
        thread: requested.thread(1)?,
        place: if args.outside { ThreadLocation::Outside } else { ThreadLocation::Inside },
        hand: hand(args, requested)?,
        cutter: if args.cutter == CutterName::Hob {
            ThreadMillCutter::Hob
        } else {
            ThreadMillCutter::Single
        },
        cut: if args.conventional {
            MillingDirection::Conventional
        } else {
            MillingDirection::Climb
        },
        ramp: args.ramp,
        root: numbers.maybe(args.root.as_ref())?,
        tool_diameter: numbers.of(&args.tool)?,
        depth: numbers.of(&args.depth)?,
        feed: numbers.of(&args.feed)?,
        spindle: args.spindle,
        wear: args.compensation.then_some(wear),
        tool: args.tool_number,
        number: args.number,
        clearance: numbers.maybe(args.clearance.as_ref())?.unwrap_or(usual(0.1, 2.5)),
        control: args.control,
        units: numbers.units,
    })
}

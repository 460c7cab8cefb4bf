//! Speeds and feeds.

use chordal::machine::{QuantityDimension, QuantityError, parse_quantity};
use chordal_calc::{AnswerUnit, CuttingData, EdgeSpeed, ToolFeed, cutting};

use super::answer::{CalculationOutput, give};
use super::quantity::{UnitReader, WrittenQuantity, feed, length, spindle};
use crate::failure::CommandFailure;
use crate::options::wrong_quantity;

const EXAMPLES: &str = "\
Examples:
  chordal calc speeds --tool 12mm --surface 120m/min --teeth 4 --per-tooth 0.05mm
  chordal calc speeds --tool 0.5in --surface 400sfm --teeth 3 --per-tooth 0.003in \\
      --width 0.05in --depth 1in
  chordal calc speeds --tool 10mm --spindle 6000 --teeth 2 --feed 900mm/min";

/// Spindle speed, feed, chip and removal of a cut, or the cutting speed of a spindle speed
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Diameter of the tool
    #[arg(long, short, value_name = "DIAMETER", value_parser = length)]
    tool: WrittenQuantity,

    /// Cutting speed, such as 120m/min or 400sfm
    #[arg(long, value_name = "SPEED", value_parser = surface, required_unless_present = "spindle")]
    surface: Option<(f64, bool)>,

    /// Spindle speed instead of the cutting speed
    #[arg(long, value_name = "RPM", value_parser = spindle, conflicts_with = "surface")]
    spindle: Option<f64>,

    /// Teeth of the tool
    #[arg(long, value_name = "N")]
    teeth: Option<u32>,

    /// Feed of a tooth
    #[arg(long, value_name = "LENGTH", value_parser = length, requires = "teeth")]
    per_tooth: Option<WrittenQuantity>,

    /// Feed instead of the feed of a tooth
    #[arg(long, value_name = "FEED", value_parser = feed, requires = "teeth", conflicts_with = "per_tooth")]
    feed: Option<WrittenQuantity>,

    /// Width of the cut, across the feed
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    width: Option<WrittenQuantity>,

    /// Depth of the cut, along the tool
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    depth: Option<WrittenQuantity>,

    #[command(flatten)]
    answer: CalculationOutput,
}

/// `120m/min`, `400sfm`, `400ft/min`: mm/s, and whether it is in feet.
fn surface(text: &str) -> Result<(f64, bool), String> {
    let lower = text.trim().to_ascii_lowercase();
    let feet = lower.strip_suffix("sfm").map(|number| format!("{number} ft/min"));
    let is_feet = feet.is_some() || lower.contains("ft");
    match parse_quantity(&feet.unwrap_or(lower), QuantityDimension::Velocity) {
        Ok(value) => Ok((value, is_feet)),
        Err(QuantityError::NoUnit { text, .. }) => {
            Err(format!("`{text}` has no unit: write {text}m/min or {text}sfm"))
        }
        Err(error) => Err(wrong_quantity(&error)),
    }
}

pub fn run(args: &Args) -> Result<(), CommandFailure> {
    let written = [
        Some(&args.tool),
        args.per_tooth.as_ref(),
        args.feed.as_ref(),
        args.width.as_ref(),
        args.depth.as_ref(),
    ];
    let mut numbers = UnitReader::new(args.answer.units, written);
    if args.answer.units.is_none() && args.surface.is_some_and(|(_, feet)| feet) {
        numbers.units = AnswerUnit::Inch;
    }
    let tool_feed = match (&args.per_tooth, &args.feed) {
        (Some(tooth), _) => Some(ToolFeed::PerTooth(numbers.of(tooth)?)),
        (None, Some(feed)) => Some(ToolFeed::PerTime(numbers.of(feed)?)),
        (None, None) => None,
    };
    let speed = match (args.surface, args.spindle) {
        (Some((surface, _)), _) => EdgeSpeed::Surface(surface),
        (None, Some(rpm)) => EdgeSpeed::Spindle(rpm),
        (None, None) => {
            return Err(CommandFailure::wrong("no speed is given", "give --surface or --spindle"));
        }
    };
    let ask = CuttingData {
        diameter: numbers.of(&args.tool)?,
        speed,
        feed: tool_feed.zip(args.teeth),
        depth: numbers.maybe(args.depth.as_ref())?,
        width: numbers.maybe(args.width.as_ref())?,
    };
    give(cutting(&ask, numbers.units), &args.answer)
}

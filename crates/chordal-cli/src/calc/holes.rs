//! Holes: on a circle, and before a tap.

use chordal::geometry::Vec2;
use chordal_calc::{BoltCircle, TapDrill, ThreadForm, bolt_circle, tap_drill};

use super::answer::{CalculationOutput, give};
use super::quantity::{UnitReader, WrittenQuantity, angle, length};
use super::thread::ThreadSizeArgs;
use crate::failure::CommandFailure;

const CIRCLE_EXAMPLES: &str = "\
Examples:
  chordal calc bolt-circle --diameter 80mm --holes 6
  chordal calc bolt-circle --diameter 3in --holes 8 --start 22.5deg --center-x 4in --center-y 2in
  chordal calc bolt-circle --diameter 80mm --holes 4 --sweep 90deg -o holes.svg";

/// X and Y of holes on a circle
#[derive(clap::Args)]
#[command(after_help = CIRCLE_EXAMPLES)]
pub struct BoltCircleArgs {
    /// Diameter of the circle
    #[arg(long, short, value_name = "LENGTH", value_parser = length)]
    diameter: WrittenQuantity,

    /// Number of holes
    #[arg(long, value_name = "N")]
    holes: u32,

    /// Direction from the centre to the first hole, from the X axis
    #[arg(long, value_name = "ANGLE", default_value = "0deg", value_parser = angle, allow_hyphen_values = true)]
    start: f64,

    /// Angle from the first hole to the last; 360deg: all round, evenly; negative goes clockwise
    #[arg(long, value_name = "ANGLE", default_value = "360deg", value_parser = angle, allow_hyphen_values = true)]
    sweep: f64,

    /// X of the centre; 0 when left out
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true)]
    center_x: Option<WrittenQuantity>,

    /// Y of the centre; 0 when left out
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true)]
    center_y: Option<WrittenQuantity>,

    #[command(flatten)]
    answer: CalculationOutput,
}

pub fn circle(args: &BoltCircleArgs) -> Result<(), CommandFailure> {
    let written = [Some(&args.diameter), args.center_x.as_ref(), args.center_y.as_ref()];
    let numbers = UnitReader::new(args.answer.units, written);
    let x = numbers.maybe(args.center_x.as_ref())?.unwrap_or(0.0);
    let y = numbers.maybe(args.center_y.as_ref())?.unwrap_or(0.0);
    let ask = BoltCircle {
        center: Vec2::new(x, y),
        diameter: numbers.of(&args.diameter)?,
        holes: args.holes,
        start: args.start,
        sweep: args.sweep,
    };
    give(bolt_circle(&ask, numbers.units), &args.answer)
}

const TAP_EXAMPLES: &str = "\
Examples:
  chordal calc tap-drill M10x1.5
  chordal calc tap-drill 1/4-20 --percent 65
  chordal calc tap-drill M6x1 --forming";

/// Diameter of the hole before a tap
#[derive(clap::Args)]
#[command(after_help = TAP_EXAMPLES)]
pub struct TapDrillArgs {
    #[command(flatten)]
    size: ThreadSizeArgs,

    /// Share of the full thread profile
    #[arg(long, value_name = "PERCENT", default_value = "75")]
    percent: f64,

    /// For a tap that presses the thread instead of cutting it
    #[arg(long)]
    forming: bool,

    #[command(flatten)]
    answer: CalculationOutput,
}

pub fn tap_drill_of(args: &TapDrillArgs) -> Result<(), CommandFailure> {
    let requested = args.size.read(args.answer.units)?;
    let pipe =
        |form| matches!(form, ThreadForm::Npt | ThreadForm::Nptf | ThreadForm::G | ThreadForm::R);
    if requested.name.as_ref().is_some_and(|name| pipe(name.form)) {
        return Err(CommandFailure::wrong(
            "the share of a profile of 60° says nothing of a pipe thread",
            "the tap's maker names its drill; `chordal calc thread` gives the sizes of the thread",
        ));
    }
    let ask = TapDrill {
        thread: requested.thread(1)?,
        share: args.percent / 100.0,
        forming: args.forming,
    };
    give(tap_drill(&ask, requested.numbers.units), &args.answer)
}

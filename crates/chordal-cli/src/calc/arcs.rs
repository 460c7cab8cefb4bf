//! Corners with arcs, arcs from angles, chords of arcs.

use chordal::geometry::{TurnDirection, Vec2};
use chordal_calc::{
    ArcArc, ArcPoints, ChordCount, LineArc, arc_points, arc_with_arc, chord_count, line_with_arc,
};
use clap::ValueEnum;

use super::answer::{CalculationOutput, give};
use super::corners::SideName;
use super::quantity::{UnitReader, WrittenQuantity, angle, length};
use crate::failure::CommandFailure;

/// On which side of an arc the cutter is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum ArcSide {
    /// Within the arc's circle
    Inside,
    /// Around it
    Outside,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum LineSide {
    /// Between the line and the arc's centre
    Near,
    /// Beyond the line
    Far,
}

const LINE_EXAMPLES: &str = "\
Examples:
  chordal calc line-arc --radius 1.25in --height 0.5in --tool 0.5in
  chordal calc line-arc --radius 1.25in --height 0.5in --tool 0.5in --corner 1.1454in
  chordal calc line-arc --radius 30mm --height 12mm --tool 10mm --arc outside --line far";

/// Cutter offset at a corner of a line with an arc
#[derive(clap::Args)]
#[command(after_help = LINE_EXAMPLES)]
pub struct LineArcArgs {
    /// Radius of the arc
    #[arg(long, short, value_name = "LENGTH", value_parser = length)]
    radius: WrittenQuantity,

    /// Distance of the line from the arc's centre
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    height: WrittenQuantity,

    /// Diameter of the tool
    #[arg(long, short, value_name = "DIAMETER", value_parser = length)]
    tool: WrittenQuantity,

    /// Where the cutter is, seen from the arc
    #[arg(long, value_enum, default_value = "inside")]
    arc: ArcSide,

    /// Where the cutter is, seen from the line
    #[arg(long, value_enum, default_value = "near")]
    line: LineSide,

    /// The corner along the line from the arc's centre, if the drawing gives it
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    corner: Option<WrittenQuantity>,

    #[command(flatten)]
    answer: CalculationOutput,
}

pub fn line_arc(args: &LineArcArgs) -> Result<(), CommandFailure> {
    let written = [Some(&args.radius), Some(&args.height), Some(&args.tool), args.corner.as_ref()];
    let numbers = UnitReader::new(args.answer.units, written);
    let ask = LineArc {
        cutter_radius: numbers.of(&args.tool)? / 2.0,
        radius: numbers.of(&args.radius)?,
        height: numbers.of(&args.height)?,
        inside: args.arc == ArcSide::Inside,
        toward: args.line == LineSide::Near,
        corner: numbers.maybe(args.corner.as_ref())?,
    };
    give(line_with_arc(&ask, numbers.units), &args.answer)
}

const ARCS_EXAMPLES: &str = "\
Examples:
  chordal calc arc-arc --radius1 1in --radius2 0.75in --dx 1.25in --tool 0.5in
  chordal calc arc-arc --radius1 30mm --radius2 20mm --dx 30mm --dy 10mm --tool 8mm \\
      --arc1 inside --crossing right -o corner.svg";

/// Cutter offset at a corner of two arcs
#[derive(clap::Args)]
#[command(after_help = ARCS_EXAMPLES)]
pub struct ArcArcArgs {
    /// Radius of the first arc
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    radius1: WrittenQuantity,

    /// Radius of the second arc
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    radius2: WrittenQuantity,

    /// The second centre from the first, along X
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true)]
    dx: WrittenQuantity,

    /// The second centre from the first, along Y
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true)]
    dy: Option<WrittenQuantity>,

    /// Diameter of the tool
    #[arg(long, short, value_name = "DIAMETER", value_parser = length)]
    tool: WrittenQuantity,

    /// Where the cutter is, seen from the first arc
    #[arg(long, value_enum, default_value = "outside")]
    arc1: ArcSide,

    /// Where the cutter is, seen from the second arc
    #[arg(long, value_enum, default_value = "outside")]
    arc2: ArcSide,

    /// Which crossing, seen from the first centre towards the second
    #[arg(long, value_enum, default_value = "left")]
    crossing: SideName,

    #[command(flatten)]
    answer: CalculationOutput,
}

pub fn arc_arc(args: &ArcArcArgs) -> Result<(), CommandFailure> {
    let written = [&args.radius1, &args.radius2, &args.dx, &args.tool].map(Some);
    let numbers = UnitReader::new(args.answer.units, written.into_iter().chain([args.dy.as_ref()]));
    let ask = ArcArc {
        cutter_radius: numbers.of(&args.tool)? / 2.0,
        radii: [numbers.of(&args.radius1)?, numbers.of(&args.radius2)?],
        inside: [args.arc1 == ArcSide::Inside, args.arc2 == ArcSide::Inside],
        center_offset: [numbers.of(&args.dx)?, numbers.maybe(args.dy.as_ref())?.unwrap_or(0.0)],
        side: args.crossing.into(),
    };
    give(arc_with_arc(&ask, numbers.units), &args.answer)
}

const ARC_EXAMPLES: &str = "\
Examples:
  chordal calc arc --radius 1in --from 90deg --to 0deg --cw --start-x 2in --start-y 3in
  chordal calc arc --radius 20mm --from -30deg --to 135deg -o arc.svg";

/// Centre, end, I and J of an arc from its radius and angles
#[derive(clap::Args)]
#[command(after_help = ARC_EXAMPLES)]
pub struct ArcArgs {
    /// Radius of the arc
    #[arg(long, short, value_name = "LENGTH", value_parser = length)]
    radius: WrittenQuantity,

    /// Direction from the centre to the start, from the X axis
    #[arg(long, value_name = "ANGLE", value_parser = angle, allow_hyphen_values = true)]
    from: f64,

    /// Direction from the centre to the end
    #[arg(long, value_name = "ANGLE", value_parser = angle, allow_hyphen_values = true)]
    to: f64,

    /// Clockwise (G2) instead of counter-clockwise (G3)
    #[arg(long)]
    cw: bool,

    /// X of the start; 0 when left out
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true)]
    start_x: Option<WrittenQuantity>,

    /// Y of the start; 0 when left out
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true)]
    start_y: Option<WrittenQuantity>,

    #[command(flatten)]
    answer: CalculationOutput,
}

pub fn arc(args: &ArcArgs) -> Result<(), CommandFailure> {
    let written = [Some(&args.radius), args.start_x.as_ref(), args.start_y.as_ref()];
    let numbers = UnitReader::new(args.answer.units, written);
    let start = |own: &Option<WrittenQuantity>| -> Result<f64, CommandFailure> {
        Ok(numbers.maybe(own.as_ref())?.unwrap_or(0.0))
    };
    let ask = ArcPoints {
        start: Vec2::new(start(&args.start_x)?, start(&args.start_y)?),
        radius: numbers.of(&args.radius)?,
        from: args.from,
        to: args.to,
        direction: if args.cw { TurnDirection::Cw } else { TurnDirection::Ccw },
    };
    give(arc_points(&ask, numbers.units), &args.answer)
}

const CHORD_EXAMPLES: &str = "\
Examples:
  chordal calc chords --radius 10mm --tolerance 0.001mm
  chordal calc chords --radius 2in --tolerance 0.0005in --sweep 90deg";

/// How many chords replace an arc within a tolerance
#[derive(clap::Args)]
#[command(after_help = CHORD_EXAMPLES)]
pub struct ChordsArgs {
    /// Radius of the arc
    #[arg(long, short, value_name = "LENGTH", value_parser = length)]
    radius: WrittenQuantity,

    /// How far a chord may be from the arc
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    tolerance: WrittenQuantity,

    /// Angle of the arc
    #[arg(long, value_name = "ANGLE", default_value = "360deg", value_parser = angle)]
    sweep: f64,

    #[command(flatten)]
    answer: CalculationOutput,
}

pub fn chords(args: &ChordsArgs) -> Result<(), CommandFailure> {
    let numbers = UnitReader::new(args.answer.units, [Some(&args.radius), Some(&args.tolerance)]);
    let ask = ChordCount {
        radius: numbers.of(&args.radius)?,
        tolerance: numbers.of(&args.tolerance)?,
        sweep: args.sweep,
    };
    give(chord_count(&ask, numbers.units), &args.answer)
}

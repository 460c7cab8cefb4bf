//! Where the cutter stands at a corner of lines, and at a tangent point.

use chordal_calc::{
    CornerSide, LineAxis, PlaneAxis, TangentTransition, TravelSide, TwoLines, corner_of_lines,
    corner_with_axis, tangent_point,
};
use clap::ValueEnum;

use super::answer::{CalculationOutput, give};
use super::quantity::{UnitReader, WrittenQuantity, angle, length};
use crate::failure::CommandFailure;

const CORNER_EXAMPLES: &str = "\
Examples:
  chordal calc corner --angle 60deg --axis y --tool 0.5in          0.144 in along Y
  chordal calc corner --angle 30deg --tool 0.5in --rise 1in        where the slope ends: X1.665
  chordal calc corner --angle 45deg --tool 10mm --inside -o corner.svg";

/// Cutter offset at a corner of a slanted line with a line along an axis
#[derive(clap::Args)]
#[command(after_help = CORNER_EXAMPLES)]
pub struct CornerArgs {
    /// Angle of the slanted line to the axis: by how much the path turns
    #[arg(long, short, value_parser = angle, allow_hyphen_values = true)]
    angle: f64,

    /// Diameter of the tool
    #[arg(long, short, value_name = "DIAMETER", value_parser = length)]
    tool: WrittenQuantity,

    /// The axis of the other line
    #[arg(long, value_enum, default_value = "x")]
    axis: AxisName,

    /// The cutter is in the corner, not around it
    #[arg(long)]
    inside: bool,

    /// Distance that the slanted line goes across the axis: gives the end of the line
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    rise: Option<WrittenQuantity>,

    #[command(flatten)]
    answer: CalculationOutput,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum AxisName {
    /// Along X
    X,
    /// Along Y
    Y,
}

/// On which side of its travel the cutter is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum SideName {
    /// Left, as with G41
    Left,
    /// Right, as with G42
    Right,
}

impl From<SideName> for TravelSide {
    fn from(name: SideName) -> TravelSide {
        match name {
            SideName::Left => TravelSide::Left,
            SideName::Right => TravelSide::Right,
        }
    }
}

pub fn corner(args: &CornerArgs) -> Result<(), CommandFailure> {
    let numbers = UnitReader::new(args.answer.units, [Some(&args.tool), args.rise.as_ref()]);
    let ask = LineAxis {
        cutter_radius: numbers.of(&args.tool)? / 2.0,
        angle: args.angle,
        axis: if args.axis == AxisName::X { PlaneAxis::X } else { PlaneAxis::Y },
        bend: if args.inside { CornerSide::Inside } else { CornerSide::Outside },
        rise: numbers.maybe(args.rise.as_ref())?,
    };
    give(corner_with_axis(&ask, numbers.units), &args.answer)
}

const TWO_EXAMPLES: &str = "\
Examples:
  chordal calc two-angles -a 15deg -b 45deg --tool 0.5in
  chordal calc two-angles -a 45deg -b -20deg --tool 10mm --side left -o corner.png";

/// Cutter offset at a corner of two slanted lines
#[derive(clap::Args)]
#[command(after_help = TWO_EXAMPLES)]
pub struct TwoAnglesArgs {
    /// Direction of travel on the first line, from the X axis
    #[arg(short, value_name = "ANGLE", value_parser = angle, allow_hyphen_values = true)]
    a: f64,

    /// Direction of travel on the second line, from the X axis
    #[arg(short, value_name = "ANGLE", value_parser = angle, allow_hyphen_values = true)]
    b: f64,

    /// Diameter of the tool
    #[arg(long, short, value_name = "DIAMETER", value_parser = length)]
    tool: WrittenQuantity,

    /// Side of the cutter, seen along its travel
    #[arg(long, value_enum, default_value = "left")]
    side: SideName,

    #[command(flatten)]
    answer: CalculationOutput,
}

pub fn two_angles(args: &TwoAnglesArgs) -> Result<(), CommandFailure> {
    let numbers = UnitReader::new(args.answer.units, [Some(&args.tool)]);
    let ask = TwoLines {
        cutter_radius: numbers.of(&args.tool)? / 2.0,
        a: args.a,
        b: args.b,
        side: args.side.into(),
    };
    give(corner_of_lines(&ask, numbers.units), &args.answer)
}

const TANGENT_EXAMPLES: &str = "\
Examples:
  chordal calc tangent --angle 45deg --tool 0.5in        0.17678 in along X and Y";

/// Cutter offset where a line touches an arc, or an arc another arc
#[derive(clap::Args)]
#[command(after_help = TANGENT_EXAMPLES)]
pub struct TangentArgs {
    /// Direction of the contour at the point, from the X axis
    #[arg(long, short, value_parser = angle, allow_hyphen_values = true)]
    angle: f64,

    /// Diameter of the tool
    #[arg(long, short, value_name = "DIAMETER", value_parser = length)]
    tool: WrittenQuantity,

    /// Side of the cutter, seen along its travel
    #[arg(long, value_enum, default_value = "left")]
    side: SideName,

    #[command(flatten)]
    answer: CalculationOutput,
}

pub fn tangent(args: &TangentArgs) -> Result<(), CommandFailure> {
    let numbers = UnitReader::new(args.answer.units, [Some(&args.tool)]);
    let ask = TangentTransition {
        cutter_radius: numbers.of(&args.tool)? / 2.0,
        angle: args.angle,
        side: args.side.into(),
    };
    give(tangent_point(&ask, numbers.units), &args.answer)
}

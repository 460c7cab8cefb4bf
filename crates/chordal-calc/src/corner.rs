//! Where the cutter's centre stands when both its lines are touched: corners of straight lines.

use chordal_geometry::Vec2;

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::error::{CalcError, bounded};
use crate::figure::{Figure, LineStyle};
use crate::math::{FRAC_PI_2, PI, TAU, cos, sin, tan, turn, unit};
use crate::numbers::{AnswerUnit, degrees, factor};

/// An axis of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneAxis {
    /// The first.
    X,
    /// The second.
    Y,
}

/// On which side of a corner the cutter is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CornerSide {
    /// The corner points at the cutter: it goes around.
    Outside,
    /// The cutter is in the corner.
    Inside,
}

/// On which side of its travel the cutter is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TravelSide {
    /// Left, as with G41.
    Left,
    /// Right, as with G42.
    Right,
}

/// A corner of a line with a line along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineAxis {
    /// Radius of the cutter, mm.
    pub cutter_radius: f64,
    /// Angle by which the travel bends, rad: that of the slanted line to the axis.
    pub angle: f64,
    /// The axis of the other line.
    pub axis: PlaneAxis,
    /// Where the cutter is.
    pub bend: CornerSide,
    /// How far the slanted line goes across the axis, mm: its end is then reported as well.
    pub rise: Option<f64>,
}

/// A corner of two lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoLines {
    /// Radius of the cutter, mm.
    pub cutter_radius: f64,
    /// Direction of travel on the first line, from the X axis, rad.
    pub a: f64,
    /// Direction of travel on the second line, rad.
    pub b: f64,
    /// Side of the cutter.
    pub side: TravelSide,
}

/// A radius is above nothing.
pub(crate) fn cutter(radius: f64, units: AnswerUnit) -> Result<(), CalcError> {
    if radius > 0.0 && radius.is_finite() {
        return Ok(());
    }
    Err(CalcError::new(
        format!("a cutter with a radius of {} is not possible", units.length(radius)),
        "give the diameter of the cutter, above zero",
    ))
}

/// Offset of the cutter's centre at a corner of a line with an axis: CR·tan(θ/2) along the axis,
/// CR across it.
///
/// # Errors
/// When the angle is not between 0° and 180°, or the cutter is none.
pub fn corner_with_axis(ask: &LineAxis, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    let LineAxis { cutter_radius, angle, axis, bend, rise } = *ask;
    bounded(&[cutter_radius, rise.unwrap_or(0.0)], &[angle], units)?;
    cutter(cutter_radius, units)?;
    if !(angle > 1e-9 && angle < PI - 1e-9) {
        return Err(CalcError::new(
            format!("a line at {} to the axis makes no corner with it", degrees(angle)),
            "give the angle by which the path turns, above 0° and below 180°",
        ));
    }
    let along = cutter_radius * tan(angle / 2.0);
    let (on, across) = match axis {
        PlaneAxis::X => ("X", "Y"),
        PlaneAxis::Y => ("Y", "X"),
    };
    let mut worked = WorkedCalculation::new(format!("Corner of a line with the {on} axis"), units);
    worked.input("CR", "cutter radius", QuantityKind::Length, cutter_radius);
    worked.input("θ", &format!("angle of the line to the {on} axis"), QuantityKind::Angle, angle);
    let (cr, theta) = (units.number(cutter_radius), degrees(angle));
    worked.result(
        &format!("Δ{on}"),
        &format!("from the corner, along {on}"),
        QuantityKind::Length,
        along,
        "CR·tan(θ/2)",
        format!("{cr}·tan({theta}/2)"),
    );
    worked.result(
        &format!("Δ{across}"),
        &format!("from the corner, along {across}"),
        QuantityKind::Length,
        cutter_radius,
        "CR",
        cr,
    );
    let outside = bend == CornerSide::Outside;
    if let Some(rise) = rise {
        end_of_slope(&mut worked, on, rise, along, ask, units)?;
    }
    worked.note(if outside {
        "Outside corner: the centre turns beyond the end of the axis line by this much."
    } else {
        "Inside corner: the centre turns before the end of the axis line by this much."
    });
    let (a, b) = match axis {
        PlaneAxis::X => (angle, 0.0),
        PlaneAxis::Y => (FRAC_PI_2, FRAC_PI_2 - angle),
    };
    let side = if outside { TravelSide::Left } else { TravelSide::Right };
    let names = match axis {
        PlaneAxis::X => {
            (format!("ΔX {}", units.number(along)), format!("CR {}", units.number(cutter_radius)))
        }
        PlaneAxis::Y => {
            (format!("CR {}", units.number(cutter_radius)), format!("ΔY {}", units.number(along)))
        }
    };
    worked.figure = draw(a, b, side, cutter_radius, names);
    let start = if axis == PlaneAxis::X { 0.0 } else { FRAC_PI_2 - angle };
    // Where the first line would go on.
    worked.figure.line(Vec2::ZERO, unit(a) * (1.8 * cutter_radius), LineStyle::Helper);
    worked.figure.angle(Vec2::ZERO, 1.6 * cutter_radius, start, angle, format!("θ {theta}"));
    Ok(worked)
}

/// Where the slanted line ends, and the cutter's centre there: the point P of the lecture.
fn end_of_slope(
    worked: &mut WorkedCalculation,
    on: &str,
    rise: f64,
    along: f64,
    ask: &LineAxis,
    units: AnswerUnit,
) -> Result<(), CalcError> {
    if !(rise > 0.0 && rise.is_finite()) {
        return Err(CalcError::new(
            format!("a line cannot rise by {}", units.length(rise)),
            "give the distance that the slanted line goes across the axis, above zero",
        ));
    }
    worked.input("h", "distance that the line goes across the axis", QuantityKind::Length, rise);
    let run = rise / tan(ask.angle);
    worked.intermediate(
        "b",
        &format!("the corner P, along {on} from the start of the line"),
        QuantityKind::Length,
        run,
        "h/tan(θ)",
        format!("{}/tan({})", units.number(rise), degrees(ask.angle)),
    );
    let (place, formula, sign) = match ask.bend {
        CornerSide::Outside => (run - along, format!("b − Δ{on}"), "−"),
        CornerSide::Inside => (run + along, format!("b + Δ{on}"), "+"),
    };
    worked.result(
        on,
        "the cutter's centre, from the start of the line",
        QuantityKind::Length,
        place,
        &formula,
        format!("{} {sign} {}", units.number(run), units.number(along)),
    );
    Ok(())
}

/// Offset of the cutter's centre at a corner of two lines:
/// CR·sin((a+b)/2)/cos((a−b)/2) and CR·cos((a+b)/2)/cos((a−b)/2).
///
/// # Errors
/// When the second line goes back along the first, or the cutter is none.
pub fn corner_of_lines(ask: &TwoLines, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    let TwoLines { cutter_radius, a, side, .. } = *ask;
    bounded(&[cutter_radius], &[a, ask.b], units)?;
    cutter(cutter_radius, units)?;
    // The bend taken the short way, in (−180°, 180°].
    let bend = PI - turn(PI - (ask.b - a));
    let b = a + bend;
    if (PI - bend.abs()) < 1e-9 {
        return Err(CalcError::new(
            format!(
                "a line at {} after a line at {} goes back on itself: there is no corner",
                degrees(ask.b),
                degrees(a)
            ),
            "give the directions of travel on both lines; they differ by less than 180°",
        ));
    }
    let (half, middle) = ((a - b) / 2.0, (a + b) / 2.0);
    let (dx, dy) =
        (cutter_radius * sin(middle) / cos(half), cutter_radius * cos(middle) / cos(half));
    let mut worked = WorkedCalculation::new("Corner of two lines", units);
    worked.input("CR", "cutter radius", QuantityKind::Length, cutter_radius);
    worked.input("a", "direction of the first line, from X", QuantityKind::Angle, a);
    worked.input("b", "direction of the second line, from X", QuantityKind::Angle, b);
    let (cr, ta, tb) = (units.number(cutter_radius), degrees(a), factor(degrees(b)));
    for (symbol, name, value) in [("ΔX", "sin", dx), ("ΔY", "cos", dy)] {
        worked.result(
            symbol,
            &format!("from the corner, along {}", &symbol["Δ".len()..]),
            QuantityKind::Length,
            value,
            &format!("CR·{name}((a+b)/2)/cos((a−b)/2)"),
            format!("{cr}·{name}(({ta}+{tb})/2)/cos(({ta}−{tb})/2)"),
        );
    }
    let (x, y) = match side {
        TravelSide::Left => (-dx, dy),
        TravelSide::Right => (dx, -dy),
    };
    let turns_left = bend > 0.0;
    let outside = turns_left != (side == TravelSide::Left);
    worked.note(format!(
        "Cutter {} of the travel, {} corner: its centre is at X {} Y {} from the corner.",
        if side == TravelSide::Left { "left" } else { "right" },
        if bend.abs() < 1e-12 {
            "no"
        } else if outside {
            "outside"
        } else {
            "inside"
        },
        signed(x, units),
        signed(y, units)
    ));
    let names =
        (format!("ΔX {}", units.number(dx.abs())), format!("ΔY {}", units.number(dy.abs())));
    worked.figure = draw(a, b, side, cutter_radius, names);
    let reach = 1.9 * cutter_radius;
    let figure = &mut worked.figure;
    figure.line(Vec2::ZERO, Vec2::new(reach * 1.1, 0.0), LineStyle::Helper);
    let back = turn(a) > 1e-9;
    if back {
        figure.angle(Vec2::ZERO, reach * 0.62, 0.0, PI - turn(PI - a), format!("a {ta}"));
    }
    if turn(b) > 1e-9 && TAU - turn(b) > 1e-9 {
        figure.angle(Vec2::ZERO, reach, 0.0, PI - turn(PI - b), format!("b {}", degrees(b)));
    }
    if back {
        // Where the first line would go on.
        figure.line(Vec2::ZERO, unit(a) * (reach * 0.75), LineStyle::Helper);
    }
    Ok(worked)
}

pub(crate) fn signed(value: f64, units: AnswerUnit) -> String {
    let text = units.number(value);
    if text.starts_with('-') || text == "0" { text } else { format!("+{text}") }
}

/// Both lines, the cutter in the corner P = 0, its way and the two distances.
fn draw(a: f64, b: f64, side: TravelSide, cr: f64, (width, height): (String, String)) -> Figure {
    let (first, second) = (unit(a), unit(b));
    let (mine, other) = (first.turned_left(), second.turned_left());
    let sign = if side == TravelSide::Left { 1.0 } else { -1.0 };
    let center = (mine + other) * (sign * cr / (1.0 + mine.dot(other)));
    let arm = (3.2 * cr).max(center.length() * 1.3 + 1.2 * cr);
    let mut figure = Figure::default();
    figure.line(first * -arm, Vec2::ZERO, LineStyle::Part);
    figure.line(Vec2::ZERO, second * arm, LineStyle::Part);
    figure.line(center - first * arm, center, LineStyle::Path);
    figure.line(center, center + second * arm, LineStyle::Path);
    figure.arrow(center - first * (arm * 0.55), a);
    figure.arrow(center + second * (arm * 0.75), b);
    figure.circle(center, cr, LineStyle::Cutter);
    for normal in [mine, other] {
        figure.line(center, center - normal * (sign * cr), LineStyle::Helper);
    }
    figure.point(Vec2::ZERO, "P");
    figure.point(center, "C");
    let away = |value: f64| if value < 0.0 { -1.0 } else { 1.0 };
    let reach = 1.45 * cr;
    if center.a.abs() > 1e-9 * cr {
        let y = center.b + away(center.b) * reach;
        figure.width(Vec2::ZERO, center, y, width);
    }
    if center.b.abs() > 1e-9 * cr {
        let x = center.a + away(center.a) * reach;
        figure.height(Vec2::ZERO, center, x, height);
    }
    figure
}

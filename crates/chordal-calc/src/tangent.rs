//! Where a line touches an arc, or an arc another: the cutter stands on the common normal.

use chordal_geometry::Vec2;

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::corner::{TravelSide, cutter, signed};
use crate::error::{CalcError, bounded};
use crate::figure::{Figure, LineStyle};
use crate::math::{FRAC_PI_2, cos, sin, turn, unit};
use crate::numbers::{AnswerUnit, degrees};

/// A place where the contour goes on without a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentTransition {
    /// Radius of the cutter, mm.
    pub cutter_radius: f64,
    /// Direction of the contour there, from the X axis, rad.
    pub angle: f64,
    /// Side of the cutter.
    pub side: TravelSide,
}

/// Offset of the cutter's centre at a tangent point: CR·sin θ and CR·cos θ.
///
/// # Errors
/// When the cutter is none.
pub fn tangent_point(
    ask: &TangentTransition,
    units: AnswerUnit,
) -> Result<WorkedCalculation, CalcError> {
    let TangentTransition { cutter_radius, angle, side } = *ask;
    bounded(&[cutter_radius], &[angle], units)?;
    cutter(cutter_radius, units)?;
    let (dx, dy) = (cutter_radius * sin(angle), cutter_radius * cos(angle));
    let mut worked =
        WorkedCalculation::new("Tangent point of a line with an arc, or of two arcs", units);
    worked.input("CR", "cutter radius", QuantityKind::Length, cutter_radius);
    worked.input("θ", "direction of the contour at the point, from X", QuantityKind::Angle, angle);
    let (cr, theta) = (units.number(cutter_radius), degrees(angle));
    for (axis, name, value) in [("X", "sin", dx), ("Y", "cos", dy)] {
        worked.result(
            &format!("Δ{axis}"),
            &format!("from the tangent point, along {axis}"),
            QuantityKind::Length,
            value,
            &format!("CR·{name}(θ)"),
            format!("{cr}·{name}({theta})"),
        );
    }
    let (sign, word) = if side == TravelSide::Left { (1.0, "left") } else { (-1.0, "right") };
    let center = Vec2::new(-sign * dx, sign * dy);
    worked.note(format!(
        "Cutter {word} of the travel: its centre is at X {} Y {} from the point.",
        signed(center.a, units),
        signed(center.b, units)
    ));
    worked.figure = draw(angle, center, cutter_radius, units);
    let figure = &mut worked.figure;
    if turn(angle) > 1e-9 {
        let reach = 2.4 * cutter_radius;
        figure.line(Vec2::ZERO, Vec2::new(1.15 * reach, 0.0), LineStyle::Helper);
        figure.line(Vec2::ZERO, unit(angle) * (1.15 * reach), LineStyle::Helper);
        figure.angle(Vec2::ZERO, reach, 0.0, angle, format!("θ {theta}"));
    }
    Ok(worked)
}

/// A line that goes over into an arc, which turns away from the cutter.
fn draw(angle: f64, center: Vec2, cr: f64, units: AnswerUnit) -> Figure {
    let mut figure = Figure::default();
    let (along, radius) = (unit(angle), 3.0 * cr);
    let away = center * (-1.0 / cr);
    let middle = away * radius;
    let normal = crate::math::atan2(-away.b, -away.a);
    // The travel goes on around the arc's centre, which lies opposite to the cutter.
    let sense = if away.dot(along.turned_left()) > 0.0 { 1.0 } else { -1.0 };
    let sweep = sense * FRAC_PI_2 * 0.75;
    figure.line(along * (-3.0 * cr), Vec2::ZERO, LineStyle::Part);
    figure.arc(middle, radius, normal, sweep, LineStyle::Part);
    figure.line(center - along * (3.0 * cr), center, LineStyle::Path);
    figure.arc(middle, radius + cr, normal, sweep, LineStyle::Path);
    figure.arrow(center - along * (1.8 * cr), angle);
    figure.circle(center, cr, LineStyle::Cutter);
    figure.line(center, Vec2::ZERO, LineStyle::Helper);
    figure.point(Vec2::ZERO, "T");
    figure.point(center, "C");
    let sign = |value: f64| if value < 0.0 { -1.0 } else { 1.0 };
    if center.a.abs() > 1e-9 * cr {
        let y = center.b + sign(center.b) * 1.45 * cr;
        figure.width(Vec2::ZERO, center, y, format!("ΔX {}", units.number(center.a.abs())));
    }
    if center.b.abs() > 1e-9 * cr {
        let x = center.a + sign(center.a) * 1.45 * cr;
        figure.height(Vec2::ZERO, center, x, format!("ΔY {}", units.number(center.b.abs())));
    }
    figure
}
